#include "tools/bxc/blame.h"

#include <algorithm>
#include <map>
#include <set>
#include <spirv.hpp>
#include <string_view>

#include "tools/bxc/spirv_module.h"

namespace boxcar {
namespace {

enum class Blame { Compiler, Shader };

// A part of the validator's message, and what in the HLSL avoids it; {} is the variable that it is about.
struct Remedy {
    std::string_view sign;
    std::string_view advice;
    Blame blame = Blame::Compiler;
};
constexpr Remedy kRemedies[] = {
    {"Ldexp", "write x * exp2(e) instead of ldexp(x, e)"},
    {"vector bool: Any", "compare with 0 instead of calling any() on a scalar"},
    {"vector bool: All", "compare with 0 instead of calling all() on a scalar"},
    {"Matrix types can only be parameterized", "use a float matrix, or an array of vectors"},
    {"Expected Sampled Image", "compile with -Gec for sampler and tex2D, or use Texture2D and SamplerState"},
    {"VUID-Position-Position", "make SV_Position a float4"},
    {"conflicting input location", "make system values out parameters, not inout"},
    {"conflicting output location", "give each output its own semantic"},
    {"OpTypeImage", "make texture variables in functions, not global or static"},
    {"OpTypeSampler", "make sampler variables in functions, not global or static"},
    {"If OpTypeBool is stored", "declare {} as uint"},
    {"needs to be a bool scalar", "declare {} as bool", Blame::Shader},
    {"needs to be a 32-bit float scalar", "declare {} as float", Blame::Shader},
    {"needs to be a 32-bit int scalar", "declare {} as uint", Blame::Shader},
    {"needs to be a 32-bit int array", "declare {} as uint", Blame::Shader},
    {"needs to be a 3-component 32-bit int vector", "declare {} as uint3", Blame::Shader},
    {"Derivative instructions require", "ddx, ddy, fwidth and Sample are for pixel shaders", Blame::Shader},
    {"OpKill requires", "discard and clip are for pixel shaders", Blame::Shader},
    {"Workgroup Storage Class", "groupshared is for compute shaders", Blame::Shader},
    {"OpControlBarrier execution scope", "group barriers are for compute shaders", Blame::Shader},
};

Remedy RemedyFor(std::string_view fault) {
    const auto found = std::ranges::find_if(
        kRemedies, [&](const Remedy& remedy) { return fault.find(remedy.sign) != std::string_view::npos; });
    return found != std::end(kRemedies) ? *found : Remedy{"", "write that part of the shader another way"};
}

// A function, variable and line of the HLSL; "" and a place without a file are unknown.
struct Origin {
    std::string function, variable;
    SourcePlace place;
};

// "@main(vf2;" -> "main"
std::string PlainName(std::string name) {
    name = name.substr(0, name.find('('));
    return name.starts_with('@') ? name.substr(1) : name;
}

// True if an instruction of a function has to do with one of the ids: by its type, or the variable that it touches.
bool Uses(const SpirvInstruction& instruction, const std::set<uint32_t>& ids) {
    const std::vector<uint32_t>& operands = instruction.operands;
    const bool touchesThird = instruction.opcode == spv::OpLoad || instruction.opcode == spv::OpAccessChain;
    return (!operands.empty() && ids.contains(operands[0])) ||
           (touchesThird && operands.size() > 2 && ids.contains(operands[2]));
}

// The first instruction of a function that has to do with what a declaration declares, or with what is made of that;
// of an entry point, its function. The declaration itself if there is none.
size_t FirstUse(const SpirvModule& module, size_t declaration) {
    const SpirvInstruction& declared = module.instructions[declaration - 1];
    if (declared.opcode == spv::OpEntryPoint) {
        const auto isEntry = [&](const SpirvInstruction& each) {
            return each.opcode == spv::OpFunction && each.operands.at(1) == declared.operands.at(1);
        };
        const auto entry = std::ranges::find_if(module.instructions, isEntry);
        return static_cast<size_t>(entry - module.instructions.begin()) + 1;
    }
    std::set<uint32_t> ids;
    bool inFunction = false;
    for (size_t i = declaration - 1; i < module.instructions.size(); ++i) {
        const SpirvInstruction& each = module.instructions[i];
        const std::vector<uint32_t>& operands = each.operands;
        if (each.opcode == spv::OpFunction && ids.empty()) return declaration;
        inFunction = inFunction || each.opcode == spv::OpFunction;
        if (inFunction && Uses(each, ids)) return i + 1;
        const bool isType = each.opcode >= spv::OpTypeVoid && each.opcode <= spv::OpTypeFunction && !operands.empty();
        const bool isVariable = !inFunction && each.opcode == spv::OpVariable;
        const auto isKnown = [&](uint32_t word) { return ids.contains(word); };
        if (isType && (i + 1 == declaration || std::any_of(operands.begin() + 1, operands.end(), isKnown)))
            ids.insert(operands[0]);
        if (isVariable && (i + 1 == declaration || isKnown(operands.at(0)))) ids.insert(operands.at(1));
    }
    return declaration;
}

// The name of the variable that an instruction declares, or "".
std::string VariableOf(const SpirvModule& module, size_t instruction) {
    if (instruction == 0 || instruction > module.instructions.size()) return "";
    const SpirvInstruction& declared = module.instructions[instruction - 1];
    if (declared.opcode != spv::OpVariable) return "";
    const auto isItsName = [&](const SpirvInstruction& each) {
        return each.opcode == spv::OpName && each.operands.at(0) == declared.operands.at(1);
    };
    const auto name = std::ranges::find_if(module.instructions, isItsName);
    return name == module.instructions.end() ? "" : name->Text(1);
}

Origin OriginOf(const SpirvModule& module, size_t instruction) {
    std::map<uint32_t, std::string> strings, names;
    Origin origin;
    const std::string variable = VariableOf(module, instruction);
    size_t number = 0;
    for (const SpirvInstruction& each : module.instructions) {
        const std::vector<uint32_t>& operands = each.operands;
        switch (each.opcode) {
            case spv::OpString: strings[operands.at(0)] = each.Text(1); break;
            case spv::OpName: names[operands.at(0)] = PlainName(each.Text(1)); break;
            case spv::OpFunction: origin.function = names[operands.at(1)]; break;
            case spv::OpFunctionEnd: origin = {}; break;
            case spv::OpNoLine: origin.place = {}; break;
            case spv::OpLine: origin.place = {strings[operands.at(0)], static_cast<int>(operands.at(1)), 0}; break;
            default: break;
        }
        if (++number == instruction && origin.function.empty())
            instruction = FirstUse(module, instruction);
        else if (number == instruction)
            return {origin.function, variable, origin.place};
    }
    return {"", variable, {}};
}

}  // namespace

Diagnostic BlameCompiler(const SpirvFault& fault, ValidationStep step, const CompileOptions& options,
                         const std::vector<uint32_t>& withLines) {
    Origin origin;
    if (!withLines.empty())
        if (const auto again = FindFault(withLines, step))
            origin = OriginOf(SpirvModule(withLines), again->instruction);
    if (origin.place.file.empty()) origin.place = {options.file, 0, 0};
    const std::string where = origin.function.empty() ? "" : fmt::format(" in '{}'", origin.function);
    const Remedy remedy = RemedyFor(fault.text);
    const bool isResult = origin.variable.starts_with("@entryPointOutput");
    const std::string variable = isResult                  ? "the result"
                                 : origin.variable.empty() ? "it"
                                                           : fmt::format("'{}'", origin.variable);
    const std::string advice = fmt::format(fmt::runtime(remedy.advice), variable);
    if (remedy.blame == Blame::Shader)
        return {origin.place, Severity::Error, fmt::format("invalid SPIR-V{}: {} ({})", where, advice, fault.text)};
    const char* const maker = step == ValidationStep::Final ? "from the optimizer" : "from the compiler";
    return {origin.place, Severity::Error,
            fmt::format("invalid SPIR-V {}{}, which is its fault, not the shader's: {} ({})", maker, where, advice,
                        fault.text)};
}

}  // namespace boxcar
