#include "samples/cli/precision/figures.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "samples/cli/plot.h"
#include "samples/cli/precision/precision.h"

namespace boxcar {
namespace {

// Hensley 2005, sect. 4: both of its means together, and none.
constexpr Bias kOurBias = Bias::Mean;
constexpr SATOrigin kOurOrigin = SATOrigin::Center;

Case Ours(Precision precision) {
    return {precision, kOurBias, kOurOrigin};
}
Case Old(Precision precision) {
    return {precision, Bias::None, SATOrigin::Corner};
}

// A rectangle of a picture, which repeats.
Picture Cut(const Picture& from, uint32_t x0, uint32_t y0, uint32_t width, uint32_t height) {
    Picture cut{width, height, from.channels, from.stored, {}};
    for (uint32_t y = y0; y < y0 + height; y++)
        for (uint32_t x = x0; x < x0 + width; x++)
            for (uint32_t c = 0; c < from.channels; c++)
                cut.samples.push_back(
                    from.samples[(size_t{y % from.heightTexels} * from.widthTexels + x % from.widthTexels) *
                                     from.channels +
                                 c]);
    return cut;
}

// Each texel as a square of `times` x `times`.
Picture Enlarged(const Picture& from, uint32_t times) {
    Picture large{from.widthTexels * times, from.heightTexels * times, from.channels, from.stored, {}};
    for (uint32_t y = 0; y < large.heightTexels; y++)
        for (uint32_t x = 0; x < large.widthTexels; x++)
            for (uint32_t c = 0; c < from.channels; c++)
                large.samples.push_back(
                    from.samples[(size_t{y / times} * from.widthTexels + x / times) * from.channels + c]);
    return large;
}

Picture Checkerboard(uint32_t sideTexels, uint32_t squareTexels) {
    Picture board{sideTexels, sideTexels, 3, SampleType::Unorm8, {}};
    for (uint32_t y = 0; y < sideTexels; y++)
        for (uint32_t x = 0; x < sideTexels; x++)
            board.samples.insert(board.samples.end(), 3,
                                 static_cast<float>((x / squareTexels + y / squareTexels) % 2));
    return board;
}

std::string SnrText(const Measurement& measured) {
    if (!measured.snrDb) return "overflow";
    return std::isinf(*measured.snrDb) ? "exact" : fmt::format("{:.1f} dB", *measured.snrDb);
}

class Figures {
public:
    Figures(Device& device, std::filesystem::path folder) : m_device(device), m_folder(std::move(folder)) {}

    GallerySection OldAndOurs(const Picture& photograph);
    GallerySection Curves(const Picture& photograph);

private:
    // The picture as its table gives it back.
    Picture GivenBack(Meter& meter, const Picture& like, const Case& setup) {
        Picture back = like;
        back.samples.clear();
        for (const glm::vec4& texel : meter.Identity(setup))
            for (uint32_t c = 0; c < like.channels; c++)
                back.samples.push_back(texel[static_cast<int>(c)]);
        return back;
    }

    Device& m_device;
    std::filesystem::path m_folder;
};

GallerySection Figures::OldAndOurs(const Picture& photograph) {
    constexpr uint32_t kSide = 256;
    constexpr uint32_t kZoom = 64;
    GallerySection section{
        "Pictures given back by tables of few bits",
        "Hensley 2005, Fig. 4; Scheuermann 2005 (without and with improved precision)",
        "Each picture is summed, and every texel read back as a box of 1 x 1. The old method sums from the corner: "
        "its "
        "entries grow to the right and down, and their rounding with them. Ours takes the mean off and sums outwards "
        "from the centre. Below: the lower right of the photograph, enlarged.",
        {},
        {}};
    const auto row = [&](const std::string& name, const std::string& what, const Picture& picture,
                         Precision precision) {
        Meter meter(m_device, SubjectOf(picture, Transfer::Raw), {1});
        const Case cases[] = {Ours(precision), Old(precision)};
        const char* words[] = {"ours", "old"};
        std::vector<Picture> back = {picture};
        section.figures.push_back(SaveFigure(m_folder, fmt::format("precision_{}_original.png", name), picture,
                                             fmt::format("{}, the original.", what)));
        for (int i = 0; i < 2; i++) {
            back.push_back(GivenBack(meter, picture, cases[i]));
            section.figures.push_back(
                SaveFigure(m_folder, fmt::format("precision_{}_{}.png", name, words[i]), back.back(),
                           fmt::format("{}, {}: {}.", Name(precision), i == 0 ? "ours" : "old method",
                                       SnrText(meter.Measure(cases[i])))));
        }
        return back;
    };
    row("checkerboard", "A checkerboard", Checkerboard(kSide, 16), Precision::Fp16);
    const std::vector<Picture> back =
        row("photograph", "A photograph", Cut(photograph, 128, 128, kSide, kSide), Precision::Fp24);
    const char* words[] = {"original", "ours", "old"};
    for (size_t i = 0; i < back.size(); i++)
        section.figures.push_back(
            SaveFigure(m_folder, fmt::format("precision_zoom_{}.png", words[i]),
                       Enlarged(Cut(back[i], kSide - kZoom, kSide - kZoom, kZoom, kZoom), kSide / kZoom),
                       fmt::format("{} x {} texels of it, {}.", kZoom, kZoom, i == 2 ? "old method" : words[i])));
    return section;
}

GallerySection Figures::Curves(const Picture& photograph) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    constexpr Precision kFloats[] = {Precision::Fp16, Precision::Fp24, Precision::Fp32};
    GallerySection section{
        "What a bit, a bias and an origin are worth",
        "Hensley 2005, sect. 4; Scheuermann 2005 (\"errors are unbiased and average out\"); Green 2003",
        "Measured on this device by the command boxcar precision. Left: the photograph, cut or repeated to each "
        "size. "
        "A mantissa bit is worth 6 dB, twice the side costs 12 dB. Second: 160 x 160 texels of it. A wider box has "
        "the "
        "same four roundings under a larger area, so its error falls as 1 / width^2; a serial scan (Green's lines) "
        "begins lower and falls slower. A table of whole codes (u32) has no error at any size or width: it does not "
        "fit on these axes.",
        {},
        {}};

    Plot sizes{.title = "Signal to noise of the 1 x 1 box",
               .xLabel = "side of the picture, texels",
               .yLabel = "SNR, dB",
               .xTicks = {32, 64, 128, 256, 512, 1024},
               .curves = {},
               .notes = {"ours: less the mean, from the centre", "old: from the corner",
                         "old fp16 ends where sums overflow", "u32: exact at every size"}};
    for (int i = 0; i < 3; i++) {
        sizes.curves.push_back({fmt::format("{}, ours", Name(kFloats[i])), {}, i, false});
        sizes.curves.push_back({fmt::format("{}, old", Name(kFloats[i])), {}, i, true});
    }
    for (const double side : sizes.xTicks) {
        const auto sideTexels = static_cast<uint32_t>(side);
        Meter meter(m_device, SubjectOf(Cut(photograph, 0, 0, sideTexels, sideTexels), Transfer::Raw), {1});
        for (size_t i = 0; i < 3; i++) {
            sizes.curves[2 * i].points.emplace_back(side, meter.Measure(Ours(kFloats[i])).snrDb.value_or(kNone));
            sizes.curves[2 * i + 1].points.emplace_back(side, meter.Measure(Old(kFloats[i])).snrDb.value_or(kNone));
        }
    }
    section.figures.push_back(
        SaveFigure(m_folder, "precision_by_size.svg", sizes, "Signal to noise by the side of the picture."));

    Plot widths{
        .title = "RMS error of the mean over a box",
        .xLabel = "width of the box, texels",
        .yLabel = "RMS error, white = 1",
        .xTicks = {1, 3, 9, 33, 129},
        .yLog = true,
        .curves = {},
        .notes = {"ours, old: as in the other plot", "u32: 0 at every width", "half a step of 8 bits: 0.002"}};
    // A serial scan draws a column at a time, which validation layers take the longer over the more there are.
    Meter meter(m_device, SubjectOf(Cut(photograph, 176, 160, 160, 160), Transfer::Raw));
    const auto add = [&](const std::string& label, const Case& setup, int color, bool dashed) {
        Curve& curve = widths.curves.emplace_back(Curve{label, {}, color, dashed});
        for (const auto& [sizeTexels, rms] : meter.Measure(setup).widths)
            curve.points.emplace_back(sizeTexels, rms.value_or(kNone));
    };
    add("fp16, ours", Ours(Precision::Fp16), 0, false);
    add("fp24, ours", Ours(Precision::Fp24), 1, false);
    add("fp24, old", Old(Precision::Fp24), 1, true);
    add("fp24 truncated, ours", Ours(Precision::Fp24Truncated), 3, false);
    add("fp32, ours", Ours(Precision::Fp32), 2, false);
    add("fp32, old", Old(Precision::Fp32), 2, true);
    add("fp32, serial scan", {.taps = 2, .builder = Builder::Lines}, 4, true);
    section.figures.push_back(
        SaveFigure(m_folder, "precision_by_width.svg", widths, "Error by the width of the box."));
    return section;
}

}  // namespace

void AddPrecisionSections(Device& device, const std::filesystem::path& folder, const Picture& photograph,
                          std::vector<GallerySection>& sections) {
    Figures figures(device, folder);
    sections.push_back(figures.OldAndOurs(photograph));
    sections.push_back(figures.Curves(photograph));
}

}  // namespace boxcar
