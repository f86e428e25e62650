#include "tools/bxc/spirv_module.h"

#include <cstring>

#define SPV_ENABLE_UTILITY_CODE
#include <spirv.hpp>

namespace boxcar {
namespace {

constexpr size_t kHeaderWords = 5;
constexpr size_t kBoundWord = 3;

}  // namespace

std::string SpirvInstruction::Text(size_t operand) const {
    std::string text;
    for (; operand < operands.size(); ++operand)
        for (int shift = 0; shift < 32; shift += 8) {
            const char c = static_cast<char>(operands[operand] >> shift & 0xff);
            if (c == '\0') return text;
            text += c;
        }
    return text;
}

SpirvModule::SpirvModule(std::span<const uint32_t> words) {
    const auto header = words.first(std::min(kHeaderWords, words.size()));
    m_header.assign(header.begin(), header.end());
    words = words.subspan(header.size());
    while (!words.empty()) {
        const size_t count = words[0] >> 16;
        if (count == 0 || count > words.size()) break;
        const auto operands = words.subspan(1, count - 1);
        instructions.push_back({static_cast<uint16_t>(words[0]), {operands.begin(), operands.end()}});
        words = words.subspan(count);
    }
    m_rest.assign(words.begin(), words.end());
}

std::vector<uint32_t> SpirvModule::Words() const {
    std::vector<uint32_t> words = m_header;
    for (const SpirvInstruction& instruction : instructions) {
        words.push_back(static_cast<uint32_t>((instruction.operands.size() + 1) << 16 | instruction.opcode));
        words.insert(words.end(), instruction.operands.begin(), instruction.operands.end());
    }
    words.insert(words.end(), m_rest.begin(), m_rest.end());
    return words;
}

uint32_t SpirvModule::NewId() {
    return m_header.at(kBoundWord)++;
}

SpirvTypes::SpirvTypes(const SpirvModule& module) {
    for (const SpirvInstruction& instruction : module.instructions) {
        bool hasResult = false, hasType = false;
        spv::HasResultAndType(static_cast<spv::Op>(instruction.opcode), &hasResult, &hasType);
        const std::vector<uint32_t>& operands = instruction.operands;
        if (hasResult && hasType && operands.size() >= 2) m_typeOfValue[operands[1]] = operands[0];
        if (instruction.opcode == spv::OpConstant && operands.size() == 3) m_constants[operands[1]] = operands[2];
        if (hasResult && !hasType && !operands.empty()) m_types[operands[0]] = instruction;
    }
}

const SpirvInstruction* SpirvTypes::Find(uint32_t type) const {
    const auto found = m_types.find(type);
    return found == m_types.end() ? nullptr : &found->second;
}

uint32_t SpirvTypes::TypeOf(uint32_t value) const {
    const auto found = m_typeOfValue.find(value);
    return found == m_typeOfValue.end() ? 0 : found->second;
}

uint32_t SpirvTypes::PointeeOf(uint32_t type) const {
    return Is(type, spv::OpTypePointer) ? Find(type)->operands.at(2) : 0;
}

uint32_t SpirvTypes::ElementOf(uint32_t type) const {
    return Is(type, spv::OpTypeArray) || Is(type, spv::OpTypeVector) ? Find(type)->operands.at(1) : 0;
}

bool SpirvTypes::Is(uint32_t type, uint16_t opcode) const {
    const SpirvInstruction* instruction = Find(type);
    return instruction && instruction->opcode == opcode;
}

bool SpirvTypes::IsInt(uint32_t type, bool isSigned) const {
    return Is(type, spv::OpTypeInt) && Find(type)->operands.at(1) == 32 &&
           (Find(type)->operands.at(2) != 0) == isSigned;
}

bool SpirvTypes::IsFloat4(uint32_t type) const {
    return Is(type, spv::OpTypeVector) && Find(type)->operands.at(2) == 4 && Is(ElementOf(type), spv::OpTypeFloat);
}

bool SpirvTypes::IsArrayOfOne(uint32_t type) const {
    if (!Is(type, spv::OpTypeArray)) return false;
    const auto length = m_constants.find(Find(type)->operands.at(2));
    return length != m_constants.end() && length->second == 1;
}

}  // namespace boxcar
