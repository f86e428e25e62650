#include "tools/bxc/options.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <functional>
#include <optional>

namespace boxcar {
namespace {

namespace fs = std::filesystem;

// A flag: with a value if `apply` wants one. `name` is as typed, with its dashes.
struct Flag {
    std::string_view name;
    bool takesValue = false;
    std::function<void(const std::string&)> apply;
    bool joined = false;  // the value may follow without a space: -DNAME
};

// "-T" is also "/T".
bool Names(const Flag& flag, std::string_view word) {
    return word == flag.name ||
           (word.starts_with('/') && !flag.name.starts_with("--") && word.substr(1) == flag.name.substr(1));
}

std::optional<std::string> JoinedValue(const Flag& flag, std::string_view word) {
    const bool slash = word.starts_with('/') && word.find('/', 1) >= word.find('=');
    if (flag.joined && word.size() > flag.name.size() && (word[0] == '-' || slash) &&
        word.substr(1).starts_with(flag.name.substr(1)))
        return std::string(word.substr(flag.name.size()));
    if (const size_t equals = word.find('='); flag.takesValue && flag.name.starts_with("--") &&
                                              equals != std::string_view::npos && word.substr(0, equals) == flag.name)
        return std::string(word.substr(equals + 1));
    return std::nullopt;
}

// Applies the flags among `words` and returns the others.
std::vector<std::string> ParseFlags(std::span<const std::string> words, std::span<const Flag> flags) {
    std::vector<std::string> others;
    for (size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i];
        if (const auto flag = std::ranges::find_if(flags, [&](const Flag& f) { return Names(f, word); });
            flag != flags.end()) {
            if (flag->takesValue && i + 1 == words.size()) throw UsageError("'{}' needs a value", word);
            flag->apply(flag->takesValue ? words[++i] : std::string());
            continue;
        }
        bool applied = false;
        for (const Flag& flag : flags)
            if (const auto value = JoinedValue(flag, word); value && !applied) {
                flag.apply(*value);
                applied = true;
            }
        if (applied) continue;

        const bool path = word.starts_with('/') && (word.find('/', 1) != std::string::npos || fs::exists(word));
        if (word.size() > 1 && (word[0] == '-' || (word[0] == '/' && !path))) {
            std::string accepted;
            for (const Flag& flag : flags)
                accepted += (accepted.empty() ? "" : " ") + std::string(flag.name);
            throw UsageError("unknown flag '{}'; accepted: {}", word, accepted);
        }
        others.push_back(word);
    }
    return others;
}

int ParseNumber(std::string_view flag, const std::string& text, int min, int max) {
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || number < min || number > max)
        throw UsageError("'{} {}': expected a whole number from {} to {}", flag, text, min, max);
    return number;
}

bool IsIdentifier(std::string_view text) {
    const auto isLetter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    return !text.empty() && !isDigit(text[0]) &&
           std::ranges::all_of(text, [&](char c) { return isLetter(c) || isDigit(c); });
}

ShaderStage ParseProfile(const std::string& profile) {
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    const std::string_view stage = std::string_view(profile).substr(0, 2);
    const std::string_view version = std::string_view(profile).substr(std::min<size_t>(2, profile.size()));
    if (version.empty() || (version.size() == 4 && version[0] == '_' && isDigit(version[1]) && version[2] == '_' &&
                            isDigit(version[3]))) {
        if (stage == "vs") return ShaderStage::Vertex;
        if (stage == "ps") return ShaderStage::Pixel;
        if (stage == "cs") return ShaderStage::Compute;
    }
    throw UsageError("'-T {}': expected vs, ps or cs, with or without a version, as in ps_5_0", profile);
}

Define ParseDefine(const std::string& text) {
    const size_t equals = text.find('=');
    Define define{text.substr(0, equals), equals == std::string::npos ? "1" : text.substr(equals + 1)};
    if (!IsIdentifier(define.name)) throw UsageError("'-D {}': expected NAME or NAME=VALUE", text);
    return define;
}

int ParseHlslVersion(const std::string& text) {
    for (const int version : {2016, 2017, 2018, 2021})
        if (text == std::to_string(version)) return version;
    throw UsageError("'-HV {}': expected 2016, 2017, 2018 or 2021", text);
}

std::vector<Flag> CompileFlags(CompileOptions& options, bool& hasProfile) {
    return {
        {"-T", true, [&](const std::string& value) { options.stage = ParseProfile(value), hasProfile = true; }},
        {"-E", true,
         [&](const std::string& value) {
             if (!IsIdentifier(value)) throw UsageError("'-E {}': expected the name of a function", value);
             options.entry = value;
         }},
        {"-D", true, [&](const std::string& value) { options.defines.push_back(ParseDefine(value)); }, true},
        {"-I", true, [&](const std::string& value) { options.includeDirs.push_back(value); }, true},
        {"-O0", false, [&](const std::string&) { options.optimization = 0; }},
        {"-O1", false, [&](const std::string&) { options.optimization = 1; }},
        {"-O2", false, [&](const std::string&) { options.optimization = 2; }},
        {"-O3", false, [&](const std::string&) { options.optimization = 3; }},
        {"-Zi", false, [&](const std::string&) { options.debugInfo = true; }},
        {"-WX", false, [&](const std::string&) { options.warningsAreErrors = true; }},
        {"-Gec", false, [&](const std::string&) { options.dx9Compatible = true; }},
        {"-HV", true, [&](const std::string& value) { options.hlslVersion = ParseHlslVersion(value); }},
        {"--after", true, [&](const std::string& value) { options.after = value; }},
        {"-o", true, [&](const std::string& value) { options.output = value; }},
    };
}

std::vector<Flag> LimitFlags(Options& options) {
    return {
        {"--timeout", true,
         [&](const std::string& value) { options.timeoutSeconds = ParseNumber("--timeout", value, 1, 86400); }},
        {"--max-memory", true,
         [&](const std::string& value) { options.maxMemoryMib = ParseNumber("--max-memory", value, 64, 1 << 20); }},
    };
}

void CheckCompileOptions(CompileOptions& options, bool hasProfile, const std::vector<std::string>& others) {
    if (others.empty()) throw UsageError("no shader file is given");
    if (others.size() > 1) throw UsageError("'{}': expected one shader file; there is '{}'", others[1], others[0]);
    if (!hasProfile) throw UsageError("'{}' has no profile: expected -T vs_5_0, ps_5_0 or cs_5_0", others[0]);
    if (!options.after.empty() && options.stage != ShaderStage::Pixel)
        throw UsageError("'--after {}': only a pixel shader (-T ps) comes after a vertex shader", options.after);
    options.file = others[0];
}

constexpr const char* kHelp = R"(bxc: compiles HLSL to SPIR-V that is proven valid for Vulkan 1.1.

  bxc compile FILE -T PROFILE -o OUT.spv [flags]     one shader
  bxc build MANIFEST -o DIR [-j N]                   every shader that a file lists
  bxc compile --help, bxc build --help               their flags, with an example
  bxc --version

Exit code: 0 all is well; 1 the work failed; 2 the command line is wrong.
)";

constexpr const char* kCompileFlagsHelp = R"(  -T PROFILE      vs_5_0, ps_5_0, cs_5_0 or short vs, ps, cs
  -E NAME         entry point; main unless given
  -D NAME[=VALUE] macro; VALUE is 1 unless given
  -I DIR          where #include looks, after the including file's folder
  -O0 .. -O3      0 only makes the SPIR-V legal, 1 makes it small, 2 and 3 fast; -O3 unless given
  -Zi             source text and lines in the SPIR-V
  -WX             warnings are errors
  -Gec            Direct3D 9 samplers: sampler, tex2D
  -HV YEAR        2016, 2017, 2018, 2021: accepted for lines shared with dxc; no effect
  --after FILE    the vertex shader, entry main, that feeds this pixel shader: their interfaces must match
)";

constexpr const char* kLimitFlagsHelp = R"(  --timeout SECONDS   a compile that takes longer is ended; 60 unless given
  --max-memory MIB    a compile that needs more is ended; 1024 unless given
)";

std::string CompileHelp() {
    return fmt::format(
        "bxc compile FILE -T PROFILE -o OUT.spv [flags]: writes OUT.spv, OUT.layout.json (what a program binds to "
        "it)\n"
        "and OUT.d (its dependencies, for make). Flags may start with / as well: /T ps_5_0.\n\n"
        "{}  -o OUT.spv      where to write\n{}\n"
        "Example:\n"
        "  bxc compile hlsl/shaders/sat_pass.ps.hlsl -T ps_5_0 -D TAPS=4 -I hlsl -o sat_pass.spv\n",
        kCompileFlagsHelp, kLimitFlagsHelp);
}

std::string BuildHelp() {
    return fmt::format(
        "bxc build MANIFEST -o DIR [flags]: compiles the shaders that MANIFEST lists, if they are out of date.\n\n"
        "  -o DIR              where to write\n"
        "  -j N                worker processes; one a core unless given\n"
        "  --embed NAME        also writes DIR/NAME.h and DIR/NAME.cpp, which put the shaders into a C++ program\n"
        "  --depfile FILE      also writes the dependencies of it all, for ninja or make\n"
        "{}\n"
        "A manifest has one shader a line: its file, relative to the manifest, then these flags. # starts a "
        "comment.\n"
        "-D NAME={{A,B}} compiles the shader once for each value; several of them multiply.\n"
        "#include looks in the manifest's own folder last.\n\n"
        "{}  -o NAME.spv     name of the output in DIR; the file's name, entry and values unless given\n\n"
        "Example:\n"
        "  $ cat hlsl/shaders.cfg\n"
        "  shaders/sat_pass.ps.hlsl -T ps_5_0 -D TAPS={{2,4,8,16}}\n"
        "  $ bxc build hlsl/shaders.cfg -o build/shaders\n"
        "  writes build/shaders/shaders/sat_pass.ps.TAPS=2.spv, .layout.json, .d and so on\n",
        kLimitFlagsHelp, kCompileFlagsHelp);
}

void ParseCompile(std::span<const std::string> words, Options& options) {
    options.command = Command::Compile;
    bool hasProfile = false;
    std::vector<Flag> flags = CompileFlags(options.compile, hasProfile);
    std::ranges::move(LimitFlags(options), std::back_inserter(flags));
    CheckCompileOptions(options.compile, hasProfile, ParseFlags(words, flags));

    const std::string& output = options.compile.output;
    if (output.empty()) throw UsageError("no output is given: expected -o OUT.spv");
    if ((!output.ends_with(".spv") && !output.starts_with("/dev/")) || output == options.compile.file)
        throw UsageError("'-o {}': expected a name that ends in .spv and is not the shader's", output);
}

void ParseBuild(std::span<const std::string> words, Options& options) {
    options.command = Command::Build;
    std::vector<Flag> flags = {
        {"-o", true, [&](const std::string& value) { options.outputDir = value; }},
        {"-j", true, [&](const std::string& value) { options.jobs = ParseNumber("-j", value, 1, 256); }, true},
        {"--embed", true,
         [&](const std::string& value) {
             if (!IsIdentifier(value)) throw UsageError("'--embed {}': expected a C++ identifier", value);
             options.embed = value;
         }},
        {"--depfile", true, [&](const std::string& value) { options.depfile = value; }},
    };
    std::ranges::move(LimitFlags(options), std::back_inserter(flags));
    const std::vector<std::string> others = ParseFlags(words, flags);
    if (others.size() != 1) throw UsageError("expected one manifest; {} are given", others.size());
    if (options.outputDir.empty()) throw UsageError("no output folder is given: expected -o DIR");
    options.manifest = others[0];
}

constexpr const char* kCommands = "accepted: compile, build, --help, --version";

}  // namespace

CompileOptions ParseCompileOptions(std::span<const std::string> words) {
    CompileOptions options;
    bool hasProfile = false;
    const std::vector<std::string> others = ParseFlags(words, CompileFlags(options, hasProfile));
    CheckCompileOptions(options, hasProfile, others);
    return options;
}

std::string ToText(const CompileOptions& options) {
    constexpr const char* kProfiles[] = {"vs", "ps", "cs"};
    std::string text = fmt::format("-T {} -E {}", kProfiles[static_cast<int>(options.stage)], options.entry);
    for (const Define& define : options.defines)
        text += fmt::format(" -D {}={}", define.name, define.value);
    for (const std::string& dir : options.includeDirs)
        text += fmt::format(" -I {}", dir);
    text += fmt::format(" -O{}", options.optimization);
    if (options.debugInfo) text += " -Zi";
    if (options.warningsAreErrors) text += " -WX";
    if (options.dx9Compatible) text += " -Gec";
    if (!options.after.empty()) text += fmt::format(" --after {}", options.after);
    return text;
}

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
