#include <algorithm>
#include <cmath>
#include <string_view>

#include "samples/files/codecs.h"
#include "samples/files/color.h"
#include "samples/files/icc_profile.h"

namespace boxcar {
namespace {

// IEC 61966-2-1:1999, sect. 4.1; ITU-R BT.709 has the same.
constexpr Primaries kSrgbPrimaries = {0.64f, 0.33f, 0.30f, 0.60f, 0.15f, 0.06f, 0.3127f, 0.3290f};
constexpr float kSamePrimaries = 0.002f;  // files round them to three digits, or take another digit for white

bool AreSrgb(const Primaries& primaries) {
    return std::equal(primaries.begin(), primaries.end(), kSrgbPrimaries.begin(),
                      [](float a, float b) { return std::abs(a - b) <= kSamePrimaries; });
}

// Some programs write zeros where they know nothing.
bool SpanATriangle(const Primaries& p) {
    const float area = (p[2] - p[0]) * (p[5] - p[1]) - (p[4] - p[0]) * (p[3] - p[1]);
    return std::isfinite(area) && area != 0.0f && p[7] > 0.0f &&
           std::all_of(p.begin(), p.end(), [](float c) { return std::abs(c) <= 2.0f; });
}

bool HoldsPrimaries(FileFormat format, const Primaries& primaries) {
    if (format == FileFormat::Png)  // cHRM has no sign
        return std::all_of(primaries.begin(), primaries.end(), [](float c) { return c >= 0.0f; });
    return format == FileFormat::Exr;
}

}  // namespace

void SetPrimaries(Picture& picture, const Primaries& primaries) {
    if (picture.channels > 2 && SpanATriangle(primaries) && !AreSrgb(primaries))
        picture.colorSpace.primaries = primaries;
}

void LeaveOutProfile(Picture& picture, std::string_view space) {
    space = space.substr(0, space.find_last_not_of(' ') + 1);
    picture.notes.push_back(space.empty()
                                ? "its ICC profile is damaged and left out"
                                : fmt::format("its ICC profile is for {} and is left out; the picture is {} here",
                                              space, picture.channels > 2 ? "RGB" : "gray"));
}

// ICC.1:2010, sect. 7.2: size (bytes 0 to 3), color space (16 to 19), "acsp" (36 to 39)
void SetIccProfile(Picture& picture, ByteView profile) {
    constexpr size_t kHeaderBytes = 128;
    const std::string_view text(reinterpret_cast<const char*>(profile.data()), profile.size());
    if (text.size() < kHeaderBytes || text.substr(36, 4) != "acsp") return LeaveOutProfile(picture, "");
    const std::string_view space = text.substr(16, 4);
    if (space != (picture.channels > 2 ? "RGB " : "GRAY")) return LeaveOutProfile(picture, space);
    picture.colorSpace.iccProfile.assign(profile.begin(), profile.end());
    const std::optional<double> half = LightOfHalf(profile);
    if (half && !IsLightOfSrgbHalf(*half))
        picture.notes.push_back(
            fmt::format("its ICC profile's curve is not used: 0.5 is light of {:.2f} by it and of {:.2f} by sRGB's",
                        *half, SrgbToLinear(0.5)));
}

bool HasSrgbColors(const ColorSpace& space) {
    return !space.primaries && (space.iccProfile.empty() || IsSrgbProfile(space.iccProfile));
}

std::string LostColorSpace(const ColorSpace& space, FileFormat format) {
    std::string lost;
    const auto add = [&](std::string_view name) { lost += fmt::format("{}{}", lost.empty() ? "" : ", ", name); };
    const bool holdsProfile = format == FileFormat::Png || format == FileFormat::Jpeg;
    if (!holdsProfile && !space.iccProfile.empty() && !IsSrgbProfile(space.iccProfile)) add("ICC profile");
    if (space.gamma != 0.0 && format != FileFormat::Png) add(fmt::format("gamma of {:g}", space.gamma));
    if (space.primaries && !HoldsPrimaries(format, *space.primaries)) add("primaries");
    if (lost.empty()) return {};
    return fmt::format(
        "{} cannot hold the input's {}: its colors will be taken for {}", FormatName(format), lost,
        format == FileFormat::Exr || format == FileFormat::Pfm ? "linear light of sRGB's primaries" : "sRGB");
}

}  // namespace boxcar
