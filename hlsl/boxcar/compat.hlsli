// compat.hlsli: what the compilers do not agree on, once. No other file of the library asks which compiler it is.
//
//   VULKAN defined              glslang, for Vulkan
//   __hlsl_dx_compiler defined  dxc
//   neither                     fxc
#ifndef BOXCAR_COMPAT_HLSLI
#define BOXCAR_COMPAT_HLSLI

// BOXCAR_CONSTANTS(Name) { .. }: the one block of constants of an entry point. Push constants on Vulkan (at most 128
// bytes), constant buffer b0 on Direct3D (there: root constants or a small buffer).
#if defined(VULKAN)
#define BOXCAR_CONSTANTS(name) [[vk::push_constant]] cbuffer name
#else
#define BOXCAR_CONSTANTS(name) cbuffer name : register(b0)
#endif

#endif
