#include "samples/cli/depth.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <glm/vec2.hpp>
#include <limits>
#include <optional>

#include "samples/app/disparity.h"
#include "samples/cli/options.h"
#include "samples/files/color.h"

namespace boxcar {
namespace {

constexpr double kLargestScale = 1e9;
constexpr float kNearest = 1e30f;  // as a disparity: nearer depths become this, which no lens shows
constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

bool IsDistance(const DepthOptions& options) {
    return options.isWord == "distance";
}

bool IsUnknown(const DepthOptions& options, const std::string& word) {
    const auto& words = options.unknownWords;
    if (words.empty()) return word != "inf" || !IsDistance(options);
    return std::ranges::find(words, word) != words.end();
}

std::optional<double> ParseNumber(std::string_view text) {
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

// "0.001" or "1/256"; nothing where the flag is not there.
std::optional<double> ParseScale(const std::string& text) {
    if (text.empty()) return {};
    const std::string_view view = text;
    const size_t slash = view.find('/');
    const auto over = ParseNumber(view.substr(0, slash));
    const auto under = slash == std::string::npos ? std::optional(1.0) : ParseNumber(view.substr(slash + 1));
    const double scale = over && under ? *over / *under : 0;
    if (!(scale > 0 && scale <= kLargestScale))
        throw UsageError("--depth-scale {}: expected a number or A/B, above 0 and at most {:g}", text, kLargestScale);
    return scale;
}

// What the file's samples are in the units of --focus.
class Units {
public:
    Units(const DepthOptions& options, SampleType stored) : m_scale(ParseScale(options.scaleText)) {
        if (stored == SampleType::Float32) return;
        m_isRelative = !m_scale && !IsDistance(options);
        m_largestCode = m_isRelative ? 0 : stored == SampleType::Unorm8 ? 255 : 65535;
    }

    float Of(float sample) const {
        const double number = m_largestCode > 0 ? std::round(double{sample} * m_largestCode) : double{sample};
        return static_cast<float>(number * m_scale.value_or(1));
    }

    // Disparities of integers, from 0 to 1.
    bool IsRelative() const { return m_isRelative; }
    // What one step of integers is; 0 of floats, which have none.
    double Step() const { return m_largestCode > 0 ? m_scale.value_or(1) : 0; }

private:
    std::optional<double> m_scale;
    bool m_isRelative = false;
    double m_largestCode = 0;  // 0: samples count as they are
};

// A value of --focus in its units; nothing where it is a texel.
std::optional<double> ParseFocus(const DepthOptions& options) {
    if (options.focusText.find(',') != std::string::npos) return {};
    const auto focus = ParseNumber(options.focusText);
    if (focus && *focus <= std::numeric_limits<float>::max() && (IsDistance(options) ? *focus > 0 : *focus >= 0))
        return focus;
    throw UsageError("--focus {}: expected a {}, or x,y of a texel", options.focusText,
                     IsDistance(options) ? "distance above 0, finite" : "disparity, 0 (infinitely far) or more");
}

double FocusOf(const DepthOptions& options, const std::vector<float>& depth, Extent2D extent, const Units& units) {
    const auto given = ParseFocus(options);
    if (!given) {
        const glm::uvec2 texel = ParseTexel("--focus", options.focusText, extent);
        const float seen = depth[size_t{texel.y} * extent.widthTexels + texel.x];
        if (std::isinf(seen))
            throw UsageError("--focus {}: what is seen there is infinitely far; give a distance or another texel",
                             options.focusText);
        return seen;
    }
    if (units.IsRelative() && *given > 1)
        throw UsageError(
            "--focus {}: expected 0 to 1, as white is 1 in this depth; --depth-scale 1 keeps the file's numbers",
            options.focusText);
    if (IsDistance(options) && *given < units.Step())
        throw UsageError("--focus {}: nearer than {:g}, a single step of {}; expected a distance in its units",
                         options.focusText, units.Step(), options.path);
    return *given;
}

// The sample in the units of --focus, or kUnknown. Throws Error; `at` is where, as a message has it.
float DepthOf(float sample, const DepthOptions& options, const Units& units, const std::string& path,
              TexelPosition at) {
    const bool isDistance = IsDistance(options);
    const auto refuse = [&](const char* why) {
        return Error("{}: {:g} at ({}, {}); {}", path, sample, at.x, at.y, why);
    };
    if (std::isnan(sample)) {
        if (IsUnknown(options, "nan")) return kUnknown;
        throw refuse("--unknown nan takes it as unknown");
    }
    if (sample < 0) throw refuse("depth is 0 or more");
    if (sample == 0) {
        if (IsUnknown(options, "zero")) return kUnknown;
        if (isDistance) throw refuse("a distance is more; --unknown zero takes it as unknown");
    }
    if (std::isinf(sample)) {
        if (IsUnknown(options, "inf")) return kUnknown;
        if (!isDistance) throw refuse("a disparity is finite; --unknown inf takes it as unknown");
        return sample;
    }
    const float depth = units.Of(sample);
    return isDistance ? std::max(depth, std::numeric_limits<float>::min()) : std::min(depth, kNearest);
}

}  // namespace

void AddDepthOptions(CLI::App& command, DepthOptions& options) {
    command
        .add_option("--depth", options.path,
                    "Picture of the depth, as large as IN; its red is read, in the file's own units")
        ->required()
        ->type_name("D");
    command
        .add_option("--depth-is", options.isWord,
                    "disparity: larger is nearer (default); distance: larger is farther, infinity is far away")
        ->check(CLI::IsMember({"disparity", "distance"}))
        ->type_name("K");
    command
        .add_option("--depth-scale", options.scaleText,
                    "What 1 in the file is in the units of --focus: a number or A/B, as 0.001 of millimeters for "
                    "meters (default 1: floats as they are, 8 and 16-bit files in codes; but disparities of these "
                    "1/255 and 1/65535, so that white is 1)")
        ->type_name("S");
    command
        .add_option("--unknown", options.unknownWords,
                    "Values that say the depth is unknown: zero, nan, inf, several as in zero,nan, or none (default "
                    "zero,nan,inf; of distances zero,nan)")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(CLI::IsMember({"zero", "nan", "inf", "none"}))
        ->type_name("U");
    command
        .add_option("--focus", options.focusText,
                    "What is sharp: a disparity or a distance, or x,y: what is seen at that texel of IN")
        ->required()
        ->type_name("F");
}

void RequireWords(const DepthOptions& options) {
    ParseScale(options.scaleText);
    ParseFocus(options);
    if (options.unknownWords.size() > 1 && std::ranges::count(options.unknownWords, "none") > 0)
        throw UsageError("--unknown none: with other words; expected none alone, or some of zero, nan, inf");
}

DepthMap ReadDepth(const DepthOptions& options, const Picture& picture, const Device& device) {
    const DeviceLimits& limits = device.Limits();
    const Picture read = ReadPicture(options.path, {limits.maxSideTexels, limits.maxImageBytes});
    RequireSameSize(picture, read, options.path, "depth");
    const Extent2D extent{read.widthTexels, read.heightTexels};
    const Units units(options, read.stored);

    std::vector<float> depth(extent.Texels());
    for (size_t i = 0; i < depth.size(); i++) {
        const TexelPosition at{static_cast<uint32_t>(i % extent.widthTexels),
                               static_cast<uint32_t>(i / extent.widthTexels)};
        depth[i] = DepthOf(read.samples[i * read.channels], options, units, options.path, at);
    }
    if (!FillUnknown(depth, extent))
        throw Error("{}: the depth of every texel is unknown; --unknown says which values mean that", options.path);
    const double focus = FocusOf(options, depth, extent, units);
    if (!IsDistance(options)) return {std::move(depth), static_cast<float>(focus)};
    for (float& distance : depth)
        distance = static_cast<float>(std::min(focus / double{distance}, double{kNearest}));
    return {std::move(depth), 1};
}

}  // namespace boxcar
