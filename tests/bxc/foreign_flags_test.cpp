// The flags and manifests of other people's build scripts: what they make of a shader.
#include <sstream>

#include "tests/bxc/foreign_test.h"

namespace boxcar {
namespace {

using ForeignFlagsTest = ForeignTest;

constexpr uint16_t kOpDecorate = 71, kOpMemberDecorate = 72;
constexpr uint32_t kNoContraction = 42;

TEST_F(ForeignFlagsTest, MatricesLieByRowsWithZpr) {
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

TEST_F(ForeignFlagsTest, YearFollowsWithoutASpace) {
    const std::string text = "float4 main(float4 a : A) : SV_Target0 { return select(a > 0, a, 1); }\n";
    Compile(text, "ps", {"-HV2021"});
    Compile(text, "ps", {"/HV2021"});
    EXPECT_EQ(Run(text, "ps", {"-HV2018"}).exitCode, 1);
}

TEST_F(ForeignFlagsTest, RegistersShiftAsTheFlagsSay) {
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

TEST_F(ForeignFlagsTest, HeaderHoldsTheBytesOfTheSpirv) {
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

TEST_F(ForeignFlagsTest, HeaderAloneNeedsNoOutputAndVnNamesItsArray) {
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

TEST_F(ForeignFlagsTest, FoTakesANameWithAnyEnding) {
    Write("a.hlsl", kPlainPixelShader);
    EXPECT_EQ(Bxc({"compile", "a.hlsl", "-T", "ps", "-Fo", "out.cso"}).exitCode, 0);
    EXPECT_TRUE(Exists("out.cso") && Exists("out.cso.layout.json") && Exists("out.cso.d"));
}

TEST_F(ForeignFlagsTest, GisForbidsContractionOfEveryOperation) {
    const std::string text =
        "float4 main(float4 a : A, float4 b : B) : SV_Target0 { return a * b + dot(a, b) - a / b; }\n";
    Compile(text, "ps");
    EXPECT_EQ(Count(kOpDecorate, kNoContraction), 0u);
    Compile(text, "ps", {"/Gis"});
    EXPECT_EQ(Count(kOpDecorate, kNoContraction), 5u) << "multiply, dot, add, divide, subtract";
}

TEST_F(ForeignFlagsTest, PositionIsTurnedOverAndItsWInvertedWhereAsked) {
    constexpr uint16_t kOpFNegate = 127, kOpFDiv = 136;
    const auto count = [&](uint16_t opcode) {
        return std::ranges::count(SpirvModule(Spirv()).instructions, opcode, &SpirvInstruction::opcode);
    };
    const std::string vertex = "float4 main(float4 p : POSITION) : SV_Position { return p; }\n";
    Compile(vertex, "vs");
    EXPECT_EQ(count(kOpFNegate), 0);
    Compile(vertex, "vs", {"-fvk-invert-y"});
    EXPECT_EQ(count(kOpFNegate), 1);
    const std::string pixel = "float4 main(float4 p : SV_Position) : SV_Target0 { return p.w; }\n";
    Compile(pixel, "ps");
    EXPECT_EQ(count(kOpFDiv), 0);
    Compile(pixel, "ps", {"-fvk-use-dx-position-w"});
    EXPECT_EQ(count(kOpFDiv), 1);
}

TEST_F(ForeignFlagsTest, HalfHas16BitsWhereAsked) {
    constexpr uint16_t kOpTypeFloat = 22;
    const std::string text =
        "StructuredBuffer<half4> b : register(t0);\n"
        "float4 main(min16float c : C) : SV_Target0 { half4 r = c + b[2]; return r; }\n";
    Compile(text, "ps");
    EXPECT_EQ(Count(kOpTypeFloat, 16), 0u);
    Compile(text, "ps", {"/enable-16bit-types"});
    EXPECT_EQ(Count(kOpTypeFloat, 16), 1u);
}

TEST_F(ForeignFlagsTest, ShaderMakesManifestIsBuiltWithTheFlagsOfItsCommandLine) {
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
