// Other people's HLSL: what is accepted, and what it becomes. tests/hlsl runs it on a device.
#include "tests/bxc/foreign_test.h"

#include "tools/bxc/validate.h"

namespace boxcar {
namespace {

TEST_F(ForeignTest, PositionOfAnInoutParameterIsThePositionWhereverItStands) {
    struct VertexShader {
        const char* text;
        Words outputs;
    };
    const VertexShader shaders[] = {
        {"void main(inout float2 uv : TEXCOORD0, inout float4 p : SV_Position, out float2 b[2] : B, out float c : C) "
         "{\n"
         "    p = p * 2; b[0] = b[1] = uv; c = 1; }",
         {"uv TEXCOORD0 0 1", "b B0 1 2", "c C0 3 1"}},
        {"void main(inout float4 p : sv_position, inout float4 n : NORMAL) { p = n; }", {"n NORMAL0 0 1"}},
        {"void main(float4 n : NORMAL, out float4 c : COLOR, out float4 p : SV_POSITION0) { c = p = n; }",
         {"c COLOR0 0 1"}},
        {"float4 main(float4 n : NORMAL) : SV_Position0 { return n; }", {}},
        {"struct V { float4 c : COLOR; float4 p : SV_Position; float2 uv[2] : TEXCOORD0; };\n"
         "void main(inout V v) { v.p += v.c; }",
         {"c COLOR0 0 1", "uv[0] TEXCOORD0 1 1", "uv[1] TEXCOORD1 2 1"}},
        {"struct P { float4 p : SV_Position0; float k : K; };\nstruct V { float4 c : COLOR; P inner; };\n"
         "void main(inout V v) { v.inner.p += v.c; }",
         {"c COLOR0 0 1", "k K0 1 1"}},
        {"void main(float4 n : NORMAL, out float4 c : COLOR, inout float4 p[1] : SV_Position) { c = n; p[0] *= n; }",
         {"c COLOR0 0 1"}},
        {"struct V { float4 p[1] : SV_Position; float2 uv : TEXCOORD0; };\n"
         "V main(float4 n : NORMAL) { V v; v.p[0] = n; v.uv = 0; return v; }",
         {"uv TEXCOORD0 0 1"}},
        {"struct P { float4 p : SV_Position; float2 uv : TEXCOORD0; };\nstruct V { P inner[1]; float k : K; };\n"
         "void main(float4 n : NORMAL, out V v) { v.inner[0].p = n; v.inner[0].uv = n.xy; v.k = 1; }",
         {"uv TEXCOORD0 0 1", "k K0 1 1"}},
        {"struct P { float4 p : SV_Position; float2 uv : TEXCOORD0; };\n"
         "void main(float4 n : NORMAL, out P v[1]) { v[0].p = n; v[0].uv = n.xy; }",
         {"uv TEXCOORD0 0 1"}}};
    for (const VertexShader& each : shaders) {
        const ShaderLayout layout = Compile(each.text, "vs");
        EXPECT_TRUE(layout.writesPosition) << each.text;
        EXPECT_EQ(Lines(layout.outputs), each.outputs) << each.text;
    }
}

TEST_F(ForeignTest, InvalidTypesAndStagesAreToldWithTheWayOut) {
    struct InvalidShader {
        const char* text;
        const char* profile;
        const char* message;
    };
    const InvalidShader shaders[] = {
        {"float4 main(float4 p : SV_Position, nointerpolation bool b[2] : B) : SV_Target { return b[0] ? 1 : 0; }",
         "ps", " in 'main', which is its fault, not the shader's: declare 'b' as uint ("},
        {"float4 main(float i : SV_VertexID) : SV_Position { return i; }", "vs",
         "SPIR-V in 'main': declare 'i' as uint ("},
        {"float4 main(uint f : SV_IsFrontFace) : SV_Target { return f; }", "ps",
         "SPIR-V in 'main': declare 'f' as bool ("},
        {"float4 main(out float2 d : SV_Depth) : SV_Target { d = 1; return 1; }", "ps", "declare 'd' as float ("},
        {"float4 main(float2 a : A) : SV_Position { return ddx(a.x); }", "vs",
         "SPIR-V in 'main': ddx, ddy, fwidth and Sample are for pixel shaders ("},
        {"float4 main(float2 a : A) : SV_Position { clip(a); return 1; }", "vs", "discard and clip are for pixel"},
        {"groupshared float g; float4 main() : SV_Target { g = 1; return g; }", "ps", "is for compute shaders ("}};
    for (const InvalidShader& each : shaders) {
        const RunResult run = Run(each.text, each.profile);
        EXPECT_EQ(run.exitCode, 1);
        EXPECT_NE(run.err.find(each.message), std::string::npos) << run.err;
    }
}

TEST_F(ForeignTest, BoolsTravelBetweenStagesAsUint) {
    constexpr uint16_t kOpDecorate = 71, kOpSelect = 169, kOpINotEqual = 171;
    constexpr uint32_t kFlat = 14;
    const auto count = [&](uint16_t opcode) {
        const SpirvModule module(Spirv());
        return std::ranges::count(module.instructions, opcode, &SpirvInstruction::opcode);
    };
    const auto types = [](const std::vector<LayoutVariable>& variables) {
        Words names;
        for (const LayoutVariable& each : variables)
            names.push_back(each.type);
        return names;
    };
    const std::string vertex =
        "void main(float4 p : P, bool a : A, bool3 b : B, out float4 o : SV_Position, out bool c : C,\n"
        "          out bool2 d : D) { o = p; c = a; d = b.xz; }\n";
    for (const char* level : {"-O0", "-O3"}) {
        const ShaderLayout layout = Compile(vertex, "vs", {level});
        EXPECT_EQ(types(layout.inputs), (Words{"float4", "uint", "uint3"}));
        EXPECT_EQ(types(layout.outputs), (Words{"uint", "uint2"}));
        EXPECT_EQ(count(kOpINotEqual), 2);
        EXPECT_EQ(count(kOpSelect), 2);
    }
    Write("a.vs.hlsl", vertex);
    const ShaderLayout layout = Compile(
        "float4 main(float4 o : SV_Position, bool c : C, nointerpolation bool2 d : D, bool front : SV_IsFrontFace)\n"
        "    : SV_Target0 { return c && d.y && front ? 1 : 0; }\n",
        "ps", {"--after", "a.vs.hlsl", "-Zi"});
    EXPECT_EQ(types(layout.inputs), (Words{"uint", "uint2"}));
    EXPECT_EQ(count(kOpINotEqual), 2);
    EXPECT_EQ(Count(kOpDecorate, kFlat), 3u);  // c, d, and front, which stays a bool
}

TEST_F(ForeignTest, PixelCoordinateMayHaveAnIndexOfZero) {
    const ShaderLayout layout =
        Compile("float4 main(float4 p : SV_Position0, float2 uv : UV) : SV_Target0 { return p + uv.xyxy; }", "ps");
    EXPECT_EQ(Lines(layout.inputs), Words{"uv UV0 0 1"});
}

TEST_F(ForeignTest, PositionWithAnotherIndexIsStillMissing) {
    const RunResult run = Run("void main(out float4 p : SV_Position1) { p = 0; }", "vs");
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_NE(run.err.find("'main' does not write SV_Position"), std::string::npos) << run.err;
}

constexpr const char* kSelect =
    "float4 main(float4 a : A, float4 b : B) : SV_Target0 {\n"
    "    bool2 both = and(a.xy > 0.5, or(b.x > 0.5, b.zw > 0.5));\n"
    "    return select(both.x, select(a > b, a, 0), 1);\n"
    "}\n";

TEST_F(ForeignTest, SelectAndOrAreThereWithHlsl2021Only) {
    Compile(kSelect, "ps", {"-HV", "2021", "-WX"});
    const RunResult run = Run(kSelect, "ps", {"-HV", "2018"});
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_NE(run.err.find("shader.hlsl:2:18: error: 'and': no matching overloaded function found"),
              std::string::npos)
        << run.err;
}

// Narrowed to float on the way, they would come out by a conversion.
TEST_F(ForeignTest, SelectKeepsDoublesAndHalves) {
    constexpr uint16_t kOpFConvert = 115;
    const auto conversions = [&] {
        const SpirvModule module(Spirv());
        return std::ranges::count(module.instructions, kOpFConvert, &SpirvInstruction::opcode);
    };
    Compile(
        "RWStructuredBuffer<double> d : register(u0);\n"
        "[numthreads(1, 1, 1)] void main(uint i : SV_DispatchThreadID) { d[i] = select(i > 2, d[i + 1], d[i + 2]); "
        "}\n",
        "cs", {"-HV", "2021"});
    EXPECT_EQ(conversions(), 0);
    Compile(
        "RWStructuredBuffer<half4> h : register(u0);\n"
        "[numthreads(1, 1, 1)] void main(uint i : SV_DispatchThreadID) { h[i] = select(h[0] > h[1], h[2], h[3]); }\n",
        "cs", {"-HV", "2021", "-enable-16bit-types"});
    EXPECT_EQ(conversions(), 0);
    Compile(
        "RWStructuredBuffer<half4> h : register(u0);\n"
        "[numthreads(1, 1, 1)] void main(uint i : SV_DispatchThreadID) {\n"
        "    h[i] = select(h[0] > h[1], h[2], 1) + select(i > 2, h[1], true) + select(i > 2, i, h[0].x); }\n",
        "cs", {"-HV", "2021", "-enable-16bit-types"});
    Compile(
        "RWStructuredBuffer<double3> d : register(u0);\n"
        "[numthreads(1, 1, 1)] void main(uint i : SV_DispatchThreadID) {\n"
        "    d[i] = select(d[1] > d[2], i, 0.5) + select(i > 2, true, d[2]) + select(d[1] > 0, -1, d[3]); }\n",
        "cs", {"-HV", "2021"});
}

TEST_F(ForeignTest, FunctionAndMacroOfTheSameNameGoBeforeThePrelude) {
    // Its own result is told from the intrinsic's: a constant that nothing else makes.
    const auto hasConstant = [&](float value) {
        uint32_t word;
        std::memcpy(&word, &value, sizeof word);
        const std::vector<uint32_t> spirv = Spirv();
        return std::ranges::find(spirv, word) != spirv.end();
    };
    Compile(
        "float4 select(bool4 c, float4 a, float4 b) { return 1234.5; }\n"
        "float4 main(float4 a : A) : SV_Target0 { return select(a > 0, a, a); }\n",
        "ps", {"-HV", "2021"});
    EXPECT_TRUE(hasConstant(1234.5f));
    Compile(
        "#define select(c, a, b) ((a) * 1234.5)\n"
        "float4 main(float4 a : A) : SV_Target0 { return select(a > 0, a, a); }\n",
        "ps", {"-HV", "2021"});
    EXPECT_TRUE(hasConstant(1234.5f));
    Compile(
        "struct S { float select; };\n"
        "float4 main(float4 a : A) : SV_Target0 { S s; s.select = 1234.5; float or = s.select; return or; }\n",
        "ps", {"-HV", "2021"});
}

TEST_F(ForeignTest, MessagesKeepTheirPlacesBehindThePrelude) {
    const RunResult run = Run(std::string(kSelect) + "float f() { return nope; }\n", "ps", {"-HV", "2021"});
    EXPECT_TRUE(run.err.starts_with("shader.hlsl:5:20: error: 'nope': unknown variable")) << run.err;
    const RunResult wrong =
        Run("float4 main(float4 a : A) : SV_Target0 {\n    return select(a, a); }\n", "ps", {"-HV", "2021"});
    EXPECT_TRUE(wrong.err.starts_with("shader.hlsl:2:12: error: 'select': no matching overloaded function found"))
        << wrong.err;
}

// Every function, on a byte address buffer (whose methods the compiler does not convert for) and on typed memory,

// with operands of each type, with the old value wanted in each type and not.

TEST_F(ForeignTest, AtomicsOfEveryKindAreValid) {
    std::string manifest;
    size_t count = 0;
    const std::pair<const char*, const char*> memories[] = {
        {"RWByteAddressBuffer g : register(u0);", "g.{}(12, {});"},
        {"groupshared uint g;", "{}(g, {});"},
        {"RWStructuredBuffer<int> g : register(u0);", "{}(g[3], {});"},
        {"RWTexture2D<uint> g : register(u0);", "{}(g[uint2(3, 2)], {});"}};
    for (const auto& [declaration, form] : memories)
        for (const char* function :
             {"InterlockedAdd", "InterlockedAnd", "InterlockedOr", "InterlockedXor", "InterlockedMin",
              "InterlockedMax", "InterlockedExchange", "InterlockedCompareExchange", "InterlockedCompareStore"}) {
            const std::string name = function;
            std::string body;
            for (const char* value : {"1", "1u", "-1", "x", "y", "1.5", "f", "b"})
                for (const char* before : {"", ", oldUint", ", oldInt"}) {
                    const bool wantsOld = before[0] != '\0';
                    if (name == "InterlockedCompareStore" ? wantsOld : name.ends_with("Exchange") && !wantsOld)
                        continue;
                    const std::string compare = name.find("Compare") == std::string::npos ? "" : "7, ";
                    body += fmt::format(fmt::runtime(form), name, compare + value + before) + "\n";
                    ++count;
                }
            const std::string file = fmt::format("a{}.hlsl", std::ranges::count(manifest, '\n'));
            Write(file,
                  fmt::format("{}\nRWStructuredBuffer<uint> r : register(u1);\n"
                              "[numthreads(4, 1, 1)] void main(uint x : SV_DispatchThreadID) {{\n"
                              "int y = (int)x - 5; float f = x; bool b = x > 2; uint oldUint = 0; int oldInt = 0;\n"
                              "{}r[x] = oldUint + oldInt; }}\n",
                              declaration, body));
            manifest += file + " -T cs -WX\n";
        }
    Write("s.cfg", manifest);
    const RunResult run = Bxc({"build", "s.cfg", "-o", "out"});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_EQ(run.err, "");
    EXPECT_EQ(count, 4u * (6 * 24 + 16 + 16 + 8));
}

// A scalar literal gave an id twice, and a scalar variable a crash.

TEST_F(ForeignTest, StoresOfSeveralWordsTakeScalars) {
    for (const char* value : {"0", "1u", "-1", "1.5", "x", "y", "f", "b"})
        for (const int size : {2, 3, 4})
            Compile(fmt::format("RWByteAddressBuffer g : register(u0);\n"
                                "[numthreads(4, 1, 1)] void main(uint x : SV_DispatchThreadID) {{\n"
                                "    int y = -int(x); float f = x; bool b = x > 2; g.Store{}(16 * x, {}); }}\n",
                                size, value),
                    "cs");
    Compile(
        "float Store2(float a, float2 b) { return a + b.x; }\n"
        "float4 main() : SV_Target0 { return Store2(1, float2(2, 3)); }\n",
        "ps");
}

TEST_F(ForeignTest, PushConstantsMayHaveARegister) {
    const ShaderLayout layout = Compile(
        "struct S { float4 tint; };\n[[vk::push_constant]] ConstantBuffer<S> g : register(b0, space1);\n"
        "float4 main() : SV_Target0 { return g.tint; }\n",
        "ps");
    ASSERT_EQ(layout.resources.size(), 1u);
    EXPECT_EQ(layout.resources[0].kind, ResourceKind::PushConstants);
}

TEST_F(ForeignTest, AttributesForDirect3dAreSilentAndOthersAreNot) {
    const std::string body = "float4 main(float4 a : A) : SV_Target0 {\n";
    Compile("[RootSignature(\"RootFlags(0),\" \"CBV(b0)\")]\n[shader(\"pixel\")]\n" + body +
                "    [fastopt] for (int i = 0; i < int(a.x); ++i) a += 1;\n"
                "    [allow_uav_condition]\n    while (a.x > 1) a *= 0.5;\n"
                "    [call] switch ((int)a.y) { case 0: a = 1; break; default: break; }\n"
                "    [forcecase] switch ((int)a.y) { case 0: a = 1; break; default: break; }\n"
                "    return a; }\n",
            "ps", {"-WX"});
    for (const char* text : {"[rootsig] ", "[wavesize(32)] "}) {
        const RunResult run = Run(text + body + "return a; }", "ps", {"-WX"});
        EXPECT_EQ(run.exitCode, 1);
        EXPECT_NE(run.err.find("unrecognized attribute"), std::string::npos) << run.err;
    }
    const RunResult loop = Run(body + "[flatten] for (int i = 0; i < 2; ++i) a += 1; return a; }", "ps", {"-WX"});
    EXPECT_NE(loop.err.find("attribute does not apply to a loop"), std::string::npos) << loop.err;
}

constexpr const char* kStages =
    "struct V { float4 position : SV_Position; float2 uv[2] : TEXCOORD0; nointerpolation uint key : KEY; };\n"
    "struct Patch { float edges[3] : SV_TessFactor; float inside : SV_InsideTessFactor; float3 extra : EXTRA; };\n"
    "V VS(float4 p : POSITION) { V v = (V)0; v.position = p; return v; }\n"
    "Patch OfPatch(InputPatch<V, 3> v) {\n"
    "    Patch c; c.edges[0] = c.edges[1] = c.edges[2] = c.inside = 4; c.extra = v[0].uv[1].xyx; return c; }\n"
    "[domain(\"tri\")] [partitioning(\"integer\")] [outputtopology(\"triangle_cw\")] [outputcontrolpoints(3)]\n"
    "[patchconstantfunc(\"OfPatch\")] V HS(InputPatch<V, 3> v, uint i : SV_OutputControlPointID) { return v[i]; }\n"
    "[domain(\"tri\")] V DS(Patch c, float3 at : SV_DomainLocation, const OutputPatch<V, 3> v) {\n"
    "    V o = v[0]; o.position = v[1].position * at.x; o.uv[0] += c.extra.xy; return o; }\n"
    "[maxvertexcount(3)] void GS(triangle V v[3], inout TriangleStream<V> stream) {\n"
    "    for (int i = 0; i < 3; ++i) stream.Append(v[i]); stream.RestartStrip(); }\n"
    "float4 PS(V v) : SV_Target0 { return v.uv[0].xyxy + v.uv[1].xyxy + v.key; }\n";

TEST_F(ForeignTest, EveryStageIsCompiledReflectedAndLinked) {
    const Words varyings = {"uv[0] TEXCOORD0 0 1", "uv[1] TEXCOORD1 1 1", "key KEY0 2 1"};
    Words withExtra = varyings;
    withExtra.push_back("extra EXTRA0 3 1");
    struct LinkedStages {
        const char *entry, *profile, *after, *afterProfile;
        ShaderStage stage;
        Words inputs, outputs;
        bool writesPosition;
    };
    const LinkedStages links[] = {
        {"HS", "hs_5_0", "VS", "vs", ShaderStage::Hull, varyings, withExtra, false},
        {"DS", "ds_5_0", "HS", "hs", ShaderStage::Domain, withExtra, varyings, true},
        {"GS", "gs_5_0", "DS", "ds", ShaderStage::Geometry, varyings, varyings, true},
        {"GS", "gs_5_0", "VS", "vs", ShaderStage::Geometry, varyings, varyings, true},
        {"PS", "ps_5_0", "GS", "gs", ShaderStage::Pixel, varyings, {" SV_TARGET0 0 1"}, false},
        {"PS", "ps_5_0", "DS", "ds", ShaderStage::Pixel, varyings, {" SV_TARGET0 0 1"}, false}};
    for (const LinkedStages& each : links)
        for (const char* level : {"-O0", "-O3"}) {
            SCOPED_TRACE(fmt::format("{} after {}, {}", each.entry, each.after, level));
            const ShaderLayout layout = Compile(kStages, each.profile,
                                                {"-E", each.entry, level, "--after", "shader.hlsl", "--after-T",
                                                 each.afterProfile, "--after-E", each.after});
            EXPECT_EQ(layout.stage, each.stage);
            EXPECT_EQ(layout.writesPosition, each.writesPosition);
            EXPECT_FALSE(FindFault(Spirv(), ValidationStep::Final));
            EXPECT_EQ(Lines(layout.inputs), each.inputs);
            EXPECT_EQ(Lines(layout.outputs), each.outputs);
        }
}

TEST_F(ForeignTest, WhatAStageDoesNotHandOnIsNamedWithItsStage) {
    Write("a.gs.hlsl",
          "struct V { float4 position : SV_Position; };\n"
          "[maxvertexcount(1)] void main(point V v[1], inout PointStream<V> s) { s.Append(v[0]); }\n");
    const RunResult run = Run("float4 main(float2 uv : TEXCOORD0) : SV_Target0 { return uv.xyxy; }", "ps",
                              {"--after", "a.gs.hlsl", "--after-T", "gs"});
    EXPECT_EQ(run.err,
              "shader.hlsl:1:20: error: the geometry shader does not write 'float2 uv : TEXCOORD0'; use one "
              "struct for both stages [stage_link]\n");
}

// The place, the function, whose fault it is, and what to write instead.

TEST_F(ForeignTest, InvalidSpirvIsTracedToItsFunctionAndLine) {
    Write("inc/help.hlsli", "float Steps(float x)\n{\n    float y = x + 1;\n    return ldexp(y, 3);\n}\n");
    const RunResult run =
        Run("#include \"inc/help.hlsli\"\n\nfloat4 main(float2 uv : TEXCOORD0) : SV_Target0\n{\n"
            "    return Steps(uv.x);\n}\n",
            "ps");
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_TRUE(
        run.err.starts_with("inc/help.hlsli:4: error: invalid SPIR-V from the compiler in 'Steps', which is its "
                            "fault, not the shader's: write x * exp2(e) instead of ldexp(x, e) (GLSL.std.450 Ldexp"))
        << run.err;
    EXPECT_EQ(std::ranges::count(run.err, '\n'), 1);

    const RunResult entry =
        Run("float4 main(float2 uv : TEXCOORD0) : SV_Target0\n{\n    return any(uv.x);\n}\n", "ps");
    EXPECT_TRUE(
        entry.err.starts_with("shader.hlsl:3: error: invalid SPIR-V from the compiler in 'main', which is its "
                              "fault, not the shader's: compare with 0 instead of calling any() on a scalar ("))
        << entry.err;
}

// What is wrong is a declaration, which belongs to no function: its first use does.

TEST_F(ForeignTest, InvalidDeclarationIsTracedToItsFirstUse) {
    const RunResult run =
        Run("float4 Plain(float4 a) { return a; }\n"
            "float4 Sum(int2x3 m)\n{\n    return m[0].xyzz + m[1].xyzz;\n}\n"
            "float4 main(float4 a : A) : SV_Target0\n{\n    return Plain(a) + Sum((int2x3)3);\n}\n",
            "ps");
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_NE(run.err.find("use a float matrix, or an array of vectors (Matrix types can only be parameterized"),
              std::string::npos)
        << run.err;
    const bool isInSum = run.err.starts_with("shader.hlsl:2: ") || run.err.starts_with("shader.hlsl:3: ") ||
                         run.err.starts_with("shader.hlsl:4: ");
    EXPECT_TRUE(isInSum && run.err.find("invalid SPIR-V from the compiler in 'Sum'") != std::string::npos) << run.err;
}

}  // namespace
}  // namespace boxcar
