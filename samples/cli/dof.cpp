#include "samples/cli/dof.h"

#include <algorithm>
#include <memory>

#include "samples/cli/batch.h"
#include "samples/cli/codes.h"
#include "samples/cli/device_run.h"
#include "samples/cli/disparity.h"
#include "samples/cli/light.h"
#include "samples/effects/layered_depth_of_field.h"

namespace boxcar {
namespace {

constexpr int kLayersPerSide = 8;

struct DofOptions : BatchOptions {
    std::string depth;
    std::string depthIs = "disparity";
    std::string method = "single";
    double focus = -1;
    double aperture = -1;
    TapsOption taps;
    DiscOptions disc;
};

void RequirePossible(const DofOptions& options) {
    if (options.files.inputs.size() > 1)
        throw UsageError("{} inputs: dof takes one picture and its --depth", options.files.inputs.size());
    if (options.depth == "-" && options.files.inputs[0] == "-")
        throw UsageError("--depth - and IN -: both would read standard input");
    if (!(options.focus >= 0 && options.focus <= 1))
        throw UsageError("--focus {:g}: expected 0 to 1, a grey of the depth", options.focus);
    if (!(options.aperture >= 0 && options.aperture <= kMaxSizeTexels))
        throw UsageError("--aperture {:g}: expected texels, 0 to {:.0f}", options.aperture, kMaxSizeTexels);
}

// Disparity of every texel, in alpha.
std::vector<glm::vec4> ReadDisparity(const Picture& picture, const Device& device, const DofOptions& options) {
    const Picture depth = ReadBeside(picture, options.depth, "depth", device, options.read);
    std::vector<float> disparity;
    for (size_t i = 0; i < depth.samples.size(); i += depth.channels) {
        if (depth.samples[i] < 0)
            throw Error("{}: {:g} in its red; depth is 0 (unknown) or more", options.depth, depth.samples[i]);
        disparity.push_back(depth.samples[i]);
    }
    if (options.depthIs == "distance") DistanceToDisparity(disparity);
    FillUnknown(disparity, {depth.widthTexels, depth.heightTexels});
    std::vector<glm::vec4> texels;
    for (const float value : disparity)
        texels.emplace_back(0, 0, 0, value);
    return texels;
}

// A picture with what stands in every method.
struct Photograph {
    const Picture& picture;
    const std::string& name;
    Transfer transfer;
    Extent2D extent;
    std::vector<glm::vec4> depth;
    Lens lens;
    float largestTexels;  // circle of confusion
};

struct Focused {
    std::vector<glm::vec4> texels;
    SATPrecision precision;
    std::vector<PassTime> passes;
};

Focused FocusByOneTable(Device& device, const Photograph& photograph, const DofOptions& options) {
    const auto& [picture, name, transfer, extent, depth, lens, largestTexels] = photograph;
    DepthOfFieldDesc desc{.extent = extent,
                          .taps = options.taps.Count(),
                          .boxes = options.disc.Boxes(),
                          .sides = options.disc.Sides(),
                          .largestTexels = largestTexels};
    UploadedWords words;
    if (picture.stored == SampleType::Unorm8) {
        // 16 bits of linear light are enough for 8 of sRGB, and are summed without a rounding.
        desc.codes = CodesFor(picture, name, transfer, SATPrecision::U32);
        desc.precision = SATExactPrecision(glm::vec2(desc.largestTexels), 1, false, desc.codes);
        words = UploadCodes(device, picture, transfer, desc.precision, 0, extent.heightTexels);
    } else {
        desc.precision = SATPrecision::FP32;
        desc.bias = picture.stored == SampleType::Float32 ? BlurBias::None : BlurBias::Mean;
        words.images.push_back(
            Upload(device, extent, std::span<const glm::vec4>(ToLight(picture, transfer)), "color"));
    }
    DepthOfField effect(device, desc);
    const Image disparity = Upload(device, extent, std::span(depth), "disparity");
    CommandList commands(device, CommandList::Timing::On);
    const Image& result = effect.Record(commands, words, disparity, lens);
    commands.SubmitAndWait();
    return {Download<glm::vec4>(device, result), desc.precision, commands.PassTimes()};
}

Focused FocusByLayers(Device& device, const Photograph& photograph, const DofOptions& options) {
    const auto& [picture, name, transfer, extent, depth, lens, largestTexels] = photograph;
    if (picture.channels == 2 || picture.channels == 4)
        throw Error("{}: {} channels; --method layered takes pictures without alpha", name, picture.channels);
    std::vector<glm::vec4> texels = ToLight(picture, transfer);
    float nearest = 0;
    for (size_t i = 0; i < texels.size(); i++) {
        const float most = std::max({texels[i].r, texels[i].g, texels[i].b});
        if (!(most <= kBrightestLensLight))
            throw Error("{}: light of {:g}; --method layered takes it up to {:g}", name, most, kBrightestLensLight);
        texels[i].a = depth[i].a;
        nearest = std::max(nearest, depth[i].a);
    }
    const LayeredDepthOfFieldDesc desc{.extent = extent,
                                       .boxes = options.disc.Boxes(),
                                       .sides = options.disc.Sides(),
                                       .largestTexels = largestTexels};
    LayeredDepthOfField effect(device, desc);
    const Image image = Upload(device, extent, std::span<const glm::vec4>(texels), "picture and disparity");
    CommandList commands(device, CommandList::Timing::On);
    const Image& result = effect.Record(commands, image, nullptr, lens, nearest, kLayersPerSide);
    commands.SubmitAndWait();
    return {Download<glm::vec4>(device, result), effect.Precision(), commands.PassTimes()};
}

Stats Focus(Device& device, const Job& job, const DofOptions& options) {
    const Picture picture = ReadForDevice(job.input, device, options.read);
    RequireWritable(job.output, job.format, picture.channels);
    const Transfer transfer = TransferFor(picture, options.read);
    const Extent2D extent{picture.widthTexels, picture.heightTexels};
    std::vector<glm::vec4> depth = ReadDisparity(picture, device, options);
    float largestDifference = 0;
    for (const glm::vec4& texel : depth)
        largestDifference = std::max(largestDifference, std::abs(texel.a - static_cast<float>(options.focus)));
    const Lens lens{static_cast<float>(options.focus), static_cast<float>(options.aperture)};
    const Photograph photograph{picture,
                                job.input,
                                transfer,
                                extent,
                                std::move(depth),
                                lens,
                                std::clamp(lens.apertureTexels * largestDifference, 1.0f, kMaxSizeTexels)};

    const Focused focused = options.method == "layered" ? FocusByLayers(device, photograph, options)
                                                        : FocusByOneTable(device, photograph, options);
    RequireFiniteSums(focused.texels, job.input);
    const SampleType sampleType = SampleTypeFor(job.format, picture.stored);
    WriteResult(FromLight(focused.texels, picture, transfer, sampleType), job.output, job.format, sampleType);
    return {.input = job.input,
            .output = job.output,
            .extent = extent,
            .precision = SATPrecisionName(focused.precision),
            .tableBytes = SummedAreaTableBytes(extent, focused.precision),
            .passes = focused.passes,
            .deviceBytes = device.MemoryBytes()};
}

}  // namespace

void AddDofCommand(CLI::App& app) {
    const auto options = std::make_shared<DofOptions>();
    CLI::App& command = *app.add_subcommand("dof", "Depth of field on a photograph whose depth is known");
    command.footer(
        "A thin lens: a texel of disparity D (1 / distance; brighter is nearer) becomes the mean over a circle of\n"
        "max(1, A |D - F|) texels. Depth of 0 is unknown and takes the nearest known value. By one table of the "
        "whole\n"
        "picture what is sharp bleeds into what is blurred beside it; in layers of depth it does not, and what is "
        "near\n"
        "has soft rims.\n\n"
        "Example:\n"
        "  boxcar dof photo.jpg --depth disparity.png --focus 0.5 --aperture 100 -o focused.png");
    AddBatchOptions(command, *options);
    AddTapsOption(command, options->taps);
    command.add_option("--depth", options->depth, "Picture of the depth, as large as IN; its red, raw, is read")
        ->required()
        ->type_name("D");
    command
        .add_option(
            "--depth-is", options->depthIs,
            "disparity: brighter is nearer (default); distance: brighter is farther, and the nearest becomes 1")
        ->check(CLI::IsMember({"disparity", "distance"}))
        ->type_name("K");
    command.add_option("--focus", options->focus, "What is sharp: a disparity from 0 to 1")
        ->required()
        ->type_name("F");
    command
        .add_option("--aperture", options->aperture,
                    "Diameter of the circle for a disparity that differs by 1, texels")
        ->required()
        ->type_name("A");
    command.add_option("--method", options->method, "single: one table (default); layered: a table a layer of depth")
        ->check(CLI::IsMember({"single", "layered"}))
        ->type_name("M");
    AddDiscOptions(command, options->disc);
    command.callback([options] {
        RequirePossible(*options);
        RunBatch("dof", *options, PlanJobs(options->files),
                 [&](Device& device, const Job& job) { return Focus(device, job, *options); });
    });
}

}  // namespace boxcar
