// Puts right what the compiler gets wrong in SPIR-V though it has understood the HLSL.
//
//   Atomics    The methods of RWByteAddressBuffer take their operands and results as they come: a literal 1, which is
//              an int, is added to a uint. They are converted to the type of the memory, as HLSL does; whether a
//              minimum is signed goes by that type too.
//   Positions  SV_Position of an inout parameter, and SV_Position0 anywhere, is an ordinary variable. It becomes the
//              position (in a pixel shader that reads it, the coordinate), and gives its location up. In an array of
//              one, or a struct of such an array, it is taken out of the array.
//   Bools      Between stages they are uint (repair_bools.h).
//   Bindings   Push constants have none, though [[vk::push_constant]] ConstantBuffer<S> has a register.
#pragma once

#include <cstdint>
#include <vector>

#include "tools/layout/shader_layout.h"

namespace boxcar {

// spirv  as the compiler leaves it, semantics in it. Other instructions, and modules that need nothing, stay as they
//        are.
std::vector<uint32_t> Repair(const std::vector<uint32_t>& spirv, ShaderStage stage);

}  // namespace boxcar
