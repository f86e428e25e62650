#include "tools/layout/shader_layout.h"

#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "tools/base/error.h"

namespace boxcar {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::pair<ShaderStage, const char*> kStages[] = {
    {ShaderStage::Vertex, "vertex"},     {ShaderStage::Pixel, "pixel"}, {ShaderStage::Compute, "compute"},
    {ShaderStage::Geometry, "geometry"}, {ShaderStage::Hull, "hull"},   {ShaderStage::Domain, "domain"}};

constexpr std::pair<ResourceKind, const char*> kResourceKinds[] = {
    {ResourceKind::ConstantBuffer, "constantBuffer"},
    {ResourceKind::PushConstants, "pushConstants"},
    {ResourceKind::Texture, "texture"},
    {ResourceKind::Sampler, "sampler"},
    {ResourceKind::StorageImage, "storageImage"},
    {ResourceKind::StorageBuffer, "storageBuffer"},
    {ResourceKind::CombinedImageSampler, "combinedImageSampler"},
    {ResourceKind::TexelBuffer, "texelBuffer"}};

constexpr std::pair<TextureDimension, const char*> kDimensions[] = {{TextureDimension::None, "none"},
                                                                    {TextureDimension::Flat, "2D"},
                                                                    {TextureDimension::Volume, "3D"},
                                                                    {TextureDimension::Cube, "cube"},
                                                                    {TextureDimension::Other, "other"}};

template <typename Enum, size_t N>
const char* NameOf(const std::pair<Enum, const char*> (&names)[N], Enum value) {
    for (const auto& [candidate, name] : names)
        if (candidate == value) return name;
    BOXCAR_ASSERT(!"an enumerator without a name");
    return "";
}

// A place in the document, which knows its own path: errors name it.
class Field {
public:
    Field(const Json& json, std::string path) : m_json(json), m_path(std::move(path)) {}

    Field operator[](const char* key) const {
        if (!m_json.is_object()) Fail("an object");
        const std::string path = m_path.empty() ? key : m_path + "." + key;
        const auto found = m_json.find(key);
        if (found == m_json.end()) throw Error("shader layout: '{}' is missing", path);
        return {*found, path};
    }

    std::vector<Field> Items() const {
        if (!m_json.is_array()) Fail("an array");
        std::vector<Field> items;
        for (size_t i = 0; i < m_json.size(); ++i)
            items.emplace_back(m_json[i], fmt::format("{}[{}]", m_path, i));
        return items;
    }

    std::string Text() const {
        if (!m_json.is_string()) Fail("a string");
        return m_json.get<std::string>();
    }

    bool Flag() const {
        if (!m_json.is_boolean()) Fail("true or false");
        return m_json.get<bool>();
    }

    uint32_t Number() const {
        if (!m_json.is_number_unsigned() || m_json.get<uint64_t>() > std::numeric_limits<uint32_t>::max())
            Fail("a whole number from 0 to 4294967295");
        return m_json.get<uint32_t>();
    }

    template <typename Enum, size_t N>
    Enum OneOf(const std::pair<Enum, const char*> (&names)[N]) const {
        const std::string text = Text();
        std::string accepted;
        for (const auto& [value, name] : names) {
            if (text == name) return value;
            accepted += accepted.empty() ? name : fmt::format(", {}", name);
        }
        Fail("one of " + accepted);
    }

    [[noreturn]] void Fail(std::string_view expected) const {
        throw Error("shader layout: '{}' is {}; expected {}", m_path, m_json.dump(), expected);
    }

private:
    const Json& m_json;
    std::string m_path;
};

Json ToJson(const LayoutResource& resource) {
    Json members = Json::array();
    for (const LayoutMember& member : resource.members)
        members.push_back(
            {{"name", member.name}, {"offsetBytes", member.offsetBytes}, {"sizeBytes", member.sizeBytes}});
    return {{"name", resource.name},         {"kind", NameOf(kResourceKinds, resource.kind)},
            {"set", resource.set},           {"binding", resource.binding},
            {"count", resource.count},       {"sizeBytes", resource.sizeBytes},
            {"members", std::move(members)}, {"dimension", NameOf(kDimensions, resource.dimension)}};
}

LayoutResource ResourceFrom(const Field& field) {
    LayoutResource resource;
    resource.name = field["name"].Text();
    resource.kind = field["kind"].OneOf(kResourceKinds);
    resource.set = field["set"].Number();
    resource.binding = field["binding"].Number();
    resource.count = field["count"].Number();
    resource.sizeBytes = field["sizeBytes"].Number();
    resource.dimension = field["dimension"].OneOf(kDimensions);
    for (const Field& member : field["members"].Items())
        resource.members.push_back(
            {member["name"].Text(), member["offsetBytes"].Number(), member["sizeBytes"].Number()});
    return resource;
}

Json ToJson(const LayoutVariable& variable) {
    return {{"name", variable.name},
            {"semantic", variable.semantic},
            {"location", variable.location},
            {"locationCount", variable.locationCount},
            {"type", variable.type}};
}

LayoutVariable VariableFrom(const Field& field) {
    return {field["name"].Text(), field["semantic"].Text(), field["location"].Number(),
            field["locationCount"].Number(), field["type"].Text()};
}

template <typename T>
Json ArrayOf(const std::vector<T>& values) {
    Json array = Json::array();
    for (const T& value : values)
        array.push_back(ToJson(value));
    return array;
}

}  // namespace

std::string ShaderLayoutToJson(const ShaderLayout& layout) {
    const Json json = {{"source", layout.source},
                       {"entry", layout.entry},
                       {"stage", NameOf(kStages, layout.stage)},
                       {"resources", ArrayOf(layout.resources)},
                       {"inputs", ArrayOf(layout.inputs)},
                       {"outputs", ArrayOf(layout.outputs)},
                       {"writesPosition", layout.writesPosition},
                       {"threadGroup", layout.threadGroup}};
    return json.dump(2) + "\n";
}

ShaderLayout ShaderLayoutFromJson(std::string_view text) {
    Json json;
    try {
        json = Json::parse(text);
    } catch (const Json::parse_error& error) {
        throw Error("shader layout: not JSON: {}", error.what());
    }

    const Field root(json, "");
    ShaderLayout layout;
    layout.source = root["source"].Text();
    layout.entry = root["entry"].Text();
    layout.stage = root["stage"].OneOf(kStages);
    for (const Field& resource : root["resources"].Items())
        layout.resources.push_back(ResourceFrom(resource));
    for (const Field& input : root["inputs"].Items())
        layout.inputs.push_back(VariableFrom(input));
    for (const Field& output : root["outputs"].Items())
        layout.outputs.push_back(VariableFrom(output));
    layout.writesPosition = root["writesPosition"].Flag();
    const std::vector<Field> threads = root["threadGroup"].Items();
    if (threads.size() != 3) root["threadGroup"].Fail("an array of three numbers");
    for (size_t i = 0; i < 3; ++i)
        layout.threadGroup[i] = threads[i].Number();
    return layout;
}

}  // namespace boxcar
