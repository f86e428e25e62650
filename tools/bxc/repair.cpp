#include "tools/bxc/repair.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <set>
#include <spirv.hpp>
#include <utility>

#include "tools/bxc/repair_bools.h"
#include "tools/bxc/spirv_module.h"

namespace boxcar {
namespace {

// Operands of an atomic instruction: its type, result and pointer, and where the values start that it takes.
enum AtomicOperand : size_t { kType = 0, kResult = 1, kPointer = 2 };

size_t FirstValueOf(const SpirvInstruction& instruction) {
    switch (instruction.opcode) {
        case spv::OpAtomicExchange:
        case spv::OpAtomicIAdd:
        case spv::OpAtomicISub:
        case spv::OpAtomicSMin:
        case spv::OpAtomicUMin:
        case spv::OpAtomicSMax:
        case spv::OpAtomicUMax:
        case spv::OpAtomicAnd:
        case spv::OpAtomicOr:
        case spv::OpAtomicXor: return 5;
        case spv::OpAtomicCompareExchange: return 6;
        default: return 0;
    }
}

uint16_t WithSign(uint16_t opcode, bool isSigned) {
    switch (opcode) {
        case spv::OpAtomicSMin:
        case spv::OpAtomicUMin: return isSigned ? spv::OpAtomicSMin : spv::OpAtomicUMin;
        case spv::OpAtomicSMax:
        case spv::OpAtomicUMax: return isSigned ? spv::OpAtomicSMax : spv::OpAtomicUMax;
        default: return opcode;
    }
}

class AtomicRepair {
public:
    explicit AtomicRepair(SpirvModule& module) : m_module(module), m_types(module) {}

    void Run() {
        for (const SpirvInstruction& instruction : m_module.instructions) {
            const size_t firstValue = FirstValueOf(instruction);
            const bool isWhole = firstValue > 0 && instruction.operands.size() > firstValue;
            const uint32_t memory =
                isWhole ? m_types.PointeeOf(m_types.TypeOf(instruction.operands[kPointer])) : uint32_t{0};
            if (m_types.IsInt(memory, false) || m_types.IsInt(memory, true))
                Append(instruction, firstValue, memory);
            else
                m_output.push_back(instruction);
        }
        const auto isFunction = [](const SpirvInstruction& each) { return each.opcode == spv::OpFunction; };
        m_output.insert(std::ranges::find_if(m_output, isFunction), m_constants.begin(), m_constants.end());
        m_module.instructions = std::move(m_output);
    }

private:
    void Append(SpirvInstruction atomic, size_t firstValue, uint32_t memory) {
        atomic.opcode = WithSign(atomic.opcode, m_types.IsInt(memory, true));
        for (size_t i = firstValue; i < atomic.operands.size(); ++i)
            atomic.operands[i] = Converted(atomic.operands[i], memory);

        const uint32_t type = atomic.operands[kType], result = atomic.operands[kResult];
        if (type == memory) {
            m_output.push_back(std::move(atomic));
            return;
        }
        atomic.operands[kType] = memory;
        atomic.operands[kResult] = m_module.NewId();
        const uint32_t before = atomic.operands[kResult];
        m_output.push_back(std::move(atomic));
        m_output.push_back(FromInt(type, result, before, memory));
    }

    // What makes `result`, of another type, of an int or uint.
    SpirvInstruction FromInt(uint32_t type, uint32_t result, uint32_t value, uint32_t from) {
        if (m_types.Is(type, spv::OpTypeBool)) return {spv::OpINotEqual, {type, result, value, Constant(from, 0)}};
        if (m_types.Is(type, spv::OpTypeFloat) && m_types.IsInt(from, true))
            return {spv::OpConvertSToF, {type, result, value}};
        if (m_types.Is(type, spv::OpTypeFloat)) return {spv::OpConvertUToF, {type, result, value}};
        return {spv::OpBitcast, {type, result, value}};
    }

    // The value as an int or uint, by HLSL's implicit conversion.
    uint32_t Converted(uint32_t value, uint32_t to) {
        const uint32_t from = m_types.TypeOf(value);
        if (from == to) return value;
        const uint32_t result = m_module.NewId();
        if (m_types.Is(from, spv::OpTypeInt))
            m_output.push_back({spv::OpBitcast, {to, result, value}});
        else if (m_types.Is(from, spv::OpTypeFloat))
            m_output.push_back(
                {static_cast<uint16_t>(m_types.IsInt(to, true) ? spv::OpConvertFToS : spv::OpConvertFToU),
                 {to, result, value}});
        else if (m_types.Is(from, spv::OpTypeBool))
            m_output.push_back({spv::OpSelect, {to, result, value, Constant(to, 1), Constant(to, 0)}});
        else
            return value;  // what it is, is for the validator to refuse
        return result;
    }

    uint32_t Constant(uint32_t type, uint32_t value) {
        const uint32_t id = m_module.NewId();
        m_constants.push_back({spv::OpConstant, {type, id, value}});
        return id;
    }

    SpirvModule& m_module;
    const SpirvTypes m_types;
    std::vector<SpirvInstruction> m_constants, m_output;
};

bool IsPositionSemantic(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::toupper(c); });
    return text == "SV_POSITION" || text == "SV_POSITION0";
}

// A variable of the stage's interface, and what it is decorated with.
struct InterfaceVariable {
    spv::StorageClass storage = spv::StorageClassMax;
    uint32_t type = 0;  // without the pointer
    bool isPosition = false, isBuiltIn = false;
};

// The built-in that SV_Position is there, if it is one.
std::optional<spv::BuiltIn> PositionOf(ShaderStage stage, spv::StorageClass storage) {
    const bool isPixel = stage == ShaderStage::Pixel;
    if (storage == spv::StorageClassOutput && !isPixel) return spv::BuiltInPosition;
    if (storage == spv::StorageClassInput && isPixel) return spv::BuiltInFragCoord;
    return std::nullopt;
}

// A float4, or the one element of an array, which UnwrapPositions takes out.
bool CanBePosition(const SpirvTypes& types, uint32_t type) {
    return types.IsFloat4(type) || (types.IsArrayOfOne(type) && types.IsFloat4(types.ElementOf(type)));
}

void RepairPositions(SpirvModule& module, ShaderStage stage) {
    const SpirvTypes types(module);
    std::map<uint32_t, InterfaceVariable> variables;
    std::map<uint32_t, uint32_t*> locations;
    for (SpirvInstruction& instruction : module.instructions) {
        std::vector<uint32_t>& operands = instruction.operands;
        if (instruction.opcode == spv::OpVariable) {
            variables[operands.at(1)].storage = static_cast<spv::StorageClass>(operands.at(2));
            variables[operands.at(1)].type = types.PointeeOf(operands.at(0));
        } else if (instruction.opcode == spv::OpDecorateString &&
                   operands.at(1) == spv::DecorationHlslSemanticGOOGLE) {
            variables[operands.at(0)].isPosition = IsPositionSemantic(instruction.Text(2));
        } else if (instruction.opcode == spv::OpDecorate && operands.at(1) == spv::DecorationBuiltIn) {
            variables[operands.at(0)].isBuiltIn = true;
        } else if (instruction.opcode == spv::OpDecorate && operands.at(1) == spv::DecorationLocation) {
            locations[operands.at(0)] = operands.data();
        }
    }
    for (const auto& [id, variable] : variables) {
        const std::optional<spv::BuiltIn> builtIn = PositionOf(stage, variable.storage);
        if (!builtIn || !variable.isPosition || variable.isBuiltIn || !CanBePosition(types, variable.type)) continue;
        const auto own = locations.find(id);
        if (own == locations.end()) continue;
        const uint32_t freed = own->second[2];
        own->second[1] = spv::DecorationBuiltIn;
        own->second[2] = *builtIn;
        locations.erase(own);
        for (const auto& [other, operands] : locations)
            if (variables[other].storage == variable.storage && operands[2] > freed) --operands[2];
    }
}

// The pointer type to a type in Output, in front of `instructions` that are to come: taken from further behind in the
// module, where it is declared, or made.
uint32_t OutputPointerTo(uint32_t type, SpirvModule& module, std::vector<SpirvInstruction>& instructions) {
    const auto isIt = [&](const SpirvInstruction& each) {
        return each.opcode == spv::OpTypePointer && each.operands.at(1) == spv::StorageClassOutput &&
               each.operands.at(2) == type;
    };
    if (const auto known = std::ranges::find_if(instructions, isIt); known != instructions.end())
        return known->operands.at(0);
    const auto behind = std::ranges::find_if(module.instructions, isIt);
    const uint32_t pointer = behind == module.instructions.end() ? module.NewId() : behind->operands.at(0);
    instructions.push_back({spv::OpTypePointer, {pointer, spv::StorageClassOutput, type}});
    return pointer;
}

// The variables that are the position, and an array of one: their array's type.
std::map<uint32_t, uint32_t> WrappedPositions(const SpirvModule& module, const SpirvTypes& types) {
    std::map<uint32_t, uint32_t> wrapped;
    for (const SpirvInstruction& each : module.instructions) {
        if (each.opcode != spv::OpDecorate || each.operands.at(1) != spv::DecorationBuiltIn ||
            each.operands.at(2) != spv::BuiltInPosition)
            continue;
        const uint32_t variable = each.operands.at(0), type = types.PointeeOf(types.TypeOf(variable));
        if (types.IsArrayOfOne(type) && types.IsFloat4(types.ElementOf(type))) wrapped[variable] = type;
    }
    return wrapped;
}

void UnwrapPositions(SpirvModule& module) {
    const SpirvTypes types(module);
    const std::map<uint32_t, uint32_t> wrapped = WrappedPositions(module, types);
    if (wrapped.empty()) return;
    const auto arrayOf = [&](uint32_t variable) {
        const auto found = wrapped.find(variable);
        return found == wrapped.end() ? 0 : found->second;
    };
    std::vector<SpirvInstruction> output;
    std::vector<uint32_t> hoisted;  // pointer types that are declared by now
    for (SpirvInstruction each : module.instructions) {
        std::vector<uint32_t>& operands = each.operands;
        const auto array = [&](size_t pointer) { return operands.size() > pointer ? arrayOf(operands[pointer]) : 0; };
        const bool isVariable = each.opcode == spv::OpVariable && array(1) && operands[2] == spv::StorageClassOutput;
        if (each.opcode == spv::OpTypePointer && std::ranges::find(hoisted, operands.at(0)) != hoisted.end())
            continue;
        if (isVariable) {
            operands[0] = OutputPointerTo(types.ElementOf(array(1)), module, output);
            hoisted.push_back(operands[0]);
        } else if (each.opcode == spv::OpAccessChain && array(2)) {
            operands.erase(operands.begin() + 3);  // the index, which is 0
            if (operands.size() == 3) each.opcode = spv::OpCopyObject;
        } else if (each.opcode == spv::OpStore && array(0)) {
            const uint32_t element = module.NewId();
            output.push_back({spv::OpCompositeExtract, {types.ElementOf(array(0)), element, operands[1], 0}});
            operands[1] = element;
        } else if (each.opcode == spv::OpLoad && array(2)) {
            const uint32_t element = module.NewId(), type = operands[0], result = operands[1];
            output.push_back({spv::OpLoad, {types.ElementOf(array(2)), element, operands[2]}});
            each = {spv::OpCompositeConstruct, {type, result, element}};
        }
        output.push_back(std::move(each));
    }
    module.instructions = std::move(output);
}

void RepairPushConstants(SpirvModule& module) {
    std::set<uint32_t> pushConstants;
    for (const SpirvInstruction& each : module.instructions)
        if (each.opcode == spv::OpVariable && each.operands.at(2) == spv::StorageClassPushConstant)
            pushConstants.insert(each.operands.at(1));
    std::erase_if(module.instructions, [&](const SpirvInstruction& each) {
        if (each.opcode != spv::OpDecorate || !pushConstants.contains(each.operands.at(0))) return false;
        return each.operands.at(1) == spv::DecorationBinding || each.operands.at(1) == spv::DecorationDescriptorSet;
    });
}

}  // namespace

std::vector<uint32_t> Repair(const std::vector<uint32_t>& spirv, ShaderStage stage) {
    SpirvModule module(spirv);
    AtomicRepair(module).Run();
    RepairPositions(module, stage);
    if (stage == ShaderStage::Vertex || stage == ShaderStage::Domain) UnwrapPositions(module);
    RepairPushConstants(module);
    RepairBools(module);
    return module.Words();
}

}  // namespace boxcar
