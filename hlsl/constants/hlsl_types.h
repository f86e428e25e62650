// The HLSL names of the types that constants/ uses, for C++. HLSL has them built in.
#pragma once

#include <glm/ext/vector_int2.hpp>
#include <glm/ext/vector_int4.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace boxcar {

using float2 = glm::vec2;
using float3 = glm::vec3;
using float4 = glm::vec4;
using float4x4 = glm::mat4;  // both hold it by columns: mul(m, v) in HLSL is m * v in C++
using int2 = glm::ivec2;
using int4 = glm::ivec4;

}  // namespace boxcar
