// A vertex and a pixel shader, ready to draw. Everything that Vulkan wants to be told about them comes from their
// reflected layouts: no binding number, no offset and no sampler stands in C++.
//
// Samplers are chosen by their names in the HLSL: {nearest|linear|anisotropic}{Border|Clamp|Repeat|Mirror}; Border is
// a border color of 0, linear blends mip levels too, anisotropic takes up to 16 samples (where the device can; else
// it is linear). So `SamplerState nearestBorder : register(s0);` is all there is to say.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "runtime/device.h"
#include "runtime/format.h"
#include "tools/layout/shader_layout.h"

namespace boxcar {

// Which triangles are left out. The corners of a front face go counter-clockwise on the screen.
enum class Cull { None, Back, Front };

struct PipelineDesc {
    // With inputs it draws a mesh: they are POSITION, NORMAL and TEXCOORD0, or some of them (runtime/vertex.h).
    // Without, a screen-aligned quad from SV_VertexID 0..3, a triangle strip.
    EmbeddedShader vertex;
    EmbeddedShader pixel;
    std::vector<Format> targets = {Format::RGBA32F};  // SV_Target0, 1, ..
    bool testsDepth = false;                          // draws what is nearer (less) than Pass::depth, and writes it
    Cull cull = Cull::None;
};

// Move-only.
class Pipeline {
public:
    // Throws Error: a resource of a kind, a sampler of a name or a vertex input that the runtime does not know;
    // shaders that do not link; constants over 128 bytes. The message names the shader and the resource.
    Pipeline(Device& device, const PipelineDesc& desc);

    ~Pipeline();
    Pipeline(Pipeline&&) noexcept;
    Pipeline& operator=(Pipeline&&) noexcept;

    struct Impl;
    Impl& impl() const { return *m_impl; }

private:
    std::unique_ptr<Impl> m_impl;
};

}  // namespace boxcar
