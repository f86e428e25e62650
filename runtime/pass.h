// One draw of a screen-aligned quad or of a mesh: images in, images out. Or one dispatch: images and buffers in and
// out.
#pragma once

#include <cstddef>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "runtime/compute_pipeline.h"
#include "runtime/image.h"
#include "runtime/mesh.h"
#include "runtime/pipeline.h"
#include "runtime/storage_buffer.h"

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

// What shaders may read and write, each thread where it likes, under the name that the HLSL gives it: a buffer of any
// kind, also one that is only read, or an RWTexture2D or RWTexture3D.
//
// An image has one layer and level and the format that its HLSL type means: RGBA32F for float4, R32F for float,
// RGBA32UI for uint4. Vertex shaders can only read storage.
struct Storage {
    Storage(std::string_view hlslName, const Image* written) : name(hlslName), image(written) {}
    Storage(std::string_view hlslName, const StorageBuffer* written) : name(hlslName), buffer(written) {}

    std::string_view name;
    const Image* image = nullptr;  // or
    const StorageBuffer* buffer = nullptr;
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
    std::vector<Storage> storage = {};
    std::vector<const Image*> writes;           // all of one extent; texels that are not drawn keep their value
    std::span<const std::byte> constants = {};  // exactly as many bytes as the shaders' BOXCAR_CONSTANTS block
    std::optional<Rect> area = {};              // the texels that are drawn; all of them if not given
    const Mesh* mesh = nullptr;                 // for a pipeline that draws one
    const Image* depth = nullptr;               // Depth32F, of the targets' extent; for a pipeline that tests depth
    std::optional<glm::vec4> clearColor = {};   // what `area` of the targets is set to first, in their formats
    bool clearsDepth = false;                   // sets `area` of the depth image to 1, the far plane, first
};

struct ComputePass {
    std::string_view name;  // in --stats, debuggers and messages
    const ComputePipeline& pipeline;
    std::vector<Read> reads = {};
    std::vector<Storage> storage = {};
    std::span<const std::byte> constants = {};  // exactly as many bytes as the shader's BOXCAR_CONSTANTS block
    ThreadGroups groups = {};                   // often pipeline.GroupsOver(..)
};

}  // namespace boxcar
