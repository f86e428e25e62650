#include "tools/bxc/commands/build.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "tools/bxc/commands/command.h"
#include "tools/bxc/commands/compile_jobs.h"
#include "tools/bxc/commands/limits.h"
#include "tools/bxc/embed.h"
#include "tools/bxc/write.h"

namespace boxcar {
namespace {

using Values = std::span<const std::string>;

constexpr const char* kUsage = R"(
bxc build MANIFEST -o DIR [flags]: compiles the shaders that MANIFEST lists, where they are out of date.

  -o DIR              where to write
  -j N                worker processes; one per core by default
  --embed NAME        also writes DIR/NAME.h and DIR/NAME.cpp, which put the shaders into a C++ program
  --depfile FILE      also writes what the whole build depends on, for ninja or make
)";

constexpr const char* kManifest = R"(
  -D -I -HV -Zpr ..   flags of a shader (below) that hold for every line; all except for -T -E -o --after

A manifest has one shader per line: its file, relative to the manifest, and these flags. Lines that start with # or
// are comments; #ifdef NAME (a -D of the command line), #if 0, #if 1, #else and #endif leave lines out. bxc also
reads the manifests of ShaderMake.
A word with braces compiles the shader once for each value: -D NAME={A,B}, -E {a,b}, -D {A,} (with A and without).
With several such words it is compiled for every combination. #include looks in the manifest's own folder last.

)";

constexpr const char* kOutputFlagsAndExample = R"(
  -o NAME.spv     name of the output in DIR; by default it is made of the file's name, the entry point and the values
  -o FOLDER/      folder of the output in DIR, where the name is the file's; needs no slash if several lines share it
  --outputSuffix TEXT   goes behind that name, before the values

Example:
  $ cat hlsl/passes.cfg
  shaders/sat_pass.ps.hlsl -T ps_5_0 -D TAPS={2,4,8,16}
  $ bxc build hlsl/passes.cfg -o build/shaders
  writes build/shaders/shaders/sat_pass.ps.TAPS=2.spv, .layout.json, .d and so on
)";

// Every flag of a shader that makes sense for all lines of a manifest.
std::vector<Flag> EveryShaderFlags(CompileOptions& options, bool& hasProfile) {
    constexpr std::string_view kOfOneShader[] = {"-T", "-E",  "--after", "--after-T",      "--after-E",
                                                 "-o", "-Fo", "-Fh",     "--outputSuffix", "-Vn"};
    std::vector<Flag> flags = CompileFlags(options, hasProfile);
    std::erase_if(flags, [&](const Flag& flag) {
        return std::ranges::find(kOfOneShader, flag.name) != std::end(kOfOneShader);
    });
    return flags;
}

std::string ParseEmbed(const std::string& name) {
    if (!IsIdentifier(name)) throw UsageError("'--embed {}': expected a C++ identifier", name);
    return name;
}

// What the whole build depends on; its target is the file that --embed writes, or else the output folder.
void WriteBuildDepfile(const std::vector<ShaderJob>& jobs, const BuildCommandOptions& options) {
    std::set<std::string> dependencies = {options.manifest};
    for (const ShaderJob& job : jobs)
        dependencies.merge(DependenciesOf(job));
    const std::string target =
        options.embed.empty() ? options.outputDir : options.outputDir + "/" + options.embed + ".cpp";
    WriteFile(options.depfile, DepfileText("", target, dependencies));
}

}  // namespace

BuildCommandOptions ParseBuildCommand(std::span<const std::string> words) {
    BuildCommandOptions options;
    bool hasProfile = false;
    std::vector<Flag> flags = {
        {"-o", 1, [&](Values v) { options.outputDir = v[0]; }},
        {"-j", 1, [&](Values v) { options.limits.workers = ParseNumber("-j", v[0], 1, 256); }, true},
        {"--embed", 1, [&](Values v) { options.embed = ParseEmbed(v[0]); }},
        {"--depfile", 1, [&](Values v) { options.depfile = v[0]; }},
    };
    std::ranges::move(LimitFlags(options.limits), std::back_inserter(flags));
    std::ranges::move(EveryShaderFlags(options.everyShader, hasProfile), std::back_inserter(flags));
    const std::vector<std::string> others = ParseFlags(words, flags);
    if (others.size() != 1) throw UsageError("expected one manifest; {} are given", others.size());
    if (options.outputDir.empty()) throw UsageError("no output folder is given: expected -o DIR");
    options.manifest = others[0];
    return options;
}

int RunBuildCommand(std::span<const std::string> words) {
    const BuildCommandOptions options = ParseBuildCommand(words);
    Report report;
    Diagnostics diagnostics;
    const std::vector<ShaderJob> jobs =
        ReadManifest(options.manifest, options.outputDir, options.everyShader, diagnostics);
    report.Add(diagnostics, "");
    if (HasErrors(diagnostics)) return 1;

    std::vector<ShaderJob> outOfDate;
    std::ranges::copy_if(jobs, std::back_inserter(outOfDate), [](const ShaderJob& job) { return !IsUpToDate(job); });
    const size_t failed = CompileJobs(outOfDate, options.limits, report);

    if (failed == 0 && !options.embed.empty()) WriteEmbedded(jobs, options.outputDir, options.embed);
    if (failed == 0 && !options.depfile.empty()) WriteBuildDepfile(jobs, options);
    report.Summary(outOfDate.size() - failed, jobs.size() - outOfDate.size(), failed);
    return failed == 0 ? 0 : 1;
}

std::string BuildCommandHelp() {
    return HelpText({kUsage, kLimitFlagsHelp, kManifest, kCompileFlagsHelp, kOutputFlagsAndExample});
}

}  // namespace boxcar
