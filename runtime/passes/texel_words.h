// What a summed-area table is made of: floats, or integers of one or two words a channel.
#pragma once

#include <optional>
#include <string>
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

// What a pass writes words to: one target for each.
inline std::vector<Format> WordFormats(SATPrecision precision) {
    return std::vector(WordsOf(precision), WordFormat(precision));
}

// A view of the images that together hold one value per texel and channel.
struct TexelWords {
    TexelWords(const Image& only) : low(&only) {}
    TexelWords(const Image& lowWords, const Image& highWords) : low(&lowWords), high(&highWords) {}

    const Image* low;
    const Image* high = nullptr;  // U64 only

    // What a pass reads of them, besides `others`; the upper words only where there are any.
    std::vector<Read> Reads(std::string_view lowName, std::string_view highName,
                            std::vector<Read> others = {}) const {
        others.push_back({lowName, low});
        if (high) others.push_back({highName, high});
        return others;
    }
};

// Owns those images: 16 bytes of device memory per texel and word. Move-only.
class WordImages {
public:
    // Throws Error as Image does.
    WordImages(Device& device, SATPrecision precision, Extent2D extent, const std::string& name)
        : m_low(device, {extent, WordFormat(precision), name}) {
        if (WordsOf(precision) == 2)
            m_high.emplace(device, ImageDesc{extent, WordFormat(precision), name + ", upper words"});
    }

    operator TexelWords() const { return m_high ? TexelWords(m_low, *m_high) : TexelWords(m_low); }

    // The targets of a pass that writes all words.
    std::vector<const Image*> Writes() const {
        return m_high ? std::vector<const Image*>{&m_low, &*m_high} : std::vector<const Image*>{&m_low};
    }

    Extent2D Extent() const { return m_low.Extent(); }

private:
    Image m_low;
    std::optional<Image> m_high;  // U64 only
};

// What a pass reads of a table, besides `others`: hlsl/shaders/table_io.hlsli has the names.
inline std::vector<Read> TableReads(TexelWords table, std::vector<Read> others = {}) {
    return table.Reads("table", "tableHigh", std::move(others));
}

}  // namespace boxcar
