// An image whose levels say which level they are: a fetch from it, where a texture is fetched, tells what level the
// sampler takes there.
//
//   level k, all texels:  1 / its width, 1 / its height, k, 0
//
// hlsl/boxcar/bspline_mip.hlsli reads it. Level k of FromBaseLevel (runtime/base_level.h) is level k + firstLevel
// here, so one line of texels as long as the largest texture, seen from a base level, serves textures of every size
// and aspect ratio. Today CalculateLevelOfDetail says the same without a texture.
//
// Sigg 2005, sect. 20.3
#pragma once

#include "runtime/command_list.h"

namespace boxcar {

// Builds the levels when it is made, and waits for them. 21 bytes of device memory a texel, 32 on a line.
class MetaMipmap {
public:
    // extent: of the texture; or {widthTexels, 1} for lookups with adjusted derivatives.
    MetaMipmap(Device& device, Extent2D extent);

    // RGBA32F, in ImageUse::ShaderRead.
    const Image& Levels() const { return m_levels; }

private:
    Image m_levels;
};

// Which level of a line of `widthTexels` (a power of two) is the base level for a texture: as many levels are left as
// the texture has. Throws Error: the texture is larger than the line.
uint32_t MetaBaseLevel(uint32_t widthTexels, Extent2D texture);

}  // namespace boxcar
