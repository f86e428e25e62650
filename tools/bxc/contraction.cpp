#include "tools/bxc/contraction.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <spirv.hpp>

#include "tools/bxc/spirv_module.h"

namespace boxcar {
namespace {

bool IsArithmetic(uint16_t opcode) {
    constexpr spv::Op kOps[] = {spv::OpFNegate,
                                spv::OpFAdd,
                                spv::OpFSub,
                                spv::OpFMul,
                                spv::OpFDiv,
                                spv::OpFRem,
                                spv::OpFMod,
                                spv::OpVectorTimesScalar,
                                spv::OpMatrixTimesScalar,
                                spv::OpVectorTimesMatrix,
                                spv::OpMatrixTimesVector,
                                spv::OpMatrixTimesMatrix,
                                spv::OpOuterProduct,
                                spv::OpDot};
    return std::ranges::find(kOps, opcode) != std::end(kOps);
}

}  // namespace

std::vector<uint32_t> ForbidContraction(const std::vector<uint32_t>& spirv) {
    SpirvModule module(spirv);
    std::set<uint32_t> results;
    for (const SpirvInstruction& each : module.instructions)
        if (IsArithmetic(each.opcode)) results.insert(each.operands.at(1));
    for (const SpirvInstruction& each : module.instructions)
        if (each.opcode == spv::OpDecorate && each.operands.at(1) == spv::DecorationNoContraction)
            results.erase(each.operands.at(0));

    std::vector<SpirvInstruction> decorations;
    for (const uint32_t result : results)
        decorations.push_back({spv::OpDecorate, {result, spv::DecorationNoContraction}});
    // Decorations stand before the first type.
    const auto isType = [](const SpirvInstruction& each) { return each.opcode == spv::OpTypeVoid; };
    module.instructions.insert(std::ranges::find_if(module.instructions, isType), decorations.begin(),
                               decorations.end());
    return module.Words();
}

}  // namespace boxcar
