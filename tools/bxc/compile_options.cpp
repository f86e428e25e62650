#include "tools/bxc/compile_options.h"

#include <algorithm>
#include <utility>

namespace boxcar {
namespace {

using Values = std::span<const std::string>;

constexpr std::pair<const char*, ShaderStage> kProfiles[] = {
    {"vs", ShaderStage::Vertex},   {"hs", ShaderStage::Hull},  {"ds", ShaderStage::Domain},
    {"gs", ShaderStage::Geometry}, {"ps", ShaderStage::Pixel}, {"cs", ShaderStage::Compute}};

const char* ProfileOf(ShaderStage stage) {
    return std::ranges::find(kProfiles, stage, &std::pair<const char*, ShaderStage>::second)->first;
}

// "_5_0", and fxc's "_4_0_level_9_3"
bool IsVersion(std::string_view text) {
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    const auto isNumber = [&](std::string_view t) {
        return t.size() == 4 && t[0] == '_' && isDigit(t[1]) && t[2] == '_' && isDigit(t[3]);
    };
    constexpr std::string_view kLevel = "_level";
    if (text.size() > 4 && text.substr(4).starts_with(kLevel))
        return isNumber(text.substr(0, 4)) && isNumber(text.substr(4 + kLevel.size()));
    return isNumber(text);
}

ShaderStage ParseProfile(std::string_view flag, const std::string& profile) {
    const std::string_view stage = std::string_view(profile).substr(0, 2);
    const std::string_view version = std::string_view(profile).substr(std::min<size_t>(2, profile.size()));
    if (version.empty() || IsVersion(version))
        for (const auto& [name, value] : kProfiles)
            if (stage == name) return value;
    for (const char* const other : {"lib", "as", "ms"})
        if (profile == other || profile.starts_with(fmt::format("{}_", other)))
            throw UsageError(
                "'{} {}': ray tracing, mesh and amplification shaders are not compiled; expected vs, hs, "
                "ds, gs, ps or cs",
                flag, profile);
    throw UsageError("'{} {}': expected vs, hs, ds, gs, ps or cs, with or without a version, as in ps_5_0", flag,
                     profile);
}

std::string ParseEntry(std::string_view flag, const std::string& text) {
    if (!IsIdentifier(text)) throw UsageError("'{} {}': expected the name of a function", flag, text);
    return text;
}

// A later value of a name replaces the one before.
void AddDefine(std::vector<Define>& defines, const std::string& text) {
    const size_t equals = text.find('=');
    const Define define{text.substr(0, equals), equals == std::string::npos ? "1" : text.substr(equals + 1)};
    if (!IsIdentifier(define.name)) throw UsageError("'-D {}': expected NAME or NAME=VALUE", text);
    std::erase_if(defines, [&](const Define& other) { return other.name == define.name; });
    defines.push_back(define);
}

int ParseHlslVersion(const std::string& text) {
    for (const int version : {2016, 2017, 2018, 2021})
        if (text == std::to_string(version)) return version;
    throw UsageError("'-HV {}': expected 2016, 2017, 2018 or 2021", text);
}

RegisterShift ParseShift(char registerClass, Values values) {
    const std::string flag = fmt::format("-fvk-{}-shift", registerClass);
    constexpr int kMax = 65535;
    RegisterShift shift{registerClass, ParseNumber(flag, values[0], 0, kMax)};
    if (values[1] == "all") return shift;
    try {
        shift.set = ParseNumber(flag, values[1], 0, kMax);
    } catch (const UsageError&) {
        throw UsageError("'{} {} {}': expected a space from 0 to {}, or all", flag, values[0], values[1], kMax);
    }
    return shift;
}

// The SPIR-V is 1.3 for Vulkan 1.1, which later versions take.
void CheckTarget(const std::string& target) {
    constexpr const char* kOlder[] = {"vulkan1.0", "universal1.0", "universal1.1", "universal1.2"};
    const bool isTarget = target.starts_with("vulkan1.") || target.starts_with("universal1.");
    if (!isTarget || std::ranges::find(kOlder, target) != std::end(kOlder))
        throw UsageError(
            "'-fspv-target-env={}': the SPIR-V is version 1.3, for Vulkan 1.1 and later: expected "
            "vulkan1.1 or later",
            target);
}

std::string ParseVariable(const std::string& text) {
    if (!IsIdentifier(text)) throw UsageError("'-Vn {}': expected the name of a variable in C", text);
    return text;
}

// What cannot change the SPIR-V: containers and their sections, hints, files that bxc does not need.
constexpr const char* kIgnored[] = {"-nologo",
                                    "-spirv",
                                    "-Ges",
                                    "-Gfa",
                                    "-Gfp",
                                    "-Gdp",
                                    "-Qstrip_reflect",
                                    "-Qstrip_debug",
                                    "-Qstrip_priv",
                                    "-Qstrip_rootsignature",
                                    "-Qembed_debug",
                                    "-Qkeep_reflect_in_dxil",
                                    "-Zss",
                                    "-Zsb",
                                    "-Zs",
                                    "-Vd",
                                    "-Vi",
                                    "-Cc",
                                    "-Ni",
                                    "-No",
                                    "-Lx",
                                    "-no-warnings",
                                    "-all_resources_bound",
                                    "-all-resources-bound",
                                    "-res_may_alias",
                                    "-res-may-alias",
                                    "-enable_unbounded_descriptor_tables",
                                    "-flegacy-macro-expansion",
                                    "-flegacy-resource-reservation",
                                    "-fspv-reflect",
                                    "-fvk-use-dx-layout",
                                    "-ffinite-math-only",
                                    "-fno-finite-math-only"};
constexpr const char* kIgnoredWithValue[] = {"-Fd", "-fspv-extension", "-fdiagnostics-format"};

struct Refusal {
    const char* flag;
    size_t valueCount;
    const char* reason;
};
constexpr Refusal kRefused[] = {
    {"-Fc", 1, "bxc does not write listings; spirv-dis makes one from the .spv"},
    {"-Fx", 1, "bxc does not write listings; spirv-dis makes one from the .spv"},
    {"-Fe", 1, "messages go to stderr; redirect them"},
    {"-Fre", 1, "reflection goes to the .layout.json beside the .spv"},
    {"-Frs", 1, "Vulkan has no root signatures"},
    {"-P", 1, "bxc does not write preprocessed text"},
    {"-fvk-use-gl-layout", 0, "constants are laid out as in Direct3D"},
    {"-fvk-use-scalar-layout", 0, "constants are laid out as in Direct3D"},
    {"-fspv-preserve-bindings", 0, "what a shader does not use is not in its layout"},
    {"-fspv-preserve-interface", 0, "what a shader does not use is not in its layout"},
    {"-fvk-bind-globals", 2, "constants outside a cbuffer are refused"},
    {"-fvk-bind-register", 4, "bindings come from the registers, or move with -fvk-t-shift and the like"},
    {"-auto-binding-space", 1, "give every resource its register and space"}};

void AppendForeignFlags(std::vector<Flag>& flags) {
    const auto ignore = [](Values) {};
    for (const char* name : kIgnored)
        flags.push_back({name, 0, ignore, false, false});
    for (const char* name : kIgnoredWithValue)
        flags.push_back({name, 1, ignore, true, false});
    flags.push_back({"-W", 1, ignore, true, false});  // -Wno-conversion, /W3
    for (const Refusal& refusal : kRefused)
        flags.push_back({refusal.flag, refusal.valueCount,
                         [&refusal](Values) { throw UsageError("'{}': {}", refusal.flag, refusal.reason); },
                         refusal.valueCount == 1, false});
}

}  // namespace

const char* const kCompileFlagsHelp = R"(
  -T PROFILE      vs_5_0, hs_5_0, ds_5_0, gs_5_0, ps_5_0, cs_5_0; or just vs, hs, ds, gs, ps, cs
  -E NAME         entry point; main by default
  -D NAME[=VALUE] macro; VALUE is 1 by default
  -I DIR          where #include looks, after the folder of the file that includes
  -O0 .. -O3      0 (also -Od) only makes the SPIR-V legal, 1 makes it small, 2 and 3 fast; -O3 by default
  -Zi             puts the source text and its lines into the SPIR-V
  -WX             warnings are errors
  -Gec            allows the samplers of Direct3D 9: sampler, tex2D
  -Gis            arithmetic as written: no product and sum become one operation
  -HV YEAR        2016, 2017, 2018 or 2021, which has select, and, or; 2018 by default
  -Zpr, -Zpc      matrices are stored row by row, or column by column, which is the default
  -enable-16bit-types     half and min16float have 16 bits; the device must have shaderFloat16
  -fvk-t-shift N SPACE    register(tM, spaceSPACE) becomes binding N + M; SPACE may be all; b, s and u likewise.
                          With any of these, registers that none of them names are not shifted; with none of them,
                          bN is N, sN is 16 + N, uN is 32 + N, tN is 96 + N
  -fvk-invert-y           negates the position's y
  -fvk-use-dx-position-w  w of SV_Position in a pixel shader is w, not 1 / w
  -fspv-target-env=ENV    vulkan1.1 or later: the SPIR-V is the same
  --after FILE    the shader that feeds this one: their interfaces must match
  --after-T PROFILE, --after-E NAME   its stage, vs by default (hs if this is a domain shader), and its entry point
)";

std::vector<Flag> CompileFlags(CompileOptions& options, bool& hasProfile) {
    const auto set = [](bool& flag, bool value = true) { return [&flag, value](Values) { flag = value; }; };
    const auto text = [](std::string& to) { return [&to](Values v) { to = v[0]; }; };
    std::vector<Flag> flags = {
        {"-T", 1, [&](Values v) { options.stage = ParseProfile("-T", v[0]), hasProfile = true; }, true},
        {"-E", 1, [&](Values v) { options.entry = ParseEntry("-E", v[0]); }, true},
        {"-D", 1, [&](Values v) { AddDefine(options.defines, v[0]); }, true},
        {"-I", 1, [&](Values v) { options.includeDirs.push_back(v[0]); }, true},
        {"-Od", 0, [&](Values) { options.optimization = 0; }},
        {"-O", 1, [&](Values v) { options.optimization = ParseNumber("-O", v[0], 0, 3); }, true},
        {"-Zi", 0, set(options.debugInfo)},
        {"-fspv-debug", 1, set(options.debugInfo), false, false},
        {"-WX", 0, set(options.warningsAreErrors)},
        {"-Gec", 0, set(options.dx9Compatible)},
        {"-Gis", 0, set(options.strictMath)},
        {"-HV", 1, [&](Values v) { options.hlslVersion = ParseHlslVersion(v[0]); }, true},
        {"-Zpr", 0, set(options.rowMajor)},
        {"-Zpc", 0, set(options.rowMajor, false)},
        {"-enable-16bit-types", 0, set(options.native16Bit)},
        {"-fvk-b-shift", 2, [&](Values v) { options.shifts.push_back(ParseShift('b', v)); }},
        {"-fvk-s-shift", 2, [&](Values v) { options.shifts.push_back(ParseShift('s', v)); }},
        {"-fvk-t-shift", 2, [&](Values v) { options.shifts.push_back(ParseShift('t', v)); }},
        {"-fvk-u-shift", 2, [&](Values v) { options.shifts.push_back(ParseShift('u', v)); }},
        {"-fvk-invert-y", 0, set(options.invertY)},
        {"-fvk-use-dx-position-w", 0, set(options.dxPositionW)},
        {"-fspv-target-env", 1, [](Values v) { CheckTarget(v[0]); }},
        {"--after", 1, text(options.after)},
        {"--after-T", 1, [&](Values v) { options.afterStage = ParseProfile("--after-T", v[0]); }},
        {"--after-E", 1, [&](Values v) { options.afterEntry = ParseEntry("--after-E", v[0]); }},
        {"-o", 1, text(options.output)},
        {"-Fo", 1, text(options.binary), true},
        {"--outputSuffix", 1, text(options.outputSuffix)},
        {"-Fh", 1, text(options.header), true},
        {"-Vn", 1, [&](Values v) { options.variable = ParseVariable(v[0]); }, true},
    };
    AppendForeignFlags(flags);
    return flags;
}

void CheckCompileOptions(CompileOptions& options, bool hasProfile, std::span<const std::string> others) {
    if (others.empty()) throw UsageError("no shader file is given");
    if (others.size() > 1) throw UsageError("'{}': expected one shader file; there is '{}'", others[1], others[0]);
    if (!hasProfile) throw UsageError("'{}' has no profile: expected -T vs_5_0, ps_5_0 or cs_5_0", others[0]);
    options.file = others[0];
    if (options.after.empty()) return;

    if (options.stage == ShaderStage::Domain) options.afterStage = ShaderStage::Hull;
    constexpr std::pair<ShaderStage, ShaderStage> kLinks[] = {
        {ShaderStage::Vertex, ShaderStage::Pixel},    {ShaderStage::Vertex, ShaderStage::Geometry},
        {ShaderStage::Vertex, ShaderStage::Hull},     {ShaderStage::Hull, ShaderStage::Domain},
        {ShaderStage::Domain, ShaderStage::Geometry}, {ShaderStage::Domain, ShaderStage::Pixel},
        {ShaderStage::Geometry, ShaderStage::Pixel}};
    if (std::ranges::find(kLinks, std::pair(options.afterStage, options.stage)) == std::end(kLinks))
        throw UsageError(
            "'--after {}': no {} shader comes after a {} shader; expected vs before hs, gs, ps; hs before "
            "ds; ds before gs, ps; gs before ps",
            options.after, ProfileOf(options.stage), ProfileOf(options.afterStage));
}

CompileOptions ParseCompileOptions(std::span<const std::string> words, const CompileOptions& defaults) {
    CompileOptions options = defaults;
    bool hasProfile = false;
    const std::vector<std::string> others = ParseFlags(words, CompileFlags(options, hasProfile));
    CheckCompileOptions(options, hasProfile, others);
    return options;
}

std::string ToText(const CompileOptions& options) {
    std::string text = fmt::format("-T {} -E {}", ProfileOf(options.stage), options.entry);
    for (const Define& define : options.defines)
        text += fmt::format(" -D {}={}", define.name, define.value);
    for (const std::string& dir : options.includeDirs)
        text += fmt::format(" -I {}", dir);
    text += fmt::format(" -O{}", options.optimization);
    if (options.hlslVersion >= 2021) text += fmt::format(" -HV {}", options.hlslVersion);
    if (options.debugInfo) text += " -Zi";
    if (options.warningsAreErrors) text += " -WX";
    if (options.dx9Compatible) text += " -Gec";
    if (options.strictMath) text += " -Gis";
    if (options.rowMajor) text += " -Zpr";
    if (options.native16Bit) text += " -enable-16bit-types";
    if (options.invertY) text += " -fvk-invert-y";
    if (options.dxPositionW) text += " -fvk-use-dx-position-w";
    for (const RegisterShift& each : options.shifts)
        text += fmt::format(" -fvk-{}-shift {} {}", each.registerClass, each.shift,
                            each.set == RegisterShift::kAllSets ? "all" : std::to_string(each.set));
    if (!options.after.empty())
        text += fmt::format(" --after {} --after-T {} --after-E {}", options.after, ProfileOf(options.afterStage),
                            options.afterEntry);
    if (!options.header.empty()) text += fmt::format(" -Fh {} -Vn {}", options.header, options.variable);
    return text;
}

}  // namespace boxcar
