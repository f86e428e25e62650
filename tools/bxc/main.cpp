// bxc: HLSL text -> SPIR-V that is proven valid, its layout and its dependencies. CompileShader() is the pipeline.
//
// Non-goals: a preprocessor, linker or optimiser of its own; ray and mesh stages; Direct3D bytecode.
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <optional>
#include <set>

#include "tools/bxc/blame.h"
#include "tools/bxc/compiler.h"
#include "tools/bxc/contraction.h"
#include "tools/bxc/embed.h"
#include "tools/bxc/manifest.h"
#include "tools/bxc/optimize.h"
#include "tools/bxc/options.h"
#include "tools/bxc/reflect.h"
#include "tools/bxc/repair.h"
#include "tools/bxc/report.h"
#include "tools/bxc/rules.h"
#include "tools/bxc/source.h"
#include "tools/bxc/validate.h"
#include "tools/bxc/version.h"
#include "tools/bxc/workers.h"
#include "tools/bxc/write.h"

namespace boxcar {
namespace {

// The compiler's SPIR-V, with what is known to be wrong in it put right.
CompiledShader CompileAndRepair(Compiler& compiler, const CompileOptions& options, Source& source,
                                Diagnostics& diagnostics) {
    CompiledShader compiled = compiler.Compile(options, source, diagnostics);
    compiled.spirv = Repair(compiled.spirv, options.stage);
    if (options.strictMath) compiled.spirv = ForbidContraction(compiled.spirv);
    return compiled;
}

// The module of a step, of the same shader with source lines; empty if it comes to none.
std::vector<uint32_t> WithLines(Compiler& compiler, CompileOptions options, Source& source, ValidationStep step) {
    options.debugInfo = true;
    Diagnostics untold;
    std::vector<uint32_t> spirv = CompileAndRepair(compiler, options, source, untold).spirv;
    if (step == ValidationStep::BeforeLegalization || spirv.empty()) return spirv;
    spirv = Optimize(spirv, options.optimization, options.file, untold);
    return StripSemantics(spirv, options.file, untold);
}

void Validate(Compiler& compiler, const std::vector<uint32_t>& spirv, ValidationStep step,
              const CompileOptions& options, Source& source, Diagnostics& diagnostics) {
    if (const auto fault = FindFault(spirv, step))
        diagnostics.push_back(BlameCompiler(*fault, step, options, WithLines(compiler, options, source, step)));
}

// From text to what the rules look at. Ends early where there are errors, or no entry point.
RuleSubject RunFrontEnd(Compiler& compiler, const CompileOptions& options, Source& source, Diagnostics& diagnostics) {
    const CompiledShader compiled = CompileAndRepair(compiler, options, source, diagnostics);
    RuleSubject subject{options, compiled, Outline(compiled.preprocessed, options.file, source), {}, {}};
    const std::vector<uint32_t>& spirv = subject.compiled.spirv;
    if (!subject.compiled.hasEntry || HasErrors(diagnostics)) return subject;

    Validate(compiler, spirv, ValidationStep::BeforeLegalization, options, source, diagnostics);
    if (HasErrors(diagnostics)) return subject;

    subject.declared = Reflect(spirv, ReflectScope::All, options, diagnostics);
    subject.used = Reflect(spirv, ReflectScope::Used, options, diagnostics);
    return subject;
}

// The shader that --after names, with the macros and folders of the one that it feeds.
CompileOptions PartnerOptions(const CompileOptions& options) {
    CompileOptions partner = options;
    partner.file = options.after;
    partner.stage = options.afterStage;
    partner.entry = options.afterEntry;
    return partner;
}

// One shader through every stage. Runs in a worker process; a stage that finds an error is the last.
CompileResult CompileShader(Compiler& compiler, const ShaderJob& job) {
    const CompileOptions& options = job.options;
    CompileResult result;
    Diagnostics& diagnostics = result.diagnostics;
    const auto failed = [&] {
        for (Diagnostic& diagnostic : diagnostics)
            if (options.warningsAreErrors && diagnostic.severity == Severity::Warning)
                diagnostic.severity = Severity::Error;
        return HasErrors(diagnostics);
    };

    Source source(job.root, options.includeDirs);
    const RuleSubject shader = RunFrontEnd(compiler, options, source, diagnostics);
    std::optional<RuleSubject> partner;
    if (!options.after.empty()) partner = RunFrontEnd(compiler, PartnerOptions(options), source, diagnostics);
    result.dependencies = source.Names();
    if (failed()) return result;

    CheckRules(shader, partner ? &*partner : nullptr, diagnostics);
    if (partner) CheckRules(*partner, nullptr, diagnostics);
    if (failed()) return result;

    std::vector<uint32_t> spirv = Optimize(shader.compiled.spirv, options.optimization, options.file, diagnostics);
    if (failed()) return result;

    result.layout = Reflect(spirv, ReflectScope::All, options, diagnostics);
    if (failed()) return result;

    spirv = StripSemantics(spirv, options.file, diagnostics);
    if (failed()) return result;

    Validate(compiler, spirv, ValidationStep::Final, options, source, diagnostics);
    if (failed()) return result;

    result.spirv = std::move(spirv);
    return result;
}

// Compiles the jobs in workers, writes what they make and says what they say. Returns how many failed.
size_t CompileJobs(const std::vector<ShaderJob>& jobs, const WorkerLimits& limits, Report& report) {
    const FileTime started = Now();
    size_t done = 0, failed = 0;
    CompileAll(jobs, limits, [&](const ShaderJob& job, const CompileResult& result) {
        report.Add(result.diagnostics, job.root);
        if (HasErrors(result.diagnostics)) {
            RemoveOutputs(job);
            ++failed;
        } else {
            WriteOutputs(job, result, started);
        }
        report.Progress(++done, jobs.size(), job.options.output);
    });
    return failed;
}

bool CompileOne(const Options& options) {
    const ShaderJob job{"", options.compile, options.compile.output};
    Report report;
    return CompileJobs({job}, {1, options.timeoutSeconds, options.maxMemoryMib}, report) == 0;
}

// What the whole build depends on; its target is the file that --embed writes, or else the output folder.
void WriteBuildDepfile(const std::vector<ShaderJob>& jobs, const Options& options) {
    std::set<std::string> dependencies = {options.manifest};
    for (const ShaderJob& job : jobs)
        dependencies.merge(DependenciesOf(job));
    const std::string target =
        options.embed.empty() ? options.outputDir : options.outputDir + "/" + options.embed + ".cpp";
    WriteFile(options.depfile, DepfileText("", target, dependencies));
}

bool Build(const Options& options) {
    Report report;
    Diagnostics diagnostics;
    const std::vector<ShaderJob> jobs =
        ReadManifest(options.manifest, options.outputDir, options.compile, diagnostics);
    report.Add(diagnostics, "");
    if (HasErrors(diagnostics)) return false;

    std::vector<ShaderJob> outOfDate;
    std::ranges::copy_if(jobs, std::back_inserter(outOfDate), [](const ShaderJob& job) { return !IsUpToDate(job); });
    const size_t failed =
        CompileJobs(outOfDate, {options.jobs, options.timeoutSeconds, options.maxMemoryMib}, report);

    if (failed == 0 && !options.embed.empty()) WriteEmbedded(jobs, options.outputDir, options.embed);
    if (failed == 0 && !options.depfile.empty()) WriteBuildDepfile(jobs, options);
    report.Summary(outOfDate.size() - failed, jobs.size() - outOfDate.size(), failed);
    return failed == 0;
}

int Run(const Options& options) {
    switch (options.command) {
        case Command::Compile: return CompileOne(options) ? 0 : 1;
        case Command::Build: return Build(options) ? 0 : 1;
        case Command::Worker: {
            const std::unique_ptr<Compiler> compiler = MakeCompiler();
            RunWorker([&](const ShaderJob& job) { return CompileShader(*compiler, job); });
            return 0;
        }
        case Command::Help: fmt::print("{}", options.help); return 0;
        case Command::Version: fmt::print("bxc {} ({})\n", Version(), CompilerVersion()); return 0;
    }
    return 2;
}

}  // namespace
}  // namespace boxcar

int main(int argc, char** argv) try {
    const std::vector<std::string> words(argv + 1, argv + argc);
    const int exitCode = boxcar::Run(boxcar::ParseOptions(words));
    if (std::fflush(stdout) != 0) throw boxcar::Error("cannot write to stdout: {}", std::strerror(errno));
    return exitCode;
} catch (const boxcar::UsageError& error) {
    fmt::print(stderr, "bxc: {} (bxc --help)\n", error.what());
    return 2;
} catch (const std::exception& error) {
    fmt::print(stderr, "bxc: {}\n", error.what());
    return 1;
}
