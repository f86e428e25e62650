// bxc build: what it compiles, what it leaves alone, what it removes.
#include <fmt/format.h>

#include "tests/bxc/bxc_test.h"

namespace boxcar {
namespace {

class BuildTest : public BxcTest {
protected:
    BuildTest() {
        Write("hlsl/lib/shared.hlsli", "static const float kHalf = 0.5;\n");
        Write("hlsl/a.ps.hlsl",
              "#include \"lib/shared.hlsli\"\nfloat4 main() : SV_Target0 { return kHalf * TAPS; }\n");
        Write("hlsl/b.ps.hlsl", kPlainPixelShader);
        Write("hlsl/s.cfg", "a.ps.hlsl -T ps -D TAPS={2,4}\nb.ps.hlsl -T ps\n");
    }

    RunResult Build(std::vector<std::string> flags = {}) {
        flags.insert(flags.begin(), {"build", "hlsl/s.cfg", "-o", "out"});
        return Bxc(flags);
    }
};

TEST_F(BuildTest, WritesThreeFilesForEachShader) {
    const RunResult run = Build();
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_EQ(run.err, "");
    EXPECT_EQ(run.out, "bxc: 3 shaders: 3 compiled\n");
    for (const char* name : {"a.ps.TAPS=2", "a.ps.TAPS=4", "b.ps"})
        for (const char* ending : {"spv", "layout.json", "d"})
            EXPECT_TRUE(Exists(fmt::format("out/{}.{}", name, ending))) << name << ending;
    EXPECT_NE(Read("out/a.ps.TAPS=2.spv"), Read("out/a.ps.TAPS=4.spv"));
    EXPECT_TRUE(Read("out/a.ps.TAPS=2.d")
                    .ends_with(": hlsl/a.ps.hlsl -T ps -E main -D TAPS=2 -O3\n"
                               "out/a.ps.TAPS=2.spv: \\\n"
                               "  hlsl/a.ps.hlsl \\\n"
                               "  hlsl/lib/shared.hlsli\n"))
        << Read("out/a.ps.TAPS=2.d");
}

TEST_F(BuildTest, SecondBuildCompilesNothing) {
    Build();
    EXPECT_EQ(Build().out, "bxc: 3 shaders: 3 up to date\n");
}

TEST_F(BuildTest, ChangedIncludeCompilesExactlyItsUsers) {
    Build();
    Write("hlsl/lib/shared.hlsli", "static const float kHalf = 0.25;\n");
    const std::string before = Read("out/a.ps.TAPS=2.spv");
    EXPECT_EQ(Build().out, "bxc: 3 shaders: 2 compiled, 1 up to date\n");
    EXPECT_NE(Read("out/a.ps.TAPS=2.spv"), before);
    EXPECT_EQ(Build().out, "bxc: 3 shaders: 3 up to date\n");
}

TEST_F(BuildTest, ChangedFlagsCompileTheirShaderAgain) {
    Build();
    Write("hlsl/s.cfg", "a.ps.hlsl -T ps -D TAPS={2,4}\nb.ps.hlsl -T ps -O1\n");
    EXPECT_EQ(Build().out, "bxc: 3 shaders: 1 compiled, 2 up to date\n");
}

TEST_F(BuildTest, MissingOutputIsMadeAgain) {
    for (const char* ending : {"spv", "layout.json", "d"}) {
        Build();
        std::filesystem::remove(m_folder / fmt::format("out/b.ps.{}", ending));
        EXPECT_EQ(Build().out, "bxc: 3 shaders: 1 compiled, 2 up to date\n") << ending;
    }
}

TEST_F(BuildTest, RemovedIncludeIsAnErrorAndNotUpToDate) {
    Build();
    std::filesystem::remove(m_folder / "hlsl/lib/shared.hlsli");
    const RunResult run = Build();
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_EQ(run.err, "hlsl/a.ps.hlsl:1:1: error: '#include': cannot find 'lib/shared.hlsli'; searched: .\n");
    EXPECT_EQ(run.out, "bxc: 3 shaders: 1 up to date, 2 failed\n");
}

TEST_F(BuildTest, FailingShaderLosesItsOldOutputsAndTheOthersAreWritten) {
    Build();
    Write("hlsl/a.ps.hlsl", "#if TAPS == 2\n#error two\n#endif\nfloat4 main() : SV_Target0 { return TAPS; }\n");
    const RunResult run = Build();
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_EQ(run.err, "hlsl/a.ps.hlsl:2:1: error: '#error': two\nhlsl/a.ps.hlsl:3: error: missing #endif\n");
    EXPECT_EQ(run.out, "bxc: 3 shaders: 1 compiled, 1 up to date, 1 failed\n");
    for (const char* ending : {"spv", "layout.json", "d"})
        EXPECT_FALSE(Exists(fmt::format("out/a.ps.TAPS=2.{}", ending))) << ending;
    EXPECT_TRUE(Exists("out/a.ps.TAPS=4.spv"));
}

TEST_F(BuildTest, MessageOfManyPermutationsIsToldOnce) {
    Write("hlsl/a.ps.hlsl", "#include \"none.hlsli\"\n");
    EXPECT_EQ(Build().err, "hlsl/a.ps.hlsl:1:1: error: '#include': cannot find 'none.hlsli'; searched: .\n");
}

TEST_F(BuildTest, WrongManifestCompilesNothing) {
    Write("hlsl/s.cfg", "b.ps.hlsl -T ps\na.ps.hlsl -Q\n");
    const RunResult run = Build();
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_TRUE(run.err.starts_with("hlsl/s.cfg:2: error: unknown flag '-Q'; accepted: ")) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_FALSE(Exists("out"));

    const RunResult missing = Bxc({"build", "none.cfg", "-o", "out"});
    EXPECT_EQ(missing.exitCode, 1);
    EXPECT_EQ(missing.err, "bxc: 'none.cfg': cannot be read: No such file or directory\n");
}

TEST_F(BuildTest, NumberOfWorkersDoesNotChangeTheBytes) {
    Bxc({"build", "hlsl/s.cfg", "-o", "one", "-j", "1"});
    Bxc({"build", "hlsl/s.cfg", "-o", "four", "-j", "4"});
    for (const char* name : {"a.ps.TAPS=2.spv", "a.ps.TAPS=4.spv", "b.ps.spv", "b.ps.layout.json"})
        EXPECT_EQ(Read(fmt::format("one/{}", name)), Read(fmt::format("four/{}", name))) << name;
}

TEST_F(BuildTest, DepfileOfTheBuildNamesEverySourceOnce) {
    Write("hlsl/b ps.hlsl", kPlainPixelShader);
    Write("hlsl/s.cfg", "a.ps.hlsl -T ps -D TAPS={2,4}\n\"b ps.hlsl\" -T ps\n");
    Build({"--embed", "demo", "--depfile", "out/all.d"});
    const std::string expected =
        "out/demo.cpp: \\\n  hlsl/a.ps.hlsl \\\n  hlsl/b\\ ps.hlsl \\\n  hlsl/lib/shared.hlsli \\\n  hlsl/s.cfg\n";
    EXPECT_EQ(Read("out/all.d"), expected);
    std::filesystem::remove(m_folder / "out/all.d");
    EXPECT_EQ(Build({"--embed", "demo", "--depfile", "out/all.d"}).out, "bxc: 3 shaders: 3 up to date\n");
    EXPECT_EQ(Read("out/all.d"), expected);
}

TEST_F(BuildTest, EmbeddedFilesAreTouchedOnlyWhenTheyChange) {
    Build({"--embed", "demo"});
    const auto header = std::filesystem::last_write_time(m_folder / "out/demo.h");
    const auto source = std::filesystem::last_write_time(m_folder / "out/demo.cpp");
    Write("hlsl/b.ps.hlsl", std::string("// a remark\n") + kPlainPixelShader);
    EXPECT_EQ(Build({"--embed", "demo"}).out, "bxc: 3 shaders: 1 compiled, 2 up to date\n");
    EXPECT_EQ(std::filesystem::last_write_time(m_folder / "out/demo.cpp"), source);
    Write("hlsl/lib/shared.hlsli", "static const float kHalf = 0.25;\n");
    Build({"--embed", "demo"});
    EXPECT_EQ(std::filesystem::last_write_time(m_folder / "out/demo.h"), header);
    EXPECT_NE(std::filesystem::last_write_time(m_folder / "out/demo.cpp"), source);
}

TEST_F(BuildTest, UnwritableOutputFolderIsOneLine) {
    Write("out", "a file");
    const RunResult run = Build();
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_EQ(run.err, "bxc: cannot write 'out/a.ps.TAPS=2.spv': Not a directory\n");
}

}  // namespace
}  // namespace boxcar
