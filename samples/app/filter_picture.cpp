#include "samples/app/filter_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/common.hpp>

#include "samples/app/bands.h"
#include "samples/app/light.h"
#include "tools/base/error.h"

namespace boxcar {
namespace {

bool IsRepeated(SATEdge edge) {
    return edge == SATEdge::Repeat || edge == SATEdge::Mirror;
}

template <typename Texel>
std::span<const Texel> RowsOf(const std::vector<Texel>& texels, uint32_t widthTexels, uint32_t first, uint32_t rows) {
    return std::span(texels).subspan(size_t{first} * widthTexels, size_t{rows} * widthTexels);
}

BlurDesc BlurFor(const Picture& picture, const FilterRequest& request, SATPrecision precision) {
    BlurDesc desc{.extent = {picture.widthTexels, picture.heightTexels},
                  .precision = precision,
                  .order = request.order,
                  .boxes = request.boxes,
                  .sides = request.sides,
                  .edge = request.edge,
                  .taps = request.taps,
                  .origin = request.origin,
                  .largestTexels = glm::max(request.minTexels, request.maxTexels)};
    if (precision == SATPrecision::FP32)
        desc.bias = request.bias.value_or(picture.stored == SampleType::Float32 ? BlurBias::None : BlurBias::Mean);
    return desc;
}

std::vector<Band> BandsFor(const Device& device, const BlurDesc& desc) {
    const Extent2D extent = desc.extent;
    const Extent2D reach = BlurReach(desc.order, desc.largestTexels);
    if (!IsRepeated(desc.edge)) return PlanBands(extent, reach.heightTexels);
    const uint32_t extendedWidth = extent.widthTexels + 2 * reach.widthTexels;
    const uint32_t extendedHeight = extent.heightTexels + 2 * reach.heightTexels;
    const uint32_t largestSide = device.Limits().maxSideTexels;
    if (desc.order > 1 && std::max(extendedWidth, extendedHeight) > largestSide)
        throw Error(
            "a kernel that reaches {} x {} texels over a repeated picture extends it to {} x {}; "
            "this device takes {} a side: a smaller --width, a box, or --edge clip",
            reach.widthTexels, reach.heightTexels, extendedWidth, extendedHeight, largestSide);
    return {{0, extent.heightTexels, 0, extent.heightTexels}};
}

// What is filtered: codes in one or several rounds, or light.
struct Source {
    const CodedPicture* codes = nullptr;
    const std::vector<glm::vec4>* light = nullptr;  // FP32

    size_t Rounds() const { return codes ? codes->Plan().rounds.size() : 1; }
    double Unit(size_t round) const { return codes ? codes->Plan().rounds[round].unit : 1; }

    WordImages Upload(Device& device, uint32_t widthTexels, size_t round, const Band& band) const {
        if (codes) return codes->Upload(device, round, band.firstRead, band.rowsRead);
        WordImages image(device, SATPrecision::FP32, {widthTexels, band.rowsRead}, "source");
        WriteTexels(device, *TexelWords(image).low,
                    std::as_bytes(RowsOf(*light, widthTexels, band.firstRead, band.rowsRead)));
        return image;
    }
};

// The whole picture filtered, band by band and round by round.
std::vector<glm::vec4> FilterBands(Device& device, const Source& source, BlurDesc desc, const FilterRequest& request,
                                   const std::vector<glm::vec4>& widthMap, Stats& stats) {
    const Extent2D extent = desc.extent;
    const uint32_t width = extent.widthTexels;
    std::vector<glm::vec4> filtered;
    filtered.reserve(extent.Texels());
    for (const Band& band : BandsFor(device, desc)) {
        desc.extent.heightTexels = band.rowsRead;
        std::optional<Image> map;
        if (!widthMap.empty())
            map = Upload(device, desc.extent, RowsOf(widthMap, width, band.firstRead, band.rowsRead), "widths");
        const SATWidths widths =
            map ? SATWidths(*map, request.minTexels, request.maxTexels) : SATWidths(request.maxTexels);
        // The finest round first, whose results are the smallest.
        const size_t first = filtered.size();
        filtered.resize(first + size_t{band.rows} * width, glm::vec4(0));
        for (size_t round = source.Rounds(); round-- > 0;) {
            if (source.codes) desc.codes = source.codes->Plan().rounds[round].codes;
            Blur blur(device, desc);
            const WordImages words = source.Upload(device, width, round, band);
            CommandList commands(device, CommandList::Timing::On);
            const Image& result = blur.Record(commands, words, widths);
            commands.SubmitAndWait();
            const auto rows = Download<glm::vec4>(device, result);
            const auto own = RowsOf(rows, width, band.firstRow - band.firstRead, band.rows);
            const double unit = source.Unit(round);
            for (size_t i = 0; i < own.size(); i++)
                filtered[first + i] += glm::vec4(unit * glm::dvec4(own[i]));
            AddTimes(stats.passes, commands.PassTimes());
            stats.deviceBytes = std::max(stats.deviceBytes, device.MemoryBytes());
            stats.tableBytes = std::max(stats.tableBytes, blur.TableBytes());
        }
    }
    return filtered;
}

// One line for texels whose width asks for more than the words hold, and which are NaN.
void ReportMarked(const std::vector<glm::vec4>& texels, const BlurDesc& desc, const SATCodes& codes,
                  const Picture& picture, SampleType result, const Tell& tell) {
    const auto marked = std::ranges::count_if(texels, [](const glm::vec4& texel) { return !IsFinite(texel); });
    if (marked == 0) return;
    const uint32_t side = SATLargestWidthTexels(desc.precision, codes, desc.order, false);
    tell(fmt::format("{} of {} texels ask for wider sums than {} holds ({} x {}) and are marked, as {}", marked,
                     texels.size(), SATPrecisionName(desc.precision), side, side,
                     result == SampleType::Float32 ? "NaN"
                     : picture.channels > 2        ? "magenta"
                                                   : "white"));
}

// One line where a sample of the file may be off by more than half a code; of a float file, by more than 1e-5 of the
// picture's mean.
//
//   bound  of what is filtered
void ReportBound(double bound, const std::vector<glm::vec4>& light, const Picture& picture, Transfer transfer,
                 SampleType result, const std::string& what, const Tell& tell) {
    constexpr const char* kAdvice = "leave out --precision for exact sums";
    if (result == SampleType::Float32) {
        glm::dvec4 mean(0);
        for (const glm::vec4& texel : light)
            mean += glm::abs(glm::dvec4(texel)) / static_cast<double>(light.size());
        const double largest = std::max({mean.x, mean.y, mean.z, mean.w});
        if (bound > 1e-5 * largest)
            tell(fmt::format("{}: the error of a sample is at most {:.2g}, of a mean of {:.2g}; {}", what, bound,
                             largest, kAdvice));
        return;
    }
    double codes = bound * (result == SampleType::Unorm8 ? 255 : 65535);
    if (transfer == Transfer::Srgb) {
        codes *= 12.92;  // the sRGB curve where it is steepest
        if (HasAlpha(picture)) {
            float least = 1;
            for (const glm::vec4& texel : light)
                if (const float alpha = texel[static_cast<int>(picture.channels) - 1]; alpha > 0)
                    least = std::min(least, alpha);
            codes /= least;
        }
    }
    if (codes > 0.5) tell(fmt::format("{}: the error of a sample is at most {:.2g} codes; {}", what, codes, kAdvice));
}

}  // namespace

double FloatTableBound(const std::vector<glm::vec4>& texels, Extent2D extent, const FilterRequest& request,
                       BlurBias bias) {
    glm::dvec4 mean(bias == BlurBias::Half ? 0.5 : 0.0), sum(0);
    if (bias == BlurBias::Mean) {
        for (const glm::vec4& texel : texels)
            mean += glm::dvec4(texel);
        mean /= static_cast<double>(texels.size());
    }
    for (const glm::vec4& texel : texels)
        sum += glm::abs(glm::dvec4(texel) - mean);
    double magnitudes = std::max({sum.x, sum.y, sum.z, sum.w});
    const glm::dvec2 sides(extent.widthTexels, extent.heightTexels);
    if (IsRepeated(request.edge)) {
        const glm::dvec2 period = (request.edge == SATEdge::Mirror ? 2.0 : 1.0) * sides;
        const glm::dvec2 reached = period * (glm::ceil(glm::dvec2(request.maxTexels) / period) + 1.0) / sides;
        magnitudes *= reached.x * reached.y;
    }
    const glm::dvec2 smallest = glm::max(glm::dvec2(glm::min(request.minTexels, request.maxTexels)), 1.0);
    // At a corner of the picture a quarter of the box, and half a texel of each axis, lies inside.
    const glm::dvec2 inside = request.edge == SATEdge::Clip ? glm::min(0.5 * smallest + 0.5, sides) : smallest;
    // A disc is pi / 4 of its square, a polygon a triangle at least; each of its boxes is as wrong as one.
    const double share = request.boxes == 1 ? 1 : request.sides == 0 ? 0.785 : 0.32;
    const auto depth = [](uint32_t side) { return std::bit_width(side - 1); };
    const int levels = depth(extent.widthTexels) + depth(extent.heightTexels);
    return request.boxes * (4.0 * levels + 20) * 0x1p-24 * magnitudes / (share * inside.x * inside.y);
}

std::vector<glm::vec4> FilterPicture(Device& device, const Picture& picture, const std::string& name,
                                     Transfer transfer, const FilterRequest& request,
                                     const std::vector<glm::vec4>& widthMap, SampleType result, Stats& stats,
                                     const Tell& tell) {
    const bool isInteger = request.precision != SATPrecision::FP32;
    const auto filterBands = [&](const Source& source, const BlurDesc& desc) {
        try {
            return FilterBands(device, source, desc, request, widthMap, stats);
        } catch (const Error& error) {
            throw Error("{}: {}", name, error.what());
        }
    };
    const bool isIdentity = widthMap.empty() && request.maxTexels.x <= 1 && request.maxTexels.y <= 1;
    if (isIdentity && !(request.precision && isInteger)) return ToLight(picture, transfer);
    if (isInteger) {
        const glm::vec2 size = glm::max(request.minTexels, request.maxTexels);
        const KernelSize kernel{size, request.order, widthMap.empty() && SATIsWhole(size, request.order)};
        const CodedPicture codes(picture, transfer,
                                 request.precision ? NamedCodes(picture, name, transfer, *request.precision)
                                                   : FittingCodes(picture, name, transfer, result, kernel));
        const BlurDesc desc = BlurFor(picture, request, codes.Plan().precision);
        std::vector<glm::vec4> filtered = filterBands({.codes = &codes}, desc);
        ReportMarked(filtered, desc, codes.Plan().rounds[0].codes, picture, result, tell);
        AddPlan(stats, codes.Plan());
        if (request.precision && picture.stored != SampleType::Float32 && transfer == Transfer::Srgb)
            ReportBound(0.5 * stats.step, ToLight(picture, transfer), picture, transfer, result,
                        fmt::format("{}: {} by name sums light in steps of 1 / 65535", name, stats.precision), tell);
        return filtered;
    }
    const BlurDesc desc = BlurFor(picture, request, SATPrecision::FP32);
    const std::vector<glm::vec4> light = ToLight(picture, transfer);
    std::vector<glm::vec4> filtered = filterBands({.light = &light}, desc);
    RequireFiniteSums(filtered, name);
    ReportBound(FloatTableBound(light, desc.extent, request, desc.bias), light, picture, transfer, result,
                name + ": fp32 sums round", tell);
    stats.precision = SATPrecisionName(SATPrecision::FP32);
    return filtered;
}

}  // namespace boxcar
