// What a compiled shader expects of the program that runs it: its resources with their bindings, its stage inputs and
// outputs, its constants with their byte offsets. Written by bxc beside each .spv, read by the runtime. No compiler
// library is needed to read it.
//
// Non-goals: types of locals, instructions, anything a pipeline is not built from.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace boxcar {

enum class ShaderStage { Vertex, Pixel, Compute, Geometry, Hull, Domain };

enum class ResourceKind {
    ConstantBuffer,        // cbuffer
    PushConstants,         // [[vk::push_constant]] cbuffer; set and binding are 0 and mean nothing
    Texture,               // Texture2D, Texture3D, TextureCube
    Sampler,               // SamplerState
    StorageImage,          // RWTexture2D, RWTexture3D
    StorageBuffer,         // StructuredBuffer, ByteAddressBuffer and their RW forms
    CombinedImageSampler,  // what D3D9-style `sampler` + tex2D becomes
    TexelBuffer,           // Buffer, RWBuffer
};

enum class TextureDimension { None, Flat, Volume, Cube, Other };  // Flat: Texture2D; Volume: Texture3D

// One variable of a constant block. Nested structs are flattened: "light.color", "weights".
struct LayoutMember {
    std::string name;
    uint32_t offsetBytes = 0;
    uint32_t sizeBytes = 0;

    bool operator==(const LayoutMember&) const = default;
};

struct LayoutResource {
    std::string name;  // as in the HLSL
    ResourceKind kind = ResourceKind::ConstantBuffer;
    uint32_t set = 0;
    uint32_t binding = 0;
    uint32_t count = 1;                                   // array length; 0 for an array without a length
    uint32_t sizeBytes = 0;                               // of a constant block, else 0
    std::vector<LayoutMember> members;                    // of a constant block, in the order of their offsets
    TextureDimension dimension = TextureDimension::None;  // of a texture, sampled or written

    bool operator==(const LayoutResource&) const = default;
};

// One location of a stage interface. Built-ins (SV_Position, SV_VertexID, ..) are not listed.
struct LayoutVariable {
    std::string name;      // as in the HLSL where the compiler keeps it
    std::string semantic;  // "TEXCOORD0", or "" where the compiler drops it
    uint32_t location = 0;
    uint32_t locationCount = 1;  // an array or a matrix takes several
    std::string type;            // "float4", "uint2", ..: the HLSL name of what one location holds

    bool operator==(const LayoutVariable&) const = default;
};

struct ShaderLayout {
    std::string source;  // the file, as named on the command line or in the manifest
    std::string entry;
    ShaderStage stage = ShaderStage::Pixel;
    std::vector<LayoutResource> resources;  // by set, then binding
    std::vector<LayoutVariable> inputs;     // by location
    std::vector<LayoutVariable> outputs;    // by location
    bool writesPosition = false;            // a vertex, domain or geometry shader that writes SV_Position
    uint32_t threadGroup[3] = {0, 0, 0};    // numthreads of a compute shader, else 0

    bool operator==(const ShaderLayout&) const = default;
};

// JSON text, indented, keys in a fixed order, ending in a newline: same layout, same bytes.
std::string ShaderLayoutToJson(const ShaderLayout& layout);

// The inverse of ShaderLayoutToJson. Throws Error naming the field that is missing or has another type.
ShaderLayout ShaderLayoutFromJson(std::string_view json);

// A shader that boxcar_add_shaders (cmake/shaders.cmake) put into a program. The views last as long as the program.
struct EmbeddedShader {
    std::string_view name;            // the output's path without .spv: "sat_pass.ps.TAPS=4"
    std::span<const uint32_t> spirv;  // words
    std::string_view layoutJson;
};

}  // namespace boxcar
