// What a compiled shader fetches, read off its SPIR-V: one instruction is one fetch where no loop is left.
#pragma once

#include <map>
#include <span>
#include <string>

namespace boxcar {

// How many instructions sample or load each texture, by its name in the HLSL. A loop counts as -1 under "loop": then
// the counts say nothing.
inline std::map<std::string, int> FetchesIn(std::span<const uint32_t> spirv) {
    enum Op : uint32_t { Name = 5, Load = 61, SampledImage = 86, SampleImplicitLod = 87, SampleExplicitLod = 88 };
    enum : uint32_t { ImageFetch = 95, LoopMerge = 246 };
    std::map<uint32_t, std::string> names;  // of variables
    std::map<uint32_t, uint32_t>
        sources;  // of a loaded image or of an image with its sampler: the variable, the image
    std::map<std::string, int> fetches;
    constexpr size_t kHeaderWords = 5;
    for (size_t at = kHeaderWords; at < spirv.size(); at += spirv[at] >> 16) {
        const auto operand = [&](size_t i) { return spirv[at + i]; };
        switch (spirv[at] & 0xffff) {
            case Name: names[operand(1)] = reinterpret_cast<const char*>(&spirv[at + 2]); break;
            case Load:
            case SampledImage: sources[operand(2)] = operand(3); break;
            case SampleImplicitLod:
            case SampleExplicitLod: fetches[names[sources[sources[operand(3)]]]]++; break;
            case ImageFetch: fetches[names[sources[operand(3)]]]++; break;
            case LoopMerge: fetches["loop"] = -1; break;
            default: break;
        }
    }
    return fetches;
}

}  // namespace boxcar
