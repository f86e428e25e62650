// bxc compile, from text to files.
#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "tests/bxc/bxc_test.h"
#include "tools/bxc/validate.h"

namespace boxcar {
namespace {

class CompileTest : public BxcTest {
protected:
    // Compiles `text` and returns its layout.
    ShaderLayout Compile(const std::string& text, const std::string& profile, std::vector<std::string> flags = {}) {
        Write("shader.hlsl", text);
        std::vector<std::string> words = {"compile", "shader.hlsl", "-T", profile, "-o", "out.spv"};
        words.insert(words.end(), flags.begin(), flags.end());
        const RunResult run = Bxc(words);
        EXPECT_EQ(run.exitCode, 0) << run.err;
        EXPECT_EQ(run.out + run.err, "");
        return run.exitCode == 0 ? ReadLayout("out.layout.json") : ShaderLayout{};
    }

    std::vector<uint32_t> Words(const std::string& name) const {
        const std::string bytes = Read(name);
        std::vector<uint32_t> words(bytes.size() / 4);
        std::memcpy(words.data(), bytes.data(), words.size() * 4);
        return words;
    }

    // "kind name set binding count", one a resource
    static std::vector<std::string> Bindings(const ShaderLayout& layout) {
        std::vector<std::string> lines;
        for (const LayoutResource& r : layout.resources)
            lines.push_back(
                fmt::format("{} {} {} {} {}", static_cast<int>(r.kind), r.name, r.set, r.binding, r.count));
        return lines;
    }

    // "name offset size", one a member
    static std::vector<std::string> Members(const ShaderLayout& layout, const std::string& block) {
        std::vector<std::string> lines;
        for (const LayoutResource& resource : layout.resources)
            if (resource.name == block)
                for (const LayoutMember& member : resource.members)
                    lines.push_back(fmt::format("{} {} {}", member.name, member.offsetBytes, member.sizeBytes));
        return lines;
    }

    static std::string Line(ResourceKind kind, const std::string& rest) {
        return fmt::format("{} {}", static_cast<int>(kind), rest);
    }
};

using Lines = std::vector<std::string>;

TEST_F(CompileTest, WritesSpirv13ThatIsValidForVulkan11) {
    Compile(kPlainPixelShader, "ps_5_0");
    const std::vector<uint32_t> spirv = Words("out.spv");
    ASSERT_GT(spirv.size(), 5u);
    EXPECT_EQ(spirv[0], 0x07230203u);
    EXPECT_EQ(spirv[1], 0x00010300u);
    EXPECT_FALSE(FindFault(spirv, ValidationStep::Final));
}

TEST_F(CompileTest, RegistersAreShiftedByTheirClassAndSpacesAreSets) {
    const ShaderLayout layout = Compile(
        "cbuffer Params : register(b2) { float4 tint; };\n"
        "SamplerState nearest : register(s3);\n"
        "Texture2D<float4> source : register(t4);\n"
        "Texture2D<float4> pages[3] : register(t0, space1);\n"
        "Buffer<float4> typed : register(t5);\n"
        "StructuredBuffer<float4> structured : register(t6);\n"
        "ByteAddressBuffer raw : register(t127);\n"
        "RWTexture2D<float4> target : register(u5);\n"
        "RWStructuredBuffer<uint> counts : register(u63);\n"
        "RWBuffer<uint> typedTarget : register(u0);\n"
        "[numthreads(8, 4, 2)] void main(uint3 id : SV_DispatchThreadID) {\n"
        "    target[id.xy] = tint + source.SampleLevel(nearest, float2(0, 0), 0) + pages[1].Load(int3(0, 0, 0)) +\n"
        "                    typed[id.x] + structured[id.x] + raw.Load(id.x * 4);\n"
        "    counts[id.x] = 1;\n"
        "    typedTarget[id.x] = 2;\n"
        "}\n",
        "cs_5_0");
    EXPECT_EQ(
        Bindings(layout),
        (Lines{Line(ResourceKind::ConstantBuffer, "Params 0 2 1"), Line(ResourceKind::Sampler, "nearest 0 19 1"),
               Line(ResourceKind::TexelBuffer, "typedTarget 0 32 1"),
               Line(ResourceKind::StorageImage, "target 0 37 1"), Line(ResourceKind::StorageBuffer, "counts 0 95 1"),
               Line(ResourceKind::Texture, "source 0 100 1"), Line(ResourceKind::TexelBuffer, "typed 0 101 1"),
               Line(ResourceKind::StorageBuffer, "structured 0 102 1"),
               Line(ResourceKind::StorageBuffer, "raw 0 223 1"), Line(ResourceKind::Texture, "pages 1 96 3")}));
    EXPECT_EQ(layout.stage, ShaderStage::Compute);
    EXPECT_EQ(std::vector<uint32_t>(layout.threadGroup, layout.threadGroup + 3), (std::vector<uint32_t>{8, 4, 2}));
}

// Offsets by Direct3D's rules: 16-byte registers, nothing crosses one, arrays and structs start one.
TEST_F(CompileTest, ConstantsHaveDirect3dOffsets) {
    const ShaderLayout layout = Compile(
        "struct Light { float power; float3 color; };\n"
        "cbuffer Params : register(b0) {\n"
        "    float a; float3 b; float2 c; float3 d; float4 weights[2]; float4x4 m; float tail; Light light;\n"
        "};\n"
        "float4 main() : SV_Target0 { return a + b.x + c.x + d.x + light.color.x + weights[1] + m[0] + tail; }\n",
        "ps_5_0");
    EXPECT_EQ(Members(layout, "Params"), (Lines{"a 0 4", "b 4 12", "c 16 8", "d 32 12", "weights 48 32", "m 80 64",
                                                "tail 144 4", "light.power 160 4", "light.color 164 12"}));
    EXPECT_EQ(layout.resources.at(0).sizeBytes, 176u);
}

TEST_F(CompileTest, PushConstantsAreABlockWithoutABinding) {
    const ShaderLayout layout = Compile(
        "[[vk::push_constant]] cbuffer Push { float2 offset; uint count; };\n"
        "float4 main() : SV_Target0 { return offset.xyxy * count; }\n",
        "ps");
    EXPECT_EQ(Bindings(layout), Lines{Line(ResourceKind::PushConstants, "Push 0 0 1")});
    EXPECT_EQ(Members(layout, "Push"), (Lines{"offset 0 8", "count 8 4"}));
}

TEST_F(CompileTest, UnusedResourcesAreNotInTheLayout) {
    const ShaderLayout layout = Compile(
        "Texture2D<float4> used : register(t0), unused : register(t1);\n"
        "float4 main() : SV_Target0 { return used.Load(int3(0, 0, 0)); }\n",
        "ps");
    EXPECT_EQ(Bindings(layout), Lines{Line(ResourceKind::Texture, "used 0 96 1")});
}

TEST_F(CompileTest, StageInterfaceHasLocationsSemanticsAndTypes) {
    const ShaderLayout layout = Compile(
        "struct Out { float4 position : SV_Position; float4 uv[3] : TEXCOORD2; uint2 key : KEY; };\n"
        "Out main(float3 position : POSITION, float4x4 world : WORLD, int id : ID, uint vertex : SV_VertexID) {\n"
        "    Out o;\n"
        "    o.position = mul(world, float4(position, 1));\n"
        "    o.uv[0] = o.uv[1] = o.uv[2] = id;\n"
        "    o.key = vertex;\n"
        "    return o;\n"
        "}\n",
        "vs_5_0");
    EXPECT_EQ(layout.inputs, (std::vector<LayoutVariable>{{"position", "POSITION0", 0, 1, "float3"},
                                                          {"world", "WORLD0", 1, 4, "float4"},
                                                          {"id", "ID0", 5, 1, "int"}}));
    EXPECT_EQ(layout.outputs, (std::vector<LayoutVariable>{{"uv[0]", "TEXCOORD2", 0, 1, "float4"},
                                                           {"uv[1]", "TEXCOORD3", 1, 1, "float4"},
                                                           {"uv[2]", "TEXCOORD4", 2, 1, "float4"},
                                                           {"key", "KEY0", 3, 1, "uint2"}}));
    EXPECT_TRUE(layout.writesPosition);
    EXPECT_EQ(layout.stage, ShaderStage::Vertex);
    EXPECT_EQ(layout.source, "shader.hlsl");
}

TEST_F(CompileTest, EntryPointKeepsItsName) {
    const ShaderLayout layout = Compile("float4 Blur() : SV_Target0 { return 1; }", "ps", {"-E", "Blur"});
    EXPECT_EQ(layout.entry, "Blur");
    EXPECT_NE(Read("out.spv").find("Blur"), std::string::npos);
}

TEST_F(CompileTest, MacrosAndIncludeFoldersReachTheSource) {
    Write("inc/shared.hlsli",
          "#if COUNT == 3 && FLAG && defined(VULKAN)\nTexture2D<float4> source : register(t0);\n#endif\n");
    Compile("#include \"shared.hlsli\"\nfloat4 main() : SV_Target0 { return source.Load(int3(0, 0, 0)); }", "ps",
            {"-D", "COUNT=3", "-D", "FLAG", "-I", "inc"});
    EXPECT_TRUE(Read("out.d").ends_with("\nout.spv: \\\n  inc/shared.hlsli \\\n  shader.hlsl\n")) << Read("out.d");
}

TEST_F(CompileTest, Direct3d9SamplersNeedGec) {
    const std::string text =
        "sampler source : register(s2);\nfloat4 main(float2 uv : TEXCOORD0) : COLOR { return tex2D(source, uv); }\n";
    EXPECT_EQ(Bindings(Compile(text, "ps_3_0", {"-Gec"})),
              Lines{Line(ResourceKind::CombinedImageSampler, "source 0 98 1")});

    const RunResult run = Bxc({"compile", "shader.hlsl", "-T", "ps_3_0", "-o", "out.spv"});
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_TRUE(
        run.err.starts_with("shader.hlsl:2: error: invalid SPIR-V from the compiler in 'main', which is its fault, "
                            "not the shader's: compile with -Gec for sampler and tex2D, or use Texture2D "
                            "and SamplerState (Expected Sampled Image"))
        << run.err;
    EXPECT_EQ(std::ranges::count(run.err, '\n'), 1);
}

TEST_F(CompileTest, EveryOptimizationLevelIsValidAndSmallerThanNone) {
    const std::string text =
        "Texture2D<float4> source : register(t0);\n"
        "float4 Twice(float4 x) { float4 y = x; return y + y; }\n"
        "float4 main(float2 uv : TEXCOORD0) : SV_Target0 {\n"
        "    float4 sum = 0;\n"
        "    [unroll] for (int i = 0; i < 4; ++i) sum += Twice(source.Load(int3(i, 0, 0)));\n"
        "    return sum * (1 - 1 + 2);\n"
        "}\n";
    std::vector<size_t> sizes;
    for (const char* level : {"-O0", "-O1", "-O2", "-O3"}) {
        Compile(text, "ps", {level});
        sizes.push_back(Words("out.spv").size());
        EXPECT_FALSE(FindFault(Words("out.spv"), ValidationStep::Final)) << level;
    }
    EXPECT_LT(sizes[1], sizes[0]);
    EXPECT_LT(sizes[2], sizes[0]);
    EXPECT_LT(sizes[3], sizes[0]);
}

// What each version of glslang makes of these differs; that nothing invalid gets out does not.
TEST_F(CompileTest, InvalidSpirvNeverLeavesWithExitCode0) {
    size_t refused = 0;
    for (const char* body : {"return tex2D(combined, uv);", "return ldexp(uv.x, 3);", "return any(uv.x);",
                             "return matrices._m00_m11_m22.xyzz;", "return source.Sample(nearest, uv);",
                             "return holder.t.Sample(holder.s, uv);", "return frexp(uv.x, x);"}) {
        Write("a.hlsl", fmt::format("cbuffer C : register(b0) {{ float4x4 matrices; }};\n"
                                    "sampler combined : register(s1);\n"
                                    "Texture2D<float4> source : register(t0);\n"
                                    "SamplerState nearest : register(s0);\n"
                                    "struct Holder {{ Texture2D<float4> t; SamplerState s; }};\n"
                                    "static Holder holder = {{source, nearest}};\n"
                                    "float4 main(float2 uv : TEXCOORD0) : SV_Target0 {{ float x; {} }}\n",
                                    body));
        const RunResult run = Bxc({"compile", "a.hlsl", "-T", "ps", "-O0", "-o", "out.spv"});
        if (run.exitCode != 0) {
            EXPECT_NE(run.err, "") << body;
            EXPECT_FALSE(Exists("out.spv")) << body;
            ++refused;
            continue;
        }
        EXPECT_FALSE(FindFault(Words("out.spv"), ValidationStep::Final)) << body;
    }
    EXPECT_GT(refused, 0u);
    EXPECT_LT(refused, 7u);
}

TEST_F(CompileTest, SourceTextIsInTheSpirvOnlyWithZi) {
    Write("inc/shared.hlsli", "float4 Half(float4 x) { return x * 0.5; } // remark\n");
    const std::string text =
        "#include \"inc/shared.hlsli\"\nfloat4 main(float4 c : COLOR) : SV_Target0 { return Half(c); }\n";
    Compile(text, "ps");
    EXPECT_EQ(Read("out.spv").find("shader.hlsl"), std::string::npos);
    EXPECT_EQ(Read("out.spv").find("remark"), std::string::npos);
    Compile(text, "ps", {"-Zi"});
    EXPECT_NE(Read("out.spv").find("shader.hlsl"), std::string::npos);
    EXPECT_NE(Read("out.spv").find("inc/shared.hlsli"), std::string::npos);
    EXPECT_NE(Read("out.spv").find("remark"), std::string::npos);
}

TEST_F(CompileTest, SemanticsAreNotLeftInTheSpirv) {
    Compile(kPlainPixelShader, "ps");
    EXPECT_EQ(Read("out.spv").find("TEXCOORD"), std::string::npos);
    EXPECT_EQ(Read("out.spv").find("GOOGLE"), std::string::npos);
}

TEST_F(CompileTest, SameInputGivesTheSameBytesInEveryFolder) {
    for (const char* folder : {"one", "another/deeper"}) {
        Write(fmt::format("{}/hlsl/a.ps.hlsl", folder), kPlainPixelShader);
        Write(fmt::format("{}/hlsl/s.cfg", folder), "a.ps.hlsl -T ps_5_0\na.ps.hlsl -T ps_5_0 -Zi -o debug\n");
        const RunResult run =
            Bxc({"build", fmt::format("{}/hlsl/s.cfg", folder), "-o", fmt::format("{}/out", folder)});
        ASSERT_EQ(run.exitCode, 0) << run.err;
    }
    for (const char* file : {"a.ps.spv", "a.ps.layout.json", "debug.spv", "debug.layout.json"})
        EXPECT_EQ(Read(fmt::format("one/out/{}", file)), Read(fmt::format("another/deeper/out/{}", file))) << file;
}

TEST_F(CompileTest, WarningIsToldAndIsAnErrorWithWX) {
    Write("a.hlsl", "[unknown] float4 main() : SV_Target0 { return 1; }");
    const RunResult lenient = Bxc({"compile", "a.hlsl", "-T", "ps", "-o", "out.spv"});
    EXPECT_EQ(lenient.exitCode, 0);
    EXPECT_EQ(lenient.err, "a.hlsl:1:2: warning: 'unknown': unrecognized attribute\n");
    EXPECT_TRUE(Exists("out.spv"));
    const RunResult strict = Bxc({"compile", "a.hlsl", "-T", "ps", "-o", "out.spv", "-WX"});
    EXPECT_EQ(strict.exitCode, 1);
    EXPECT_EQ(strict.err, "a.hlsl:1:2: error: 'unknown': unrecognized attribute\n");
    EXPECT_FALSE(Exists("out.spv") || Exists("out.layout.json") || Exists("out.d"));
}

TEST_F(CompileTest, MatchingPartnerIsAccepted) {
    Write("io.hlsli",
          "struct IO { float4 position : SV_Position; float2 uv : TEXCOORD0; float4 unused[2] : COLOR; };\n");
    Write("a.vs.hlsl",
          "#include \"io.hlsli\"\nIO main(float4 p : POSITION) { IO o = (IO)0; o.position = p; return o; }\n");
    Compile("#include \"io.hlsli\"\nfloat4 main(IO i) : SV_Target0 { return i.uv.xyxy; }\n", "ps",
            {"--after", "a.vs.hlsl"});
    EXPECT_NE(Read("out.d").find("a.vs.hlsl"), std::string::npos);
}

TEST_F(CompileTest, PartnerMatchesByLocationHoweverArraysAndMatricesAreDeclared) {
    Write("a.vs.hlsl",
          "void main(out float4 position : SV_Position, out float2 uv[2] : TEXCOORD1, out float3x4 m : ROW) {\n"
          "    position = 0; uv[0] = uv[1] = 0; m = (float3x4)0;\n"
          "}\n");
    Compile(
        "struct PsIn { float2 a : TEXCOORD1; float2 b : TEXCOORD2; float3x4 m : ROW; };\n"
        "float4 main(PsIn i) : SV_Target0 { return i.a.xyxy + i.b.xyxy + i.m[0]; }\n",
        "ps", {"--after", "a.vs.hlsl"});
}

TEST_F(CompileTest, PartnerIsCompiledWithTheSameMacros) {
    Write("a.vs.hlsl",
          "struct IO { float4 position : SV_Position; TYPE uv : TEXCOORD0; };\n"
          "IO main() { IO o = (IO)0; return o; }\n");
    Compile("float4 main(float4 position : SV_Position, TYPE uv : TEXCOORD0) : SV_Target0 { return uv.xyxy; }\n",
            "ps", {"-D", "TYPE=float2", "--after", "a.vs.hlsl"});
}

TEST_F(CompileTest, SourcesThatAreNotShadersAreRefusedInOneLine) {
    Write("empty.hlsl", "");
    Write("binary.hlsl", std::string("\x7f"
                                     "ELF\0\1",
                                     6));
    Write("nonsense.hlsl", "\xff\xfe)}{(\n");
    Write("large.hlsl", std::string((16 << 20) + 1, ' '));
    std::filesystem::create_directory(m_folder / "folder.hlsl");
    const std::pair<const char*, const char*> refusals[] = {
        {"empty.hlsl", "empty.hlsl:1: error: there is no entry point 'main' [missing_entry]\n"},
        {"binary.hlsl", "binary.hlsl: error: 'binary.hlsl': not text: byte 4 is 0\n"},
        {"large.hlsl", "large.hlsl: error: 'large.hlsl': longer than 16 MiB, the most that is read\n"},
        {"folder.hlsl", "folder.hlsl: error: 'folder.hlsl': a folder; a file is expected\n"},
        {"none.hlsl", "none.hlsl: error: 'none.hlsl': cannot be read: No such file or directory\n"}};
    for (const auto& [file, message] : refusals) {
        const RunResult run = Bxc({"compile", file, "-T", "ps", "-o", "out.spv"});
        EXPECT_EQ(run.exitCode, 1) << file;
        EXPECT_EQ(run.err, message);
        EXPECT_FALSE(Exists("out.spv"));
    }
    const RunResult run = Bxc({"compile", "nonsense.hlsl", "-T", "ps", "-o", "out.spv"});
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_TRUE(run.err.starts_with("nonsense.hlsl:1:")) << run.err;
}

TEST_F(CompileTest, WhatCannotBeWrittenIsOneLineAndExitCode1) {
    Write("a.hlsl", kPlainPixelShader);
    Write("file", "");
    const RunResult full = Bxc({"compile", "a.hlsl", "-T", "ps", "-o", "/dev/full"});
    EXPECT_EQ(full.exitCode, 1);
    EXPECT_EQ(full.err, "bxc: cannot write '/dev/full': No space left on device\n");
    const RunResult below = Bxc({"compile", "a.hlsl", "-T", "ps", "-o", "file/out.spv"});
    EXPECT_EQ(below.exitCode, 1);
    EXPECT_EQ(below.err, "bxc: cannot write 'file/out.spv': Not a directory\n");
}

// A link of our own stands for /dev/stdout, which a program that replaces links would take from the whole system.
TEST_F(CompileTest, StandardOutputByNameIsAppendedToAndStays) {
    Write("a.hlsl", kPlainPixelShader);
    Write("bad.hlsl", "nonsense");
    Write("log", "kept");
    std::filesystem::create_symlink("/proc/self/fd/1", m_folder / "stdout.spv");
    const auto append = [&](const std::string& shader) {
        return RunProgram({"sh", "-c", BXC_PROGRAM " compile " + shader + " -T ps -o stdout.spv >> log"}).exitCode;
    };
    EXPECT_EQ(append("a.hlsl"), 0);
    const std::string log = Read("log");
    EXPECT_TRUE(log.starts_with("kept\x03\x02\x23\x07")) << log.substr(0, 20);
    EXPECT_EQ(append("bad.hlsl"), 1);
    EXPECT_EQ(Read("log"), log);
    EXPECT_TRUE(std::filesystem::is_symlink(m_folder / "stdout.spv"));
    EXPECT_FALSE(Exists("stdout.layout.json"));
}

TEST_F(CompileTest, UnwritableSideFileLeavesNothingHalfWritten) {
    Write("a.hlsl", kPlainPixelShader);
    std::filesystem::create_directories(m_folder / "out/a.layout.json/x");
    const RunResult run = Bxc({"compile", "a.hlsl", "-T", "ps", "-o", "out/a.spv"});
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_EQ(run.err, "bxc: cannot write 'out/a.layout.json': Is a directory\n");
    EXPECT_FALSE(Exists("out/a.d"));
    for (const auto& entry : std::filesystem::directory_iterator(m_folder / "out"))
        EXPECT_EQ(entry.path().filename().string().find(".boxcar-"), std::string::npos) << entry.path();
}

TEST_F(CompileTest, WrongCommandLineIsExitCode2) {
    const RunResult none = Bxc({});
    EXPECT_EQ(none.exitCode, 2);
    EXPECT_EQ(none.err, "bxc: no command is given; accepted: compile, build, --help, --version (bxc --help)\n");
    const RunResult unknown = Bxc({"run"});
    EXPECT_EQ(unknown.exitCode, 2);
    EXPECT_EQ(unknown.err, "bxc: unknown command 'run'; accepted: compile, build, --help, --version (bxc --help)\n");
    EXPECT_EQ(Bxc({"compile", "a.hlsl", "-T", "ps", "-o", "x.spv", "--what"}).exitCode, 2);
}

TEST_F(CompileTest, HelpHasAnExampleForEachCommand) {
    for (const char* command : {"compile", "build"}) {
        const RunResult run = Bxc({command, "--help"});
        EXPECT_EQ(run.exitCode, 0);
        EXPECT_NE(run.out.find("Example"), std::string::npos);
        EXPECT_EQ(run.err, "");
    }
    EXPECT_EQ(Bxc({"--help"}).exitCode, 0);
    EXPECT_TRUE(Bxc({"--version"}).out.starts_with("bxc "));
}

}  // namespace
}  // namespace boxcar
