// What the compiler does to itself stays in its process.
#include <fmt/format.h>

#include <chrono>
#include <cstdlib>

#include "tests/bxc/bxc_test.h"

namespace boxcar {
namespace {

class WorkersTest : public BxcTest {
protected:
    // Under AddressSanitizer a worker would print a report and exit instead of dying of the signal.
    WorkersTest() { setenv("ASAN_OPTIONS", "handle_segv=0:detect_leaks=0", 1); }

    // Macros that double 40 times: nothing finishes this.
    static std::string Bomb(const std::string& seed) {
        std::string text = "#define A0 " + seed + "\n";
        for (int i = 1; i <= 40; ++i)
            text += fmt::format("#define A{} A{} A{}\n", i, i - 1, i - 1);
        return text + "float4 main() : SV_Target0 { return 0 A40; }\n";
    }

    const std::string m_crash = "float4 main(uint4 v : V) : SV_Target0 { return msad4(v.x, v.yz, v); }\n";
};

TEST_F(WorkersTest, CrashOfTheCompilerIsADiagnosticAndTheRestGoOn) {
    Write("crash.hlsl", m_crash);
    Write("good.hlsl", kPlainPixelShader);
    Write("s.cfg",
          "good.hlsl -T ps -o first\ncrash.hlsl -T ps\ngood.hlsl -T ps -o second\ngood.hlsl -T ps -o third\n");
    for (const char* workers : {"1", "3"}) {
        std::filesystem::remove_all(m_folder / "out");
        const RunResult run = Bxc({"build", "s.cfg", "-o", "out", "-j", workers});
        EXPECT_EQ(run.exitCode, 1);
        EXPECT_EQ(run.err, "crash.hlsl: error: the compiler crashed: Segmentation fault\n");
        EXPECT_EQ(run.out, "bxc: 4 shaders: 3 compiled, 1 failed\n");
        for (const char* name : {"first", "second", "third"})
            EXPECT_TRUE(Exists(fmt::format("out/{}.spv", name))) << name;
        EXPECT_FALSE(Exists("out/crash.spv"));
    }
}

TEST_F(WorkersTest, HangOfTheCompilerIsEndedAndTheRestGoOn) {
    Write("hang.hlsl", Bomb("+ 1"));
    Write("good.hlsl", kPlainPixelShader);
    Write("s.cfg", "hang.hlsl -T ps\ngood.hlsl -T ps\n");
    const auto started = std::chrono::steady_clock::now();
    const RunResult run = Bxc({"build", "s.cfg", "-o", "out", "-j1", "--timeout", "5", "--max-memory", "100000"});
    EXPECT_LT(std::chrono::steady_clock::now() - started, std::chrono::seconds(55));
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_EQ(run.err, "hang.hlsl: error: the compiler was stopped: it took more than 5 s\n");
    EXPECT_TRUE(Exists("out/good.spv"));
}

TEST_F(WorkersTest, CompileThatDevoursTheMemoryIsEndedAndTheRestGoOn) {
    Write("eat.hlsl", Bomb("+ " + std::string(900, 'x')));
    Write("good.hlsl", kPlainPixelShader);
    Write("s.cfg", "eat.hlsl -T ps\ngood.hlsl -T ps\n");
    const RunResult run = Bxc({"build", "s.cfg", "-o", "out", "-j1", "--max-memory", "400"});
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_EQ(run.err, "eat.hlsl: error: the compiler was stopped: it took more than 400 MiB of memory\n");
    EXPECT_TRUE(Exists("out/good.spv"));
}

TEST_F(WorkersTest, CompileOfOneShaderIsGuardedToo) {
    Write("crash.hlsl", m_crash);
    const RunResult run = Bxc({"compile", "crash.hlsl", "-T", "ps", "-o", "out.spv"});
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_EQ(run.err, "crash.hlsl: error: the compiler crashed: Segmentation fault\n");
}

TEST_F(WorkersTest, OneWorkerTakesManyShadersOneAfterAnother) {
    Write("good.hlsl", kPlainPixelShader);
    std::string manifest;
    for (int i = 0; i < 40; ++i)
        manifest += fmt::format("good.hlsl -T ps -o {}\n", i);
    Write("s.cfg", manifest);
    const RunResult run = Bxc({"build", "s.cfg", "-o", "out", "-j1"});
    EXPECT_EQ(run.out, "bxc: 40 shaders: 40 compiled\n") << run.err;
    EXPECT_EQ(Read("out/0.spv"), Read("out/39.spv"));
}

TEST_F(WorkersTest, MessagesComeInTheOrderOfTheManifest) {
    std::string manifest, expected;
    for (int i = 0; i < 12; ++i) {
        Write(fmt::format("{}.hlsl", i), i % 2 ? "" : "float loose; float4 main() : SV_Target0 { return loose; }");
        manifest += fmt::format("{}.hlsl -T ps\n", i);
        expected += i % 2 ? fmt::format("{}.hlsl:1: error: there is no entry point 'main' [missing_entry]\n", i)
                          : fmt::format(
                                "{}.hlsl:1:7: error: 'loose' is a constant outside a cbuffer; put it into a "
                                "named cbuffer with a register, or make it static const [loose_globals]\n",
                                i);
    }
    Write("s.cfg", manifest);
    EXPECT_EQ(Bxc({"build", "s.cfg", "-o", "out", "-j4"}).err, expected);
}

}  // namespace
}  // namespace boxcar
