// An image without its finest levels: what OpenGL calls its base level, Direct3D its most detailed mip.
#pragma once

#include "runtime/image.h"

namespace boxcar {

// Another view of `image`, whose level 0 is `firstLevel`: a sampler takes levels from there on. `image` has one
// layer, more levels than `firstLevel`, and was last used as ImageUse::ShaderRead; it outlives what is returned, and
// neither is written any more.
Image FromBaseLevel(Device& device, const Image& image, uint32_t firstLevel);

}  // namespace boxcar
