// Meshes in from files.
//
// Non-goals: writing; materials, groups, smoothing groups, colors, lines, curves and surfaces, which are passed
// over.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "runtime/vertex.h"

namespace boxcar {

// A mesh in memory, as boxcar::Mesh takes it.
struct MeshData {
    std::vector<Vertex> vertices;
    std::vector<uint32_t> indices;  // three a triangle, counter-clockwise seen from outside
};

struct MeshLimits {
    uint64_t maxBytes = uint64_t{1} << 28;  // of the file
    uint32_t maxVertices = 1 << 22;         // of the mesh; and the file's positions, normals and uv, each
    uint32_t maxTriangles = 1 << 22;
};

// Reads a Wavefront OBJ file.
//
//   path  a file, or "-" for standard input
//
// A line that ends in a backslash goes on in the next; what stands behind a # is a comment; a mark of UTF-8 in front
// is passed over. Indices of normals or uv, in a file that has not one of them, are passed over, and so are slashes
// with nothing behind them.
//
// Corners with the same position, normal and uv become one vertex. A face of up to 255 corners becomes a fan of
// triangles round its first one, which is right for convex faces. Normals are made of length 1; where the file has
// none, or one of length 0, they are the mean of the faces round the position, each weighted by its area. uv have
// their origin top-left (the file's is at the bottom), and are 0 where the file has none.
//
// Throws Error, one line that begins with the path and names the line in the file: it cannot be read, has no face, is
// cut off or damaged, a number is not finite, an index is out of range, or it is over a limit.
MeshData ReadMesh(const std::string& path, const MeshLimits& limits = {});

// The same from memory; `name` stands for the path in errors.
MeshData DecodeMesh(std::span<const uint8_t> file, const std::string& name, const MeshLimits& limits = {});

}  // namespace boxcar
