// One draw of a screen-aligned quad: images in, images out.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "runtime/image.h"
#include "runtime/pipeline.h"

namespace boxcar {

struct Rect {
    uint32_t xTexels = 0;
    uint32_t yTexels = 0;
    uint32_t widthTexels = 0;
    uint32_t heightTexels = 0;
};

// An image under the name that the HLSL gives it.
struct Read {
    std::string_view name;
    const Image* image = nullptr;
};

// The bytes of a struct of hlsl/constants/.
template <typename T>
std::span<const std::byte> ConstantBytes(const T& constants) {
    return std::as_bytes(std::span<const T, 1>(&constants, 1));
}

struct Pass {
    std::string_view name;  // in --stats, debuggers and messages
    const Pipeline& pipeline;
    std::vector<Read> reads = {};
    std::vector<const Image*> writes;           // all of one extent; texels that are not drawn keep their value
    std::span<const std::byte> constants = {};  // exactly as many bytes as the shaders' BOXCAR_CONSTANTS block
    std::optional<Rect> area = {};              // the texels that are drawn; all of them if not given
};

}  // namespace boxcar
