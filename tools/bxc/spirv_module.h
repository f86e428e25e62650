// A SPIR-V module as a list of instructions, for stages that change a few of them and keep the rest.
//
// Non-goals: control flow, types as objects; SPIRV-Tools has those.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace boxcar {

struct SpirvInstruction {
    uint16_t opcode = 0;             // spv::Op
    std::vector<uint32_t> operands;  // all words behind the first, result and type among them

    // The literal text that starts at an operand.
    std::string Text(size_t operand) const;
};

class SpirvModule {
public:
    // From the first instruction whose length is impossible on, words do not become part of the list; Words() still
    // returns them.
    explicit SpirvModule(std::span<const uint32_t> words);

    std::vector<uint32_t> Words() const;
    uint32_t NewId();

    std::vector<SpirvInstruction> instructions;

private:
    std::vector<uint32_t> m_header, m_rest;
};

// The type of every value of a module, and what its types are.
class SpirvTypes {
public:
    explicit SpirvTypes(const SpirvModule& module);

    uint32_t TypeOf(uint32_t value) const;    // 0: it has none
    uint32_t PointeeOf(uint32_t type) const;  // 0: it is not a pointer
    uint32_t ElementOf(uint32_t type) const;  // of an array or a vector; 0: it is neither
    bool Is(uint32_t type, uint16_t opcode) const;
    bool IsInt(uint32_t type, bool isSigned) const;  // of 32 bits
    bool IsFloat4(uint32_t type) const;
    bool IsArrayOfOne(uint32_t type) const;

private:
    const SpirvInstruction* Find(uint32_t type) const;

    std::map<uint32_t, uint32_t> m_typeOfValue, m_constants;
    std::map<uint32_t, SpirvInstruction> m_types;
};

}  // namespace boxcar
