#include "samples/cli/codes.h"

#include <algorithm>
#include <cmath>

#include "samples/files/color.h"

namespace boxcar {
namespace {

constexpr double kLinearLargest = 65535;
const double kHalfScale = std::ldexp(1.0, 24);
const double kHalfLimit = std::ldexp(1.0, 40);

double LargestCode(SampleType stored) {
    return stored == SampleType::Unorm8 ? 255 : 65535;
}

// Linear light of every code.
std::vector<double> LightOfCodes(const Picture& picture) {
    const double largest = LargestCode(picture.stored);
    std::vector<double> light(static_cast<size_t>(largest) + 1);
    for (size_t i = 0; i < light.size(); i++)
        light[i] = ToLinear(picture.colorSpace, static_cast<double>(i) / largest);
    return light;
}

}  // namespace

SATCodes CodesFor(const Picture& picture, const std::string& name, Transfer transfer, SATPrecision precision,
                  Rounding rounding) {
    if (picture.stored != SampleType::Float32) {
        const double largest = transfer == Transfer::Srgb ? kLinearLargest : LargestCode(picture.stored);
        return {static_cast<float>(largest), largest, false};
    }
    if (precision == SATPrecision::U32)
        throw Error("{}: u32 sums 8 and 16-bit pictures; a float picture takes u64 or fp32", name);
    SATCodes codes{static_cast<float>(kHalfScale), 0, false};
    for (size_t i = 0; i < picture.samples.size(); i++) {
        const double code = std::round(picture.samples[i] * kHalfScale);
        const auto refuse = [&](const char* why) {
            const size_t texel = i / picture.channels;
            throw Error("{}: {:g} at ({}, {}) {}", name, picture.samples[i], texel % picture.widthTexels,
                        texel / picture.widthTexels, why);
        };
        if (std::abs(code) >= kHalfLimit)
            refuse("is beyond half floats; u64 sums values below 65536, fp32 takes any");
        if (rounding == Rounding::Refuse && code != picture.samples[i] * kHalfScale)
            refuse("is no half float; u64 sums half floats exactly, fp32 takes any");
        codes.largest = std::max(codes.largest, std::abs(code));
        codes.isSigned |= code < 0;
    }
    return codes;
}

CodeWords EncodeRows(const Picture& picture, Transfer transfer, SATPrecision precision, uint32_t firstRow,
                     uint32_t rows) {
    const size_t channels = picture.channels;
    const size_t texels = size_t{rows} * picture.widthTexels;
    const bool isFloat = picture.stored == SampleType::Float32;
    const bool isLight = transfer == Transfer::Srgb && !isFloat;
    const double scale = isFloat ? kHalfScale : LargestCode(picture.stored);
    const std::vector<double> light = isLight ? LightOfCodes(picture) : std::vector<double>();
    const float* sample = picture.samples.data() + channels * firstRow * picture.widthTexels;

    CodeWords words;
    words.low.assign(texels, glm::uvec4(0));
    if (precision == SATPrecision::U64) words.high.assign(texels, glm::uvec4(0));
    for (size_t i = 0; i < texels; i++, sample += channels) {
        // From whole codes: the sample itself has been rounded to float.
        const double alpha = HasAlpha(picture) ? std::round(sample[channels - 1] * scale) / scale : 1.0;
        for (size_t c = 0; c < channels; c++) {
            const bool isAlpha = HasAlpha(picture) && c + 1 == channels;
            double code = std::round(sample[c] * scale);
            if (isLight)
                code = std::round(kLinearLargest * (isAlpha ? alpha : light[static_cast<size_t>(code)] * alpha));
            const auto bits = static_cast<uint64_t>(static_cast<int64_t>(code));
            words.low[i][static_cast<int>(c)] = static_cast<uint32_t>(bits);
            if (precision == SATPrecision::U64)
                words.high[i][static_cast<int>(c)] = static_cast<uint32_t>(bits >> 32);
        }
    }
    return words;
}

UploadedWords UploadCodes(Device& device, const Picture& picture, Transfer transfer, SATPrecision precision,
                          uint32_t firstRow, uint32_t rows) {
    const Extent2D extent{picture.widthTexels, rows};
    const CodeWords codes = EncodeRows(picture, transfer, precision, firstRow, rows);
    UploadedWords words;
    words.images.push_back(Upload(device, extent, std::span(codes.low), "source"));
    if (precision == SATPrecision::U64)
        words.images.push_back(Upload(device, extent, std::span(codes.high), "source, upper words"));
    return words;
}

}  // namespace boxcar
