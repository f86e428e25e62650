#include "samples/files/volume.h"

#include <nifti1_io.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <new>

#include "samples/files/bytes.h"
#include "tools/layout/error.h"

namespace boxcar {
namespace {

constexpr size_t kHeaderBytes = 348;
constexpr uint32_t kOffsetBytes = 352;   // of the voxels, at the least: four bytes tell of extensions
constexpr size_t kChunkBytes = 1 << 16;  // a whole number of voxels of any type
constexpr double kLeastMillimetres = 1e-6, kLargestMillimetres = 1e6;

// The file's bytes one after the other, out of gzip's if that is what it is. Never unpacks more than it is asked for.
class Source {
public:
    explicit Source(ByteView file) : m_file(file), m_isPacked(file.size() > 1 && file[0] == 0x1f && file[1] == 0x8b) {
        if (!m_isPacked) return;
        m_stream.next_in = const_cast<uint8_t*>(file.data());
        m_stream.avail_in = static_cast<uInt>(file.size());
        constexpr int kGzip = 16 + MAX_WBITS;
        if (inflateInit2(&m_stream, kGzip) != Z_OK) throw std::bad_alloc();
    }
    ~Source() {
        if (m_isPacked) inflateEnd(&m_stream);
    }
    Source(const Source&) = delete;

    // Returns how many bytes there were: fewer than were asked for at the end.
    size_t Read(std::span<uint8_t> bytes) {
        if (!m_isPacked) {
            const size_t count = std::min(bytes.size(), m_file.size());
            std::copy_n(m_file.begin(), count, bytes.begin());
            m_file = m_file.subspan(count);
            return count;
        }
        m_stream.next_out = bytes.data();
        m_stream.avail_out = static_cast<uInt>(bytes.size());
        while (m_stream.avail_out > 0 && !m_isAtEnd) {
            const int result = inflate(&m_stream, Z_NO_FLUSH);
            m_isCut = result == Z_BUF_ERROR;
            m_isAtEnd = result == Z_STREAM_END || m_isCut;
            if (!m_isAtEnd && result != Z_OK) throw Error("it is damaged: its packed bytes contradict themselves");
        }
        return bytes.size() - m_stream.avail_out;
    }

    void ReadAll(std::span<uint8_t> bytes, const char* what) {
        if (Read(bytes) < bytes.size()) throw Error("it is cut off: its {} are incomplete", what);
    }

    // Reads on to where gzip holds the checksum, if that is within a megabyte.
    void Finish() {
        std::vector<uint8_t> rest(kChunkBytes);
        for (int i = 0; i < 16 && Read(rest) == rest.size(); i++) {
        }
        if (m_isCut) throw Error("it is cut off: its packed bytes have no end");
    }

private:
    ByteView m_file;
    bool m_isPacked;
    bool m_isAtEnd = false;
    bool m_isCut = false;
    z_stream m_stream = {};
};

struct Header {
    nifti_1_header fields;
    bool isSwapped;
};

Header ReadHeader(Source& source) {
    Header header;
    uint8_t bytes[kHeaderBytes];
    static_assert(sizeof(header.fields) == sizeof(bytes));
    if (source.Read(bytes) < sizeof(bytes)) throw Error("it is too short for a NIfTI-1 volume");
    std::memcpy(&header.fields, bytes, sizeof(bytes));
    int size = header.fields.sizeof_hdr;
    const std::string_view magic(header.fields.magic, 4);
    nifti_swap_Nbytes(1, 4, &size);
    header.isSwapped = size == kHeaderBytes;
    constexpr int kNifti2Bytes = 540;
    if (size == kNifti2Bytes || header.fields.sizeof_hdr == kNifti2Bytes)
        throw Error("it is a NIfTI-2 file; NIfTI-1 is expected");
    if (magic == std::string_view("ni1\0", 4))
        throw Error("it is one of a pair of files .hdr and .img; one file .nii is expected");
    if ((!header.isSwapped && header.fields.sizeof_hdr != kHeaderBytes) || magic != std::string_view("n+1\0", 4))
        throw Error("it is no NIfTI-1 file");
    if (header.isSwapped) swap_nifti_header(&header.fields, 1);
    return header;
}

// Extent and lengths; no voxels yet.
Volume VolumeOf(const nifti_1_header& header, const VolumeLimits& limits) {
    const int dimensions = header.dim[0];
    if (dimensions < 1 || dimensions > 7) throw Error("it has {} dimensions; 3 are expected", dimensions);
    uint32_t extent[3] = {1, 1, 1};
    uint64_t voxels = 1;
    for (int i = 1; i <= dimensions; i++) {
        if (header.dim[i] < 1) throw Error("its dimension {} is {}; 1 or more is expected", i, header.dim[i]);
        if (i > 3 && header.dim[i] > 1)
            throw Error("its dimension {} is {}: several volumes; one is expected", i, header.dim[i]);
        if (i > 3) continue;
        extent[i - 1] = static_cast<uint32_t>(header.dim[i]);
        voxels *= extent[i - 1];
        if (extent[i - 1] > limits.maxSideVoxels)
            throw Error("its dimension {} is {}; at most {} is read", i, header.dim[i], limits.maxSideVoxels);
    }
    if (voxels > limits.maxVoxels) throw Error("{} voxels; at most {} are read", voxels, limits.maxVoxels);

    Volume volume{extent[0], extent[1], extent[2], glm::vec3(1), {}};
    const int unit = XYZT_TO_SPACE(header.xyzt_units);
    const double scale = unit == NIFTI_UNITS_METER ? 1e3 : unit == NIFTI_UNITS_MICRON ? 1e-3 : 1;
    for (int i = 0; i < 3; i++) {
        const double side = scale * std::abs(header.pixdim[i + 1]);
        const bool isNeedless = extent[i] == 1 && !(side > 0);
        if (!isNeedless && !(side >= kLeastMillimetres && side <= kLargestMillimetres))
            throw Error("voxels of {:g} millimetres along axis {}; {:g} to {:g} are expected", side, i + 1,
                        kLeastMillimetres, kLargestMillimetres);
        if (!isNeedless) volume.voxelMillimetres[i] = static_cast<float>(side);
    }
    return volume;
}

template <typename T>
void Append(std::span<const uint8_t> bytes, std::vector<double>& values) {
    for (size_t i = 0; i < bytes.size(); i += sizeof(T)) {
        T value;
        std::memcpy(&value, &bytes[i], sizeof(T));
        values.push_back(static_cast<double>(value));
    }
}

using Decoder = void (*)(std::span<const uint8_t>, std::vector<double>&);

Decoder DecoderOf(int type) {
    switch (type) {
        case DT_UINT8: return Append<uint8_t>;
        case DT_INT8: return Append<int8_t>;
        case DT_INT16: return Append<int16_t>;
        case DT_UINT16: return Append<uint16_t>;
        case DT_INT32: return Append<int32_t>;
        case DT_UINT32: return Append<uint32_t>;
        case DT_INT64: return Append<int64_t>;
        case DT_UINT64: return Append<uint64_t>;
        case DT_FLOAT32: return Append<float>;
        case DT_FLOAT64: return Append<double>;
        default: break;
    }
    throw Error("voxels of type {} ({}); whole numbers and floats are read", nifti_datatype_string(type), type);
}

void SkipToVoxels(Source& source, const nifti_1_header& header) {
    const float offset = header.vox_offset;
    if (offset != 0 && !(offset >= kOffsetBytes && offset < 1e9f && offset == std::floor(offset)))
        throw Error("its voxels begin at byte {:g}; {} or more is expected", offset, kOffsetBytes);
    std::vector<uint8_t> skipped(kChunkBytes);
    for (size_t left = std::max(static_cast<uint32_t>(offset), kOffsetBytes) - kHeaderBytes; left > 0;) {
        const size_t count = std::min(left, skipped.size());
        source.ReadAll(std::span(skipped).first(count), "extensions");
        left -= count;
    }
}

void ReadVoxels(Source& source, const Header& header, Volume& volume) {
    const Decoder append = DecoderOf(header.fields.datatype);
    int voxelBytes = 0, swapBytes = 0;
    nifti_datatype_sizes(header.fields.datatype, &voxelBytes, &swapBytes);
    if (header.fields.bitpix != 8 * voxelBytes)
        throw Error("it is damaged: {} bits a voxel of type {}", header.fields.bitpix,
                    nifti_datatype_string(header.fields.datatype));
    SkipToVoxels(source, header.fields);
    const bool isScaled = std::isfinite(header.fields.scl_slope) && header.fields.scl_slope != 0 &&
                          std::isfinite(header.fields.scl_inter);
    const double slope = isScaled ? header.fields.scl_slope : 1, shift = isScaled ? header.fields.scl_inter : 0;

    const size_t count = size_t{volume.widthVoxels} * volume.heightVoxels * volume.depthVoxels;
    std::vector<uint8_t> bytes;
    std::vector<double> values;
    while (volume.voxels.size() < count) {
        bytes.resize(std::min(kChunkBytes, (count - volume.voxels.size()) * static_cast<size_t>(voxelBytes)));
        source.ReadAll(bytes, "voxels");
        if (header.isSwapped && swapBytes > 1)
            nifti_swap_Nbytes(bytes.size() / static_cast<size_t>(swapBytes), swapBytes, bytes.data());
        values.clear();
        append(bytes, values);
        for (const double value : values) {
            const auto voxel = static_cast<float>(slope * value + shift);
            const size_t at = volume.voxels.size();
            if (!std::isfinite(voxel))
                throw Error("voxel ({}, {}, {}) is {}; finite numbers are expected", at % volume.widthVoxels,
                            at / volume.widthVoxels % volume.heightVoxels,
                            at / volume.widthVoxels / volume.heightVoxels, voxel);
            volume.voxels.push_back(voxel);
        }
    }
    source.Finish();
}

}  // namespace

Volume ReadVolume(const std::string& path, const VolumeLimits& limits) {
    const auto checkStart = [&](ByteView start) {
        if (start.empty()) throw Error("{}: the file is empty; a NIfTI-1 volume is expected", InputName(path));
    };
    return DecodeVolume(ReadBytes(path, limits.maxBytes, checkStart), InputName(path), limits);
}

// The library reads files by their names only, prints what it finds wrong and takes what memory a header asks for: so
// it tells of the format here, and the bytes are read by Source.
Volume DecodeVolume(std::span<const uint8_t> file, const std::string& name, const VolumeLimits& limits) {
    try {
        nifti_set_debug_level(0);
        Source source(file);
        const Header header = ReadHeader(source);
        Volume volume = VolumeOf(header.fields, limits);
        ReadVoxels(source, header, volume);
        return volume;
    } catch (const std::bad_alloc&) {
        throw Error("{}: there is not enough memory to read it", name);
    } catch (const Error& error) {
        throw Error("{}: {}", name, error.what());
    }
}

}  // namespace boxcar
