#include "samples/app/codes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hlsl/boxcar/sat_range.h"
#include "samples/files/color.h"
#include "tools/base/error.h"

namespace boxcar {
namespace {

constexpr double kLinearLargest = 65535;
const double kHalfScale = std::ldexp(1.0, 24);
const double kHalfLimit = std::ldexp(1.0, 40);
constexpr double kLeastCodes = 9;  // of every round: 8 steps and one for their rounding

double LargestCode(SampleType stored) {
    return stored == SampleType::Unorm8 ? 255 : 65535;
}

bool IsLight(const Picture& picture, Transfer transfer) {
    return transfer == Transfer::Srgb && picture.stored != SampleType::Float32;
}

// Linear light of every code.
std::vector<double> LightOfCodes(const Picture& picture) {
    const double largest = LargestCode(picture.stored);
    std::vector<double> light(static_cast<size_t>(largest) + 1);
    for (size_t i = 0; i < light.size(); i++)
        light[i] = ToLinear(picture.colorSpace, static_cast<double>(i) / largest);
    return light;
}

// The code of a value in a round; then what rounds, one after the other, leave over of a value.
double CodeOf(double value, const CodeRound& round) {
    return std::round(value * round.codes.scale / round.unit);
}

double LeftOver(double value, std::span<const CodeRound> rounds) {
    for (const CodeRound& round : rounds)
        value -= CodeOf(value, round) * round.unit / round.codes.scale;
    return value;
}

// The values of a picture as far as a plan needs to know them.
struct Values {
    double largest = 0;
    double smallest = std::numeric_limits<double>::infinity();  // that is not 0
    bool isSigned = false;
};

Values ValuesOf(const Picture& picture, Transfer transfer) {
    if (picture.stored != SampleType::Float32) {
        // The smallest light that the file can hold.
        const double code = 1 / LargestCode(picture.stored);
        const double light = IsLight(picture, transfer) ? ToLinear(picture.colorSpace, code) : code;
        return {1, HasAlpha(picture) && IsLight(picture, transfer) ? light * code : light, false};
    }
    Values values;
    for (const float sample : picture.samples) {
        const double magnitude = std::abs(static_cast<double>(sample));
        values.largest = std::max(values.largest, magnitude);
        if (magnitude > 0) values.smallest = std::min(values.smallest, magnitude);
        values.isSigned |= sample < 0;
    }
    return values;
}

// How far a code may be from its value.
class Tolerance {
public:
    Tolerance(const Picture& picture, SampleType result) {
        constexpr double kSteepestSrgb = 12.92, kShareOfCode = 0.005;
        const bool isFloat = picture.stored == SampleType::Float32;
        if (result != SampleType::Float32) m_absolute = kShareOfCode / (kSteepestSrgb * LargestCode(result));
        if (result == SampleType::Float32) m_relative = 0x1p-20;
        if (result == SampleType::Float32 || !HasAlpha(picture)) return;
        // Color and alpha are both rounded, and the one is divided by the other.
        if (isFloat)
            m_relative = 0x1p-24;
        else
            m_absolute *= 0.5 / LargestCode(picture.stored);
    }

    double Of(double magnitude) const { return std::min(m_absolute, std::max(m_relative * magnitude, kLeast)); }

private:
    static constexpr double kLeast = 0x1p-150;  // half of the smallest float
    static constexpr double kNone = std::numeric_limits<double>::infinity();
    double m_absolute = kNone, m_relative = kNone;
};

// Whether no value is farther from its codes than is allowed.
bool IsFineEnough(const Picture& picture, const std::vector<CodeRound>& rounds, const Tolerance& tolerance,
                  double smallest) {
    if (0.5 * rounds.back().Step() <= tolerance.Of(smallest)) return true;
    if (picture.stored != SampleType::Float32) return false;
    return std::ranges::all_of(picture.samples, [&](float sample) {
        return std::abs(LeftOver(sample, rounds)) <= tolerance.Of(std::abs(static_cast<double>(sample)));
    });
}

bool Holds(SATPrecision precision, const KernelSize& kernel, const SATCodes& codes) {
    return SATBoxIsExact(kernel.sizeTexels, static_cast<int>(kernel.order), kernel.isWhole,
                         SATLargestMass(precision, codes));
}

// The finest codes of values up to `largest` that the words hold; codes up to 2 say that there are none to speak of.
CodeRound FinestCodes(SATPrecision precision, const KernelSize& kernel, double largest, bool isSigned) {
    CodeRound round{{1, std::ldexp(1.0, 63), isSigned}, std::ldexp(1.0, std::ilogb(largest) - 62)};
    while (round.codes.largest > 2 && !Holds(precision, kernel, round.codes)) {
        round.unit *= 2;
        round.codes.largest = std::ceil(largest / round.unit) + 1;
    }
    return round;
}

}  // namespace

CodePlan NamedCodes(const Picture& picture, const std::string& name, Transfer transfer, SATPrecision precision) {
    if (picture.stored != SampleType::Float32) {
        const double largest = IsLight(picture, transfer) ? kLinearLargest : LargestCode(picture.stored);
        return {precision, {{{static_cast<float>(largest), largest, false}}}};
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
        if (code != picture.samples[i] * kHalfScale)
            refuse("is not a half float; u64 sums half floats exactly, fp32 takes any");
        codes.largest = std::max(codes.largest, std::abs(code));
        codes.isSigned |= code < 0;
    }
    return {precision, {{codes}}};
}

CodePlan FittingCodes(const Picture& picture, const std::string& name, Transfer transfer, SampleType result,
                      const KernelSize& kernel) {
    if (picture.stored != SampleType::Float32 && transfer == Transfer::Raw) {
        for (const SATPrecision precision : {SATPrecision::U32, SATPrecision::U64}) {
            const CodePlan own = NamedCodes(picture, name, transfer, precision);
            if (Holds(precision, kernel, own.rounds[0].codes)) return own;
        }
    }
    const Values values = ValuesOf(picture, transfer);
    if (values.largest == 0) return {SATPrecision::U64, {{{1, 1, false}}}};
    const Tolerance tolerance(picture, result);
    double largest = values.largest;
    if (picture.stored != SampleType::Float32) {
        const CodePlan narrow{SATPrecision::U32, {FinestCodes(SATPrecision::U32, kernel, largest, false)}};
        if (IsFineEnough(picture, narrow.rounds, tolerance, values.smallest)) return narrow;
    }
    CodePlan plan{SATPrecision::U64, {}};
    do {
        const bool isSigned = values.isSigned || !plan.rounds.empty();
        plan.rounds.push_back(FinestCodes(SATPrecision::U64, kernel, largest, isSigned));
        if (plan.rounds.back().codes.largest < kLeastCodes) {
            const SATCodes least{1, 2 * kLeastCodes, true};  // in any round
            const uint32_t side = SATLargestWidthTexels(SATPrecision::U64, least, kernel.order, kernel.isWhole);
            constexpr const char* kNames[] = {"box", "tent", "parabolic kernel"};
            throw Error("{}: a {} of {:g} x {:g} texels is too wide for sums of 64 bits; {} x {} fits", name,
                        kNames[kernel.order - 1], kernel.sizeTexels.x, kernel.sizeTexels.y, side, side);
        }
        largest = 0.5 * plan.rounds.back().Step();
    } while (!IsFineEnough(picture, plan.rounds, tolerance, values.smallest));
    return plan;
}

void AddPlan(Stats& stats, const CodePlan& plan) {
    stats.precision = SATPrecisionName(plan.precision);
    stats.step = plan.rounds.back().Step();
    stats.rounds = plan.rounds.size();
}

CodedPicture::CodedPicture(const Picture& picture, Transfer transfer, CodePlan plan)
    : m_picture(picture), m_plan(std::move(plan)) {
    if (IsLight(picture, transfer)) m_light = LightOfCodes(picture);
}

CodeWords CodedPicture::Rows(size_t round, uint32_t firstRow, uint32_t rows) const {
    const size_t channels = m_picture.channels;
    const size_t texels = size_t{rows} * m_picture.widthTexels;
    const bool isFloat = m_picture.stored == SampleType::Float32;
    const double largest = isFloat ? 1 : LargestCode(m_picture.stored);
    const bool hasAlpha = HasAlpha(m_picture);
    const bool isWide = m_plan.precision == SATPrecision::U64;
    const float* sample = m_picture.samples.data() + channels * firstRow * m_picture.widthTexels;
    const auto codeOf = [&](double value) {
        value = LeftOver(value, std::span(m_plan.rounds).first(round));
        return static_cast<uint64_t>(static_cast<int64_t>(CodeOf(value, m_plan.rounds[round])));
    };
    // Of opaque 8 and 16-bit pictures, of every code once.
    std::vector<uint64_t> codes;
    if (!isFloat && (m_light.empty() || !hasAlpha)) {
        codes.resize(static_cast<size_t>(largest) + 1);
        for (size_t i = 0; i < codes.size(); i++)
            codes[i] = codeOf(m_light.empty() ? static_cast<double>(i) / largest : m_light[i]);
    }

    CodeWords words;
    words.low.assign(texels, glm::uvec4(0));
    if (isWide) words.high.assign(texels, glm::uvec4(0));
    for (size_t i = 0; i < texels; i++, sample += channels) {
        // From whole codes: the sample itself has been rounded to float.
        const auto whole = [&](size_t c) { return static_cast<size_t>(std::lrint(sample[c] * largest)); };
        const double alpha = !isFloat && hasAlpha ? static_cast<double>(whole(channels - 1)) / largest : 1;
        for (size_t c = 0; c < channels; c++) {
            uint64_t bits;
            if (isFloat)
                bits = codeOf(sample[c]);
            else if (!codes.empty())
                bits = codes[whole(c)];
            else
                bits = codeOf(c + 1 == channels ? alpha : m_light[whole(c)] * alpha);
            words.low[i][static_cast<int>(c)] = static_cast<uint32_t>(bits);
            if (isWide) words.high[i][static_cast<int>(c)] = static_cast<uint32_t>(bits >> 32);
        }
    }
    return words;
}

WordImages CodedPicture::Upload(Device& device, size_t round, uint32_t firstRow, uint32_t rows) const {
    const CodeWords codes = Rows(round, firstRow, rows);
    WordImages words(device, m_plan.precision, {m_picture.widthTexels, rows}, "source");
    const TexelWords images = words;
    WriteTexels(device, *images.low, std::as_bytes(std::span(codes.low)));
    if (images.high) WriteTexels(device, *images.high, std::as_bytes(std::span(codes.high)));
    return words;
}

}  // namespace boxcar
