#include "tools/bxc/repair_bools.h"

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <spirv.hpp>

namespace boxcar {
namespace {

bool IsVariable(const SpirvInstruction& each) {
    return each.opcode == spv::OpVariable &&
           (each.operands.at(2) == spv::StorageClassInput || each.operands.at(2) == spv::StorageClassOutput);
}

class BoolRepair {
public:
    explicit BoolRepair(SpirvModule& module) : m_module(module), m_types(module) {}

    void Run() {
        FindVariables();
        if (m_boolOf.empty()) return;
        std::vector<SpirvInstruction> output;
        bool inFunctions = false;
        for (const SpirvInstruction& each : m_module.instructions) {
            if (IsVariable(each) && m_boolOf.contains(each.operands.at(1))) {
                m_variables.push_back(each);
                continue;
            }
            if (each.opcode == spv::OpFunction && !inFunctions) {
                inFunctions = true;
                m_at = output.size();
            }
            Append(output, each);
        }
        for (SpirvInstruction& variable : m_variables) {
            const auto storage = static_cast<spv::StorageClass>(variable.operands[2]);
            variable.operands[0] =
                Declared(spv::OpTypePointer,
                         {static_cast<uint32_t>(storage), UintFor(m_boolOf.at(variable.operands[1]))}, output);
            m_globals.push_back(variable);
        }
        output.insert(output.begin() + static_cast<ptrdiff_t>(m_at), m_globals.begin(), m_globals.end());
        m_module.instructions = std::move(output);
    }

private:
    // Those that are loaded and stored as a whole, and no more.
    void FindVariables() {
        std::set<uint32_t> builtIns;
        for (const SpirvInstruction& each : m_module.instructions) {
            if (each.opcode == spv::OpDecorate && each.operands.at(1) == spv::DecorationBuiltIn)
                builtIns.insert(each.operands.at(0));
            if (!IsVariable(each) || builtIns.contains(each.operands.at(1))) continue;
            const uint32_t type = m_types.PointeeOf(each.operands.at(0));
            const bool isVector = m_types.Is(type, spv::OpTypeVector);
            if (m_types.Is(isVector ? m_types.ElementOf(type) : type, spv::OpTypeBool))
                m_boolOf[each.operands.at(1)] = type;
        }
        for (const SpirvInstruction& each : m_module.instructions)
            if (each.opcode == spv::OpAccessChain || each.opcode == spv::OpFunctionCall)
                for (size_t i = 2; i < each.operands.size(); ++i)
                    m_boolOf.erase(each.operands[i]);
    }

    void Append(std::vector<SpirvInstruction>& output, SpirvInstruction each) {
        std::vector<uint32_t>& operands = each.operands;
        if (each.opcode == spv::OpLoad && m_boolOf.contains(operands.at(2))) {
            const uint32_t type = operands[0], result = operands[1], loaded = m_module.NewId();
            output.push_back({spv::OpLoad, {UintFor(type), loaded, operands[2]}});
            each = {spv::OpINotEqual, {type, result, loaded, Constant(type, 0)}};
        } else if (each.opcode == spv::OpStore && m_boolOf.contains(operands.at(0))) {
            const uint32_t type = m_boolOf.at(operands[0]), stored = m_module.NewId();
            output.push_back(
                {spv::OpSelect, {UintFor(type), stored, operands[1], Constant(type, 1), Constant(type, 0)}});
            operands[1] = stored;
        }
        output.push_back(std::move(each));
    }

    // The id of a type with these operands: one of the module, or a new one before the first function.
    uint32_t Declared(uint16_t opcode, std::vector<uint32_t> operands, const std::vector<SpirvInstruction>& known) {
        const auto isIt = [&](const SpirvInstruction& each) {
            return each.opcode == opcode && std::ranges::equal(std::span(each.operands).subspan(1), operands);
        };
        for (const std::span<const SpirvInstruction> list :
             {std::span(known), std::span<const SpirvInstruction>(m_globals)})
            if (const auto found = std::ranges::find_if(list, isIt); found != list.end()) return found->operands[0];
        operands.insert(operands.begin(), m_module.NewId());
        m_globals.push_back({opcode, operands});
        return operands[0];
    }

    uint32_t CountOf(uint32_t type) const {
        for (const SpirvInstruction& each : m_module.instructions)
            if (each.opcode == spv::OpTypeVector && each.operands.at(0) == type) return each.operands.at(2);
        return 1;
    }

    // uint for bool, uint2 for bool2
    uint32_t UintFor(uint32_t boolType) {
        if (const auto known = m_uintFor.find(boolType); known != m_uintFor.end()) return known->second;
        uint32_t type = Declared(spv::OpTypeInt, {32, 0}, m_module.instructions);
        if (const uint32_t count = CountOf(boolType); count > 1)
            type = Declared(spv::OpTypeVector, {type, count}, m_module.instructions);
        return m_uintFor[boolType] = type;
    }

    uint32_t Constant(uint32_t boolType, uint32_t value) {
        const uint32_t type = UintFor(boolType), count = CountOf(boolType), scalar = m_module.NewId();
        m_globals.push_back(
            {spv::OpConstant, {Declared(spv::OpTypeInt, {32, 0}, m_module.instructions), scalar, value}});
        if (count == 1) return scalar;
        std::vector<uint32_t> operands(2 + count, scalar);
        operands[0] = type;
        operands[1] = m_module.NewId();
        m_globals.push_back({spv::OpConstantComposite, operands});
        return operands[1];
    }

    SpirvModule& m_module;
    const SpirvTypes m_types;
    std::map<uint32_t, uint32_t> m_boolOf;   // variable: its type
    std::map<uint32_t, uint32_t> m_uintFor;  // bool type: uint type
    std::vector<SpirvInstruction> m_globals, m_variables;
    size_t m_at = 0;  // of the first function
};

}  // namespace

void RepairBools(SpirvModule& module) {
    BoolRepair(module).Run();
}

}  // namespace boxcar
