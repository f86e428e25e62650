// Fixes what the compiler gets wrong in the SPIR-V of HLSL that it has understood.
//
//   Atomics    The compiler does not convert the operands and results of RWByteAddressBuffer's methods: a literal 1,
//              which is an int, is added to a uint. They are converted to the type of the memory, as HLSL does. That
//              type also decides whether a minimum is signed.
//   Positions  SV_Position of an inout parameter, and SV_Position0 anywhere, is an ordinary variable. It becomes the
//              position (in a pixel shader that reads it, the coordinate), and gives up its location. If it is in an
//              array of one, or in a struct of such an array, it is taken out of the array.
//   Bools      Between stages they are uint (repair_bools.h).
//   Bindings   Push constants have none, even if [[vk::push_constant]] ConstantBuffer<S> has a register.
#pragma once

#include <cstdint>
#include <vector>

#include "tools/layout/shader_layout.h"

namespace boxcar {

// spirv  as the compiler leaves it, semantics in it. Instructions that are right stay as they are.
std::vector<uint32_t> Repair(const std::vector<uint32_t>& spirv, ShaderStage stage);

}  // namespace boxcar
