// Arithmetic as it is written: with -Gis no driver may fuse a product and a sum into one operation.
#pragma once

#include <cstdint>
#include <vector>

namespace boxcar {

// Decorates every floating-point operation with NoContraction.
std::vector<uint32_t> ForbidContraction(const std::vector<uint32_t>& spirv);

}  // namespace boxcar
