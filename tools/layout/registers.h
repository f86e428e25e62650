// Where the registers of HLSL end up among the bindings of Vulkan, unless a shader's flags say otherwise. In Direct3D
// each class of registers counts for itself; in Vulkan they share the bindings of a set. So each class starts at its
// own base, far enough from the next one for b0 to b15, s0 to s15, u0 to u63 and t0 and up.
#pragma once

#include <cstdint>

namespace boxcar {

struct HlslRegister {
    char registerClass = 'b';  // b: constants, s: samplers, u: read and written, t: textures and buffers
    uint32_t number = 0;       // 3 in register(t3)

    bool operator==(const HlslRegister&) const = default;
};

// The binding of register 0 of each class, in ascending order.
struct RegisterBase {
    char registerClass;
    uint32_t binding;
};
constexpr RegisterBase kRegisterBases[] = {{'b', 0}, {'s', 16}, {'u', 32}, {'t', 96}};

// The register that ends up at a binding.
constexpr HlslRegister RegisterAt(uint32_t binding) {
    HlslRegister found;
    for (const RegisterBase& base : kRegisterBases)
        if (binding >= base.binding) found = {base.registerClass, binding - base.binding};
    return found;
}

}  // namespace boxcar
