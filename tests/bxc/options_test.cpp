#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tools/bxc/commands/build.h"
#include "tools/bxc/commands/compile.h"

namespace boxcar {
namespace {

CompileOptions Parse(const std::vector<std::string>& words) {
    return ParseCompileOptions(words);
}

// The message with which a parser refuses a command line, or "accepted".
template <typename Parser>
std::string Refusal(Parser parse, const std::vector<std::string>& words) {
    try {
        parse(words);
    } catch (const UsageError& error) {
        return error.what();
    }
    return "accepted";
}

std::string ShaderRefusal(const std::vector<std::string>& words) {
    return Refusal(Parse, words);
}

std::string CompileRefusal(const std::vector<std::string>& words) {
    return Refusal(ParseCompileCommand, words);
}

std::string BuildRefusal(const std::vector<std::string>& words) {
    return Refusal(ParseBuildCommand, words);
}

constexpr const char* kAccepted =
    "-T -E -D -I -Od -O -Zi -WX -Gec -Gis -HV -Zpr -Zpc -enable-16bit-types -fvk-b-shift -fvk-s-shift -fvk-t-shift "
    "-fvk-u-shift -fvk-invert-y -fvk-use-dx-position-w -fspv-target-env --after --after-T --after-E -o -Fo "
    "--outputSuffix -Fh -Vn";

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
    EXPECT_EQ(Parse({"a", "-T", "ps", "/Iinc/x", "/FhCompiled/a.h"}),
              Parse({"a", "-T", "ps", "-I", "inc/x", "-Fh", "Compiled/a.h"}));
}

TEST(OptionsTest, ProfileSelectsTheStageWithOrWithoutAVersion) {
    EXPECT_EQ(Parse({"a", "-T", "vs"}).stage, ShaderStage::Vertex);
    EXPECT_EQ(Parse({"a", "-T", "ps_4_0"}).stage, ShaderStage::Pixel);
    EXPECT_EQ(Parse({"a", "-T", "cs_6_6"}).stage, ShaderStage::Compute);
    EXPECT_EQ(Parse({"a", "-T", "ps"}), Parse({"a", "-T", "ps_5_0"}));
    EXPECT_EQ(Parse({"a", "-T", "hs_5_0"}).stage, ShaderStage::Hull);
    EXPECT_EQ(Parse({"a", "-T", "ds_5_0"}).stage, ShaderStage::Domain);
    EXPECT_EQ(Parse({"a", "-T", "gs_5_0"}).stage, ShaderStage::Geometry);
    EXPECT_EQ(Parse({"a", "-Tvs_4_0_level_9_3"}), Parse({"a", "-T", "vs"}));
    for (const char* profile : {"xs_5_0", "ps_5", "ps50", "p", "", "PS_5_0", "ps_4_0_level_9", "ps_4_0_level_9_1_"})
        EXPECT_EQ(ShaderRefusal({"a", "-T", profile}), "'-T " + std::string(profile) +
                                                           "': expected vs, hs, ds, gs, ps or cs, with or without a "
                                                           "version, as in ps_5_0");
    for (const char* profile : {"lib_6_3", "ms_6_5", "as"})
        EXPECT_EQ(
            ShaderRefusal({"a", "-T", profile}),
            "'-T " + std::string(profile) +
                "': ray tracing, mesh and amplification shaders are not compiled; expected vs, hs, ds, gs, ps or "
                "cs");
}

TEST(OptionsTest, WrongFlagIsNamedWithThoseThatAreAccepted) {
    for (const char* flag : {"-Fy", "/od", "--after-all", "-zi"})
        EXPECT_EQ(ShaderRefusal({"a", "-T", "ps", flag}),
                  "unknown flag '" + std::string(flag) + "'; accepted: " + kAccepted);
}

// A build script's line is taken as it is.
TEST(OptionsTest, FlagsThatCannotChangeTheSpirvAreIgnored) {
    EXPECT_EQ(Parse({"a",
                     "-T",
                     "ps",
                     "/nologo",
                     "/Ges",
                     "/Qstrip_reflect",
                     "-spirv",
                     "/Zpc",
                     "-W3",
                     "-Wno-error",
                     "-Vd",
                     "-fspv-target-env=vulkan1.3",
                     "/Zss",
                     "-fspv-target-env=universal1.5",
                     "-fvk-use-dx-layout",
                     "-fspv-extension=SPV_KHR_ray_query",
                     "-all_resources_bound",
                     "/Qstrip_debug",
                     "/Fda.pdb",
                     "-Fd",
                     "a.pdb"}),
              Parse({"a", "-T", "ps"}));
}

TEST(OptionsTest, FlagsOfOtherCompilersThatBxcCanMeanAreRead) {
    const CompileOptions options = Parse({"a",
                                          "/Tps_5_0",
                                          "/EBlur",
                                          "/Od",
                                          "/Zpr",
                                          "/Gis",
                                          "-enable-16bit-types",
                                          "-fvk-t-shift",
                                          "100",
                                          "0",
                                          "-fvk-b-shift",
                                          "7",
                                          "all",
                                          "-fvk-invert-y",
                                          "/Fo",
                                          "out.cso",
                                          "/Fhout.h",
                                          "/Vn",
                                          "kBlur",
                                          "-fvk-use-dx-position-w"});
    CompileOptions expected;
    expected.file = "a";
    expected.entry = "Blur";
    expected.optimization = 0;
    expected.rowMajor = expected.strictMath = expected.native16Bit = true;
    expected.invertY = expected.dxPositionW = true;
    expected.shifts = {{'t', 100, 0}, {'b', 7, RegisterShift::kAllSets}};
    expected.binary = "out.cso";
    expected.header = "out.h";
    expected.variable = "kBlur";
    EXPECT_EQ(options, expected);
    EXPECT_EQ(Parse({"a", "-T", "ps", "-Zpr", "-Zpc"}).rowMajor, false);
    EXPECT_EQ(Parse({"a", "-T", "ps", "-O", "1"}).optimization, 1);
}

TEST(OptionsTest, FlagsThatBxcCannotMeanAreRefusedWithTheReason) {
    const std::pair<std::vector<std::string>, const char*> refusals[] = {
        {{"/Fc", "a.asm"}, "'-Fc': bxc does not write listings; spirv-dis makes one from the .spv"},
        {{"/Fea.txt"}, "'-Fe': messages go to stderr; redirect them"},
        {{"-fvk-use-scalar-layout"}, "'-fvk-use-scalar-layout': constants are laid out as in Direct3D"},
        {{"-fvk-bind-globals", "0", "1"}, "'-fvk-bind-globals': constants outside a cbuffer are refused"},
        {{"-fspv-target-env=vulkan1.0"},
         "'-fspv-target-env=vulkan1.0': the SPIR-V is version 1.3, for Vulkan 1.1 and later: expected vulkan1.1 or "
         "later"},
        {{"-fvk-t-shift", "x", "0"}, "'-fvk-t-shift x': expected a whole number from 0 to 65535"},
        {{"-fvk-t-shift", "1", "-1"}, "'-fvk-t-shift 1 -1': expected a space from 0 to 65535, or all"},
        {{"-fvk-t-shift", "1", "foo"}, "'-fvk-t-shift 1 foo': expected a space from 0 to 65535, or all"},
        {{"-fvk-t-shift", "1"}, "'-fvk-t-shift' needs two values"},
        {{"-Vn", "1a"}, "'-Vn 1a': expected the name of a variable in C"}};
    for (const auto& [flags, message] : refusals) {
        std::vector<std::string> words = {"a", "-T", "ps"};
        words.insert(words.end(), flags.begin(), flags.end());
        EXPECT_EQ(ShaderRefusal(words), message);
    }
}

TEST(OptionsTest, LaterValueOfAMacroReplacesTheOneBefore) {
    EXPECT_EQ(Parse({"a", "-T", "ps", "-DA=1", "-DB", "-DA=2"}).defines,
              (std::vector<Define>{{"B", "1"}, {"A", "2"}}));
}

TEST(OptionsTest, OnlyStagesThatFollowEachOtherAreLinked) {
    const auto linked = [](const char* stage, const char* before) {
        return ShaderRefusal({"a", "-T", stage, "--after", "b", "--after-T", before, "--after-E", "f"});
    };
    const std::pair<const char*, const char*> links[] = {{"ps", "vs"}, {"ps", "ds"}, {"ps", "gs"}, {"gs", "vs"},
                                                         {"gs", "ds"}, {"hs", "vs"}, {"ds", "hs"}, {"ds", "vs"}};
    for (const auto& [stage, before] : links)  // before a domain shader is always a hull shader
        EXPECT_EQ(linked(stage, before), "accepted") << stage << " after " << before;
    EXPECT_EQ(Parse({"a", "-T", "ds", "--after", "b"}).afterStage, ShaderStage::Hull);
    for (const auto& [stage, before] :
         {std::pair("cs", "vs"), {"vs", "vs"}, {"hs", "gs"}, {"ps", "ps"}, {"gs", "hs"}})
        EXPECT_EQ(linked(stage, before),
                  "'--after b': no " + std::string(stage) + " shader comes after a " + before +
                      " shader; expected vs before hs, gs, ps; hs before ds; ds before gs, ps; "
                      "gs before ps");
}

TEST(OptionsTest, WrongValueIsNamedWithWhatIsExpected) {
    EXPECT_EQ(ShaderRefusal({"a", "-T"}), "'-T' needs a value");
    EXPECT_EQ(ShaderRefusal({"a", "-T", "ps", "-D", "1A=2"}), "'-D 1A=2': expected NAME or NAME=VALUE");
    EXPECT_EQ(ShaderRefusal({"a", "-T", "ps", "-E", "a b"}), "'-E a b': expected the name of a function");
    EXPECT_EQ(ShaderRefusal({"a", "-T", "ps", "-HV", "2020"}), "'-HV 2020': expected 2016, 2017, 2018 or 2021");
    EXPECT_EQ(ShaderRefusal({"-T", "ps"}), "no shader file is given");
    EXPECT_EQ(ShaderRefusal({"a", "b", "-T", "ps"}), "'b': expected one shader file; there is 'a'");
    EXPECT_EQ(ShaderRefusal({"a"}), "'a' has no profile: expected -T vs_5_0, ps_5_0 or cs_5_0");
    EXPECT_EQ(ShaderRefusal({"a", "-T", "ps", "-O4"}), "'-O 4': expected a whole number from 0 to 3");
}

TEST(OptionsTest, CommandsAreRead) {
    const BuildCommandOptions build = ParseBuildCommand(std::vector<std::string>{
        "s.cfg", "-o", "out", "-j4", "--embed", "e", "--depfile=d", "--timeout", "7", "--max-memory=64"});
    EXPECT_EQ(build.manifest, "s.cfg");
    EXPECT_EQ(build.outputDir, "out");
    EXPECT_EQ(build.limits.workers, 4);
    EXPECT_EQ(build.embed, "e");
    EXPECT_EQ(build.depfile, "d");
    EXPECT_EQ(build.limits.timeoutSeconds, 7);
    EXPECT_EQ(build.limits.maxMemoryMib, 64);
    const CompileCommandOptions compile =
        ParseCompileCommand(std::vector<std::string>{"a", "-T", "ps", "-o", "a.spv", "--timeout=7"});
    EXPECT_EQ(compile.shader.output, "a.spv");
    EXPECT_EQ(compile.limits.timeoutSeconds, 7);
}

TEST(OptionsTest, FlagsOfABuildHoldForEveryLine) {
    const BuildCommandOptions build = ParseBuildCommand(
        std::vector<std::string>{"s.cfg", "-o", "out", "-D", "A=1", "-Iinc", "-HV", "2021", "-WX", "-Zpr"});
    EXPECT_EQ(build.everyShader.defines, (std::vector<Define>{{"A", "1"}}));
    EXPECT_EQ(build.everyShader.includeDirs, std::vector<std::string>{"inc"});
    EXPECT_EQ(build.everyShader.hlslVersion, 2021);
    EXPECT_TRUE(build.everyShader.warningsAreErrors && build.everyShader.rowMajor);
    EXPECT_EQ(build.outputDir, "out");
}

TEST(OptionsTest, WrongCommandLineIsRefused) {
    EXPECT_EQ(BuildRefusal({"-o", "x"}), "expected one manifest; 0 are given");
    EXPECT_EQ(BuildRefusal({"a", "b", "-o", "x"}), "expected one manifest; 2 are given");
    EXPECT_EQ(BuildRefusal({"a"}), "no output folder is given: expected -o DIR");
    EXPECT_EQ(BuildRefusal({"a", "-o", "x", "-E", "f"}),
              "unknown flag '-E'; accepted: -o -j --embed --depfile --timeout --max-memory -D -I -Od -O -Zi -WX -Gec "
              "-Gis -HV -Zpr -Zpc -enable-16bit-types -fvk-b-shift -fvk-s-shift -fvk-t-shift -fvk-u-shift "
              "-fvk-invert-y -fvk-use-dx-position-w -fspv-target-env");
    for (const char* number : {"0", "257", "x", "1.5", "", "-1", "99999999999"})
        EXPECT_EQ(BuildRefusal({"a", "-o", "x", "-j", number}),
                  "'-j " + std::string(number) + "': expected a whole number from 1 to 256");
    EXPECT_EQ(BuildRefusal({"a", "-o", "x", "--embed", "a-b"}), "'--embed a-b': expected a C++ identifier");
    EXPECT_EQ(CompileRefusal({"a", "-T", "ps"}), "no output is given: expected -o OUT.spv");
    for (const char* output : {"x", "x.hlsl"})
        EXPECT_EQ(CompileRefusal({"a.hlsl", "-T", "ps", "-o", output}),
                  "'-o " + std::string(output) + "': expected a name that ends in .spv and is not the shader's");
    EXPECT_EQ(CompileRefusal({"a.hlsl", "-T", "ps", "-Fo", "a.hlsl"}), "the output 'a.hlsl' is the shader itself");
    EXPECT_EQ(CompileRefusal({"a.hlsl", "-T", "ps", "-Fh", "a.hlsl"}), "the output 'a.hlsl' is the shader itself");
    EXPECT_EQ(CompileRefusal({"a.spv", "-T", "ps", "-o", "a.spv"}),
              "'-o a.spv': expected a name that ends in .spv and is not the shader's");
}

TEST(OptionsTest, TextOfTheFlagsTellsApartWhatCompilesDifferently) {
    const std::string plain = ToText(Parse({"a", "-T", "ps"}));
    EXPECT_EQ(plain, ToText(Parse({"a", "/T", "ps_5_0", "-O3", "-E", "main", "-o", "other.spv"})));
    for (const std::vector<std::string>& flags : std::vector<std::vector<std::string>>{{"-E", "f"},
                                                                                       {"-D", "A"},
                                                                                       {"-I", "x"},
                                                                                       {"-O2"},
                                                                                       {"-Zi"},
                                                                                       {"-WX"},
                                                                                       {"-Gec"},
                                                                                       {"--after", "x"},
                                                                                       {"-HV", "2021"},
                                                                                       {"-Zpr"},
                                                                                       {"-Gis"},
                                                                                       {"-enable-16bit-types"},
                                                                                       {"-fvk-invert-y"},
                                                                                       {"-fvk-use-dx-position-w"},
                                                                                       {"-fvk-s-shift", "0", "all"},
                                                                                       {"-fvk-s-shift", "0", "0"}}) {
        std::vector<std::string> words = {"a", "-T", "ps"};
        words.insert(words.end(), flags.begin(), flags.end());
        EXPECT_NE(ToText(Parse(words)), plain) << flags[0];
    }
}

}  // namespace
}  // namespace boxcar
