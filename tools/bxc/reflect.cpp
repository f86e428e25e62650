#include "tools/bxc/reflect.h"

#include <algorithm>
#include <cstdlib>
#include <span>
#include <spirv_cross.hpp>
#include <tuple>

#include "tools/base/printable.h"

namespace boxcar {
namespace {

using spirv_cross::SPIRType;

// "float3", "uint": what one location holds, as HLSL names it.
std::string TypeName(const SPIRType& type) {
    const char* scalar = type.basetype == SPIRType::Int      ? "int"
                         : type.basetype == SPIRType::UInt   ? "uint"
                         : type.basetype == SPIRType::Double ? "double"
                                                             : "float";
    return type.vecsize > 1 ? fmt::format("{}{}", scalar, type.vecsize) : scalar;
}

void AddMembers(const spirv_cross::Compiler& module, const SPIRType& type, const std::string& prefix,
                uint32_t offsetBytes, std::vector<LayoutMember>& members) {
    for (uint32_t i = 0; i < type.member_types.size(); ++i) {
        const SPIRType& member = module.get_type(type.member_types[i]);
        const std::string name = prefix + module.get_member_name(type.self, i);
        const uint32_t offset = offsetBytes + module.type_struct_member_offset(type, i);
        if (member.basetype == SPIRType::Struct && member.array.empty())
            AddMembers(module, member, name + ".", offset, members);
        else
            members.push_back({name, offset, static_cast<uint32_t>(module.get_declared_struct_member_size(type, i))});
    }
}

uint32_t CountOf(std::span<const uint32_t> lengths) {
    uint32_t count = 1;
    for (const uint32_t length : lengths)
        count *= length;
    return count;
}
uint32_t CountOf(const SPIRType& type) {
    return CountOf({type.array.data(), type.array.size()});
}

TextureDimension DimensionOf(const SPIRType& type) {
    if (type.basetype != SPIRType::Image && type.basetype != SPIRType::SampledImage) return TextureDimension::None;
    if (type.image.arrayed || type.image.ms) return TextureDimension::Other;
    switch (type.image.dim) {
        case spv::Dim2D: return TextureDimension::Flat;
        case spv::Dim3D: return TextureDimension::Volume;
        case spv::DimCube: return TextureDimension::Cube;
        default: return TextureDimension::Other;
    }
}

LayoutResource MakeResource(const spirv_cross::Compiler& module, const spirv_cross::Resource& resource,
                            ResourceKind kind) {
    const SPIRType& type = module.get_type(resource.type_id);
    const SPIRType& base = module.get_type(resource.base_type_id);
    const bool isBlock = kind == ResourceKind::ConstantBuffer || kind == ResourceKind::PushConstants;
    LayoutResource result;
    const spirv_cross::ID named = isBlock ? spirv_cross::ID(resource.base_type_id) : resource.id;
    result.name = module.get_name(named);
    result.kind = kind;
    if (kind != ResourceKind::PushConstants) {
        result.set = module.get_decoration(resource.id, spv::DecorationDescriptorSet);
        result.binding = module.get_decoration(resource.id, spv::DecorationBinding);
    }
    result.count = CountOf(type);
    result.dimension = DimensionOf(base);
    if (base.basetype == SPIRType::Image && base.image.dim == spv::DimBuffer) result.kind = ResourceKind::TexelBuffer;
    if (isBlock) {
        result.sizeBytes = static_cast<uint32_t>(module.get_declared_struct_size(base));
        AddMembers(module, base, "", 0, result.members);
    }
    return result;
}

// "@entryPointOutput.uv" -> "uv"; "" for the value that the entry point itself returns.
std::string VariableName(const std::string& path) {
    const size_t dot = path.find_last_of('.');
    if (dot != std::string::npos) return path.substr(dot + 1);
    return path.starts_with('@') ? "" : path;
}

// "TEXCOORD1" of "uv[2]" -> "TEXCOORD3", because the compiler takes arrays apart; "NORMAL" -> "NORMAL0".
std::string SemanticName(const std::string& decoration, const std::string& variable) {
    const size_t digits = decoration.find_last_not_of("0123456789") + 1;
    if (digits == 0) return "";
    const size_t bracket = variable.find('[');
    const int index = std::atoi(decoration.c_str() + digits);
    const int element = bracket == std::string::npos ? 0 : std::atoi(variable.c_str() + bracket + 1);
    return fmt::format("{}{}", decoration.substr(0, digits), index + element);
}

enum class Direction { In, Out };

// True if a stage has each of its variables once a vertex, but for those of a whole patch.
bool IsOncePerVertex(ShaderStage stage, Direction direction) {
    if (direction == Direction::Out) return stage == ShaderStage::Hull;
    return stage == ShaderStage::Hull || stage == ShaderStage::Domain || stage == ShaderStage::Geometry;
}

std::vector<LayoutVariable> MakeVariables(const spirv_cross::Compiler& module,
                                          const spirv_cross::SmallVector<spirv_cross::Resource>& resources,
                                          bool oncePerVertex) {
    std::vector<LayoutVariable> variables;
    for (const spirv_cross::Resource& resource : resources) {
        const SPIRType& type = module.get_type(resource.type_id);
        LayoutVariable variable;
        variable.name = VariableName(module.get_name(resource.id));
        variable.semantic =
            SemanticName(module.get_decoration_string(resource.id, spv::DecorationHlslSemanticGOOGLE), variable.name);
        variable.location = module.get_decoration(resource.id, spv::DecorationLocation);
        std::span<const uint32_t> lengths(type.array.data(), type.array.size());  // the outermost is last
        if (oncePerVertex && !lengths.empty() && !module.has_decoration(resource.id, spv::DecorationPatch))
            lengths = lengths.first(lengths.size() - 1);
        variable.locationCount = CountOf(lengths) * std::max(type.columns, 1u);
        variable.type = TypeName(type);
        variables.push_back(std::move(variable));
    }
    std::ranges::sort(variables, {}, &LayoutVariable::location);
    return variables;
}

ShaderLayout MakeLayout(const std::vector<uint32_t>& spirv, ReflectScope scope, const CompileOptions& options) {
    const spirv_cross::Compiler module(spirv);
    const spirv_cross::ShaderResources found =
        scope == ReflectScope::All ? module.get_shader_resources()
                                   : module.get_shader_resources(module.get_active_interface_variables());

    ShaderLayout layout;
    layout.source = ValidUtf8(options.file);
    layout.entry = options.entry;
    layout.stage = options.stage;

    const auto add = [&](const auto& resources, ResourceKind kind) {
        for (const spirv_cross::Resource& resource : resources)
            layout.resources.push_back(MakeResource(module, resource, kind));
    };
    add(found.uniform_buffers, ResourceKind::ConstantBuffer);
    add(found.push_constant_buffers, ResourceKind::PushConstants);
    add(found.separate_images, ResourceKind::Texture);
    add(found.separate_samplers, ResourceKind::Sampler);
    add(found.storage_images, ResourceKind::StorageImage);
    add(found.storage_buffers, ResourceKind::StorageBuffer);
    add(found.sampled_images, ResourceKind::CombinedImageSampler);
    std::ranges::sort(layout.resources, {}, [](const LayoutResource& resource) {
        return std::tie(resource.set, resource.binding, resource.name);
    });

    layout.inputs = MakeVariables(module, found.stage_inputs, IsOncePerVertex(options.stage, Direction::In));
    layout.outputs = MakeVariables(module, found.stage_outputs, IsOncePerVertex(options.stage, Direction::Out));
    const bool feedsRasterizer = options.stage == ShaderStage::Vertex || options.stage == ShaderStage::Domain ||
                                 options.stage == ShaderStage::Geometry;
    layout.writesPosition = feedsRasterizer && std::ranges::any_of(found.builtin_outputs, [](const auto& output) {
                                return output.builtin == spv::BuiltInPosition;
                            });
    if (options.stage == ShaderStage::Compute)
        for (uint32_t i = 0; i < 3; ++i)
            layout.threadGroup[i] = module.get_execution_mode_argument(spv::ExecutionModeLocalSize, i);
    return layout;
}

}  // namespace

ShaderLayout Reflect(const std::vector<uint32_t>& spirv, ReflectScope scope, const CompileOptions& options,
                     Diagnostics& diagnostics) {
    try {
        return MakeLayout(spirv, scope, options);
    } catch (const spirv_cross::CompilerError& error) {
        diagnostics.push_back({{options.file, 0, 0}, Severity::Error, fmt::format("no layout: {}", error.what())});
        return {};
    }
}

}  // namespace boxcar
