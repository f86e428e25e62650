#include "tools/bxc/glslang_log.h"

#include "tests/bxc/bxc_test.h"

namespace boxcar {
namespace {

class GlslangLogTest : public BxcTest {
protected:
    std::vector<std::string> Messages(const std::string& log) {
        Source source(m_folder.string(), {});
        std::string error;
        for (const char* name : {"a.hlsl", "inc/b.hlsli"})
            source.Open(name, error);
        Diagnostics diagnostics;
        AppendGlslangLog(log, "a.hlsl", source, diagnostics);
        std::vector<std::string> messages;
        for (const Diagnostic& diagnostic : diagnostics)
            messages.push_back(ToText(diagnostic));
        return messages;
    }
};

using Names = std::vector<std::string>;

TEST_F(GlslangLogTest, MessageIsPlacedAtItsToken) {
    Write("a.hlsl", "one\n  float4 x = uv;\n");
    Write("inc/b.hlsli", "return nope;");
    EXPECT_EQ(Messages("ERROR: a.hlsl:2: '=' :  cannot convert\n"
                       "WARNING: inc/b.hlsli:1: 'nope' : unknown: x : y\n"
                       "ERROR: a.hlsl:1: '' : no token\n"),
              (Names{"a.hlsl:2:12: error: '=': cannot convert", "inc/b.hlsli:1:8: warning: 'nope': unknown: x : y",
                     "a.hlsl:1: error: no token"}));
}

TEST_F(GlslangLogTest, ParserPositionIsTheColumnOfWhatWasExpected) {
    Write("a.hlsl", "float x = 1 return x;\n");
    EXPECT_EQ(Messages("ERROR: a.hlsl:1: ';' : Expected \n"
                       "ERROR: a.hlsl:1: 'declaration' : Expected \n"
                       "a.hlsl(1): error at column 18, HLSL parsing failed.\n"
                       "ERROR: 3 compilation errors.  No code generated.\n\n\n"),
              (Names{"a.hlsl:1:13: error: expected ';'", "a.hlsl:1:13: error: expected declaration"}));
}

TEST_F(GlslangLogTest, NothingIsDroppedAndNothingIsToldTwice) {
    Write("a.hlsl", "");
    EXPECT_EQ(Messages("a.hlsl(4): error at column 2, HLSL parsing failed.\n"),
              Names{"a.hlsl:4:2: error: the parser stopped here"});
    EXPECT_EQ(Messages("ERROR: 1 compilation errors.  No code generated.\n"),
              Names{"a.hlsl: error: 1 compilation errors.  No code generated."});
    EXPECT_EQ(Messages("WARNING: Linking: odd\nWARNING: Linking: odd\nsomething else\n"),
              (Names{"a.hlsl: warning: Linking: odd", "a.hlsl: error: something else"}));
    EXPECT_EQ(Messages("ERROR: no: place 12: here\n"), Names{"a.hlsl: error: no: place 12: here"});
}

TEST_F(GlslangLogTest, IncludeErrorIsToldWithoutItsEcho) {
    Write("a.hlsl", "#include \"x\"");
    EXPECT_EQ(Messages("ERROR: a.hlsl:1: '#include' : cannot find 'x' for header name: x\n"),
              Names{"a.hlsl:1:1: error: '#include': cannot find 'x'"});
}

TEST_F(GlslangLogTest, VeryLongLinesAreRead) {
    Write("a.hlsl", "");
    const std::string text(1 << 20, 'x');
    EXPECT_EQ(Messages("ERROR: a.hlsl:1: '#error' : " + text + "\n"), Names{"a.hlsl:1: error: '#error': " + text});
}

TEST_F(GlslangLogTest, AttributesThatMeanNothingToVulkanAreLeftOut) {
    Write("a.hlsl", "[FastOpt] for (;;)\n\n[unroll] switch (x)\n");
    EXPECT_EQ(Messages("WARNING: a.hlsl:1: 'RootSignature' : unrecognized attribute \n"
                       "WARNING: a.hlsl:1: '' : attribute does not apply to a loop \n"
                       "WARNING: a.hlsl:3: '' : attribute does not apply to a switch \n"
                       "WARNING: a.hlsl:2: 'rootsignatures' : unrecognized attribute \n"
                       "ERROR: a.hlsl:1: 'shader' : unrecognized attribute \n"),
              (Names{"a.hlsl:3: warning: attribute does not apply to a switch",
                     "a.hlsl:2: warning: 'rootsignatures': unrecognized attribute",
                     "a.hlsl:1: error: 'shader': unrecognized attribute"}));
}

TEST_F(GlslangLogTest, AttributesOfAnEntryPointStandOnLinesAboveIt) {
    Write("a.hlsl", "[maxtessfactor(15)]\n[domain(\"tri\")]\nV main() {\n\n}\n[loop]\nV other() {\n");
    EXPECT_EQ(Messages("WARNING: a.hlsl:3: '' : attribute does not apply to entry point \n"
                       "WARNING: a.hlsl:7: '' : attribute does not apply to entry point \n"),
              Names{"a.hlsl:7: warning: attribute does not apply to entry point"});
}

TEST_F(GlslangLogTest, MissingPartOfTheCompilerIsItsFault) {
    EXPECT_EQ(Messages("Missing functionality: matrix swizzle\n"),
              Names{"a.hlsl: error: the compiler cannot translate this, which is its fault, not the shader's: matrix "
                    "swizzle"});
}

}  // namespace
}  // namespace boxcar
