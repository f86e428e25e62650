#include "samples/cli/bspline_figures.h"

#include <fmt/format.h>

#include <cmath>

#include "runtime/passes/quad_shaders.h"
#include "runtime/passes/resize.h"
#include "samples/app/device_run.h"
#include "samples/app/light.h"
#include "samples/cli/plot.h"

namespace boxcar {
namespace {

using Texels = std::vector<glm::vec4>;

constexpr std::pair<ResizeFilter, const char*> kFilters[] = {
    {ResizeFilter::Nearest, "nearest"},
    {ResizeFilter::Linear, "linear"},
    {ResizeFilter::BSpline, "cubic B-spline"},
    {ResizeFilter::CatmullRom, "Catmull-Rom"},
    {ResizeFilter::InterpolatingBSpline, "interpolating B-spline"},
};

class Figures {
public:
    Figures(Device& device, std::filesystem::path folder) : m_device(device), m_folder(std::move(folder)) {}

    GallerySection Kernels();
    GallerySection Larger(const Picture& photograph);
    GallerySection Smaller();

private:
    Texels Resized(const Texels& source, const ResizeDesc& desc) {
        const Image image = Upload(m_device, desc.source, std::span(source), "source");
        Resize resize(m_device, desc);
        CommandList commands(m_device);
        const Image& result = resize.Record(commands, image);
        commands.SubmitAndWait();
        return Download<glm::vec4>(m_device, result);
    }

    Texels Weights(int order, uint32_t points) {
        const Pipeline pipeline(m_device, QuadShaders(fmt::format("bspline_weights.ps.ORDER={}", order)));
        const Image result(m_device, {{points, 1}, Format::RGBA32F, "weights"});
        const BSplineWeightsConstants constants{static_cast<float>(points)};
        CommandList commands(m_device);
        commands.Draw(
            {.name = "weights", .pipeline = pipeline, .writes = {&result}, .constants = ConstantBytes(constants)});
        commands.SubmitAndWait();
        return Download<glm::vec4>(m_device, result);
    }

    Device& m_device;
    std::filesystem::path m_folder;
};

GallerySection Figures::Kernels() {
    GallerySection section{
        "The cubic B-spline, its derivatives and its relatives",
        "Sigg 2005, Fig. 20-1",
        "Each curve was read back from the device. Left: the weight of a texel by its distance, and its slopes: the "
        "second derivative is still continuous. Right: what one white texel becomes when it is made larger. Only "
        "curves that are 0 at all other texels give the texels back.",
        {},
        {}};
    constexpr uint32_t kPoints = 64;
    Plot derivatives{.title = "Cubic B-spline",
                     .xLabel = "distance, texels",
                     .yLabel = "weight",
                     .xTicks = {-3, -2, -1, 0, 1, 2, 3},
                     .xLog = false,
                     .yStep = 0.5,
                     .curves = {},
                     .notes = {}};
    constexpr const char* kNames[] = {"value", "first derivative", "second derivative"};
    for (int order = 0; order < 3; order++) {
        const Texels weights = Weights(order, kPoints);
        Curve curve{kNames[order], {}, order, order > 0, false};
        curve.points.emplace_back(-3, 0);
        curve.points.emplace_back(-2, 0);
        for (int texel = 3; texel >= 0; texel--)
            for (uint32_t i = 0; i < kPoints; i++)
                curve.points.emplace_back((i + 0.5) / kPoints + 1 - texel, weights[i][texel]);
        curve.points.emplace_back(2, 0);
        curve.points.emplace_back(3, 0);
        derivatives.curves.push_back(std::move(curve));
    }
    section.figures.push_back(SaveFigure(m_folder, "bspline_derivatives.svg", derivatives,
                                         "The weights of BSplineWeights, BSplineWeights1 and 2."));

    constexpr uint32_t kTexels = 11, kScale = 40;
    Texels impulse(kTexels, glm::vec4(0));
    impulse[kTexels / 2] = glm::vec4(1);
    Plot responses{.title = "One white texel, larger",
                   .xLabel = "distance, texels",
                   .yLabel = "value",
                   .xTicks = {-5, -4, -3, -2, -1, 0, 1, 2, 3, 4, 5},
                   .xLog = false,
                   .yStep = 0.25,
                   .curves = {},
                   .notes = {}};
    for (size_t f = 0; f < std::size(kFilters); f++) {
        const Texels wide =
            Resized(impulse, {{kTexels, 1}, {kTexels * kScale, 1}, {1.0f / kScale, 1}, kFilters[f].first});
        Curve curve{kFilters[f].second, {}, static_cast<int>(f), f == 0, false};
        for (uint32_t x = kScale / 2; x + kScale / 2 < kTexels * kScale; x++)
            curve.points.emplace_back((x + 0.5) / kScale - 0.5 * kTexels, wide[x].x);
        responses.curves.push_back(std::move(curve));
    }
    section.figures.push_back(
        SaveFigure(m_folder, "bspline_responses.svg", responses, "The five filters of boxcar resize."));
    return section;
}

GallerySection Figures::Larger(const Picture& photograph) {
    GallerySection section{
        "Larger by third-order filters: boxcar resize --scale 8",
        "Sigg 2005, Fig. 20-3",
        "A piece of the photograph, eight times as large. Look at the rims of the highlights: linear interpolation "
        "draws them as diamonds and crosses. The B-spline has none of that, but smooths; the other two go through "
        "the "
        "texels.",
        {},
        {}};
    constexpr Extent2D kPiece{60, 48}, kLarge{480, 384};
    constexpr uint32_t kLeft = 205, kTop = 165;
    const Texels light = ToLight(photograph, Transfer::Srgb);
    Texels piece;
    for (uint32_t y = 0; y < kPiece.heightTexels; y++)
        for (uint32_t x = 0; x < kPiece.widthTexels; x++)
            piece.push_back(light[(kTop + y) * photograph.widthTexels + kLeft + x]);
    const Picture like{kLarge.widthTexels, kLarge.heightTexels, photograph.channels, photograph.stored, {}};
    for (const auto& [filter, name] : kFilters) {
        const Texels large = Resized(piece, {kPiece, kLarge, float2(0.125f), filter});
        section.figures.push_back(SaveFigure(m_folder, fmt::format("larger_{}.png", section.figures.size()),
                                             FromLight(large, like, Transfer::Srgb, SampleType::Unorm8),
                                             fmt::format("{}.", name)));
    }
    return section;
}

GallerySection Figures::Smaller() {
    GallerySection section{
        "Smaller without aliases: boxcar resize --scale 0.25",
        "beyond the papers",
        "Rings that are finer the farther they are from the middle, a quarter as large. Beyond half of the way out "
        "the small picture cannot hold them. One texel of sixteen shows rings that are not there; under kernels as "
        "wide as the small picture's texels they become gray, the sooner the more the kernel smooths.",
        {},
        {}};
    constexpr Extent2D kPlate{1200, 1200}, kSmall{300, 300};
    Texels plate;
    for (uint32_t y = 0; y < kPlate.heightTexels; y++)
        for (uint32_t x = 0; x < kPlate.widthTexels; x++) {
            const double dx = x - 599.5, dy = y - 599.5;
            plate.emplace_back(0.5 + 0.5 * std::cos((dx * dx + dy * dy) * 3.14159265358979 / 2 / 1200));
        }
    const Picture like{kSmall.widthTexels, kSmall.heightTexels, 1, SampleType::Unorm8, {}};
    for (const auto& [filter, name] : kFilters) {
        const Texels small = Resized(plate, {kPlate, kSmall, float2(4), filter});
        section.figures.push_back(SaveFigure(m_folder, fmt::format("smaller_{}.png", section.figures.size()),
                                             FromLight(small, like, Transfer::Raw, SampleType::Unorm8),
                                             fmt::format("{}.", name)));
    }
    return section;
}

}  // namespace

void AddBSplineSections(Device& device, const std::filesystem::path& folder, const Picture& photograph,
                        std::vector<GallerySection>& sections) {
    Figures figures(device, folder);
    sections.push_back(figures.Kernels());
    sections.push_back(figures.Larger(photograph));
    sections.push_back(figures.Smaller());
}

}  // namespace boxcar
