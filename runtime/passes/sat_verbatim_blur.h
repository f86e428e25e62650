// The papers' box lookup exactly as they print it, to look at beside SATFilter: shifted by half a texel or a whole
// one, not clipped at the rim, and W x H times too bright.
//
//   table  ->  tex2D_SAT_blur round every texel  ->  image
//
// Scheuermann 2005 (tex2D_SAT_blur); hlsl/boxcar/d3d9.hlsli
#pragma once

#include <glm/vec2.hpp>

#include "runtime/command_list.h"

namespace boxcar {

// Holds one pipeline and the result: 16 bytes of device memory per texel. Move-only. Not thread-safe.
class SatVerbatimBlur {
public:
    SatVerbatimBlur(Device& device, Extent2D extent);

    // `table`: without bias. `sizeTexels`: full width and height of the box, handed to the shader in uv.
    const Image& Record(CommandList& commands, const Image& table, glm::vec2 sizeTexels);

private:
    Pipeline m_pipeline;
    Image m_result;
};

}  // namespace boxcar
