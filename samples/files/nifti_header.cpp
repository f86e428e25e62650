#include "samples/files/nifti_header.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <optional>
#include <string_view>

#include "tools/base/error.h"

namespace boxcar {
namespace {

static_assert(sizeof(nifti_1_header) == 348 && sizeof(nifti_2_header) == 540);

constexpr size_t kExtensionBytes = 4;  // they tell of extensions
constexpr int64_t kLargestOffsetBytes = 1'000'000'000;
constexpr double kLeastTurn = 1e-4, kLeastShear = 1e-3, kFlat = 1e-6;

// The fields that are read, of either version.
template <typename Fields>
nifti_2_header Widened(const Fields& fields) {
    nifti_2_header wide = {};
    wide.sizeof_hdr = fields.sizeof_hdr;
    wide.datatype = fields.datatype;
    wide.bitpix = fields.bitpix;
    std::ranges::copy(fields.dim, wide.dim);
    std::ranges::copy(fields.pixdim, wide.pixdim);
    wide.scl_slope = fields.scl_slope;
    wide.scl_inter = fields.scl_inter;
    wide.xyzt_units = fields.xyzt_units;
    wide.qform_code = fields.qform_code;
    wide.sform_code = fields.sform_code;
    wide.quatern_b = fields.quatern_b;
    wide.quatern_c = fields.quatern_c;
    wide.quatern_d = fields.quatern_d;
    std::ranges::copy(fields.srow_x, wide.srow_x);
    std::ranges::copy(fields.srow_y, wide.srow_y);
    std::ranges::copy(fields.srow_z, wide.srow_z);
    const auto offset = static_cast<double>(fields.vox_offset);
    if (!(offset >= 0 && offset < kLargestOffsetBytes && offset == std::floor(offset)))
        throw Error("its voxels begin at byte {:g}; {} or more is expected", offset,
                    static_cast<size_t>(fields.sizeof_hdr) + kExtensionBytes);
    wide.vox_offset = static_cast<int64_t>(offset);
    return wide;
}

template <typename Fields>
NiftiHeader ReadFields(Unpacker& source, ByteView start, bool isSwapped) {
    constexpr int kVersion = sizeof(Fields) == sizeof(nifti_1_header) ? 1 : 2;
    uint8_t bytes[sizeof(Fields)];
    std::ranges::copy(start, bytes);
    if (source.Read(std::span(bytes).subspan(start.size())) + start.size() < sizeof(bytes))
        throw Error("it is too short for a NIfTI-{} volume", kVersion);
    Fields fields;
    std::memcpy(&fields, bytes, sizeof(fields));
    const std::string_view magic(fields.magic, sizeof(fields.magic));
    const std::string_view end = kVersion == 1 ? std::string_view("\0", 1) : std::string_view("\0\r\n\032\n", 5);
    const auto number = static_cast<char>('0' + kVersion);
    const bool isPair = magic == std::string("ni") + number + std::string(end);
    if (!isPair && magic != std::string("n+") + number + std::string(end)) {
        if (kVersion == 1 && magic == std::string_view("\0\0\0\0", 4))
            throw Error("it is an Analyze file, which does not say where left is; NIfTI is expected");
        throw Error("it is no NIfTI-{} file", kVersion);
    }
    if (isSwapped) swap_nifti_header(&fields, kVersion);
    return {Widened(fields), isSwapped, isPair};
}

// Where the file's x, y, z axes go a voxel further, in the file's unit.
struct Affine {
    glm::dmat3 steps;
    const char* name;
};

bool IsSolid(const glm::dmat3& steps) {
    glm::dmat3 unit = steps;
    for (int i = 0; i < 3; i++) {
        const double length = glm::length(steps[i]);
        if (!std::isfinite(length) || length == 0) return false;
        unit[i] /= length;
    }
    return std::abs(glm::determinant(unit)) > kFlat;
}

std::optional<Affine> SformOf(const nifti_2_header& fields) {
    if (fields.sform_code <= 0) return {};
    glm::dmat3 steps;
    for (int i = 0; i < 3; i++)
        steps[i] = {fields.srow_x[i], fields.srow_y[i], fields.srow_z[i]};
    if (!IsSolid(steps)) return {};
    return Affine{steps, "sform"};
}

glm::dvec3 SidesOf(const nifti_2_header& fields) {
    return {std::abs(fields.pixdim[1]), std::abs(fields.pixdim[2]), std::abs(fields.pixdim[3])};
}

std::optional<Affine> QformOf(const nifti_2_header& fields) {
    if (fields.qform_code <= 0) return {};
    const double hand = fields.pixdim[0] < 0 ? -1 : 1;
    const nifti_dmat44 rotation =
        nifti_quatern_to_dmat44(fields.quatern_b, fields.quatern_c, fields.quatern_d, 0, 0, 0, 1, 1, 1, hand);
    glm::dmat3 steps;
    for (int i = 0; i < 3; i++)
        steps[i] = {rotation.m[0][i], rotation.m[1][i], rotation.m[2][i]};
    if (!IsSolid(steps)) return {};
    return Affine{steps, "qform"};
}

nifti_dmat33 Rows(const glm::dmat3& matrix) {
    nifti_dmat33 rows;
    for (int row = 0; row < 3; row++)
        for (int column = 0; column < 3; column++)
            rows.m[row][column] = matrix[column][row];
    return rows;
}

glm::dmat3 NearestRotation(const glm::dmat3& matrix) {
    const nifti_dmat33 rows = nifti_dmat33_polar(Rows(matrix));
    glm::dmat3 rotation;
    for (int row = 0; row < 3; row++)
        for (int column = 0; column < 3; column++)
            rotation[column][row] = rows.m[row][column];
    return rotation;
}

double LargestDifference(const glm::dmat3& a, const glm::dmat3& b) {
    double largest = 0;
    for (int column = 0; column < 3; column++)
        for (int row = 0; row < 3; row++)
            largest = std::max(largest, std::abs(a[column][row] - b[column][row]));
    return largest;
}

// The directions that the file's axes run in, as the codes of nearest sides.
std::array<int, 3> CodesOf(const glm::dmat3& unit) {
    const nifti_dmat33 rows = Rows(unit);
    nifti_dmat44 matrix = {};
    for (int row = 0; row < 3; row++)
        std::copy_n(rows.m[row], 3, matrix.m[row]);
    std::array<int, 3> codes;
    nifti_dmat44_to_orientation(matrix, &codes[0], &codes[1], &codes[2]);
    return codes;
}

}  // namespace

NiftiStart StartOf(ByteView start) {
    int32_t bytes = 0;
    if (start.size() < sizeof(bytes)) throw Error("it is too short for a NIfTI volume");
    if (start[0] == '#' && start[1] == '?') throw Error("it is a Radiance picture; a NIfTI volume is expected");
    std::memcpy(&bytes, start.data(), sizeof(bytes));
    for (const bool isSwapped : {false, true}) {
        if (isSwapped) nifti_swap_Nbytes(1, sizeof(bytes), &bytes);
        if (bytes == sizeof(nifti_1_header) || bytes == sizeof(nifti_2_header))
            return {static_cast<size_t>(bytes), isSwapped};
    }
    throw Error("it is no NIfTI file");
}

NiftiHeader ReadNiftiHeader(Unpacker& source) {
    nifti_set_debug_level(0);
    uint8_t bytes[4];
    const ByteView start = ByteView(bytes).first(source.Read(bytes));
    const auto [headerBytes, isSwapped] = StartOf(start);
    return headerBytes == sizeof(nifti_1_header) ? ReadFields<nifti_1_header>(source, start, isSwapped)
                                                 : ReadFields<nifti_2_header>(source, start, isSwapped);
}

uint64_t BytesBeforeVoxels(const NiftiHeader& header) {
    const auto offset = static_cast<uint64_t>(header.fields.vox_offset);
    if (header.isPair) return offset;
    const auto headerBytes = static_cast<uint64_t>(header.fields.sizeof_hdr);
    if (offset == 0) return kExtensionBytes;
    if (offset < headerBytes + kExtensionBytes)
        throw Error("its voxels begin at byte {}; {} or more is expected", offset, headerBytes + kExtensionBytes);
    return offset - headerBytes;
}

NiftiAxes AxesOf(const nifti_2_header& fields) {
    NiftiAxes axes;
    axes.sides = SidesOf(fields);
    std::optional<Affine> affine = SformOf(fields);
    if (affine)
        for (int i = 0; i < 3; i++)
            axes.sides[i] = glm::length(affine->steps[i]);
    else
        affine = QformOf(fields);
    if (!affine) {
        axes.what = "voxel sizes alone, no orientation";
        return axes;
    }
    glm::dmat3 unit;
    for (int i = 0; i < 3; i++)
        unit[i] = glm::normalize(affine->steps[i]);
    const std::array<int, 3> codes = CodesOf(unit);  // 1 right, 2 left, 3 front, 4 back, 5 up, 6 down
    const glm::dvec3 storedSides = axes.sides;
    glm::dmat3 along;
    for (int i = 0; i < 3; i++) {
        const int code = codes[static_cast<size_t>(i)], world = (code - 1) / 2;
        const bool isReversed = code % 2 == 0;
        axes.stored[static_cast<size_t>(world)] = i;
        axes.isReversed[static_cast<size_t>(world)] = isReversed;
        axes.sides[world] = storedSides[i];
        along[world] = isReversed ? -unit[i] : unit[i];
    }
    axes.what =
        fmt::format("{}, stored {}{}{}", affine->name, "-RLAPSI"[codes[0]], "-RLAPSI"[codes[1]], "-RLAPSI"[codes[2]]);
    if (LargestDifference(along, glm::dmat3(1)) > kLeastTurn) {
        const glm::dmat3 rotation = NearestRotation(along);
        axes.turn = rotation;
        const double cosine = (rotation[0][0] + rotation[1][1] + rotation[2][2] - 1) / 2;
        axes.what +=
            fmt::format(", turned by {:.2f} degrees", glm::degrees(std::acos(std::clamp(cosine, -1.0, 1.0))));
        axes.hasShear = LargestDifference(along, rotation) > kLeastShear;
        if (axes.hasShear) axes.what += ", without its shear";
    }
    return axes;
}

}  // namespace boxcar
