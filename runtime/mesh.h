// Triangles on the device.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "runtime/device.h"
#include "runtime/vertex.h"

namespace boxcar {

// One device buffer: 32 bytes a vertex and 4 an index, and for the time of construction as much again in host memory
// that the device reads. Move-only.
class Mesh {
public:
    // Throws Error: no triangle; a number of indices that three does not divide; an index that is not below the
    // number of vertices; more memory than the device has left. The message names the mesh.
    //
    //   indices  three a triangle, into `vertices`
    //   name     for debuggers and messages
    Mesh(Device& device, std::span<const Vertex> vertices, std::span<const uint32_t> indices,
         const std::string& name);

    ~Mesh();
    Mesh(Mesh&&) noexcept;
    Mesh& operator=(Mesh&&) noexcept;

    struct Impl;
    Impl& impl() const { return *m_impl; }

private:
    std::unique_ptr<Impl> m_impl;
};

}  // namespace boxcar
