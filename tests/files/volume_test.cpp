// NIfTI files by hand, whole and damaged.
#include "samples/files/volume.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

#include "tests/files/nifti_file.h"

namespace boxcar::test {
namespace {

Volume Read(const BinaryFile& file, const VolumeReading& reading = {}) {
    return DecodeVolume(file.m_bytes, "v.nii", reading);
}

void ExpectError(const Bytes& file, const std::string& text) {
    EXPECT_EQ(ErrorOf([&] { DecodeVolume(file, "v.nii"); }), "v.nii: " + text);
}

template <typename T>
void ExpectRoundTrip(int16_t type, const std::vector<T>& voxels) {
    const auto count = static_cast<int16_t>(voxels.size() / 2);
    const std::vector<float> expected(voxels.begin(), voxels.end());
    for (const bool isBigEndian : {false, true}) {
        NiftiFile file({1, 2, count}, type, 8 * sizeof(T), isBigEndian);
        file.Voxels(voxels);
        EXPECT_EQ(Read(file).voxels, expected) << type << isBigEndian;
        EXPECT_EQ(DecodeVolume(Packed(file.m_bytes), "v").voxels, expected) << type << isBigEndian;
    }
}

TEST(VolumeFile, HoldsEveryTypeOfNumberInBothByteOrdersPackedOrNot) {
    ExpectRoundTrip<uint8_t>(kUint8, {0, 255, 3, 4});
    ExpectRoundTrip<int8_t>(kInt8, {0, -128, 127, 4});
    ExpectRoundTrip<int16_t>(kInt16, {-32768, 32767, 1, 258});
    ExpectRoundTrip<uint16_t>(kUint16, {0, 65535, 1, 258});
    ExpectRoundTrip<int32_t>(kInt32, {-70000, 70000, 1, 258});
    ExpectRoundTrip<uint32_t>(kUint32, {4294967295u, 70000, 1, 258});
    ExpectRoundTrip<int64_t>(kInt64, {-5000000000, 5000000000, 1, 258});
    ExpectRoundTrip<uint64_t>(kUint64, {18446744073709551615u, 70000, 1, 258});
    ExpectRoundTrip<float>(kFloat, {-1.5f, 1e30f, 0, 258});
    ExpectRoundTrip<double>(kDouble, {-1.5, 1e30, 0, 258});
}

TEST(VolumeFile, ExtentSidesScaleAndExtensionsAreTheFiles) {
    NiftiFile file({3, 2, 1, 1, 1}, kInt16, 16, true);
    file.Set(80, -0.5f).Set(84, 2.0f).Set(88, 0.0f);  // an axis of one voxel may have no length
    file.Set(112, 0.5f).Set(116, -10.0f).Set(108, 368.0f);
    file.Voxels<int16_t>(std::vector<int16_t>(8, 99)).Voxels<int16_t>({1, 2, 3, 4, 5, 6, 99});
    Volume volume = Read(file);
    EXPECT_EQ(volume.widthVoxels, 3u);
    EXPECT_EQ(volume.heightVoxels, 2u);
    EXPECT_EQ(volume.depthVoxels, 1u);
    EXPECT_EQ(volume.voxelMillimetres, glm::vec3(0.5f, 2, 1));
    EXPECT_EQ(volume.voxels, std::vector<float>({-9.5f, -9, -8.5f, -8, -7.5f, -7}));
    file.Set<uint8_t>(123, 1);  // metres
    file.Set(112, std::nanf("")).Set(88, 3.0f);
    volume = Read(file);
    EXPECT_EQ(volume.voxelMillimetres, glm::vec3(500, 2000, 3000));
    EXPECT_EQ(volume.voxels, std::vector<float>({1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(Read(NiftiFile({1}, kUint8, 8).Voxels<uint8_t>({7})).voxels, std::vector<float>({7}));
}

TEST(VolumeFile, TheHeadIsWhatItsHeaderSays) {
    const Volume head = ReadVolume(SAMPLES_FOLDER "ch2bet.nii.gz");
    EXPECT_EQ(head.widthVoxels, 181u);
    EXPECT_EQ(head.heightVoxels, 217u);
    EXPECT_EQ(head.depthVoxels, 181u);
    EXPECT_EQ(head.voxelMillimetres, glm::vec3(1));
    EXPECT_EQ(head.voxels.size(), 181u * 217 * 181);
    EXPECT_EQ(std::ranges::min(head.voxels), 0);
    EXPECT_GT(std::ranges::max(head.voxels), 100);
}

TEST(VolumeFile, WhatItIsNotIsSaidInOneLine) {
    const auto small = [](int16_t type = kUint8, int16_t bits = 8) {
        return NiftiFile({2, 2, 2}, type, bits).Voxels(std::vector<uint8_t>(128, 1));
    };
    ExpectError({}, "it is too short for a NIfTI volume");
    ExpectError(ToBytes(std::string(400, 'x')), "it is no NIfTI file");
    ExpectError(ToBytes("#?RADIANCE\n"), "it is a Radiance picture; a NIfTI volume is expected");
    Bytes cut = small().m_bytes;
    cut.resize(340);
    ExpectError(cut, "it is too short for a NIfTI-1 volume");
    ExpectError(small().Set<uint8_t>(344, 'm').m_bytes, "it is no NIfTI-1 file");
    ExpectError(small().Set<uint32_t>(344, 0).m_bytes,
                "it is an Analyze file, which does not say where left is; NIfTI is expected");
    ExpectError(small().Set(344, uint32_t{0x0031696e}).m_bytes,
                "it is one of a pair of files .hdr and .img; one file .nii is expected");
    ExpectError(small().Set(0, 540).m_bytes, "it is too short for a NIfTI-2 volume");
    ExpectError(Nifti2File({2, 2, 2}, kUint8, 8).Set<uint8_t>(8, '\n').m_bytes, "it is no NIfTI-2 file");
    ExpectError(Nifti2File({2, 2, int64_t{1} << 40}, kUint8, 8).m_bytes,
                "its dimension 3 is 1099511627776; at most 2048 is read");
    ExpectError(Nifti2File({2, 2, 2}, kUint8, 8).Set<int64_t>(168, 352).m_bytes,
                "its voxels begin at byte 352; 544 or more is expected");
    ExpectError(Nifti2File({2, 2, 2}, kUint8, 8).Set<int64_t>(168, int64_t{1} << 62).m_bytes,
                "its voxels begin at byte 4.61169e+18; 544 or more is expected");
    ExpectError(small().Set<int16_t>(40, 0).m_bytes, "it has 0 dimensions; 3 are expected");
    ExpectError(small().Set<int16_t>(44, -2).m_bytes, "its dimension 2 is -2; 1 or more is expected");
    ExpectError(NiftiFile({2, 2, 2, 1, 3}, kUint8, 8).m_bytes,
                "its dimension 5 is 3: several numbers a voxel; one is expected");
    ExpectError(NiftiFile({2, 2, 4000}, kUint8, 8).m_bytes, "its dimension 3 is 4000; at most 2048 is read");
    ExpectError(NiftiFile({2048, 2048, 2048}, kUint8, 8).m_bytes, "8589934592 voxels; at most 134217728 are read");
    ExpectError(small(kRgb, 24).m_bytes, "voxels of type RGB24 (128); whole numbers and floats are read");
    ExpectError(small(kComplex, 64).m_bytes, "voxels of type COMPLEX64 (32); whole numbers and floats are read");
    ExpectError(small(77, 8).m_bytes, "voxels of type **ILLEGAL** (77); whole numbers and floats are read");
    ExpectError(small(kUint8, 16).m_bytes, "it is damaged: 16 bits a voxel of type UINT8");
    ExpectError(small().Set(84, std::nanf("")).m_bytes,
                "voxels of nan millimetres along axis 2; 1e-06 to 1e+06 are expected");
    ExpectError(small().Set(84, 0.0f).m_bytes, "voxels of 0 millimetres along axis 2; 1e-06 to 1e+06 are expected");
    ExpectError(small().Set(108, 17.0f).m_bytes, "its voxels begin at byte 17; 352 or more is expected");
    ExpectError(small().Set(108, 1e8f).m_bytes, "it is cut off: its extensions are incomplete");
    ExpectError(NiftiFile({2, 2, 2}, kUint8, 8).Voxels<uint8_t>({1, 2, 3}).m_bytes,
                "it is cut off: its voxels are incomplete");
    ExpectError(NiftiFile({2, 1, 2}, kFloat, 32).Voxels<float>({1, 2, 3, std::nanf("")}).m_bytes,
                "voxel (1, 0, 1) is nan; finite numbers are expected, or --nan zero");
    ExpectError(NiftiFile({1}, kDouble, 64).Voxels<double>({1e300}).m_bytes,
                "voxel (0, 0, 0) is inf; finite numbers are expected, or --nan zero");
    const TemporaryFolder folder;
    EXPECT_EQ(ErrorOf([&] { ReadVolume(folder.Path("none.nii")); }),
              folder.Path("none.nii") + ": cannot be read: No such file or directory");
    EXPECT_EQ(ErrorOf([&] { ReadVolume(folder.Put("empty.nii", {})); }),
              folder.Path("empty.nii") + ": the file is empty; a NIfTI volume is expected");
    EXPECT_EQ(ErrorOf([] { ReadVolume("/dev/zero"); }), "/dev/zero: it is no NIfTI file");
}

// A megabyte of zeros in a kilobyte: no more is unpacked than the header's voxels, a chunk at a time.
TEST(VolumeFile, PackedBytesAreUnpackedNoFurtherThanTheVoxelsGo) {
    NiftiFile bomb({512, 512, 512}, kUint8, 8);
    bomb.m_bytes.resize(1 << 20);
    ExpectError(Packed(bomb.m_bytes), "it is cut off: its voxels are incomplete");
    NiftiFile small({2, 2, 2}, kUint8, 8);
    small.m_bytes.resize(64 << 20);
    EXPECT_EQ(DecodeVolume(Packed(small.m_bytes), "v").voxels.size(), 8u);
}

TEST(VolumeFile, NaNAndInfinityAreZeroWhereThatIsAskedFor) {
    NiftiFile file({2, 1, 2}, kFloat, 32);
    file.Voxels<float>({1, INFINITY, -INFINITY, std::nanf("")}).Set(112, 2.0f).Set(116, 5.0f);
    EXPECT_EQ(Read(file, {.zeroesNotFinite = true}).voxels, std::vector<float>({7, 0, 0, 0}));
}

TEST(VolumeFile, Nifti2IsReadAsNifti1Is) {
    const std::vector<int16_t> voxels = {-32768, 32767, 1, 258, 5, 6};
    for (const bool isBigEndian : {false, true}) {
        Nifti2File file({3, 2, 1}, kInt16, 16, isBigEndian);
        file.Set(112, 0.5).Set(120, 2.0).Set(176, 0.5).Set(184, -10.0);
        file.Set<int64_t>(168, 560).Set<int32_t>(500, 1).Voxels<uint8_t>(std::vector<uint8_t>(16)).Voxels(voxels);
        for (const Bytes& bytes : {file.m_bytes, Packed(file.m_bytes)}) {
            const Volume volume = DecodeVolume(bytes, "v");
            EXPECT_EQ(volume.widthVoxels, 3u);
            EXPECT_EQ(volume.heightVoxels, 2u);
            EXPECT_EQ(volume.depthVoxels, 1u);
            EXPECT_EQ(volume.voxelMillimetres, glm::vec3(500, 2000, 1000));
            EXPECT_EQ(volume.voxels, std::vector<float>({-16394, 16373.5f, -9.5f, 119, -7.5f, -7}));
        }
    }
}

TEST(VolumeFile, TheFrameOfASeriesIsTheOneAskedFor) {
    for (const bool isPacked : {false, true}) {
        const Bytes file =
            NiftiFile({2, 1, 2, 3}, kInt16, 16).Voxels<int16_t>({1, 2, 3, 4, 11, 12, 13, 14, 21, 22, 23, 24}).m_bytes;
        const Bytes bytes = isPacked ? Packed(file) : file;
        for (uint64_t frame = 0; frame < 3; frame++) {
            const Volume volume = DecodeVolume(bytes, "v", {.frame = frame});
            const auto first = static_cast<float>(10 * frame + 1);
            EXPECT_EQ(volume.voxels, std::vector<float>({first, first + 1, first + 2, first + 3}));
            EXPECT_EQ(volume.framesInFile, 3u);
            EXPECT_TRUE(volume.what.ends_with(fmt::format("; volume {} of 0 to 2", frame))) << volume.what;
        }
        EXPECT_EQ(DecodeVolume(bytes, "v").voxels, std::vector<float>({1, 2, 3, 4}));
        EXPECT_EQ(ErrorOf([&] { DecodeVolume(bytes, "v", {.frame = 3}); }),
                  "v: it holds 3 volumes; there is no volume 3, the first being 0");
        EXPECT_THROW(DecodeVolume(bytes, "v", {.frame = ~uint64_t{0}}), UsageError);
        EXPECT_EQ(ErrorOf([&] { DecodeVolume(bytes, "v", {.frame = 2}, {.maxSkippedBytes = 15}); }),
                  "v: volume 2 lies 0.0 GiB after the first; at most 0.0 are passed over");
    }
    EXPECT_EQ(ErrorOf([&] { Read(NiftiFile({1}, kUint8, 8).Voxels<uint8_t>({7}), {.frame = 1}); }),
              "v.nii: it holds 1 volume; there is no volume 1, the first being 0");
    const Nifti2File endless({2, 2, 2, int64_t{1} << 60}, kUint8, 8);
    EXPECT_EQ(ErrorOf([&] { Read(endless, {.frame = uint64_t{1} << 59}); }),
              "v.nii: volume 576460752303423488 lies 4294967296.0 GiB after the first; at most 8.0 are passed over");
}

// The pair is found by either name, packed or not, in both versions of the format.
TEST(VolumeFile, PairsAreReadByTheNameOfEither) {
    const std::vector<int16_t> voxels = {1, 2, 3, 4};
    const Bytes first = NiftiFile({2, 1, 2}, kInt16, 16).Set(108, 4.0f).Set(344, uint32_t{0x0031696e}).m_bytes;
    const Bytes second = Nifti2File({2, 1, 2}, kInt16, 16).Set<int64_t>(168, 4).Set<uint8_t>(5, 'i').m_bytes;
    const Bytes image = BinaryFile(4).Voxels(voxels).m_bytes;
    const std::vector<float> expected(voxels.begin(), voxels.end());
    for (const Bytes& header : {first, second, Bytes(first.begin(), first.begin() + 348)})
        for (const std::string headerEnding : {".hdr", ".hdr.gz"})
            for (const std::string imageEnding : {".img", ".img.gz"}) {
                const TemporaryFolder folder;
                const auto put = [&](const std::string& ending, const Bytes& bytes) {
                    return folder.Put("a.b" + ending, ending.ends_with("gz") ? Packed(bytes) : bytes);
                };
                const std::string headerPath = put(headerEnding, header);
                EXPECT_EQ(ErrorOf([&] { ReadVolume(headerPath); }),
                          headerPath + ": it is one of a pair of files .hdr and .img, and the .img is not beside it");
                const std::string imagePath = put(imageEnding, image);
                EXPECT_EQ(ReadVolume(headerPath).voxels, expected);
                EXPECT_EQ(ReadVolume(imagePath).voxels, expected);
                put(imageEnding, Bytes(image.begin(), image.end() - 1));
                EXPECT_EQ(ErrorOf([&] { ReadVolume(headerPath); }),
                          headerPath + ": it is cut off: its voxels are incomplete");
            }
    const TemporaryFolder folder;
    const std::string alone = folder.Put("v.img", image);
    EXPECT_EQ(ErrorOf([&] { ReadVolume(alone); }), alone + ": it is no NIfTI file");
}

Bytes Joined(const std::vector<Bytes>& parts) {
    Bytes whole;
    for (const Bytes& part : parts)
        whole.insert(whole.end(), part.begin(), part.end());
    return whole;
}

TEST(VolumeFile, PackedFilesMayHaveSeveralMembers) {
    std::vector<int16_t> voxels(60);
    for (size_t i = 0; i < voxels.size(); i++)
        voxels[i] = static_cast<int16_t>(i * 331);
    const Bytes file = NiftiFile({3, 4, 5}, kInt16, 16).Voxels(voxels).m_bytes;
    const std::vector<float> expected(voxels.begin(), voxels.end());
    for (const size_t memberBytes : {1, 7, 348, 400}) {
        std::vector<Bytes> members;
        for (size_t at = 0; at < file.size(); at += memberBytes)
            members.push_back(Packed(ByteView(file).subspan(at, std::min(memberBytes, file.size() - at))));
        members.push_back(Packed({}));  // as bgzip ends
        EXPECT_EQ(DecodeVolume(Joined(members), "v").voxels, expected) << memberBytes;
        members.push_back({0, 0, 0, 7});  // which gzip does not read
        EXPECT_EQ(DecodeVolume(Joined(members), "v").voxels, expected) << memberBytes;
        const Bytes packed = Joined({members.begin(), members.end() - 2});
        for (size_t length = 0; length < packed.size(); length++)
            EXPECT_FALSE(ErrorOf([&] { DecodeVolume(ByteView(packed).first(length), "v"); }).empty()) << length;
    }
    // A later member is as damaged as the first may be.
    const Bytes first = Packed(ByteView(file).first(380)), second = Packed(ByteView(file).subspan(380));
    Bytes damaged = Joined({first, second});
    damaged[damaged.size() - 6] ^= 1;
    ExpectError(damaged, "it is damaged: its packed bytes contradict themselves");
    ExpectError(Joined({first, {0x1f, 0x8b, 9, 9, 9, 9}}), "it is damaged: its packed bytes contradict themselves");
}

// Cut anywhere: the whole volume, or one line.
TEST(VolumeFile, CutOffFilesAreRefused) {
    std::vector<int16_t> voxels(60);
    for (size_t i = 0; i < voxels.size(); i++)
        voxels[i] = static_cast<int16_t>(i * 331);
    const Bytes whole = NiftiFile({3, 4, 5}, kInt16, 16).Voxels(voxels).m_bytes;
    for (size_t length = 0; length < whole.size(); length += length < 340 ? 7 : 1)
        EXPECT_FALSE(ErrorOf([&] { DecodeVolume(ByteView(whole).first(length), "v"); }).empty()) << length;
    const Bytes packed = Packed(whole);
    for (size_t length = 0; length < packed.size(); length++)
        EXPECT_FALSE(ErrorOf([&] { DecodeVolume(ByteView(packed).first(length), "v"); }).empty()) << length;
}

TEST(VolumeFile, DamagedFilesAreReadOrRefusedInOneLine) {
    std::mt19937 random(1);
    std::vector<float> voxels(60, 2.5f);
    const Bytes whole = NiftiFile({3, 4, 5}, kFloat, 32).Voxels(voxels).m_bytes;
    const Bytes second = Nifti2File({3, 4, 5}, kFloat, 32).Voxels(voxels).m_bytes;
    for (const Bytes& file : {whole, Packed(whole), second})
        for (int i = 0; i < 500; i++) {
            Bytes damaged = file;
            for (int flips = 0; flips < 1 + i % 3; flips++)
                damaged[random() % std::min<size_t>(damaged.size(), 560)] ^= static_cast<uint8_t>(1u << random() % 8);
            try {
                const Volume volume = DecodeVolume(damaged, "v");
                EXPECT_EQ(volume.voxels.size(),
                          size_t{volume.widthVoxels} * volume.heightVoxels * volume.depthVoxels);
            } catch (const Error& error) {
                EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
            }
        }
    // Packed bytes that still unpack have a checksum.
    Bytes damaged = Packed(whole);
    damaged[damaged.size() - 6] ^= 1;
    ExpectError(damaged, "it is damaged: its packed bytes contradict themselves");
}

}  // namespace
}  // namespace boxcar::test
