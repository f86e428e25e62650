#include "samples/files/mesh.h"

#include <tiny_obj_loader.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <string_view>
#include <unordered_map>

#include "samples/files/bytes.h"
#include "tools/base/error.h"

namespace boxcar {
namespace {

constexpr uint32_t kMaxCorners = 255;  // of a face: tinyobjloader counts them in a byte

// Takes what stands before the next of `ends` off `text`, and that one with it.
std::string_view Next(std::string_view& text, std::string_view ends) {
    const size_t end = text.find_first_of(ends);
    const std::string_view part = text.substr(0, end);
    text.remove_prefix(end == text.npos ? text.size() : end + 1);
    return part;
}

// Empty at the end of the line.
std::string_view NextWord(std::string_view& line) {
    std::string_view word;
    while (word.empty() && !line.empty())
        word = Next(line, " \t");
    return word;
}

// What a kind of lines holds so far.
struct Known {
    const char* one;
    const char* several;
    uint32_t count = 0;
    uint64_t missedInLine = 0;  // the first line that had an index where there was none yet
    int64_t missedIndex = 0;
};

// Looks through the text before tinyobjloader does, which takes what is no number for 0, only warns of indices out of
// range, knows no continued lines and no comments behind numbers, and gives tags as much memory as they ask for. So
// it is handed the lines that have been looked at, no others, each in one piece and with the indices that it has.
class Checker {
public:
    explicit Checker(const MeshLimits& limits) : m_limits(limits) {}

    // The lines that make up the mesh.
    std::string Checked(std::string_view text) {
        constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
        if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
        while (!text.empty()) {
            const std::string_view line = NextStatement(text);
            std::string_view rest = line;
            const std::string_view word = NextWord(rest);
            if (word == "f") {
                CheckFace(rest);
                continue;
            }
            if (word == "v")
                CheckNumbers(rest, m_positions, 3, 3);
            else if (word == "vn")
                CheckNumbers(rest, m_normals, 3, 3);
            else if (word == "vt")
                CheckNumbers(rest, m_uvs, 1, 2);
            else
                continue;
            m_kept.append(line).append("\n");
        }
        if (m_triangles == 0) throw Error("it has no face; an OBJ mesh is expected");
        return std::move(m_kept);
    }

private:
    template <typename... Args>
    [[noreturn]] void Fail(fmt::format_string<Args...> format, Args&&... args) const {
        throw Error("line {} {}", m_line, fmt::format(format, std::forward<Args>(args)...));
    }

    // Without its comment.
    std::string_view NextLine(std::string_view& text) {
        m_linesRead++;
        std::string_view line = Next(text, "\n");
        if (line.ends_with('\r')) line.remove_suffix(1);
        if (line.find_first_of(std::string_view("\0\r", 2)) != line.npos)
            Fail("has a zero byte or a lone carriage return; OBJ is text");
        return line.substr(0, line.find('#'));
    }

    // A line and those that a backslash at its end goes on with.
    std::string_view NextStatement(std::string_view& text) {
        m_line = m_linesRead + 1;
        std::string_view line = NextLine(text);
        if (!line.ends_with('\\')) return line;
        m_joined.clear();
        for (; line.ends_with('\\'); line = NextLine(text)) {
            line.remove_suffix(1);
            m_joined.append(line).append(" ");
        }
        m_joined.append(line);
        return m_joined;
    }

    // The first `most` words, of which `needed` must be there.
    void CheckNumbers(std::string_view rest, Known& known, int needed, int most) {
        for (int i = 0; i < most; i++) {
            std::string_view word = NextWord(rest);
            if (word.empty() && i >= needed) break;
            if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
            double number = 0;
            const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
            const bool isWhole = !word.empty() && end == word.data() + word.size() && error == std::errc();
            if (!isWhole || !(std::abs(number) <= std::numeric_limits<float>::max()))
                Fail("is {} without {} finite numbers", known.one, needed == most ? "3" : "1 or 2");
        }
        if (known.missedInLine > 0) {
            throw Error("line {}: index {}; there are 0 {} so far", known.missedInLine, known.missedIndex,
                        known.several);
        }
        if (++known.count > m_limits.maxVertices)
            Fail("is {} more than the {} that are read", known.one, m_limits.maxVertices);
    }

    void CheckFace(std::string_view rest) {
        uint32_t corners = 0;
        m_kept.append("f");
        for (std::string_view corner = NextWord(rest); !corner.empty(); corner = NextWord(rest)) {
            if (std::ranges::count(corner, '/') > 2) FailCorner();
            const std::string_view position = Next(corner, "/"), uv = Next(corner, "/"), normal = corner;
            CheckIndex(position, m_positions);
            const bool hasUv = HasIndex(uv, m_uvs), hasNormal = HasIndex(normal, m_normals);
            m_kept.append(" ").append(position);
            if (hasUv || hasNormal) m_kept.append("/");
            if (hasUv) m_kept.append(uv);
            if (hasNormal) m_kept.append("/").append(normal);
            if (++corners > kMaxCorners)
                Fail("is a face of more than {} corners, the most that are read", kMaxCorners);
        }
        m_kept.append("\n");
        if (corners < 3) Fail("is a face of {} corners; 3 to {} are expected", corners, kMaxCorners);
        m_triangles += corners - 2;
        if (m_triangles > m_limits.maxTriangles)
            Fail("leads to more than {} triangles, the most that are read", m_limits.maxTriangles);
    }

    // 1 is the first; -1 is the last so far.
    int64_t IndexOf(std::string_view word) const {
        int64_t index = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), index);
        if (word.empty() || end != word.data() + word.size() || error == std::errc::invalid_argument) FailCorner();
        return error == std::errc() ? index : 0;
    }

    void CheckIndex(std::string_view word, const Known& known) const {
        constexpr size_t kMostShown = 40;
        const int64_t index = IndexOf(word);
        if (index == 0 || std::abs(index) > known.count)
            throw Error("line {}: index {}; there are {} {} so far", m_line, word.substr(0, kMostShown), known.count,
                        known.several);
    }

    // Some programs write indices of what they have not written: where a file has none at all they mean nothing.
    bool HasIndex(std::string_view word, Known& known) {
        if (word.empty()) return false;
        if (known.count > 0 || IndexOf(word) == 0)
            CheckIndex(word, known);
        else if (known.missedInLine == 0) {
            known.missedInLine = m_line;
            known.missedIndex = IndexOf(word);
        }
        return known.count > 0;
    }

    [[noreturn]] void FailCorner() const { Fail("has a corner that is none of v, v/vt, v//vn, v/vt/vn"); }

    const MeshLimits& m_limits;
    std::string m_kept, m_joined;
    uint64_t m_line = 0;  // at which the statement begins
    uint64_t m_linesRead = 0;
    Known m_positions{"a position", "positions"}, m_normals{"a normal", "normals"}, m_uvs{"a uv", "uv"};
    uint32_t m_triangles = 0;
};

using Corner = tinyobj::index_t;

// Numbers that tinyobjloader's arithmetic cannot hold, as 0.[600 zeros]1e600, become NaN in it.
bool AreFinite(const std::vector<float>& numbers) {
    return std::ranges::all_of(numbers, [](float number) { return std::isfinite(number); });
}

// What has been looked at and yet is refused can only be a difference between Checker and tinyobjloader.
tinyobj::ObjReader Parse(const std::string& text) {
    tinyobj::ObjReaderConfig config;
    config.triangulate = false;  // its ears are right for convex faces only, and take the cube of the corners' number
    config.vertex_color = false;
    tinyobj::ObjReader reader;
    if (!reader.ParseFromString(text, "", config) || reader.GetShapes().size() != 1)
        throw Error("it is damaged: {}", reader.Error().substr(0, reader.Error().find('\n')));
    const tinyobj::attrib_t& read = reader.GetAttrib();
    if (!AreFinite(read.vertices) || !AreFinite(read.normals) || !AreFinite(read.texcoords))
        throw Error("one of its numbers has too many digits");
    return reader;
}

// The corners of the triangles, three by three.
std::vector<Corner> Triangles(const tinyobj::mesh_t& mesh) {
    std::vector<Corner> corners;
    const Corner* face = mesh.indices.data();
    for (const uint32_t count : mesh.num_face_vertices) {
        for (uint32_t i = 2; i < count; i++)
            corners.insert(corners.end(), {face[0], face[i - 1], face[i]});
        face += count;
    }
    return corners;
}

glm::dvec3 Vector(const std::vector<float>& values, int index) {
    const float* v = &values[3 * static_cast<size_t>(index)];
    return {v[0], v[1], v[2]};
}

// The first index of each position: files made of patches hold those of their borders twice.
std::vector<size_t> FirstOfEqual(const std::vector<float>& positions) {
    std::map<std::array<float, 3>, size_t> first;
    std::vector<size_t> indices;
    for (size_t i = 0; i < positions.size() / 3; i++)
        indices.push_back(
            first.try_emplace({positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]}, i).first->second);
    return indices;
}

// Of each position: the sum of the areas of the triangles round it, as vectors. In double, where no square of a float
// overflows.
std::vector<glm::dvec3> SmoothNormals(const std::vector<float>& positions, const std::vector<Corner>& corners) {
    const std::vector<size_t> firstOf = FirstOfEqual(positions);
    std::vector<glm::dvec3> normals(firstOf.size(), glm::dvec3(0));
    for (size_t i = 0; i < corners.size(); i += 3) {
        const glm::dvec3 a = Vector(positions, corners[i].vertex_index);
        const glm::dvec3 area = glm::cross(Vector(positions, corners[i + 1].vertex_index) - a,
                                           Vector(positions, corners[i + 2].vertex_index) - a);
        for (size_t k = i; k < i + 3; k++)
            normals[firstOf[static_cast<size_t>(corners[k].vertex_index)]] += area;
    }
    for (size_t i = 0; i < normals.size(); i++)
        normals[i] = normals[firstOf[i]];
    return normals;
}

MeshData Merge(const tinyobj::attrib_t& file, const std::vector<Corner>& corners, const MeshLimits& limits) {
    struct Hash {
        size_t operator()(const std::array<int, 3>& key) const {
            uint64_t hash = 0;
            for (const int index : key)
                hash = (hash ^ static_cast<uint32_t>(index)) * 0x9e3779b97f4a7c15u;  // 2^64 / golden ratio
            return hash ^ hash >> 32;
        }
    };
    const std::vector<glm::dvec3> smooth = SmoothNormals(file.vertices, corners);
    std::unordered_map<std::array<int, 3>, uint32_t, Hash> known;
    MeshData mesh;
    for (const Corner& corner : corners) {
        const auto [vertexIndex, normalIndex, uvIndex] = corner;
        const auto [at, isNew] =
            known.try_emplace({vertexIndex, normalIndex, uvIndex}, static_cast<uint32_t>(mesh.vertices.size()));
        mesh.indices.push_back(at->second);
        if (!isNew) continue;
        if (mesh.vertices.size() == limits.maxVertices)
            throw Error("it makes more than {} vertices, the most that are read", limits.maxVertices);
        glm::dvec3 normal = normalIndex < 0 ? glm::dvec3(0) : Vector(file.normals, normalIndex);
        if (glm::length(normal) == 0) normal = smooth[static_cast<size_t>(vertexIndex)];
        if (glm::length(normal) == 0) normal = {0, 1, 0};  // the faces round it have no area
        Vertex vertex{Vector(file.vertices, vertexIndex), glm::normalize(normal), {}};
        if (uvIndex >= 0) {
            const float* uv = &file.texcoords[2 * static_cast<size_t>(uvIndex)];
            vertex.uv = {uv[0], 1 - uv[1]};
        }
        mesh.vertices.push_back(vertex);
    }
    return mesh;
}

}  // namespace

MeshData ReadMesh(const std::string& path, const MeshLimits& limits) {
    const auto checkStart = [&](ByteView start) {
        if (start.empty()) throw Error("{}: the file is empty; an OBJ mesh is expected", InputName(path));
        if (std::ranges::count(start, 0) > 0) throw Error("{}: no text; an OBJ mesh is expected", InputName(path));
    };
    return DecodeMesh(ReadBytes(path, limits.maxBytes, checkStart), InputName(path), limits);
}

MeshData DecodeMesh(std::span<const uint8_t> file, const std::string& name, const MeshLimits& limits) {
    try {
        const std::string text = Checker(limits).Checked({reinterpret_cast<const char*>(file.data()), file.size()});
        const tinyobj::ObjReader reader = Parse(text);
        return Merge(reader.GetAttrib(), Triangles(reader.GetShapes()[0].mesh), limits);
    } catch (const Error& error) {
        throw Error("{}: {}", name, error.what());
    }
}

}  // namespace boxcar
