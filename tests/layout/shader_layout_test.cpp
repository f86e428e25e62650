#include "tools/layout/shader_layout.h"

#include <gtest/gtest.h>

#include <string>

#include "tools/base/error.h"

namespace boxcar {
namespace {

// Every field differs from its default.
ShaderLayout FullLayout() {
    ShaderLayout layout;
    layout.source = "shaders/sat \"quoted\".ps.hlsl";
    layout.entry = "Blur";
    layout.stage = ShaderStage::Compute;
    const ResourceKind kinds[] = {ResourceKind::ConstantBuffer,
                                  ResourceKind::PushConstants,
                                  ResourceKind::Texture,
                                  ResourceKind::Sampler,
                                  ResourceKind::StorageImage,
                                  ResourceKind::StorageBuffer,
                                  ResourceKind::CombinedImageSampler,
                                  ResourceKind::TexelBuffer};
    for (const ResourceKind kind : kinds)
        layout.resources.push_back(
            {"resource", kind, 1, 96, 0, 68, {{"tint", 0, 16}, {"light.color", 16, 12}}, TextureDimension::Volume});
    layout.inputs = {{"uv[1]", "TEXCOORD1", 1, 4, "float4"}};
    layout.outputs = {{"", "SV_TARGET0", 0, 1, "uint2"}};
    layout.writesPosition = true;
    layout.threadGroup[0] = 8;
    layout.threadGroup[1] = 4;
    layout.threadGroup[2] = 4294967295;
    return layout;
}

// The message with which a document is refused.
std::string Refusal(const std::string& json) {
    try {
        ShaderLayoutFromJson(json);
    } catch (const Error& error) {
        return error.what();
    }
    return "accepted";
}

// FullLayout() as text, with one piece of it replaced.
std::string Broken(const std::string& piece, const std::string& replacement) {
    std::string json = ShaderLayoutToJson(FullLayout());
    const size_t at = json.find(piece);
    EXPECT_NE(at, std::string::npos) << piece;
    return json.replace(at, piece.size(), replacement);
}

TEST(ShaderLayoutTest, ComesBackFromJsonAsItWas) {
    EXPECT_EQ(ShaderLayoutFromJson(ShaderLayoutToJson(FullLayout())), FullLayout());
    EXPECT_EQ(ShaderLayoutFromJson(ShaderLayoutToJson({})), ShaderLayout{});
}

TEST(ShaderLayoutTest, JsonIsTheSameForTheSameLayoutAndEndsInANewline) {
    const std::string json = ShaderLayoutToJson(FullLayout());
    EXPECT_EQ(json, ShaderLayoutToJson(ShaderLayoutFromJson(json)));
    EXPECT_TRUE(json.ends_with("}\n"));
    EXPECT_LT(json.find("\"source\""), json.find("\"resources\""));
}

TEST(ShaderLayoutTest, MissingFieldIsNamedWithItsPath) {
    EXPECT_EQ(Refusal(Broken("\"entry\"", "\"entri\"")), "shader layout: 'entry' is missing");
    EXPECT_EQ(Refusal(Broken("\"binding\"", "\"x\"")), "shader layout: 'resources[0].binding' is missing");
    EXPECT_EQ(Refusal(Broken("\"offsetBytes\": 16", "\"x\": 16")),
              "shader layout: 'resources[0].members[1].offsetBytes' is missing");
}

TEST(ShaderLayoutTest, FieldOfAnotherTypeIsNamedWithWhatIsExpected) {
    EXPECT_EQ(Refusal(Broken("\"set\": 1", "\"set\": -1")),
              "shader layout: 'resources[0].set' is -1; expected a whole number from 0 to 4294967295");
    EXPECT_EQ(Refusal(Broken("\"set\": 1", "\"set\": 4294967296")),
              "shader layout: 'resources[0].set' is 4294967296; expected a whole number from 0 to 4294967295");
    EXPECT_EQ(Refusal(Broken("\"Blur\"", "7")), "shader layout: 'entry' is 7; expected a string");
    EXPECT_EQ(Refusal(Broken("\"compute\"", "\"mesh\"")),
              "shader layout: 'stage' is \"mesh\"; expected one of vertex, pixel, compute, geometry, hull, domain");
    EXPECT_EQ(Refusal(Broken("true", "1")), "shader layout: 'writesPosition' is 1; expected true or false");
    EXPECT_EQ(Refusal(Broken("\"threadGroup\": [\n    8,", "\"threadGroup\": [\n    8, 8,")),
              "shader layout: 'threadGroup' is [8,8,4,4294967295]; expected an array of three numbers");
    EXPECT_EQ(Refusal("[]"), "shader layout: '' is []; expected an object");
}

TEST(ShaderLayoutTest, TextThatIsNotJsonIsRefused) {
    EXPECT_TRUE(Refusal("").starts_with("shader layout: not JSON: ")) << Refusal("");
    const std::string json = ShaderLayoutToJson(FullLayout());
    EXPECT_TRUE(Refusal(json.substr(0, json.size() / 2)).starts_with("shader layout: not JSON: "));
}

}  // namespace
}  // namespace boxcar
