// A picture of codes with its surroundings, for kernels of higher order over repeated pictures: their tables have no
// closed form outside the picture, so the picture is made larger first.
//
//   source, W x H  ->  one pass  ->  (W + 2 px) x (H + 2 py)
#pragma once

#include <optional>

#include "runtime/command_list.h"
#include "runtime/passes/texel_words.h"

namespace boxcar {

struct ExtendedImageDesc {
    Extent2D extent;   // of the source
    Extent2D padding;  // texels on either side of each axis
    SATPrecision precision = SATPrecision::U32;
    bool isMirrored = false;  // the picture and its mirror image by turns (the edge texel comes twice), or repeated
};

// Holds one pipeline and the extended image: 16 bytes a texel of it and word. Move-only. Not thread-safe.
class ExtendedImage {
public:
    // Throws Error: the extended image is over the device's limits.
    ExtendedImage(Device& device, const ExtendedImageDesc& desc);

    TexelWords Record(CommandList& commands, TexelWords source);

    // Of the extended image.
    Extent2D Extent() const { return m_extended.Extent(); }

private:
    ExtendedImageDesc m_desc;
    Pipeline m_pipeline;
    WordImages m_extended;
};

}  // namespace boxcar
