// The files that come with the samples, which nothing here has written: against the formats' own libraries.
#include <OpenEXR/ImfArray.h>
#include <OpenEXR/ImfRgbaFile.h>

// jpeglib.h needs what is before it.
// clang-format off
#include <cstdio>
#include <jpeglib.h>
// clang-format on

#include "tests/files/support.h"

namespace boxcar::test {
namespace {

Picture DecodeWithLibjpeg(const Bytes& file) {
    jpeg_decompress_struct jpeg;
    jpeg_error_mgr errors;
    jpeg.err = jpeg_std_error(&errors);
    jpeg_create_decompress(&jpeg);
    jpeg_mem_src(&jpeg, file.data(), file.size());
    jpeg_read_header(&jpeg, TRUE);
    jpeg_start_decompress(&jpeg);
    Picture picture{jpeg.output_width, jpeg.output_height, 3, SampleType::Unorm8, {}};
    Bytes row(size_t{picture.widthTexels} * 3);
    while (jpeg.output_scanline < jpeg.output_height) {
        JSAMPROW to = row.data();
        jpeg_read_scanlines(&jpeg, &to, 1);
        for (const uint8_t code : row)
            picture.samples.push_back(static_cast<float>(code) / 255.0f);
    }
    jpeg_destroy_decompress(&jpeg);
    return picture;
}

TEST(SamplesTest, PhotographsAreReadAsLibjpegReadsThem) {
    for (const char* name : {"fruits.jpg", "building.jpg"}) {
        SCOPED_TRACE(name);
        const std::string path = std::string(SAMPLES_FOLDER) + name;
        const Picture read = ReadPicture(path);
        const Picture expected = DecodeWithLibjpeg(Contents(path));
        ExpectSame(read, expected);
    }
}

TEST(SamplesTest, TheEnvironmentIsReadAsOpenExrReadsIt) {
    const std::string path = std::string(SAMPLES_FOLDER) + "city.exr";
    Imf::RgbaInputFile file(path.c_str());
    Imf::Array2D<Imf::Rgba> texels(256, 512);
    file.setFrameBuffer(&texels[0][0], 1, 512);
    file.readPixels(0, 255);
    Picture expected{512, 256, 3, SampleType::Float32, {}};
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 512; ++x)
            for (const half value : {texels[y][x].r, texels[y][x].g, texels[y][x].b})
                expected.samples.push_back(value);
    ExpectSame(ReadPicture(path), expected);
}

TEST(SamplesTest, PhotographsCutOffAreRefused) {
    const TemporaryFolder folder;
    const Bytes whole = Contents(std::string(SAMPLES_FOLDER) + "fruits.jpg");
    for (size_t length = 0; length < whole.size(); length += 499) {
        const std::string path = folder.Put("cut.jpg", ByteView(whole).first(length));
        ASSERT_THROW(ReadPicture(path), Error) << length << " of " << whole.size() << " bytes";
    }
}

}  // namespace
}  // namespace boxcar::test
