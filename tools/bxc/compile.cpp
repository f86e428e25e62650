#include "tools/bxc/compile.h"

#include <optional>
#include <utility>

#include "tools/bxc/blame.h"
#include "tools/bxc/contraction.h"
#include "tools/bxc/optimize.h"
#include "tools/bxc/reflect.h"
#include "tools/bxc/repair.h"
#include "tools/bxc/rules.h"
#include "tools/bxc/source.h"
#include "tools/bxc/validate.h"

namespace boxcar {
namespace {

// A shader on its way through the stages.
struct Compilation {
    Compiler& compiler;
    const CompileOptions& options;
    Source source;
    std::optional<RuleSubject> shader, partner;  // partner: the shader that --after names, if there is one
    CompileResult result;
};

// The compiler's SPIR-V, with what is known to be wrong in it put right.
CompiledShader CompileAndRepair(Compiler& compiler, const CompileOptions& options, Source& source,
                                Diagnostics& diagnostics) {
    CompiledShader compiled = compiler.Compile(options, source, diagnostics);
    compiled.spirv = Repair(compiled.spirv, options.stage);
    if (options.strictMath) compiled.spirv = ForbidContraction(compiled.spirv);
    return compiled;
}

// The same shader's module at the same step, but with source lines in it; empty if it does not get that far.
std::vector<uint32_t> WithLines(Compilation& compilation, CompileOptions options, ValidationStep step) {
    options.debugInfo = true;
    Diagnostics untold;
    std::vector<uint32_t> spirv = CompileAndRepair(compilation.compiler, options, compilation.source, untold).spirv;
    if (step == ValidationStep::BeforeLegalization || spirv.empty()) return spirv;
    spirv = Optimize(spirv, options.optimization, options.file, untold);
    return StripSemantics(spirv, options.file, untold);
}

void Validate(Compilation& compilation, const CompileOptions& options, const std::vector<uint32_t>& spirv,
              ValidationStep step) {
    if (const auto fault = FindFault(spirv, step))
        compilation.result.diagnostics.push_back(
            BlameCompiler(*fault, step, options, WithLines(compilation, options, step)));
}

// From text to what the rules look at. Ends early where there are errors, or no entry point.
RuleSubject RunFrontEnd(Compilation& compilation, const CompileOptions& options) {
    Diagnostics& diagnostics = compilation.result.diagnostics;
    const CompiledShader compiled = CompileAndRepair(compilation.compiler, options, compilation.source, diagnostics);
    RuleSubject subject{options, compiled, Outline(compiled.preprocessed, options.file, compilation.source), {}, {}};
    const std::vector<uint32_t>& spirv = subject.compiled.spirv;
    if (!subject.compiled.hasEntry || HasErrors(diagnostics)) return subject;

    Validate(compilation, options, spirv, ValidationStep::BeforeLegalization);
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

void ReadShaders(Compilation& compilation) {
    const CompileOptions& options = compilation.options;
    compilation.shader = RunFrontEnd(compilation, options);
    if (!options.after.empty()) compilation.partner = RunFrontEnd(compilation, PartnerOptions(options));
    compilation.result.dependencies = compilation.source.Names();
    compilation.result.spirv = compilation.shader->compiled.spirv;
}

void ApplyRules(Compilation& compilation) {
    const RuleSubject* partner = compilation.partner ? &*compilation.partner : nullptr;
    CheckRules(*compilation.shader, partner, compilation.result.diagnostics);
    if (partner) CheckRules(*partner, nullptr, compilation.result.diagnostics);
}

void OptimizeModule(Compilation& compilation) {
    const CompileOptions& options = compilation.options;
    CompileResult& result = compilation.result;
    result.spirv = Optimize(result.spirv, options.optimization, options.file, result.diagnostics);
}

void ReflectModule(Compilation& compilation) {
    CompileResult& result = compilation.result;
    result.layout = Reflect(result.spirv, ReflectScope::All, compilation.options, result.diagnostics);
}

void StripModule(Compilation& compilation) {
    CompileResult& result = compilation.result;
    result.spirv = StripSemantics(result.spirv, compilation.options.file, result.diagnostics);
}

void ValidateModule(Compilation& compilation) {
    Validate(compilation, compilation.options, compilation.result.spirv, ValidationStep::Final);
}

// The pipeline.
constexpr void (*kStages[])(Compilation&) = {
    ReadShaders,     // text -> SPIR-V (prelude, compiler, repair), validated and reflected as the compiler leaves it
    ApplyRules,      // what the compiler accepts and bxc does not
    OptimizeModule,  // legal for Vulkan, and fast
    ReflectModule,   // the layout
    StripModule,     // without the semantics, which only the layout needs
    ValidateModule,  // proven
};

// Whether an error was found. With -WX a warning is one.
bool HasFailed(Compilation& compilation) {
    for (Diagnostic& diagnostic : compilation.result.diagnostics)
        if (compilation.options.warningsAreErrors && diagnostic.severity == Severity::Warning)
            diagnostic.severity = Severity::Error;
    return HasErrors(compilation.result.diagnostics);
}

}  // namespace

CompileResult CompileShader(Compiler& compiler, const std::string& root, const CompileOptions& options) {
    Compilation compilation{compiler, options, Source(root, options.includeDirs), {}, {}, {}};
    for (const auto stage : kStages) {
        stage(compilation);
        if (!HasFailed(compilation)) continue;
        compilation.result.spirv.clear();
        break;
    }
    return std::move(compilation.result);
}

}  // namespace boxcar
