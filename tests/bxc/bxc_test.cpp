#include "tests/bxc/bxc_test.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <sstream>

namespace boxcar {

const char* const kPlainPixelShader = R"(
cbuffer Params : register(b0) { float4 tint; };
Texture2D<float4> source : register(t0);
SamplerState nearest : register(s0);
float4 main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target0 {
    return source.Sample(nearest, uv) * tint;
}
)";

BxcTest::BxcTest() {
    const testing::TestInfo* info = testing::UnitTest::GetInstance()->current_test_info();
    std::string name = fmt::format("{}.{}.{}", info->test_suite_name(), info->name(), getpid());
    for (char& c : name)
        if (c == '/') c = '_';
    m_folder = std::filesystem::path(testing::TempDir()) / name;
    std::filesystem::create_directories(m_folder);
}

BxcTest::~BxcTest() {
    std::filesystem::remove_all(m_folder);
}

void BxcTest::Write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((m_folder / name).parent_path());
    std::ofstream(m_folder / name, std::ios::binary) << text;
}

std::string BxcTest::Read(const std::string& name) const {
    std::ifstream file(m_folder / name, std::ios::binary);
    EXPECT_TRUE(file) << name;
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

bool BxcTest::Exists(const std::string& name) const {
    return std::filesystem::exists(m_folder / name);
}

ShaderLayout BxcTest::ReadLayout(const std::string& name) const {
    return ShaderLayoutFromJson(Read(name));
}

RunResult BxcTest::RunProgram(const std::vector<std::string>& words) const {
    const std::string out = (m_folder / ".stdout").string(), err = (m_folder / ".stderr").string();
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addchdir_np(&actions, m_folder.c_str());
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    std::vector<char*> arguments;
    for (const std::string& word : words)
        arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    pid_t process = 0;
    const int error = posix_spawnp(&process, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    EXPECT_EQ(error, 0) << words[0];

    int status = 0;
    waitpid(process, &status, 0);
    EXPECT_TRUE(WIFEXITED(status)) << words[0] << " died of signal " << WTERMSIG(status);
    return {WEXITSTATUS(status), Read(out), Read(err)};
}

RunResult BxcTest::Bxc(std::vector<std::string> words) const {
    words.insert(words.begin(), BXC_PROGRAM);
    return RunProgram(words);
}

}  // namespace boxcar
