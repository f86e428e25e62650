#include "tools/bxc/options.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace boxcar {
namespace {

CompileOptions Parse(const std::vector<std::string>& words) {
    return ParseCompileOptions(words);
}

std::string CompileRefusal(const std::vector<std::string>& words) {
    try {
        ParseCompileOptions(words);
    } catch (const UsageError& error) {
        return error.what();
    }
    return "accepted";
}

std::string Refusal(const std::vector<std::string>& words) {
    try {
        ParseOptions(words);
    } catch (const UsageError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(OptionsTest, EveryCompileFlagIsRead) {
    const CompileOptions options =
        Parse({"a.ps.hlsl", "-T",  "ps_5_0", "-E",   "Blur", "-D",   "A",  "-D",      "B=2",     "-I",       "inc",
               "-O1",       "-Zi", "-WX",    "-Gec", "-HV",  "2021", "-o", "out.spv", "--after", "a.vs.hlsl"});
    CompileOptions expected;
    expected.file = "a.ps.hlsl";
    expected.stage = ShaderStage::Pixel;
    expected.entry = "Blur";
    expected.defines = {{"A", "1"}, {"B", "2"}};
    expected.includeDirs = {"inc"};
    expected.optimization = 1;
    expected.debugInfo = true;
    expected.warningsAreErrors = true;
    expected.dx9Compatible = true;
    expected.hlslVersion = 2021;
    expected.after = "a.vs.hlsl";
    expected.output = "out.spv";
    EXPECT_EQ(options, expected);
}

TEST(OptionsTest, SlashAndDashMeanTheSame) {
    EXPECT_EQ(Parse({"a.hlsl", "/T", "vs_5_0", "/E", "f", "/D", "A=1", "/I", "x", "/O0", "/Zi", "/WX", "/Gec", "/HV",
                     "2016"}),
              Parse({"a.hlsl", "-T", "vs_5_0", "-E", "f", "-D", "A=1", "-I", "x", "-O0", "-Zi", "-WX", "-Gec", "-HV",
                     "2016"}));
}

TEST(OptionsTest, DefineAndIncludeTakeTheirValueWithoutASpace) {
    EXPECT_EQ(Parse({"a.hlsl", "-T", "ps", "-DA=1", "/DB", "-Iinc/x", "/DC=a/b"}),
              Parse({"a.hlsl", "-T", "ps", "-D", "A=1", "-D", "B", "-I", "inc/x", "-D", "C=a/b"}));
}

TEST(OptionsTest, AbsolutePathIsAFileAndNotASlashFlag) {
    EXPECT_EQ(Parse({"/Zimmer/a.hlsl", "-T", "ps"}).file, "/Zimmer/a.hlsl");
    EXPECT_EQ(Parse({"/tmp", "-T", "ps"}).file, "/tmp");
}

TEST(OptionsTest, ProfileSelectsTheStageWithOrWithoutAVersion) {
    EXPECT_EQ(Parse({"a", "-T", "vs"}).stage, ShaderStage::Vertex);
    EXPECT_EQ(Parse({"a", "-T", "ps_4_0"}).stage, ShaderStage::Pixel);
    EXPECT_EQ(Parse({"a", "-T", "cs_6_6"}).stage, ShaderStage::Compute);
    EXPECT_EQ(Parse({"a", "-T", "ps"}), Parse({"a", "-T", "ps_5_0"}));
    for (const char* profile : {"gs_5_0", "ps_5", "ps50", "p", "", "PS_5_0"})
        EXPECT_EQ(
            CompileRefusal({"a", "-T", profile}),
            "'-T " + std::string(profile) + "': expected vs, ps or cs, with or without a version, as in ps_5_0");
}

TEST(OptionsTest, WrongFlagIsNamedWithThoseThatAreAccepted) {
    for (const char* flag : {"-Fo", "/Od", "--after-all", "-O4", "-zi"})
        EXPECT_EQ(CompileRefusal({"a", "-T", "ps", flag}),
                  "unknown flag '" + std::string(flag) +
                      "'; accepted: -T -E -D -I -O0 -O1 -O2 -O3 -Zi -WX -Gec -HV --after -o");
}

TEST(OptionsTest, WrongValueIsNamedWithWhatIsExpected) {
    EXPECT_EQ(CompileRefusal({"a", "-T"}), "'-T' needs a value");
    EXPECT_EQ(CompileRefusal({"a", "-T", "ps", "-D", "1A=2"}), "'-D 1A=2': expected NAME or NAME=VALUE");
    EXPECT_EQ(CompileRefusal({"a", "-T", "ps", "-E", "a b"}), "'-E a b': expected the name of a function");
    EXPECT_EQ(CompileRefusal({"a", "-T", "ps", "-HV", "2020"}), "'-HV 2020': expected 2016, 2017, 2018 or 2021");
    EXPECT_EQ(CompileRefusal({"-T", "ps"}), "no shader file is given");
    EXPECT_EQ(CompileRefusal({"a", "b", "-T", "ps"}), "'b': expected one shader file; there is 'a'");
    EXPECT_EQ(CompileRefusal({"a"}), "'a' has no profile: expected -T vs_5_0, ps_5_0 or cs_5_0");
    EXPECT_EQ(CompileRefusal({"a", "-T", "cs", "--after", "b"}),
              "'--after b': only a pixel shader (-T ps) comes after a vertex shader");
}

TEST(OptionsTest, CommandsAreRead) {
    const Options build = ParseOptions(std::vector<std::string>{"build", "s.cfg", "-o", "out", "-j4", "--embed", "e",
                                                                "--depfile=d", "--timeout", "7", "--max-memory=64"});
    EXPECT_EQ(build.command, Command::Build);
    EXPECT_EQ(build.manifest, "s.cfg");
    EXPECT_EQ(build.outputDir, "out");
    EXPECT_EQ(build.jobs, 4);
    EXPECT_EQ(build.embed, "e");
    EXPECT_EQ(build.depfile, "d");
    EXPECT_EQ(build.timeoutSeconds, 7);
    EXPECT_EQ(build.maxMemoryMib, 64);
    EXPECT_EQ(ParseOptions(std::vector<std::string>{"--version"}).command, Command::Version);
}

TEST(OptionsTest, WrongCommandLineIsRefused) {
    EXPECT_EQ(Refusal({}), "no command is given; accepted: compile, build, --help, --version");
    EXPECT_EQ(Refusal({"run"}), "unknown command 'run'; accepted: compile, build, --help, --version");
    EXPECT_EQ(Refusal({"build", "-o", "x"}), "expected one manifest; 0 are given");
    EXPECT_EQ(Refusal({"build", "a", "b", "-o", "x"}), "expected one manifest; 2 are given");
    EXPECT_EQ(Refusal({"build", "a"}), "no output folder is given: expected -o DIR");
    EXPECT_EQ(Refusal({"build", "a", "-o", "x", "-Zi"}),
              "unknown flag '-Zi'; accepted: -o -j --embed --depfile --timeout --max-memory");
    for (const char* number : {"0", "257", "x", "1.5", "", "-1", "99999999999"})
        EXPECT_EQ(Refusal({"build", "a", "-o", "x", "-j", number}),
                  "'-j " + std::string(number) + "': expected a whole number from 1 to 256");
    EXPECT_EQ(Refusal({"build", "a", "-o", "x", "--embed", "a-b"}), "'--embed a-b': expected a C++ identifier");
    EXPECT_EQ(Refusal({"compile", "a", "-T", "ps"}), "no output is given: expected -o OUT.spv");
    for (const char* output : {"x", "x.hlsl"})
        EXPECT_EQ(Refusal({"compile", "a.hlsl", "-T", "ps", "-o", output}),
                  "'-o " + std::string(output) + "': expected a name that ends in .spv and is not the shader's");
    EXPECT_EQ(Refusal({"compile", "a.spv", "-T", "ps", "-o", "a.spv"}),
              "'-o a.spv': expected a name that ends in .spv and is not the shader's");
}

TEST(OptionsTest, TextOfTheFlagsTellsApartWhatCompilesDifferently) {
    const std::string plain = ToText(Parse({"a", "-T", "ps"}));
    EXPECT_EQ(plain, ToText(Parse({"a", "/T", "ps_5_0", "-O3", "-E", "main", "-o", "other.spv"})));
    for (const std::vector<std::string>& flags : std::vector<std::vector<std::string>>{
             {"-E", "f"}, {"-D", "A"}, {"-I", "x"}, {"-O2"}, {"-Zi"}, {"-WX"}, {"-Gec"}, {"--after", "x"}}) {
        std::vector<std::string> words = {"a", "-T", "ps"};
        words.insert(words.end(), flags.begin(), flags.end());
        EXPECT_NE(ToText(Parse(words)), plain) << flags[0];
    }
}

}  // namespace
}  // namespace boxcar
