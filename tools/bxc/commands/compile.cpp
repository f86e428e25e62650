#include "tools/bxc/commands/compile.h"

#include <algorithm>
#include <iterator>

#include "tools/bxc/commands/command.h"
#include "tools/bxc/commands/compile_jobs.h"
#include "tools/bxc/commands/limits.h"

namespace boxcar {
namespace {

constexpr const char* kUsage = R"(
bxc compile FILE -T PROFILE -o OUT.spv [flags]: writes OUT.spv, OUT.layout.json (what a program binds to the shader)
and OUT.d (what the shader depends on, for make). A flag may also start with /, and its value may follow without a
space: /Tps_5_0.

)";

constexpr const char* kOutputFlags = R"(
  -o OUT.spv      where to write; -Fo OUT is the same with any ending
  -Fh OUT.h       also writes the SPIR-V as an array in a C header; without -o, nothing but the header
  -Vn NAME        name of that array; by default g_ and the entry point
)";

constexpr const char* kExample = R"(

Flags of fxc and dxc that cannot change the SPIR-V are ignored: -nologo -spirv -Ges -Qstrip_reflect -W3 and so on.

Example:
  bxc compile hlsl/shaders/sat_pass.ps.hlsl -T ps_5_0 -D TAPS=4 -I hlsl -o sat_pass.spv
)";

}  // namespace

CompileCommandOptions ParseCompileCommand(std::span<const std::string> words) {
    CompileCommandOptions options;
    CompileOptions& shader = options.shader;
    bool hasProfile = false;
    std::vector<Flag> flags = CompileFlags(shader, hasProfile);
    std::ranges::move(LimitFlags(options.limits), std::back_inserter(flags));
    CheckCompileOptions(shader, hasProfile, ParseFlags(words, flags));

    const bool isNamedSpv = shader.output.ends_with(".spv") || shader.output.starts_with("/dev/");
    if (!shader.output.empty() && (!isNamedSpv || shader.output == shader.file))
        throw UsageError("'-o {}': expected a name that ends in .spv and is not the shader's", shader.output);
    if (shader.output.empty()) shader.output = shader.binary;
    if (shader.output.empty() && shader.header.empty()) throw UsageError("no output is given: expected -o OUT.spv");
    for (const std::string& name : {shader.output, shader.header})
        if (name == shader.file) throw UsageError("the output '{}' is the shader itself", name);
    return options;
}

int RunCompileCommand(std::span<const std::string> words) {
    const CompileCommandOptions options = ParseCompileCommand(words);
    Report report;
    return CompileJobs({{"", options.shader, options.shader.output}}, options.limits, report) == 0 ? 0 : 1;
}

std::string CompileCommandHelp() {
    return HelpText({kUsage, kCompileFlagsHelp, kOutputFlags, kLimitFlagsHelp, kExample});
}

}  // namespace boxcar
