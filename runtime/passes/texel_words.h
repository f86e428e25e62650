// What a summed-area table is made of: floats, or integers of one or two words a channel.
#pragma once

#include <utility>
#include <vector>

#include "runtime/pass.h"

namespace boxcar {

enum class SATPrecision {
    FP32,  // RGBA32F; rounds
    U32,   // RGBA32UI: sums of codes modulo 2^32; exact while the sum under the filter fits
    U64,   // two RGBA32UI, the lower and the upper words: modulo 2^64
};

// "fp32", "u32", "u64"
constexpr const char* SATPrecisionName(SATPrecision precision) {
    constexpr const char* kNames[] = {"fp32", "u32", "u64"};
    return kNames[static_cast<size_t>(precision)];
}

constexpr uint32_t WordsOf(SATPrecision precision) {
    return precision == SATPrecision::U64 ? 2 : 1;
}

constexpr Format WordFormat(SATPrecision precision) {
    return precision == SATPrecision::FP32 ? Format::RGBA32F : Format::RGBA32UI;
}

// The images that together hold one value a texel and channel.
struct TexelWords {
    TexelWords(const Image& only) : low(&only) {}
    TexelWords(const Image& lowWords, const Image& highWords) : low(&lowWords), high(&highWords) {}

    const Image* low;
    const Image* high = nullptr;  // U64 only
};

// What a pass reads of a table, besides `others`: hlsl/shaders/table_io.hlsli has the names.
inline std::vector<Read> TableReads(TexelWords table, std::vector<Read> others = {}) {
    others.push_back({"table", table.low});
    if (table.high) others.push_back({"tableHigh", table.high});
    return others;
}

}  // namespace boxcar
