// Every file in tests/hlsl/reject must be refused with exactly the messages at its head:
//   // flags: -T ps_5_0
//   // expect: loose_global.ps.hlsl:4:7: error: ..
#include <algorithm>
#include <fstream>
#include <sstream>

#include "tests/bxc/bxc_test.h"

namespace boxcar {
namespace {

namespace fs = std::filesystem;

const fs::path kCorpus = fs::path(REPOSITORY) / "tests/hlsl/reject";

// The files with such a head; the others are what they include.
std::vector<std::string> RejectedShaders() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(kCorpus)) {
        std::ifstream file(entry.path());
        std::string line;
        if (std::getline(file, line) && line.starts_with("// flags: ")) names.push_back(entry.path().filename());
    }
    std::ranges::sort(names);
    return names;
}

using RejectTest = BxcTest;

TEST_F(RejectTest, EveryShaderIsRefusedWithTheMessagesAtItsHead) {
    fs::copy(kCorpus, m_folder, fs::copy_options::recursive);
    const std::vector<std::string> shaders = RejectedShaders();
    EXPECT_GE(shaders.size(), 20u);
    for (const std::string& shader : shaders) {
        SCOPED_TRACE(shader);
        std::vector<std::string> words = {"compile", shader, "-o", "out.spv"};
        std::string expected, line, word;
        for (std::istringstream lines(Read(shader)); std::getline(lines, line);) {
            if (line.starts_with("// flags: "))
                for (std::istringstream flags(line.substr(10)); flags >> word;)
                    words.push_back(word);
            if (line.starts_with("// expect: ")) expected += line.substr(11) + "\n";
        }
        EXPECT_NE(expected, "") << "the file does not say what it expects";

        const RunResult run = Bxc(words);
        EXPECT_EQ(run.err, expected);
        EXPECT_EQ(run.exitCode, 1);
        EXPECT_FALSE(Exists("out.spv"));
    }
}

}  // namespace
}  // namespace boxcar
