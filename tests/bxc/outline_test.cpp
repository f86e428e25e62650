#include "tools/bxc/outline.h"

#include <gtest/gtest.h>

namespace boxcar {
namespace {

// Without the texts themselves there are no columns: only file and line are looked at here.
class OutlineTest : public testing::Test {
protected:
    Outline Make(const std::string& text) { return Outline(text, "a.hlsl", m_source); }
    static SourcePlace At(const char* file, int line) { return {file, line, 0}; }

    Source m_source{"", {}};
};

TEST_F(OutlineTest, GlobalIsFoundWhereItIsFirstNamedOutsideBrackets) {
    const Outline outline = Make(
        "float4 f(float2 tint) { float size; return tint; }\n"
        "struct S { float tint; };\n"
        "cbuffer Params : register(b0)\n"
        "{ float tint; };\n"
        "Texture2D<float4> source[2] : register(t0), size : register(t2);\n"
        "float tint;\n"
        "float g() { return tint; }\n");
    EXPECT_EQ(outline.Global("Params"), At("a.hlsl", 3));
    EXPECT_EQ(outline.Global("source"), At("a.hlsl", 5));
    EXPECT_EQ(outline.Global("size"), At("a.hlsl", 5));
    EXPECT_EQ(outline.Global("tint"), At("a.hlsl", 6));
    EXPECT_EQ(outline.Global("none"), At("a.hlsl", 1));
}

TEST_F(OutlineTest, LineDirectivesLeadIntoIncludedFilesAndBack) {
    const Outline outline = Make(
        "#line 1 \"inc/b.hlsli\"\n"
        "\n"
        "float inB;\n"
        "#line 7 \"a.hlsl\"\n"
        "float inA;\n"
        "#line 20\n"
        "float later;\n");
    EXPECT_EQ(outline.Global("inB"), At("inc/b.hlsli", 2));
    EXPECT_EQ(outline.Global("inA"), At("a.hlsl", 7));
    EXPECT_EQ(outline.Global("later"), At("a.hlsl", 20));
}

TEST_F(OutlineTest, FunctionIsFoundWhereItHasABody) {
    const Outline outline = Make(
        "float main(float2 uv);\n"
        "float other() { return main(float2(0, 0)); }\n"
        "float4\n"
        "main(float2 uv : TEXCOORD0) : SV_Target\n"
        "{ return uv.xyxy; }\n");
    EXPECT_EQ(outline.Function("main"), At("a.hlsl", 4));
    EXPECT_EQ(outline.Function("other"), At("a.hlsl", 2));
    EXPECT_EQ(outline.Function("Main"), std::nullopt);
}

constexpr const char* kStageInterface =
    "struct Light { float3 color : COLOR; };\n"
    "struct VsIn { float3 position : POSITION; float2 uv : TEXCOORD0; };\n"
    "struct VsOut {\n"
    "    float4 position : SV_Position;\n"
    "    nointerpolation float2 uv[8] : TEXCOORD0, extra : EXTRA;\n"
    "    Light light;\n"
    "};\n"
    "VsOut main(in VsIn i,\n"
    "           uint id : SV_VertexID,\n"
    "           out float depth : DEPTH)\n"
    "{ VsOut uv; return uv; }\n";

TEST_F(OutlineTest, InputIsAParameterOrAFieldOfOne) {
    const Outline outline = Make(kStageInterface);
    EXPECT_EQ(outline.Input("main", "position"), At("a.hlsl", 2));
    EXPECT_EQ(outline.Input("main", "uv"), At("a.hlsl", 2));
    EXPECT_EQ(outline.Input("main", "id"), At("a.hlsl", 9));
    EXPECT_EQ(outline.Input("main", "none"), At("a.hlsl", 1));
    EXPECT_EQ(outline.Input("none", "uv"), At("a.hlsl", 1));
}

TEST_F(OutlineTest, OutputIsAFieldOfTheResultOrAnOutParameterOrTheFunction) {
    const Outline outline = Make(kStageInterface);
    EXPECT_EQ(outline.Output("main", "position"), At("a.hlsl", 4));
    EXPECT_EQ(outline.Output("main", "uv[3]"), At("a.hlsl", 5));
    EXPECT_EQ(outline.Output("main", "extra"), At("a.hlsl", 5));
    EXPECT_EQ(outline.Output("main", "color"), At("a.hlsl", 1));
    EXPECT_EQ(outline.Output("main", "depth"), At("a.hlsl", 10));
    EXPECT_EQ(outline.Output("main", ""), At("a.hlsl", 8));
}

TEST_F(OutlineTest, TextWithUnpairedBracketsIsSurvived) {
    for (const char* text : {"", "}}}}", "((((", "main(", "struct S {", "struct main(", ":",
                             "main( ) :", "struct S { S s; }; S main(S s) {"}) {
        const Outline outline = Make(text);
        EXPECT_EQ(outline.Input("main", "x"), At("a.hlsl", 1)) << text;
        EXPECT_EQ(outline.Output("main", "x"), At("a.hlsl", 1)) << text;
    }
}

// A macro counts the arguments of a call as the preprocessor does.
TEST_F(OutlineTest, MentionsTellMethodsAndCountArguments) {
    const Outline outline = Make(
        "float select;\n"
        "float f() { a.select(1, float2(2, 3)); select(); return select(x[1], {2, 3}, (4, 5)); }\n"
        "b.select;\n");
    std::vector<std::pair<bool, size_t>> mentions;
    for (const Outline::Mention& mention : outline.Mentions("select"))
        mentions.emplace_back(mention.isMethod, mention.argumentCount);
    EXPECT_EQ(mentions,
              (std::vector<std::pair<bool, size_t>>{{false, 0}, {true, 2}, {false, 0}, {false, 4}, {true, 0}}));
    EXPECT_TRUE(outline.Mentions("none").empty());
}

}  // namespace
}  // namespace boxcar
