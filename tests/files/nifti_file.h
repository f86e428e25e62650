// NIfTI files by hand, written at the offsets of the format's definitions.
#pragma once

#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <vector>

#include "tests/files/support.h"

namespace boxcar::test {

constexpr int16_t kUint8 = 2, kInt16 = 4, kInt32 = 8, kFloat = 16, kComplex = 32, kDouble = 64, kRgb = 128,
                  kInt8 = 256, kUint16 = 512, kUint32 = 768, kInt64 = 1024, kUint64 = 1280;

// Bytes at offsets, in either byte order.
class BinaryFile {
public:
    explicit BinaryFile(size_t bytes, bool isBigEndian = false) : m_bytes(bytes), m_isBigEndian(isBigEndian) {}

    template <typename T>
    BinaryFile& Set(size_t offset, T value) {
        auto bytes = std::bit_cast<std::array<uint8_t, sizeof(T)>>(value);
        if (m_isBigEndian) std::ranges::reverse(bytes);
        if (m_bytes.size() < offset + sizeof(T)) m_bytes.resize(offset + sizeof(T));
        std::ranges::copy(bytes, m_bytes.begin() + static_cast<std::ptrdiff_t>(offset));
        return *this;
    }

    template <typename T>
    BinaryFile& Voxels(const std::vector<T>& voxels) {
        for (const T voxel : voxels)
            Set(m_bytes.size(), voxel);
        return *this;
    }

    Bytes m_bytes;

private:
    bool m_isBigEndian;
};

// NIfTI-1: voxels of a millimetre, without an orientation.
class NiftiFile : public BinaryFile {
public:
    NiftiFile(std::vector<int16_t> dims, int16_t type, int16_t bits, bool isBigEndian = false)
        : BinaryFile(352, isBigEndian) {
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
};

// The same in NIfTI-2.
class Nifti2File : public BinaryFile {
public:
    Nifti2File(std::vector<int64_t> dims, int16_t type, int16_t bits, bool isBigEndian = false)
        : BinaryFile(544, isBigEndian) {
        Set<int32_t>(0, 540);
        std::memcpy(&m_bytes[4], "n+2\0\r\n\032\n", 8);
        Set(12, type);
        Set(14, bits);
        Set(16, static_cast<int64_t>(dims.size()));
        for (size_t i = 0; i < dims.size(); i++)
            Set(24 + 8 * i, dims[i]);
        for (size_t i = 0; i < 3; i++)
            Set(112 + 8 * i, 1.0);
        Set<int64_t>(168, 544);
        Set<int32_t>(500, 2);  // millimetres
    }
};

inline Bytes Packed(ByteView bytes) {
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

}  // namespace boxcar::test
