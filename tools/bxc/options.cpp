#include "tools/bxc/options.h"

#include <algorithm>
#include <iterator>

namespace boxcar {
namespace {

using Values = std::span<const std::string>;

std::vector<Flag> LimitFlags(Options& options) {
    return {
        {"--timeout", 1, [&](Values v) { options.timeoutSeconds = ParseNumber("--timeout", v[0], 1, 86400); }},
        {"--max-memory", 1, [&](Values v) { options.maxMemoryMib = ParseNumber("--max-memory", v[0], 64, 1 << 20); }},
    };
}

constexpr const char* kHelp = R"(bxc: compiles HLSL to SPIR-V that is proven valid for Vulkan 1.1.

  bxc compile FILE -T PROFILE -o OUT.spv [flags]     one shader
  bxc build MANIFEST -o DIR [-j N]                   every shader that a file lists
  bxc compile --help, bxc build --help               their flags, with an example
  bxc --version

Exit code: 0 all is well; 1 the work failed; 2 the command line is wrong.
)";

constexpr const char* kLimitFlagsHelp = R"(  --timeout SECONDS   a compile that takes longer is ended; 60 unless given
  --max-memory MIB    a compile that needs more is ended; 1024 unless given
)";

std::string CompileHelp() {
    return fmt::format(
        R"(bxc compile FILE -T PROFILE -o OUT.spv [flags]: writes OUT.spv, OUT.layout.json (what a program binds to it)
and OUT.d (its dependencies, for make). Flags may start with / as well, and take their value without a space: /Tps_5_0.

{}  -o OUT.spv      where to write; -Fo OUT is the same with any ending
  -Fh OUT.h       also writes the SPIR-V as an array in a C header; alone, there is no OUT.spv
  -Vn NAME        name of that array; g_ and the entry point unless given
{}
Flags of fxc and dxc that cannot change the SPIR-V are ignored: -nologo -spirv -Ges -Qstrip_reflect -W3 and so on.

Example:
  bxc compile hlsl/shaders/sat_pass.ps.hlsl -T ps_5_0 -D TAPS=4 -I hlsl -o sat_pass.spv
)",
        kCompileFlagsHelp, kLimitFlagsHelp);
}

std::string BuildHelp() {
    return fmt::format(
        R"(bxc build MANIFEST -o DIR [flags]: compiles the shaders that MANIFEST lists, if they are out of date.

  -o DIR              where to write
  -j N                worker processes; one a core unless given
  --embed NAME        also writes DIR/NAME.h and DIR/NAME.cpp, which put the shaders into a C++ program
  --depfile FILE      also writes the dependencies of it all, for ninja or make
{}  -D -I -HV -Zpr ..   flags of a shader (below) that hold for every line, but for -T -E -o --after

A manifest has one shader a line: its file, relative to the manifest, then these flags. Lines that start with # or //
are comments; #ifdef NAME (a -D of the command line), #if 0, #if 1, #else and #endif leave lines out. ShaderMake's
manifests are read as they are.
A word with braces compiles the shader once for each value: -D NAME={{A,B}}, -E {{a,b}}, -D {{A,}} (with A and without).
Several of them multiply. #include looks in the manifest's own folder last.

{}  -o NAME.spv     name of the output in DIR; the file's name, entry and values unless given
  -o FOLDER/      folder of the output in DIR, also without the slash if several lines share it; its name is the file's
  --outputSuffix TEXT   behind that name, before the values

Example:
  $ cat hlsl/passes.cfg
  shaders/sat_pass.ps.hlsl -T ps_5_0 -D TAPS={{2,4,8,16}}
  $ bxc build hlsl/passes.cfg -o build/shaders
  writes build/shaders/shaders/sat_pass.ps.TAPS=2.spv, .layout.json, .d and so on
)",
        kLimitFlagsHelp, kCompileFlagsHelp);
}

void ParseCompile(std::span<const std::string> words, Options& options) {
    options.command = Command::Compile;
    bool hasProfile = false;
    std::vector<Flag> flags = CompileFlags(options.compile, hasProfile);
    std::ranges::move(LimitFlags(options), std::back_inserter(flags));
    CheckCompileOptions(options.compile, hasProfile, ParseFlags(words, flags));

    CompileOptions& compile = options.compile;
    if (!compile.output.empty() && ((!compile.output.ends_with(".spv") && !compile.output.starts_with("/dev/")) ||
                                    compile.output == compile.file))
        throw UsageError("'-o {}': expected a name that ends in .spv and is not the shader's", compile.output);
    if (compile.output.empty()) compile.output = compile.binary;
    if (compile.output.empty() && compile.header.empty()) throw UsageError("no output is given: expected -o OUT.spv");
    for (const std::string& name : {compile.output, compile.header})
        if (name == compile.file) throw UsageError("the output '{}' is the shader itself", name);
}

// Every flag of a shader that makes sense for all lines of a manifest.
std::vector<Flag> CommonFlags(CompileOptions& options, bool& hasProfile) {
    constexpr std::string_view kOfOneShader[] = {"-T", "-E",  "--after", "--after-T",      "--after-E",
                                                 "-o", "-Fo", "-Fh",     "--outputSuffix", "-Vn"};
    std::vector<Flag> flags = CompileFlags(options, hasProfile);
    std::erase_if(flags, [&](const Flag& flag) {
        return std::ranges::find(kOfOneShader, flag.name) != std::end(kOfOneShader);
    });
    return flags;
}

void ParseBuild(std::span<const std::string> words, Options& options) {
    options.command = Command::Build;
    std::vector<Flag> flags = {
        {"-o", 1, [&](Values v) { options.outputDir = v[0]; }},
        {"-j", 1, [&](Values v) { options.jobs = ParseNumber("-j", v[0], 1, 256); }, true},
        {"--embed", 1,
         [&](Values v) {
             if (!IsIdentifier(v[0])) throw UsageError("'--embed {}': expected a C++ identifier", v[0]);
             options.embed = v[0];
         }},
        {"--depfile", 1, [&](Values v) { options.depfile = v[0]; }},
    };
    bool hasProfile = false;
    std::ranges::move(LimitFlags(options), std::back_inserter(flags));
    std::ranges::move(CommonFlags(options.compile, hasProfile), std::back_inserter(flags));
    const std::vector<std::string> others = ParseFlags(words, flags);
    if (others.size() != 1) throw UsageError("expected one manifest; {} are given", others.size());
    if (options.outputDir.empty()) throw UsageError("no output folder is given: expected -o DIR");
    options.manifest = others[0];
}

constexpr const char* kCommands = "accepted: compile, build, --help, --version";

}  // namespace

Options ParseOptions(std::span<const std::string> words) {
    if (words.empty()) throw UsageError("no command is given; {}", kCommands);
    const std::string& command = words[0];
    Options options;
    if (std::ranges::any_of(words, [](const std::string& word) { return word == "--help" || word == "-h"; }))
        options.help = command == "compile" ? CompileHelp() : command == "build" ? BuildHelp() : kHelp;
    else if (command == "--version")
        options.command = Command::Version;
    else if (command == "worker")
        options.command = Command::Worker;
    else if (command == "compile")
        ParseCompile(words.subspan(1), options);
    else if (command == "build")
        ParseBuild(words.subspan(1), options);
    else
        throw UsageError("unknown command '{}'; {}", command, kCommands);
    return options;
}

}  // namespace boxcar
