#include "tools/bxc/manifest.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace boxcar {
namespace {

std::vector<ShaderJob> Parse(const std::string& text, const CompileOptions& defaults = {}) {
    Diagnostics diagnostics;
    const std::vector<ShaderJob> jobs = ParseManifest(text, "hlsl/shaders.cfg", "out", defaults, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics)
        ADD_FAILURE() << ToText(diagnostic);
    return jobs;
}

std::vector<std::string> Outputs(const std::string& text, const CompileOptions& defaults = {}) {
    std::vector<std::string> outputs;
    for (const ShaderJob& job : Parse(text, defaults))
        outputs.push_back(job.output);
    return outputs;
}

std::vector<std::string> Errors(const std::string& text, const CompileOptions& defaults = {}) {
    Diagnostics diagnostics;
    ParseManifest(text, "hlsl/shaders.cfg", "out", defaults, diagnostics);
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
    EXPECT_EQ(Outputs("a.hlsl -T ps -Fo sub/b"), Names{"out/sub/b.spv"});
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
        Errors("a.hlsl -T ps -Fc x\n"
               "b.hlsl -T ps\n"
               "c.hlsl -T xs_5_0\n"
               "d.hlsl\n"
               "-T ps\n"
               "e.hlsl -T ps -Fh e.h\n"),
        (Names{"hlsl/shaders.cfg:1: error: '-Fc': bxc does not write listings; spirv-dis makes one from the .spv",
               "hlsl/shaders.cfg:3: error: '-T xs_5_0': expected vs, hs, ds, gs, ps or cs, with or without a "
               "version, as "
               "in ps_5_0",
               "hlsl/shaders.cfg:4: error: 'd.hlsl' has no profile: expected -T vs_5_0, ps_5_0 or cs_5_0",
               "hlsl/shaders.cfg:5: error: no shader file is given",
               "hlsl/shaders.cfg:6: error: '-Fh e.h': a line of a manifest cannot have a header; --embed NAME makes "
               "one for all of them"}));
}

TEST(ManifestTest, EntryPointsInBracesAreShadersOfTheirOwn) {
    const std::vector<ShaderJob> jobs = Parse("a.hlsl -T vs -E {main,buffer_loads} -D M={0,1}");
    ASSERT_EQ(jobs.size(), 4u);
    EXPECT_EQ(jobs[0].options.entry, "main");
    EXPECT_EQ(jobs[0].options.output, "a.M=0");
    EXPECT_EQ(jobs[3].options.entry, "buffer_loads");
    EXPECT_EQ(jobs[3].options.output, "a.buffer_loads.M=1");
    EXPECT_EQ(Outputs("a.hlsl -T vs -E {main,f} -o b.spv"), (Names{"out/b.main.spv", "out/b.f.spv"}));
    EXPECT_EQ(Outputs("a.hlsl -T vs -E{f,g}"), (Names{"out/a.f.spv", "out/a.g.spv"}));
}

TEST(ManifestTest, MacrosInBracesMayBeLeftOut) {
    for (const char* braces : {"-D {A,}", "{-D A,}", "{-DA,}"}) {
        const std::vector<ShaderJob> jobs = Parse("a.hlsl -T ps -D B " + std::string(braces));
        ASSERT_EQ(jobs.size(), 2u) << braces;
        EXPECT_EQ(jobs[0].options.defines, (std::vector<Define>{{"B", "1"}, {"A", "1"}})) << braces;
        EXPECT_EQ(jobs[0].options.output, "a.A") << braces;
        EXPECT_EQ(jobs[1].options.defines, (std::vector<Define>{{"B", "1"}})) << braces;
        EXPECT_EQ(jobs[1].options.output, "a") << braces;
    }
    const std::vector<ShaderJob> either = Parse("a.hlsl -T ps -D {A=1,B=2}");
    ASSERT_EQ(either.size(), 2u);
    EXPECT_EQ(either[1].options.defines, (std::vector<Define>{{"B", "2"}}));
    EXPECT_EQ(either[1].options.output, "a.B=2");
    const std::vector<ShaderJob> empty = Parse("a.hlsl -T ps -D A={,1}");
    ASSERT_EQ(empty.size(), 2u);
    EXPECT_EQ(empty[0].options.defines, (std::vector<Define>{{"A", ""}}));
    EXPECT_EQ(empty[0].options.output, "a.A=");
}

TEST(ManifestTest, BracesMayStandInAnyWord) {
    EXPECT_EQ(Outputs("{a,b}.hlsl -T ps"), (Names{"out/a.spv", "out/b.spv"}));
    EXPECT_EQ(Outputs("a.hlsl -T {vs,ps}"), (Names{"out/a.vs.spv", "out/a.ps.spv"}));
    EXPECT_EQ(Outputs("a.hlsl -T ps -O{1,3}"), (Names{"out/a.O1.spv", "out/a.O3.spv"}));
    EXPECT_EQ(Outputs("a.hlsl -T ps -D {A,B}={0,1}"),
              (Names{"out/a.A=0.spv", "out/a.A=1.spv", "out/a.B=0.spv", "out/a.B=1.spv"}));
}

TEST(ManifestTest, OutputThatLinesShareOrThatEndsInASlashIsAFolder) {
    EXPECT_EQ(Outputs("x/a.hlsl -T ps -o d\ny/b.hlsl -T ps -D M={1,2} -o d\n"),
              (Names{"out/d/a.spv", "out/d/b.M=1.spv", "out/d/b.M=2.spv"}));
    EXPECT_EQ(Outputs("x/a.hlsl -T ps -o d/\n"), Names{"out/d/a.spv"});
    EXPECT_EQ(Outputs("x/a.hlsl -T ps -o d\ny/b.hlsl -T ps -o e\n"), (Names{"out/d.spv", "out/e.spv"}));
    EXPECT_EQ(Errors("a.hlsl -T ps -o d.spv\nb.hlsl -T ps -o d.spv\n"),
              Names{"hlsl/shaders.cfg:2: error: the output 'd.spv' is also written by line 1"});
}

TEST(ManifestTest, FlagsOfTheBuildComeBeforeThoseOfTheLine) {
    CompileOptions defaults;
    defaults.defines = {{"A", "1"}, {"B", "1"}};
    defaults.hlslVersion = 2021;
    const std::vector<ShaderJob> jobs = Parse("a.hlsl -T ps -D A=2\nb.hlsl -T ps -HV 2018\n", defaults);
    ASSERT_EQ(jobs.size(), 2u);
    EXPECT_EQ(jobs[0].options.defines, (std::vector<Define>{{"B", "1"}, {"A", "2"}}));
    EXPECT_EQ(jobs[0].options.hlslVersion, 2021);
    EXPECT_EQ(jobs[1].options.hlslVersion, 2018);
}

TEST(ManifestTest, ShaderMakesFormIsRead) {
    const std::string text =
        "// comment of a line\n"
        "sub/a.hlsl -T vs_6_0 -o \"folder/of it\" --outputSuffix _x\n"
        "a.hlsl -T ps_6_0 -o \"folder/of it\" -E f\n"
        "#ifdef GEOMETRY\n"
        "b.hlsl -T gs\n"
        "#else\n"
        "c.hlsl -T vs\n"
        "#endif\n"
        "#if 0\n"
        "#ifdef GEOMETRY\n"
        "d.hlsl -T nonsense\n"
        "#endif\n"
        "#else\n"
        "e.hlsl -T ps -O 1\n"
        "#endif\n"
        "#if 1\n"
        "f.hlsl -T cs\n"
        "#endif\n";
    EXPECT_EQ(Outputs(text),
              (Names{"out/folder/of it/a_x.spv", "out/folder/of it/a.f.spv", "out/c.spv", "out/e.spv", "out/f.spv"}));
    CompileOptions defaults;
    defaults.defines = {{"GEOMETRY", "1"}};
    EXPECT_EQ(Outputs(text, defaults),
              (Names{"out/folder/of it/a_x.spv", "out/folder/of it/a.f.spv", "out/b.spv", "out/e.spv", "out/f.spv"}));
    EXPECT_EQ(Errors("#endif\n"), Names{"hlsl/shaders.cfg:1: error: #endif without #ifdef NAME, #if 0 or #if 1"});
    EXPECT_EQ(Errors("a.hlsl -T ps\n#if 1\n"), Names{"hlsl/shaders.cfg:2: error: a condition that no #endif ends"});
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
    EXPECT_EQ(Errors("a.hlsl -T ps -D A={1,2"), Names{"hlsl/shaders.cfg:1: error: a { that is never closed"});
    EXPECT_EQ(Errors("a.hlsl -T ps -D \"A"), Names{"hlsl/shaders.cfg:1: error: a \" that is never closed"});
    EXPECT_EQ(Errors("a.hlsl -T ps -D A={}"), Names{"hlsl/shaders.cfg:1: error: 'A={}': braces without a value"});
    EXPECT_EQ(
        Errors("a.hlsl -T ps -D A={a/b}"),
        Names{"hlsl/shaders.cfg:1: error: 'A={a/b}': a value in braces becomes part of a file name: expected no /"});
    EXPECT_EQ(Errors("a.hlsl -T ps -D{A,}"), Names{"hlsl/shaders.cfg:1: error: '-D' needs a value"});
    EXPECT_EQ(Errors("a.hlsl -T ps -D \"A={\""), Names{}) << "a brace in quotes stands for itself";
    EXPECT_EQ(Errors("a.hlsl -T ps -D \"A=}{\""), Names{});
    std::string braces = "{a,b}{a,b}{a,b}{a,b}{a,b}{a,b}{a,b}{a,b}{a,b}{a,b}{a,b}{a,b}{a,b}";
    EXPECT_EQ(Errors("a.hlsl -T ps -D A=" + braces), Names{"hlsl/shaders.cfg:1: error: more than 4096 permutations"});
    EXPECT_EQ(Errors("a.hlsl -T ps -D A=" + braces + braces),
              Names{"hlsl/shaders.cfg:1: error: more than 16 braces in one word"});
    std::string many = "a.hlsl -T ps";
    for (const char* name : {"A", "B", "C", "D"})
        many += std::string(" -D ") + name + "={1,2,3,4,5,6,7,8,9}";
    EXPECT_EQ(Errors(many), Names{"hlsl/shaders.cfg:1: error: more than 4096 permutations"});
}

}  // namespace
}  // namespace boxcar
