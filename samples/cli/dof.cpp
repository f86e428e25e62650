#include "samples/cli/dof.h"

#include <algorithm>
#include <memory>

#include "samples/cli/batch.h"
#include "samples/cli/device_run.h"
#include "samples/cli/disparity.h"
#include "samples/cli/focus_picture.h"
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

std::vector<glm::vec4> FocusByLayers(Device& device, const Photograph& photograph, const DofOptions& options,
                                     Stats& stats) {
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
    stats.precision = SATPrecisionName(effect.Precision());
    stats.tableBytes = SummedAreaTableBytes(extent, effect.Precision());
    stats.passes = commands.PassTimes();
    stats.deviceBytes = device.MemoryBytes();
    return Download<glm::vec4>(device, result);
}

Stats Focus(Device& device, const Job& job, const DofOptions& options) {
    const Picture picture = ReadForDevice(job.input, device, options.read);
    RequireWritable(job.output, job.format, picture.channels);
    const Transfer transfer = TransferOf(options.read);
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

    const SampleType sampleType = SampleTypeFor(job.format, picture.stored);
    Stats stats{.input = job.input, .output = job.output, .extent = extent};
    const std::vector<glm::vec4> focused = options.method == "layered"
                                               ? FocusByLayers(device, photograph, options, stats)
                                               : FocusPicture(device, picture, job.input, transfer,
                                                              {lens, photograph.largestTexels, options.disc.Boxes(),
                                                               options.disc.Sides(), options.taps.Count()},
                                                              photograph.depth, sampleType, stats);
    RequireFiniteSums(focused, job.input);
    WritePicture(FromLight(focused, picture, transfer, sampleType), job.output, job.format, sampleType);
    return stats;
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
