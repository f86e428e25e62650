#include "tools/bxc/manifest.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace boxcar {
namespace {

std::vector<ShaderJob> Parse(const std::string& text) {
    Diagnostics diagnostics;
    const std::vector<ShaderJob> jobs = ParseManifest(text, "hlsl/shaders.cfg", "out", diagnostics);
    for (const Diagnostic& diagnostic : diagnostics)
        ADD_FAILURE() << ToText(diagnostic);
    return jobs;
}

std::vector<std::string> Outputs(const std::string& text) {
    std::vector<std::string> outputs;
    for (const ShaderJob& job : Parse(text))
        outputs.push_back(job.output);
    return outputs;
}

std::vector<std::string> Errors(const std::string& text) {
    Diagnostics diagnostics;
    ParseManifest(text, "hlsl/shaders.cfg", "out", diagnostics);
    std::vector<std::string> errors;
    for (const Diagnostic& diagnostic : diagnostics)
        errors.push_back(ToText(diagnostic));
    return errors;
}

using Names = std::vector<std::string>;

TEST(ManifestTest, LineBecomesAShaderWithItsFlags) {
    const std::vector<ShaderJob> jobs = Parse("# first\n\nshaders/a.ps.hlsl /T ps -DA=1 /O1  # why\r\n");
    ASSERT_EQ(jobs.size(), 1u);
    EXPECT_EQ(jobs[0].root, "hlsl");
    EXPECT_EQ(jobs[0].options.file, "shaders/a.ps.hlsl");
    EXPECT_EQ(jobs[0].options.stage, ShaderStage::Pixel);
    EXPECT_EQ(jobs[0].options.defines, (std::vector<Define>{{"A", "1"}}));
    EXPECT_EQ(jobs[0].options.optimization, 1);
}

TEST(ManifestTest, OutputIsNamedAfterFileAndEntryAndPermutation) {
    EXPECT_EQ(Outputs("a.ps.hlsl -T ps"), Names{"out/a.ps.spv"});
    EXPECT_EQ(Outputs("shaders/a.hlsl -T ps -E Blur"), Names{"out/shaders/a.Blur.spv"});
    EXPECT_EQ(Outputs("a.fx -T ps -D PLAIN=3"), Names{"out/a.fx.spv"});
    EXPECT_EQ(Outputs("a.hlsl -T ps -E Blur -D TAPS={2,16}"),
              (Names{"out/a.Blur.TAPS=2.spv", "out/a.Blur.TAPS=16.spv"}));
    EXPECT_EQ(Outputs("a.hlsl -T ps -o sub/b.spv"), Names{"out/sub/b.spv"});
    EXPECT_EQ(Outputs("a.hlsl -T ps -o b -DX={1,2}"), (Names{"out/b.X=1.spv", "out/b.X=2.spv"}));
}

TEST(ManifestTest, PermutationsMultiplyInTheOrderOfTheFlags) {
    const std::vector<ShaderJob> jobs = Parse("a.hlsl -T ps -D A={1, 2} -D B=7 -DC={x,y}");
    ASSERT_EQ(jobs.size(), 4u);
    EXPECT_EQ(jobs[1].options.output, "a.A=1.C=y");
    EXPECT_EQ(jobs[1].options.defines, (std::vector<Define>{{"A", "1"}, {"B", "7"}, {"C", "y"}}));
    EXPECT_EQ(jobs[2].options.output, "a.A=2.C=x");
}

TEST(ManifestTest, QuotedWordsKeepTheirSpacesAndHashes) {
    const std::vector<ShaderJob> jobs = Parse("\"my shader.hlsl\" -T ps -D \"TEXT=a # b\" -D C={\"x\"}");
    ASSERT_EQ(jobs.size(), 1u);
    EXPECT_EQ(jobs[0].options.file, "my shader.hlsl");
    EXPECT_EQ(jobs[0].options.defines[0].value, "a # b");
}

TEST(ManifestTest, EveryWrongLineIsReportedWithItsNumber) {
    EXPECT_EQ(
        Errors("a.hlsl -T ps -Fo x\n"
               "b.hlsl -T ps\n"
               "c.hlsl -T gs_5_0\n"
               "d.hlsl\n"
               "-T ps\n"),
        (Names{"hlsl/shaders.cfg:1: error: unknown flag '-Fo'; accepted: -T -E -D -I -O0 -O1 -O2 -O3 -Zi -WX "
               "-Gec -HV --after -o",
               "hlsl/shaders.cfg:3: error: '-T gs_5_0': expected vs, ps or cs, with or without a version, as in "
               "ps_5_0",
               "hlsl/shaders.cfg:4: error: 'd.hlsl' has no profile: expected -T vs_5_0, ps_5_0 or cs_5_0",
               "hlsl/shaders.cfg:5: error: no shader file is given"}));
}

TEST(ManifestTest, TwoLinesWithOneOutputAreAnErrorThatNamesBoth) {
    EXPECT_EQ(Errors("a.hlsl -T ps\n\na.hlsl -T ps -D A\n"),
              Names{"hlsl/shaders.cfg:3: error: the output 'a.spv' is also written by line 1"});
    EXPECT_EQ(Errors("x/../a.hlsl -T ps\na.hlsl -T vs\n"),
              Names{"hlsl/shaders.cfg:2: error: the output 'a.spv' is also written by line 1"});
    EXPECT_EQ(Errors("a.hlsl -T ps -D A={1,1}\n"),
              Names{"hlsl/shaders.cfg:1: error: the output 'a.A=1.spv' is also written by line 1"});
}

TEST(ManifestTest, OutputOutsideTheFolderIsAnError) {
    for (const char* line : {"../a.hlsl -T ps", "x/../../a.hlsl -T ps", "a.hlsl -T ps -o ../a"})
        EXPECT_EQ(Errors(line),
                  Names{"hlsl/shaders.cfg:1: error: the output '../a' is outside the output folder; give "
                        "its name with -o NAME.spv"});
    EXPECT_EQ(Errors("/abs/a.hlsl -T ps"),
              Names{"hlsl/shaders.cfg:1: error: the output '/abs/a' is outside the output "
                    "folder; give its name with -o NAME.spv"});
    EXPECT_EQ(Outputs("../a.hlsl -T ps -o a"), Names{"out/a.spv"});
}

TEST(ManifestTest, WrongBracesAreErrors) {
    EXPECT_EQ(Errors("a.hlsl -T ps -D A={1,2"), Names{"hlsl/shaders.cfg:1: error: a { without its }"});
    EXPECT_EQ(Errors("a.hlsl -T ps -D \"A"), Names{"hlsl/shaders.cfg:1: error: a \" without its partner"});
    for (const char* values : {"{}", "{1,,2}", "{1,}", "{a/b}"})
        EXPECT_EQ(
            Errors("a.hlsl -T ps -D A=" + std::string(values)),
            Names{"hlsl/shaders.cfg:1: error: '-D A=" + std::string(values) +
                  "': a value in braces becomes part of a file name: expected at least one character and no /"});
    std::string many = "a.hlsl -T ps";
    for (const char* name : {"A", "B", "C", "D"})
        many += std::string(" -D ") + name + "={1,2,3,4,5,6,7,8,9}";
    EXPECT_EQ(Errors(many), Names{"hlsl/shaders.cfg:1: error: more than 4096 permutations"});
}

}  // namespace
}  // namespace boxcar
