// NIfTI files by hand, whole and damaged.
#include "samples/files/volume.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <random>

#include "tests/files/support.h"

namespace boxcar::test {
namespace {

constexpr int kUint8 = 2, kInt16 = 4, kInt32 = 8, kFloat = 16, kComplex = 32, kDouble = 64, kRgb = 128, kInt8 = 256,
              kUint16 = 512, kUint32 = 768, kInt64 = 1024, kUint64 = 1280;

// The header's fields at the offsets of the format's definition.
class NiftiFile {
public:
    NiftiFile(std::vector<int16_t> dims, int16_t type, int16_t bits, bool isBigEndian = false)
        : m_isBigEndian(isBigEndian) {
        m_bytes.resize(352);
        Set<int32_t>(0, 348);
        Set(40, static_cast<int16_t>(dims.size()));
        for (size_t i = 0; i < dims.size(); i++)
            Set(42 + 2 * i, dims[i]);
        Set(70, type);
        Set(72, bits);
        for (size_t i = 0; i < 3; i++)
            Set(80 + 4 * i, 1.0f);
        Set(108, 352.0f);
        Set<uint8_t>(123, 2);  // millimetres
        std::memcpy(&m_bytes[344], "n+1", 3);
    }

    template <typename T>
    NiftiFile& Set(size_t offset, T value) {
        auto bytes = std::bit_cast<std::array<uint8_t, sizeof(T)>>(value);
        if (m_isBigEndian) std::ranges::reverse(bytes);
        if (m_bytes.size() < offset + sizeof(T)) m_bytes.resize(offset + sizeof(T));
        std::ranges::copy(bytes, m_bytes.begin() + static_cast<std::ptrdiff_t>(offset));
        return *this;
    }

    template <typename T>
    NiftiFile& Voxels(const std::vector<T>& voxels) {
        for (const T voxel : voxels)
            Set(m_bytes.size(), voxel);
        return *this;
    }

    Bytes m_bytes;

private:
    bool m_isBigEndian;
};

Bytes Packed(const Bytes& bytes) {
    Bytes packed(bytes.size() + bytes.size() / 100 + 1024);
    z_stream stream = {};
    deflateInit2(&stream, 6, Z_DEFLATED, 16 + MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
    stream.next_in = const_cast<uint8_t*>(bytes.data());
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = packed.data();
    stream.avail_out = static_cast<uInt>(packed.size());
    EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    return packed;
}

Volume Read(const NiftiFile& file) {
    return DecodeVolume(file.m_bytes, "v.nii");
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
    ExpectError({}, "it is too short for a NIfTI-1 volume");
    ExpectError(ToBytes(std::string(400, 'x')), "it is no NIfTI-1 file");
    ExpectError(small().Set(344, uint32_t{0x0031696e}).m_bytes,
                "it is one of a pair of files .hdr and .img; one file .nii is expected");
    ExpectError(small().Set(0, 540).m_bytes, "it is a NIfTI-2 file; NIfTI-1 is expected");
    ExpectError(small().Set<int16_t>(40, 0).m_bytes, "it has 0 dimensions; 3 are expected");
    ExpectError(small().Set<int16_t>(44, -2).m_bytes, "its dimension 2 is -2; 1 or more is expected");
    ExpectError(NiftiFile({2, 2, 2, 5}, kUint8, 8).m_bytes, "its dimension 4 is 5: several volumes; one is expected");
    ExpectError(NiftiFile({2, 2, 2, 1, 3}, kUint8, 8).m_bytes,
                "its dimension 5 is 3: several volumes; one is expected");
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
                "voxel (1, 0, 1) is nan; finite numbers are expected");
    ExpectError(NiftiFile({1}, kDouble, 64).Voxels<double>({1e300}).m_bytes,
                "voxel (0, 0, 0) is inf; finite numbers are expected");
    const TemporaryFolder folder;
    EXPECT_EQ(ErrorOf([&] { ReadVolume(folder.Path("none.nii")); }),
              folder.Path("none.nii") + ": cannot be read: No such file or directory");
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
    for (const Bytes& file : {whole, Packed(whole)})
        for (int i = 0; i < 500; i++) {
            Bytes damaged = file;
            for (int flips = 0; flips < 1 + i % 3; flips++)
                damaged[random() % std::min<size_t>(damaged.size(), 400)] ^= static_cast<uint8_t>(1u << random() % 8);
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
