// What a mesh holds at each of its vertices.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace boxcar {

// A vertex shader reads these members as POSITION (or SV_Position), NORMAL and TEXCOORD0, or some of them.
struct Vertex {
    glm::vec3 position{0};  // in the mesh's own units
    glm::vec3 normal{0};    // length 1
    glm::vec2 uv{0};        // origin top-left

    bool operator==(const Vertex&) const = default;
};

}  // namespace boxcar
