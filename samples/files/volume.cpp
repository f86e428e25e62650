#include "samples/files/volume.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <new>
#include <optional>

#include "samples/files/nifti_header.h"
#include "tools/base/error.h"

namespace boxcar {
namespace {

constexpr size_t kChunkBytes = 1 << 16;  // a whole number of voxels of any type
constexpr double kLeastMillimetres = 1e-6, kLargestMillimetres = 1e6;

using Extent = std::array<uint32_t, 3>;

// Along the file's axes.
Extent ExtentOf(const nifti_2_header& header, const VolumeLimits& limits) {
    const int64_t dimensions = header.dim[0];
    if (dimensions < 1 || dimensions > 7) throw Error("it has {} dimensions; 3 are expected", dimensions);
    Extent extent = {1, 1, 1};
    uint64_t voxels = 1;
    for (int i = 1; i <= dimensions; i++) {
        if (header.dim[i] < 1) throw Error("its dimension {} is {}; 1 or more is expected", i, header.dim[i]);
        if (i > 4 && header.dim[i] > 1)
            throw Error("its dimension {} is {}: several numbers a voxel; one is expected", i, header.dim[i]);
        if (i > 3) continue;
        if (header.dim[i] > limits.maxSideVoxels)
            throw Error("its dimension {} is {}; at most {} is read", i, header.dim[i], limits.maxSideVoxels);
        extent[static_cast<size_t>(i - 1)] = static_cast<uint32_t>(header.dim[i]);
        voxels *= static_cast<uint64_t>(header.dim[i]);
    }
    if (voxels > limits.maxVoxels) throw Error("{} voxels; at most {} are read", voxels, limits.maxVoxels);
    return extent;
}

size_t VoxelsIn(const Extent& extent) {
    return size_t{extent[0]} * extent[1] * extent[2];
}

// Extent, lengths and axes; no voxels yet.
Volume VolumeOf(const nifti_2_header& header, const NiftiAxes& axes, const Extent& stored) {
    Volume volume;
    uint32_t* const extent[] = {&volume.widthVoxels, &volume.heightVoxels, &volume.depthVoxels};
    const int unit = XYZT_TO_SPACE(header.xyzt_units);
    const double scale = unit == NIFTI_UNITS_METER ? 1e3 : unit == NIFTI_UNITS_MICRON ? 1e-3 : 1;
    for (int i = 0; i < 3; i++) {
        const int axis = axes.stored[static_cast<size_t>(i)];
        *extent[i] = stored[static_cast<size_t>(axis)];
        const double side = scale * axes.sides[i];
        const bool isNeedless = *extent[i] == 1 && !(side > 0);
        if (!isNeedless && !(side >= kLeastMillimetres && side <= kLargestMillimetres))
            throw Error("voxels of {:g} millimetres along axis {}; {:g} to {:g} are expected", side, axis + 1,
                        kLeastMillimetres, kLargestMillimetres);
        if (!isNeedless) volume.voxelMillimetres[i] = static_cast<float>(side);
    }
    volume.worldFromAxes = axes.turn;
    volume.hasShear = axes.hasShear;
    if (header.dim[0] >= 4) volume.framesInFile = static_cast<uint64_t>(header.dim[4]);
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

// Passes over the volumes before the frame.
void SkipToFrame(Unpacker& source, uint64_t frame, uint64_t frameBytes, const VolumeLimits& limits) {
    if (frame > limits.maxSkippedBytes / frameBytes)
        throw Error("volume {} lies {:.1f} GiB after the first; at most {:.1f} are passed over", frame,
                    static_cast<double>(frame) * static_cast<double>(frameBytes) / (1 << 30),
                    static_cast<double>(limits.maxSkippedBytes) / (1 << 30));
    source.Skip(frame * frameBytes, "voxels");
}

// As the file stores them.
std::vector<float> ReadVoxels(Unpacker& source, const NiftiHeader& header, const Extent& extent,
                              const VolumeReading& reading, const VolumeLimits& limits) {
    const nifti_2_header& fields = header.fields;
    const Decoder append = DecoderOf(fields.datatype);
    int voxelBytes = 0, swapBytes = 0;
    nifti_datatype_sizes(fields.datatype, &voxelBytes, &swapBytes);
    if (fields.bitpix != 8 * voxelBytes)
        throw Error("it is damaged: {} bits a voxel of type {}", fields.bitpix,
                    nifti_datatype_string(fields.datatype));
    const size_t count = VoxelsIn(extent);
    source.Skip(BytesBeforeVoxels(header), "extensions");
    SkipToFrame(source, reading.frame, count * static_cast<size_t>(voxelBytes), limits);
    const bool isScaled = std::isfinite(fields.scl_slope) && fields.scl_slope != 0 && std::isfinite(fields.scl_inter);
    const double slope = isScaled ? fields.scl_slope : 1, shift = isScaled ? fields.scl_inter : 0;

    std::vector<float> voxels;
    std::vector<uint8_t> bytes;
    std::vector<double> values;
    while (voxels.size() < count) {
        bytes.resize(std::min(kChunkBytes, (count - voxels.size()) * static_cast<size_t>(voxelBytes)));
        source.ReadAll(bytes, "voxels");
        if (header.isSwapped && swapBytes > 1)
            nifti_swap_Nbytes(static_cast<int64_t>(bytes.size()) / swapBytes, swapBytes, bytes.data());
        values.clear();
        append(bytes, values);
        for (const double value : values) {
            auto voxel = static_cast<float>(slope * value + shift);
            const size_t at = voxels.size();
            if (!std::isfinite(voxel)) {
                if (!reading.zeroesNotFinite)
                    throw Error("voxel ({}, {}, {}) is {}; finite numbers are expected, or --nan zero",
                                at % extent[0], at / extent[0] % extent[1], at / extent[0] / extent[1], voxel);
                voxel = 0;
            }
            voxels.push_back(voxel);
        }
    }
    source.Finish();
    return voxels;
}

// Along the world's axes.
std::vector<float> Moved(std::vector<float> stored, const Extent& extent, const NiftiAxes& axes) {
    if (axes.stored == std::array{0, 1, 2} && axes.isReversed == std::array<bool, 3>{}) return stored;
    const std::ptrdiff_t strides[] = {1, extent[0], std::ptrdiff_t{extent[0]} * extent[1]};
    std::ptrdiff_t first = 0, step[3];
    uint32_t count[3];
    for (size_t i = 0; i < 3; i++) {
        const auto axis = static_cast<size_t>(axes.stored[i]);
        count[i] = extent[axis];
        step[i] = axes.isReversed[i] ? -strides[axis] : strides[axis];
        if (axes.isReversed[i]) first += strides[axis] * (count[i] - 1);
    }
    std::vector<float> voxels;
    voxels.reserve(stored.size());
    for (uint32_t z = 0; z < count[2]; z++)
        for (uint32_t y = 0; y < count[1]; y++)
            for (uint32_t x = 0; x < count[0]; x++)
                voxels.push_back(stored[static_cast<size_t>(first + x * step[0] + y * step[1] + z * step[2])]);
    return voxels;
}

Volume Decode(const NiftiHeader& header, Unpacker& source, const VolumeReading& reading, const VolumeLimits& limits) {
    const Extent extent = ExtentOf(header.fields, limits);
    const NiftiAxes axes = AxesOf(header.fields);
    Volume volume = VolumeOf(header.fields, axes, extent);
    if (reading.frame >= volume.framesInFile)
        throw UsageError("it holds {} volume{}; there is no volume {}, the first being 0", volume.framesInFile,
                         volume.framesInFile == 1 ? "" : "s", reading.frame);
    volume.voxels = Moved(ReadVoxels(source, header, extent, reading, limits), extent, axes);
    const glm::vec3 sides = volume.voxelMillimetres;
    volume.what = fmt::format("{} x {} x {} voxels of {:g} x {:g} x {:g} mm; {}", volume.widthVoxels,
                              volume.heightVoxels, volume.depthVoxels, sides.x, sides.y, sides.z, axes.what);
    if (volume.framesInFile > 1)
        volume.what += fmt::format("; volume {} of 0 to {}", reading.frame, volume.framesInFile - 1);
    return volume;
}

// What the work throws, with the file's name before it.
template <typename Work>
auto Named(const std::string& name, Work work) {
    try {
        return work();
    } catch (const std::bad_alloc&) {
        throw Error("{}: there is not enough memory to read it", name);
    } catch (const UsageError& error) {
        throw UsageError("{}: {}", name, error.what());
    } catch (const Error& error) {
        throw Error("{}: {}", name, error.what());
    }
}

// The file beside `path` whose name ends in `ending` instead, packed or not.
std::optional<std::string> FileBeside(const std::string& path, const char* ending) {
    std::filesystem::path stem(path);
    if (stem.extension() == ".gz") stem.replace_extension();
    for (const char* packed : {"", ".gz"}) {
        const std::string beside = stem.replace_extension(ending).string() + packed;
        if (std::filesystem::is_regular_file(beside)) return beside;
    }
    return {};
}

// The header's file, where `path` is that of the voxels.
std::string HeaderPath(const std::string& path) {
    const bool isVoxels = path.ends_with(".img") || path.ends_with(".img.gz");
    return isVoxels ? FileBeside(path, ".hdr").value_or(path) : path;
}

Bytes ReadVoxelsFile(const std::string& headerPath, const std::string& path, const VolumeLimits& limits) {
    if (headerPath != path) return ReadBytes(path, limits.maxBytes, [](ByteView) {});
    const auto beside = path == "-" ? std::nullopt : FileBeside(path, ".img");
    if (!beside)
        throw Error("{}: it is one of a pair of files .hdr and .img, and the .img is not beside it", InputName(path));
    return ReadBytes(*beside, limits.maxBytes, [](ByteView) {});
}

}  // namespace

Volume ReadVolume(const std::string& path, const VolumeReading& reading, const VolumeLimits& limits) {
    const std::string headerPath = HeaderPath(path), name = InputName(headerPath);
    const auto checkStart = [&](ByteView start) {
        if (start.empty()) throw Error("{}: the file is empty; a NIfTI volume is expected", name);
        if (!IsPacked(start)) Named(name, [&] { return StartOf(start); });
    };
    const Bytes file = ReadBytes(headerPath, limits.maxBytes, checkStart);
    const bool isPair = Named(name, [&] {
        Unpacker source(file);
        return ReadNiftiHeader(source).isPair;
    });
    if (!isPair) return DecodeVolume(file, name, reading, limits);
    const Bytes voxels = ReadVoxelsFile(headerPath, path, limits);
    return Named(name, [&] {
        Unpacker header(file), source(voxels);
        return Decode(ReadNiftiHeader(header), source, reading, limits);
    });
}

// The library reads files by their names only, prints what it finds wrong and takes what memory a header asks for: so
// it tells of the format here, and the bytes are read by Unpacker.
Volume DecodeVolume(std::span<const uint8_t> file, const std::string& name, const VolumeReading& reading,
                    const VolumeLimits& limits) {
    return Named(name, [&] {
        Unpacker source(file);
        const NiftiHeader header = ReadNiftiHeader(source);
        if (header.isPair) throw Error("it is one of a pair of files .hdr and .img; one file .nii is expected");
        return Decode(header, source, reading, limits);
    });
}

}  // namespace boxcar
