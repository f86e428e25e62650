// Compiles other people's HLSL, and looks at what comes out.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "tests/bxc/bxc_test.h"
#include "tools/bxc/spirv_module.h"

namespace boxcar {

class ForeignTest : public BxcTest {
protected:
    using Words = std::vector<std::string>;

    RunResult Run(const std::string& text, const std::string& profile, const Words& flags = {}) const {
        Write("shader.hlsl", text);
        Words words = {"compile", "shader.hlsl", "-T", profile, "-o", "out.spv"};
        words.insert(words.end(), flags.begin(), flags.end());
        return Bxc(words);
    }

    // Compiles without a word, and returns the layout.
    ShaderLayout Compile(const std::string& text, const std::string& profile, const Words& flags = {}) const {
        const RunResult run = Run(text, profile, flags);
        EXPECT_EQ(run.exitCode, 0) << run.err;
        EXPECT_EQ(run.out + run.err, "");
        return run.exitCode == 0 ? ReadLayout("out.layout.json") : ShaderLayout{};
    }

    std::vector<uint32_t> Spirv() const {
        const std::string bytes = Read("out.spv");
        std::vector<uint32_t> words(bytes.size() / 4);
        std::memcpy(words.data(), bytes.data(), words.size() * 4);
        return words;
    }

    // How many instructions of the output have this opcode and, as their second operand, this word.
    size_t Count(uint16_t opcode, uint32_t second) const {
        const SpirvModule module(Spirv());
        return static_cast<size_t>(std::ranges::count_if(module.instructions, [&](const SpirvInstruction& each) {
            return each.opcode == opcode && each.operands.size() > 1 && each.operands[1] == second;
        }));
    }

    // "name semantic location", one a variable
    static Words Lines(const std::vector<LayoutVariable>& variables) {
        Words lines;
        for (const LayoutVariable& v : variables)
            lines.push_back(fmt::format("{} {} {} {}", v.name, v.semantic, v.location, v.locationCount));
        return lines;
    }

    // "name set binding"
    static Words Bindings(const ShaderLayout& layout) {
        Words lines;
        for (const LayoutResource& r : layout.resources)
            lines.push_back(fmt::format("{} {} {}", r.name, r.set, r.binding));
        return lines;
    }
};

}  // namespace boxcar
