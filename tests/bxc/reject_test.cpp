// Every file in tests/hlsl/reject must be refused with exactly the messages at its head:
//   // flags: -T ps_5_0
//   // expect: loose_global.ps.hlsl:4:7: error: ..
#include "tests/bxc/bxc_test.h"

#include <fstream>
#include <sstream>

namespace boxcar {
namespace {

namespace fs = std::filesystem;

fs::path Corpus() {
    return fs::path(REPOSITORY) / "tests/hlsl/reject";
}

std::vector<std::string> RejectedShaders() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(Corpus())) {
        std::ifstream file(entry.path());
        std::string line;
        if (std::getline(file, line) && line.starts_with("// flags: ")) names.push_back(entry.path().filename());
    }
    std::ranges::sort(names);
    return names;
}

class RejectTest : public BxcTest, public testing::WithParamInterface<std::string> {};

TEST_P(RejectTest, IsRefusedWithTheMessagesAtItsHead) {
    fs::copy(Corpus(), m_folder, fs::copy_options::recursive);
    std::vector<std::string> words = {"compile", GetParam(), "-o", "out.spv"};
    std::string expected, line;
    std::istringstream lines(Read(GetParam()));
    for (std::string word; std::getline(lines, line);) {
        if (line.starts_with("// flags: "))
            for (std::istringstream flags(line.substr(10)); flags >> word;)
                words.push_back(word);
        if (line.starts_with("// expect: ")) expected += line.substr(11) + "\n";
    }
    ASSERT_NE(expected, "") << "the file does not say what it expects";

    const RunResult run = Bxc(words);
    EXPECT_EQ(run.err, expected);
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_FALSE(Exists("out.spv"));
}

INSTANTIATE_TEST_SUITE_P(Corpus, RejectTest, testing::ValuesIn(RejectedShaders()), [](const auto& info) {
    std::string name = info.param.substr(0, info.param.find('.'));
    return name;
});

}  // namespace
}  // namespace boxcar
