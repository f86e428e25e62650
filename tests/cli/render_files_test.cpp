// boxcar render, sweep and inspect on volumes and meshes from files.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

#include "samples/files/bytes.h"
#include "tests/cli/program.h"

namespace boxcar {
namespace {

using nlohmann::json;

// 4 x 4 x 4 voxels that are 100 inside and 0 at the sides.
Bytes SmallVolume() {
    Bytes file(352 + 64);
    file[0] = 348 & 255, file[1] = 348 >> 8;
    file[40] = 3, file[42] = file[44] = file[46] = 4;
    file[70] = 2, file[72] = 8;
    for (size_t i = 80; i < 92; i += 4)
        file[i + 2] = 128, file[i + 3] = 63;  // 1 millimetre
    file[110] = 176, file[111] = 67;          // 352
    file[344] = 'n', file[345] = '+', file[346] = '1';
    for (const size_t z : {1, 2})
        for (const size_t y : {1, 2})
            for (const size_t x : {1, 2})
                file[352 + 16 * z + 4 * y + x] = 100;
    return file;
}

TEST(Render, DrawsTheSurfaceOfAVolumeWithParametersAsFlags) {
    const Folder folder;
    WriteFileAtomically(folder.Path("scan.nii"), SmallVolume());
    const std::string command = "render isosurface --volume scan.nii --size 40x30 ";
    const Outcome outcome = folder.Run(command + "--iso 40 --shade ridges --filter trilinear -o flags.png");
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    ASSERT_EQ(folder.Run(command + "--set iso=40 --set shade=ridges --set filter=trilinear -o sets.png").exitCode, 0);
    ASSERT_EQ(folder.Run(command + "--iso 0 -o full.png").exitCode, 0);
    const Picture flags = ReadPicture(folder.Path("flags.png")), sets = ReadPicture(folder.Path("sets.png"));
    EXPECT_EQ(flags.samples, sets.samples);
    EXPECT_NE(flags.samples, ReadPicture(folder.Path("full.png")).samples);
    const auto expect = [&](const std::string& arguments, int exitCode, const std::string& line) {
        const Outcome refused = folder.Run("render " + arguments + " -o refused.png");
        EXPECT_EQ(refused.exitCode, exitCode) << arguments;
        EXPECT_EQ(refused.err, "boxcar: " + line + "\n");
    };
    folder.WriteText("text.nii", "a text");
    expect("isosurface --volume text.nii", 1, "text.nii: it is no NIfTI file");
    expect("isosurface --volume none.nii", 1, "none.nii: cannot be read: No such file or directory");
    expect("isosurface --volume scan.nii --iso -101", 2, "iso=-101: the volume holds values from 0 to 100");
    expect("isosurface --shade dark", 2, "shade=dark: expected one of phong, curvature, ridges, normal, maximum");
    expect("isosurface --roughness 1", 2,
           "no parameter 'roughness'; there is filter, shade, iso, step, radius, turn, elevation, zoom");
    expect("planar-reflection --volume head", 2, "--volume head: planar-reflection has no use for it");
    expect("planar-reflection --frame 0", 2, "--frame 0: planar-reflection has no use for it");
    expect("planar-reflection --nan zero", 2, "--nan zero: planar-reflection has no use for it");
    expect("isosurface --up z", 2, "--up z: isosurface has no use for it");
    for (const std::string frame : {"-1", "x", "1.5", "18446744073709551616"})
        expect("isosurface --frame " + frame, 2, "--frame " + frame + ": expected a whole number, 0 or more");
    expect("isosurface --frame 1", 2, "--frame 1: head holds 1 volume, which is number 0");
    expect("isosurface --volume scan.nii --frame 1", 2,
           "scan.nii: it holds 1 volume; there is no volume 1, the first being 0");
}

// 6 x 4 x 4 voxels of a body without symmetry along x, stored towards the right or the left.
Bytes ScanTowards(bool isLeft, int16_t frames = 1) {
    constexpr int kWidth = 6;
    Bytes file = SmallVolume();
    file.resize(352);
    file[42] = kWidth;
    if (frames > 1) file[40] = 4, file[48] = static_cast<uint8_t>(frames);
    file[254] = 1;  // the sform: 1 voxel is 1 unit along each axis, -1 along the first
    for (const size_t at : {280, 300, 320})
        file[at + 2] = 128, file[at + 3] = 63;
    if (isLeft) file[283] |= 128;
    for (int frame = 0; frame < frames; frame++)
        for (int z = 0; z < 4; z++)
            for (int y = 0; y < 4; y++)
                for (int i = 0; i < kWidth; i++) {
                    const int x = isLeft ? kWidth - 1 - i : i;
                    const bool isInside = z % 3 > 0 && y % 3 > 0 && x > 0 && x < (y == 1 ? 3 : 5);
                    file.push_back(isInside ? static_cast<uint8_t>(100 - 20 * frame) : 0);
                }
    return file;
}

TEST(Render, TheBodysLeftIsWhereItBelongsHoweverItsScanIsStored) {
    const Folder folder;
    WriteFileAtomically(folder.Path("right.nii"), ScanTowards(false));
    WriteFileAtomically(folder.Path("left.nii"), ScanTowards(true));
    Bytes none = ScanTowards(true);
    none[254] = 0;
    WriteFileAtomically(folder.Path("none.nii"), none);
    for (const std::string name : {"right", "left", "none"}) {
        const Outcome outcome = folder.Run(
            fmt::format("render isosurface --volume {0}.nii --iso 40 --size 60x40 --stats -o {0}.png", name));
        ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
        const std::string expected = name == "none" ? "voxel sizes alone, no orientation"
                                                    : fmt::format("sform, stored {}AS", name == "left" ? 'L' : 'R');
        EXPECT_NE(outcome.err.find(
                      fmt::format("\n  volume   {}.nii: 6 x 4 x 4 voxels of 1 x 1 x 1 mm; {}\n", name, expected)),
                  std::string::npos)
            << outcome.err;
    }
    const Picture right = ReadPicture(folder.Path("right.png"));
    EXPECT_EQ(right.samples, ReadPicture(folder.Path("left.png")).samples);
    EXPECT_NE(right.samples, ReadPicture(folder.Path("none.png")).samples);

    // Seen from the front the right is on the left side of the picture, and only the front half ends at x = 3.
    ASSERT_EQ(folder
                  .Run("inspect isosurface --volume left.nii --iso 40 --size 61x41 --turn 0 --elevation 0 "
                       "--stage points -o points.exr")
                  .exitCode,
              0);
    const Picture points = ReadPicture(folder.Path("points.exr"));
    float before = INFINITY;
    for (uint32_t x = 0; x < 61; x++) {
        const float* point = &points.samples[(size_t{20} * 61 + x) * 4];
        if (point[3] == 0) continue;
        EXPECT_LT(point[0], before);
        before = point[0];
    }
    EXPECT_LT(before, 1.5f);
    const Outcome inspect =
        folder.Run("inspect isosurface --volume left.nii --iso 40 --size 9x9 --stage points --json");
    EXPECT_EQ(json::parse(inspect.out).at("volume"), "left.nii: 6 x 4 x 4 voxels of 1 x 1 x 1 mm; sform, stored LAS");
}

TEST(Render, OfASeriesTheFirstVolumeIsDrawnAndSaidToBe) {
    const Folder folder;
    WriteFileAtomically(folder.Path("series.nii"), ScanTowards(false, 3));
    const std::string command = "render isosurface --volume series.nii --iso 50 --size 40x30 -o ";
    const std::string note =
        "boxcar: series.nii: 3 volumes, of which the first is drawn; --frame 1 to 2 draws another\n";
    EXPECT_EQ(folder.Run(command + "first.png").err, note);
    EXPECT_EQ(folder.Run(command + "named.png --frame 0").err, "");
    EXPECT_EQ(folder.Run(command + "last.png --frame 2").err, "");
    EXPECT_EQ(ReadPicture(folder.Path("first.png")).samples, ReadPicture(folder.Path("named.png")).samples);
    EXPECT_NE(ReadPicture(folder.Path("first.png")).samples, ReadPicture(folder.Path("last.png")).samples);
    EXPECT_EQ(folder.Run(command + "none.png --frame 3").err,
              "boxcar: series.nii: it holds 3 volumes; there is no volume 3, the first being 0\n");
    EXPECT_EQ(folder.Run("sweep isosurface --volume series.nii --iso 30,50,60 --size 40x30 -o sheet.png").err, note);
}

TEST(Render, NanZeroIsForVolumesAndEnvironmentsToo) {
    const Folder folder;
    Bytes whole = ScanTowards(false);
    Bytes floats(whole.begin(), whole.begin() + 352);
    floats[70] = 16, floats[72] = 32;
    for (size_t i = 352; i < whole.size(); i++) {
        const float value = whole[i] == 0 ? NAN : whole[i];
        const auto bytes = std::bit_cast<std::array<uint8_t, 4>>(value);
        floats.insert(floats.end(), bytes.begin(), bytes.end());
    }
    WriteFileAtomically(folder.Path("whole.nii"), whole);
    WriteFileAtomically(folder.Path("masked.nii"), floats);
    const std::string command = "render isosurface --iso 40 --size 40x30 --volume ";
    EXPECT_EQ(folder.Run(command + "masked.nii -o out.png").err,
              "boxcar: masked.nii: voxel (0, 0, 0) is nan; finite numbers are expected, or --nan zero\n");
    ASSERT_EQ(folder.Run(command + "masked.nii --nan zero -o masked.png").exitCode, 0);
    ASSERT_EQ(folder.Run(command + "whole.nii -o whole.png").exitCode, 0);
    EXPECT_EQ(ReadPicture(folder.Path("masked.png")).samples, ReadPicture(folder.Path("whole.png")).samples);

    Picture environment{8, 4, 3, SampleType::Float32, std::vector<float>(8 * 4 * 3, 0.25f)};
    environment.samples[7] = INFINITY;
    WritePicture(environment, folder.Path("hot.exr"), FileFormat::Exr, SampleType::Float32);
    environment.samples[7] = 0;
    WritePicture(environment, folder.Path("cold.exr"), FileFormat::Exr, SampleType::Float32);
    const std::string glossy = "render glossy-environment --set face=32 --size 40x30 --env ";
    EXPECT_EQ(folder.Run(glossy + "hot.exr -o out.png").err,
              "boxcar: hot.exr: inf in it; light is finite (--nan zero replaces it)\n");
    ASSERT_EQ(folder.Run(glossy + "hot.exr --nan zero -o hot.png").exitCode, 0);
    ASSERT_EQ(folder.Run(glossy + "cold.exr -o cold.png").exitCode, 0);
    EXPECT_EQ(ReadPicture(folder.Path("hot.png")).samples, ReadPicture(folder.Path("cold.png")).samples);
}

// Boxes before a uniform light, of which they reflect a little less: what is darker is they.
TEST(Render, MeshesAreWholeWhateverTheirShapeAndTheAxisThatGoesUp) {
    const Folder folder;
    Picture environment{8, 4, 3, SampleType::Float32, std::vector<float>(8 * 4 * 3, 0.25f)};
    WritePicture(environment, folder.Path("grey.exr"), FileFormat::Exr, SampleType::Float32);
    const auto writeBox = [&](const std::string& name, glm::dvec3 size) {
        std::string text;
        for (int i = 0; i < 8; i++)
            text += fmt::format("v {} {} {}\n", i / 4 * size.x, i / 2 % 2 * size.y, i % 2 * size.z);
        folder.WriteText(name, text + "f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n");
    };
    const auto draw = [&](const std::string& arguments) {
        const Outcome outcome =
            folder.Run("render glossy-environment --env grey.exr --set face=32 -o out.exr " + arguments);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        return ReadPicture(folder.Path("out.exr"));
    };
    writeBox("sheet.obj", {1000, 1, 1000});
    writeBox("wall.obj", {1000, 1000, 1});
    writeBox("rod.obj", {1000, 40, 40});
    writeBox("tiny.obj", {3e-6, 2e-6, 1e-6});
    writeBox("huge.obj", {2e6, 1e6, 4e6});
    for (const std::string name : {"sheet", "wall", "rod", "tiny", "huge"})
        for (const std::string size : {"96x54", "48x64"}) {
            const Picture picture = draw(fmt::format("--mesh {}.obj --size {}", name, size));
            uint32_t covered = 0, atRims = 0, left = picture.widthTexels, right = 0;
            for (uint32_t y = 0; y < picture.heightTexels; y++)
                for (uint32_t x = 0; x < picture.widthTexels; x++) {
                    const float blue = picture.samples[(size_t{y} * picture.widthTexels + x) * 3 + 2];
                    if (std::abs(blue - 0.25f) < 0.01f) continue;
                    covered++;
                    left = std::min(left, x);
                    right = std::max(right, x);
                    atRims += x == 0 || y == 0 || x + 1 == picture.widthTexels || y + 1 == picture.heightTexels;
                }
            EXPECT_EQ(atRims, 0u) << name << " " << size;
            EXPECT_GT(covered, (name == "rod" ? 0.01 : 0.05) * picture.widthTexels * picture.heightTexels) << name;
            EXPECT_GT(right - left, picture.widthTexels / 5) << name << " " << size;
        }
    // z up: the wall lies.
    EXPECT_EQ(draw("--mesh wall.obj --up z --size 64x36").samples, draw("--mesh sheet.obj --size 64x36").samples);
}

}  // namespace
}  // namespace boxcar
