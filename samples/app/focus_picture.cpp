#include "samples/app/focus_picture.h"

#include <algorithm>

#include "runtime/passes/layered_depth_of_field.h"
#include "samples/app/codes.h"
#include "samples/app/light.h"
#include "tools/base/error.h"

namespace boxcar {

std::vector<glm::vec4> FocusPicture(Device& device, const Picture& picture, const std::string& name,
                                    Transfer transfer, const FocusRequest& request,
                                    const std::vector<glm::vec4>& disparity, SampleType result, Stats& stats) {
    const CodedPicture codes(
        picture, transfer,
        FittingCodes(picture, name, transfer, result, {.sizeTexels = glm::vec2(request.largestTexels)}));
    DepthOfFieldDesc desc{.extent = {picture.widthTexels, picture.heightTexels},
                          .taps = request.taps,
                          .boxes = request.boxes,
                          .sides = request.sides,
                          .largestTexels = request.largestTexels,
                          .precision = codes.Plan().precision};
    const Image depth = Upload(device, desc.extent, std::span(disparity), "disparity");
    std::vector<glm::vec4> focused(desc.extent.Texels(), glm::vec4(0));
    // The finest round first, whose results are the smallest.
    for (size_t round = codes.Plan().rounds.size(); round-- > 0;) {
        desc.codes = codes.Plan().rounds[round].codes;
        DepthOfField effect(device, desc);
        const WordImages words = codes.Upload(device, round, 0, picture.heightTexels);
        CommandList commands(device, CommandList::Timing::On);
        const Image& image = effect.Record(commands, words, depth, request.lens);
        commands.SubmitAndWait();
        const auto texels = Download<glm::vec4>(device, image);
        const double unit = codes.Plan().rounds[round].unit;
        for (size_t i = 0; i < texels.size(); i++)
            focused[i] += glm::vec4(unit * glm::dvec4(texels[i]));
        AddTimes(stats.passes, commands.PassTimes());
        stats.deviceBytes = std::max(stats.deviceBytes, device.MemoryBytes());
    }
    AddPlan(stats, codes.Plan());
    stats.tableBytes = SummedAreaTableBytes(desc.extent, desc.precision);
    return focused;
}

std::vector<glm::vec4> FocusPictureByLayers(Device& device, const Picture& picture, const std::string& name,
                                            Transfer transfer, const FocusRequest& request,
                                            const std::vector<glm::vec4>& disparity, SampleType result,
                                            Stats& stats) {
    constexpr int kLayersPerSide = 8;
    if (HasAlpha(picture))
        throw Error("{}: {} channels; --method layered takes pictures without alpha", name, picture.channels);
    std::vector<glm::vec4> texels = ToLight(picture, transfer);
    float nearest = 0;
    for (size_t i = 0; i < texels.size(); i++) {
        const float most = std::max({texels[i].r, texels[i].g, texels[i].b});
        if (!(most <= kBrightestLensLight))
            throw Error("{}: a sample of {:g}; --method layered takes at most {:g}, --method single takes any", name,
                        most, kBrightestLensLight);
        texels[i].a = disparity[i].a;
        nearest = std::max(nearest, disparity[i].a);
    }
    const LayeredDepthOfFieldDesc desc{.extent = {picture.widthTexels, picture.heightTexels},
                                       .boxes = request.boxes,
                                       .sides = request.sides,
                                       .largestTexels = request.largestTexels,
                                       .codes = LensCodes(result == SampleType::Unorm8 ? 20 : 28)};
    LayeredDepthOfField effect(device, desc);
    const Image image = Upload(device, desc.extent, std::span<const glm::vec4>(texels), "picture and disparity");
    CommandList commands(device, CommandList::Timing::On);
    const Image& focused = effect.Record(commands, image, nullptr, request.lens, nearest, kLayersPerSide);
    commands.SubmitAndWait();
    stats.precision = SATPrecisionName(effect.Precision());
    stats.step = 1.0 / desc.codes.scale;
    stats.tableBytes = SummedAreaTableBytes(desc.extent, effect.Precision());
    stats.passes = commands.PassTimes();
    stats.deviceBytes = device.MemoryBytes();
    return Download<glm::vec4>(device, focused);
}

}  // namespace boxcar
