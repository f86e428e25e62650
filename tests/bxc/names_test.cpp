// Names of files are any bytes: they reach the compiler and the outputs as they are, and a message as one line of
// UTF-8.
#include "tests/bxc/foreign_test.h"

namespace boxcar {
namespace {

using NamesTest = ForeignTest;

constexpr const char* kName =
    "b\xff"
    "d";
constexpr const char* kShown = "b\\xffd";

TEST_F(NamesTest, NameThatIsNotUtf8IsReadAndWritten) {
    const std::string name = kName;
    Write(name + ".hlsl", "#include \"" + name + ".hlsli\"\n" + kPlainPixelShader);
    Write(name + "/" + name + ".hlsli", "");
    const RunResult run = Bxc({"compile", name + ".hlsl", "-T", "ps", "-Zi", "-I", name, "-o", name + ".spv"});
    EXPECT_EQ(run.err, "");
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_TRUE(Exists(name + ".spv"));
    EXPECT_NE(
        Read(name + ".d").find("\n" + name + ".spv: \\\n  " + name + ".hlsl \\\n  " + name + "/" + name + ".hlsli\n"),
        std::string::npos)
        << Read(name + ".d");
    EXPECT_EQ(ReadLayout(name + ".layout.json").source, std::string(kShown) + ".hlsl");
}

TEST_F(NamesTest, MessagesShowTheBytesThatAreNotUtf8) {
    const std::string name = kName;
    Write(name + ".hlsl", "float4 main() : SV_Target0 { return nothing; }\n");
    Write("m.cfg", name + ".hlsl -T ps -E none\n");
    EXPECT_TRUE(Bxc({"compile", name + ".hlsl", "-T", "ps", "-o", "o.spv"})
                    .err.starts_with(std::string(kShown) + ".hlsl:1:37: error: 'nothing': unknown variable"));
    Write(name + ".hlsl", kPlainPixelShader);
    const RunResult build = Bxc({"build", "m.cfg", "-o", "out"});
    EXPECT_EQ(build.err, std::string(kShown) + ".hlsl:1: error: there is no entry point 'none' [missing_entry]\n");
}

TEST_F(NamesTest, EmbeddedNamesAreLiterals) {
    const std::string name = kName;
    Write("a.hlsl", kPlainPixelShader);
    Write("m.cfg", "a.hlsl -T ps -o " + name + "\n");
    EXPECT_EQ(Bxc({"build", "m.cfg", "-o", "out", "--embed", "all"}).err, "");
    EXPECT_NE(Read("out/all.cpp").find("{\"b\\377d\", kSpirv0"), std::string::npos);
}

TEST_F(NamesTest, LineBreaksAreRefusedInOneLine) {
    Write("a\nb.hlsl", kPlainPixelShader);
    const RunResult run = Bxc({"compile", "a\nb.hlsl", "-T", "ps", "-o", "o.spv"});
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_EQ(run.err, "bxc: 'a\\nb.hlsl': no makefile can name a word with a line break (bxc --help)\n");
}

}  // namespace
}  // namespace boxcar
