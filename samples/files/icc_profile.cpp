// ICC.1:2010: a header of 128 bytes; the number of tags (4 bytes) and for each its name, offset and size (4 each); a
// tag begins with its type (4) and 4 bytes that are reserved.
#include "samples/files/icc_profile.h"

#include <array>
#include <cmath>
#include <string_view>

#include "samples/files/color.h"

namespace boxcar {
namespace {

uint32_t Word(ByteView bytes, size_t at) {
    return uint32_t{bytes[at]} << 24 | uint32_t{bytes[at + 1]} << 16 | uint32_t{bytes[at + 2]} << 8 | bytes[at + 3];
}

double Fixed(ByteView bytes, size_t at) {
    return static_cast<int32_t>(Word(bytes, at)) / 65536.0;
}

std::string_view Text(ByteView bytes, size_t at) {
    return {reinterpret_cast<const char*>(bytes.data()) + at, 4};
}

// Empty where there is no such tag.
ByteView FindTag(ByteView profile, std::string_view name) {
    constexpr size_t kTable = 128, kEntryBytes = 12;
    if (profile.size() < kTable + 4) return {};
    const size_t entries = (profile.size() - kTable - 4) / kEntryBytes;
    for (size_t i = 0; i < std::min<size_t>(Word(profile, kTable), entries); ++i) {
        const size_t entry = kTable + 4 + i * kEntryBytes;
        const size_t offset = Word(profile, entry + 4), size = Word(profile, entry + 8);
        if (Text(profile, entry) != name) continue;
        if (offset > profile.size() || size > profile.size() - offset) return {};
        return profile.subspan(offset, size);
    }
    return {};
}

// sect. 10.5: gamma where there is one number, else a table over the codes
std::optional<double> HalfByTable(ByteView curve) {
    const size_t count = Word(curve, 8);
    if (count == 0) return 0.5;
    const auto entry = [&](size_t i) { return curve[12 + 2 * i] << 8 | curve[13 + 2 * i]; };
    if ((curve.size() - 12) / 2 < count) return {};
    if (count == 1) return std::pow(0.5, entry(0) / 256.0);
    return (entry((count - 1) / 2) + entry(count / 2)) / 2.0 / 65535;
}

// sect. 10.15: (a code + b)^g, all of the five kinds above their lower part
std::optional<double> HalfByFormula(ByteView curve) {
    constexpr size_t kCounts[] = {1, 3, 4, 5, 7};
    const size_t kind = Word(curve, 8) >> 16;
    if (kind >= std::size(kCounts) || curve.size() < 12 + 4 * kCounts[kind]) return {};
    const auto number = [&](size_t i) { return Fixed(curve, 12 + 4 * i); };
    if (kind == 0) return std::pow(0.5, number(0));
    const double added = kind == 2 ? number(3) : kind == 4 ? number(5) : 0.0;
    return std::pow(number(1) * 0.5 + number(2), number(0)) + added;
}

}  // namespace

std::optional<double> LightOfHalf(ByteView profile) {
    ByteView curve = FindTag(profile, "rTRC");
    if (curve.empty()) curve = FindTag(profile, "kTRC");
    if (curve.size() < 12) return {};
    const std::string_view type = Text(curve, 0);
    return type == "curv" ? HalfByTable(curve) : type == "para" ? HalfByFormula(curve) : std::nullopt;
}

bool IsLightOfSrgbHalf(double light) {
    return std::abs(light - SrgbToLinear(0.5)) < 0.02;
}

bool IsSrgbProfile(ByteView profile) {
    const std::optional<double> half = LightOfHalf(profile);
    if (!half || !IsLightOfSrgbHalf(*half)) return false;
    if (Text(profile, 16) == "GRAY") return true;
    // IEC 61966-2-1, adapted to D50 as profiles are
    constexpr std::pair<const char*, std::array<double, 3>> kColorants[] = {
        {"rXYZ", {0.4361, 0.2225, 0.0139}}, {"gXYZ", {0.3851, 0.7169, 0.0971}}, {"bXYZ", {0.1431, 0.0606, 0.7141}}};
    for (const auto& [name, expected] : kColorants) {
        const ByteView tag = FindTag(profile, name);
        if (tag.size() < 20) return false;
        for (size_t i = 0; i < 3; ++i)
            if (std::abs(Fixed(tag, 8 + 4 * i) - expected[i]) > 0.003) return false;
    }
    return true;
}

}  // namespace boxcar
