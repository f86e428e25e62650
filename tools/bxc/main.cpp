// bxc: compiles HLSL to SPIR-V that is proven valid. The commands are in tools/bxc/commands/, the pipeline that a
// shader goes through is in tools/bxc/compile.cpp.
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <vector>

#include "tools/base/error.h"
#include "tools/bxc/commands/build.h"
#include "tools/bxc/commands/command.h"
#include "tools/bxc/commands/compile.h"
#include "tools/bxc/commands/worker.h"
#include "tools/bxc/compiler.h"
#include "tools/bxc/version.h"

namespace boxcar {
namespace {

std::string Help() {
    return HelpText({R"(
bxc: compiles HLSL to SPIR-V that is proven valid for Vulkan 1.1.

  bxc compile FILE -T PROFILE -o OUT.spv [flags]     one shader
  bxc build MANIFEST -o DIR [-j N]                   every shader that a file lists
  bxc compile --help, bxc build --help               their flags, with an example
  bxc --version

Exit code: 0 all is well; 1 the work failed; 2 the command line is wrong.
)"});
}

int PrintHelp(std::span<const std::string>) {
    fmt::print("{}", Help());
    return 0;
}

int PrintVersion(std::span<const std::string>) {
    fmt::print("bxc {} ({})\n", Version(), CompilerVersion());
    return 0;
}

constexpr Command kCommands[] = {
    {"compile", RunCompileCommand, CompileCommandHelp},
    {"build", RunBuildCommand, BuildCommandHelp},
    {"--help", PrintHelp, Help},
    {"--version", PrintVersion, Help},
    {"worker", RunWorkerCommand, nullptr},
};

std::string Accepted() {
    std::string names;
    for (const Command& command : kCommands)
        if (command.help) names += fmt::format("{}{}", names.empty() ? "accepted: " : ", ", command.name);
    return names;
}

int Run(std::span<const std::string> words) {
    if (words.empty()) throw UsageError("no command is given; {}", Accepted());
    const auto command = std::ranges::find(kCommands, words[0], &Command::name);
    const bool isKnown = command != std::end(kCommands);
    if (std::ranges::any_of(words, [](const std::string& word) { return word == "--help" || word == "-h"; })) {
        fmt::print("{}", isKnown && command->help ? command->help() : Help());
        return 0;
    }
    if (!isKnown) throw UsageError("unknown command '{}'; {}", words[0], Accepted());
    return command->run(words.subspan(1));
}

}  // namespace
}  // namespace boxcar

int main(int argc, char** argv) try {
    const std::vector<std::string> words(argv + 1, argv + argc);
    const int exitCode = boxcar::Run(words);
    if (std::fflush(stdout) != 0) throw boxcar::Error("cannot write to stdout: {}", std::strerror(errno));
    return exitCode;
} catch (const boxcar::UsageError& error) {
    fmt::print(stderr, "bxc: {} (bxc --help)\n", error.what());
    return 2;
} catch (const std::exception& error) {
    fmt::print(stderr, "bxc: {}\n", error.what());
    return 1;
}
