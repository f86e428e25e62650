// Other people's HLSL and build scripts: what is accepted, and what it becomes. tests/hlsl runs it on a device.
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <sstream>

#include "tests/bxc/bxc_test.h"
#include "tools/bxc/spirv_module.h"
#include "tools/bxc/validate.h"

namespace boxcar {
namespace {

class ForeignTest : public BxcTest {
protected:
    using Words = std::vector<std::string>;

    RunResult Run(const std::string& text, const std::string& profile, const Words& flags = {}) const {
        Write("shader.hlsl", text);
        Words words = {"compile", "shader.hlsl", "-T", profile, "-o", "out.spv"};
        words.insert(words.end(), flags.begin(), flags.end());
        return Bxc(words);
    }

    // Compiles without a word, and returns the layout.
    ShaderLayout Compile(const std::string& text, const std::string& profile, const Words& flags = {}) const {
        const RunResult run = Run(text, profile, flags);
        EXPECT_EQ(run.exitCode, 0) << run.err;
        EXPECT_EQ(run.out + run.err, "");
        return run.exitCode == 0 ? ReadLayout("out.layout.json") : ShaderLayout{};
    }

    std::vector<uint32_t> Spirv() const {
        const std::string bytes = Read("out.spv");
        std::vector<uint32_t> words(bytes.size() / 4);
        std::memcpy(words.data(), bytes.data(), words.size() * 4);
        return words;
    }

    // How many instructions of the output have this opcode and, as their second operand, this word.
    size_t Count(uint16_t opcode, uint32_t second) const {
        const SpirvModule module(Spirv());
        return static_cast<size_t>(std::ranges::count_if(module.instructions, [&](const SpirvInstruction& each) {
            return each.opcode == opcode && each.operands.size() > 1 && each.operands[1] == second;
        }));
    }

    // "name semantic location", one a variable
    static Words Lines(const std::vector<LayoutVariable>& variables) {
        Words lines;
        for (const LayoutVariable& v : variables)
            lines.push_back(fmt::format("{} {} {} {}", v.name, v.semantic, v.location, v.locationCount));
        return lines;
    }

    // "name set binding"
    static Words Bindings(const ShaderLayout& layout) {
        Words lines;
        for (const LayoutResource& r : layout.resources)
            lines.push_back(fmt::format("{} {} {}", r.name, r.set, r.binding));
        return lines;
    }
};

constexpr uint16_t kOpDecorate = 71, kOpMemberDecorate = 72;
constexpr uint32_t kNoContraction = 42;

TEST_F(ForeignTest, PositionOfAnInoutParameterIsThePositionWhereverItStands) {
    struct Case {
        const char* text;
        Words outputs;
    };
    const Case cases[] = {
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
    for (const Case& each : cases) {
        const ShaderLayout layout = Compile(each.text, "vs");
        EXPECT_TRUE(layout.writesPosition) << each.text;
        EXPECT_EQ(Lines(layout.outputs), each.outputs) << each.text;
    }
}

TEST_F(ForeignTest, PixelCoordinateMayHaveAnIndexOfZero) {
    const ShaderLayout layout =
        Compile("float4 main(float4 p : SV_Position0, float2 uv : UV) : SV_Target0 { return p + uv.xyxy; }", "ps");
    EXPECT_EQ(Lines(layout.inputs), Words{"uv UV0 0 1"});
}

TEST_F(ForeignTest, PositionWithAnotherIndexIsStillMissing) {
    const RunResult run = Run("void main(out float4 p : SV_Position1) { p = 0; }", "vs");
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_NE(run.err.find("'main' writes no SV_Position"), std::string::npos) << run.err;
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

TEST_F(ForeignTest, MatricesLieByRowsWithZpr) {
    // RowMajor and ColMajor in SPIR-V are the other way round: its matrices are HLSL's, transposed.
    constexpr uint32_t kRowMajor = 4, kColMajor = 5;
    const std::string text =
        "cbuffer C : register(b0) { float3x4 m; column_major float3x4 c; row_major float3x4 r; };\n"
        "float4 main(float4 a : A) : SV_Target0 { return (mul(m, a) + mul(c, a) + mul(r, a)).xyzz; }\n";
    const auto count = [&](uint32_t decoration) {
        const SpirvModule module(Spirv());
        return std::ranges::count_if(module.instructions, [&](const SpirvInstruction& each) {
            return each.opcode == kOpMemberDecorate && each.operands[2] == decoration;
        });
    };
    const auto sizes = [](const ShaderLayout& layout) {
        std::vector<uint32_t> result;
        for (const LayoutMember& member : layout.resources.at(0).members)
            result.push_back(member.sizeBytes);
        return result;
    };
    EXPECT_EQ(sizes(Compile(text, "ps")), (std::vector<uint32_t>{64, 64, 48}));
    EXPECT_EQ(count(kRowMajor), 2);
    EXPECT_EQ(sizes(Compile(text, "ps", {"/Zpr"})), (std::vector<uint32_t>{48, 64, 48}));
    EXPECT_EQ(count(kColMajor), 2);
    EXPECT_EQ(sizes(Compile(text, "ps", {"/Zpr", "/Zpc"})), (std::vector<uint32_t>{64, 64, 48}));
}

TEST_F(ForeignTest, RegistersShiftAsTheFlagsSay) {
    const std::string text =
        "cbuffer Params : register(b2) { float4 tint; };\n"
        "SamplerState nearest : register(s3);\n"
        "Texture2D<float4> source : register(t4), page : register(t0, space1);\n"
        "StructuredBuffer<float4> list : register(t6);\n"
        "RWStructuredBuffer<uint> counts : register(u2, space1);\n"
        "RWTexture2D<float4> target : register(u5);\n"
        "[numthreads(8, 4, 2)] void main(uint3 id : SV_DispatchThreadID) {\n"
        "    target[id.xy] = tint + source.SampleLevel(nearest, float2(0, 0), 0) + page.Load(int3(0, 0, 0)) + "
        "list[id.x];\n"
        "    counts[id.x] = 1;\n"
        "}\n";
    EXPECT_EQ(
        Bindings(Compile(text, "cs", {"-fvk-t-shift", "100", "0"})),
        (Words{"Params 0 2", "nearest 0 3", "target 0 5", "source 0 104", "list 0 106", "page 1 0", "counts 1 2"}));
    EXPECT_EQ(Bindings(Compile(text, "cs",
                               {"-fvk-t-shift", "100", "all", "-fvk-t-shift", "0", "1", "/fvk-s-shift", "300", "0",
                                "-fvk-b-shift", "7", "0", "-fvk-u-shift", "200", "1"})),
              (Words{"target 0 5", "Params 0 9", "source 0 104", "list 0 106", "nearest 0 303", "page 1 0",
                     "counts 1 202"}));
    EXPECT_EQ(Bindings(Compile(text, "cs", {"-fvk-u-shift", "200", "all", "-fvk-t-shift", "10", "all"})),
              (Words{"Params 0 2", "nearest 0 3", "source 0 14", "list 0 16", "target 0 205", "page 1 10",
                     "counts 1 202"}));
    const RunResult clash = Run(text, "cs", {"-fvk-t-shift", "1", "0"});
    EXPECT_TRUE(
        clash.err.starts_with("shader.hlsl:6:21: error: 'target' is on binding 5 of set 0, where 'source' is"))
        << clash.err;
}

TEST_F(ForeignTest, HeaderHoldsTheBytesOfTheSpirv) {
    Compile(kPlainPixelShader, "ps", {"/Fh", "inc/a.h"});
    const std::string header = Read("inc/a.h"), spirv = Read("out.spv");
    EXPECT_NE(header.find("\nconst unsigned char g_main[] = {\n"), std::string::npos) << header.substr(0, 400);
    std::string bytes, word;
    for (std::istringstream words(header.substr(header.find('{'))); words >> word;)
        if (word.starts_with("0x")) bytes += static_cast<char>(std::stoi(word.substr(2, 2), nullptr, 16));
    EXPECT_EQ(bytes, spirv);

    // As C and as C++, in which a module may be made of it without a copy: it is aligned as words are.
    Write("a.c", "#include \"inc/a.h\"\n_Static_assert(sizeof g_main % 4 == 0 && _Alignof(unsigned) == 4, \"\");\n");
    Write("a.cpp",
          "#include <cstdint>\n#include \"inc/a.h\"\nstatic_assert(sizeof g_main % 4 == 0);\n"
          "int main() { return reinterpret_cast<std::uintptr_t>(g_main) % 4; }\n");
    for (const char* file : {"a.c", "a.cpp"}) {
        const RunResult run =
            RunProgram({CXX_COMPILER, "-fsyntax-only", "-x", file[2] == 'c' && file[3] == '\0' ? "c" : "c++", file,
                        "-std=" + std::string(file[3] == '\0' ? "c11" : "c++20")});
        EXPECT_EQ(run.exitCode, 0) << run.err;
    }
}

TEST_F(ForeignTest, HeaderAloneNeedsNoOutputAndVnNamesItsArray) {
    Write("a.hlsl", kPlainPixelShader);
    const RunResult run = Bxc({"compile", "a.hlsl", "/nologo", "/Tps_5_0", "/Zi", "/Od", "/Fhout.h", "/Vn", "kBlur"});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_NE(Read("out.h").find("const unsigned char kBlur[] = {"), std::string::npos);
    EXPECT_TRUE(Exists("out.layout.json"));
    EXPECT_TRUE(Read("out.d").ends_with("\nout.h: \\\n  a.hlsl\n")) << Read("out.d");
    EXPECT_FALSE(Exists("out.spv") || Exists(".spv"));

    Write("a.hlsl", "nonsense");
    EXPECT_EQ(Bxc({"compile", "a.hlsl", "-T", "ps", "-Fh", "out.h"}).exitCode, 1);
    EXPECT_FALSE(Exists("out.h") || Exists("out.d") || Exists("out.layout.json"))
        << "nothing of a failed shader is left";
}

TEST_F(ForeignTest, FoTakesANameWithAnyEnding) {
    Write("a.hlsl", kPlainPixelShader);
    EXPECT_EQ(Bxc({"compile", "a.hlsl", "-T", "ps", "-Fo", "out.cso"}).exitCode, 0);
    EXPECT_TRUE(Exists("out.cso") && Exists("out.cso.layout.json") && Exists("out.cso.d"));
}

TEST_F(ForeignTest, GisForbidsContractionOfEveryOperation) {
    const std::string text =
        "float4 main(float4 a : A, float4 b : B) : SV_Target0 { return a * b + dot(a, b) - a / b; }\n";
    Compile(text, "ps");
    EXPECT_EQ(Count(kOpDecorate, kNoContraction), 0u);
    Compile(text, "ps", {"/Gis"});
    EXPECT_EQ(Count(kOpDecorate, kNoContraction), 5u) << "multiply, dot, add, divide, subtract";
}

TEST_F(ForeignTest, HalfHas16BitsWhereAsked) {
    constexpr uint16_t kOpTypeFloat = 22;
    const std::string text =
        "StructuredBuffer<half4> b : register(t0);\n"
        "float4 main(min16float c : C) : SV_Target0 { half4 r = c + b[2]; return r; }\n";
    Compile(text, "ps");
    EXPECT_EQ(Count(kOpTypeFloat, 16), 0u);
    Compile(text, "ps", {"/enable-16bit-types"});
    EXPECT_EQ(Count(kOpTypeFloat, 16), 1u);
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
    struct Case {
        const char *entry, *profile, *after, *afterProfile;
        ShaderStage stage;
        Words inputs, outputs;
        bool writesPosition;
    };
    const Case cases[] = {{"HS", "hs_5_0", "VS", "vs", ShaderStage::Hull, varyings, withExtra, false},
                          {"DS", "ds_5_0", "HS", "hs", ShaderStage::Domain, withExtra, varyings, true},
                          {"GS", "gs_5_0", "DS", "ds", ShaderStage::Geometry, varyings, varyings, true},
                          {"GS", "gs_5_0", "VS", "vs", ShaderStage::Geometry, varyings, varyings, true},
                          {"PS", "ps_5_0", "GS", "gs", ShaderStage::Pixel, varyings, {" SV_TARGET0 0 1"}, false},
                          {"PS", "ps_5_0", "DS", "ds", ShaderStage::Pixel, varyings, {" SV_TARGET0 0 1"}, false}};
    for (const Case& each : cases)
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
              "shader.hlsl:1:20: error: the geometry shader does not write 'float2 uv : TEXCOORD0'; let both "
              "stages share one struct [stage_link]\n");
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
                            "fault and not the shader's: write x * exp2(e) for ldexp(x, e) (GLSL.std.450 Ldexp"))
        << run.err;
    EXPECT_EQ(std::ranges::count(run.err, '\n'), 1);

    const RunResult entry =
        Run("float4 main(float2 uv : TEXCOORD0) : SV_Target0\n{\n    return any(uv.x);\n}\n", "ps");
    EXPECT_TRUE(
        entry.err.starts_with("shader.hlsl:3: error: invalid SPIR-V from the compiler in 'main', which is its "
                              "fault and not the shader's: compare with 0 instead of any() of a scalar ("))
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

TEST_F(ForeignTest, ShaderMakesManifestIsBuiltWithTheFlagsOfItsCommandLine) {
    Write("proj/hlsl/sub/a.hlsl",
          "#include <shared.h>\n#ifdef SCALED\n#define SCALE 2\n#else\n#define SCALE 1\n#endif\n"
          "float4 first(float4 p : POSITION) : SV_Position { return select(p > 0, p, 0) * SCALE; }\n"
          "float4 second(float4 p : POSITION) : SV_Position { return p * VALUE; }\n");
    Write("proj/inc/shared.h", "#define VALUE 3\n");
    Write("proj/hlsl/s.cfg",
          "// ShaderMake's form\nsub/a.hlsl -T vs -E {first,second} -D {SCALED,} -D M={0,1}\n"
          "#ifdef NONE\nmissing.hlsl -T ps\n#endif\n");
    const RunResult run = Bxc({"build", "proj/hlsl/s.cfg", "-o", "out", "-I", "proj/inc", "-HV", "2021", "-WX"});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_EQ(run.out, "bxc: 8 shaders: 8 compiled\n");
    for (const char* name : {"a.first.SCALED.M=0", "a.first.M=1", "a.second.SCALED.M=1", "a.second.M=0"})
        EXPECT_TRUE(Exists(fmt::format("out/sub/{}.spv", name))) << name;
    const RunResult again = Bxc({"build", "proj/hlsl/s.cfg", "-o", "out", "-I", "proj/inc", "-HV", "2021", "-WX"});
    EXPECT_EQ(again.out, "bxc: 8 shaders: 8 up to date\n");
    const RunResult other = Bxc({"build", "proj/hlsl/s.cfg", "-o", "out", "-I", "proj/inc", "-HV", "2021"});
    EXPECT_EQ(other.out, "bxc: 8 shaders: 8 compiled\n") << "other flags make other shaders";
}

}  // namespace
}  // namespace boxcar
