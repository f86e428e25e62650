#include "samples/cli/dof.h"

#include <algorithm>
#include <memory>

#include "samples/cli/batch.h"
#include "samples/cli/codes.h"
#include "samples/cli/depth.h"
#include "samples/cli/device_run.h"
#include "samples/cli/light.h"
#include "samples/effects/layered_depth_of_field.h"

namespace boxcar {
namespace {

constexpr int kLayersPerSide = 8;

struct DofOptions : BatchOptions {
    DepthOptions depth;
    std::string method = "single";
    double aperture = -1;
    TapsOption taps;
    DiscOptions disc;
};

void RequirePossible(const DofOptions& options) {
    if (options.files.inputs.size() > 1)
        throw UsageError("{} inputs: dof takes one picture and its --depth", options.files.inputs.size());
    if (options.depth.path == "-" && options.files.inputs[0] == "-")
        throw UsageError("--depth - and IN -: both would read standard input");
    RequireWords(options.depth);
    if (!(options.aperture >= 0 && options.aperture <= kMaxSizeTexels))
        throw UsageError("--aperture {:g}: expected texels, 0 to {:.0f}", options.aperture, kMaxSizeTexels);
}

// Disparity of every texel, in alpha.
std::vector<glm::vec4> InAlpha(const std::vector<float>& disparity) {
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
    const DepthMap depth = ReadDepth(options.depth, picture, device);
    float largestDifference = 0;
    for (const float disparity : depth.disparity)
        largestDifference = std::max(largestDifference, std::abs(disparity - depth.focusDisparity));
    const Lens lens{depth.focusDisparity, static_cast<float>(options.aperture)};
    const Photograph photograph{picture,
                                job.input,
                                transfer,
                                extent,
                                InAlpha(depth.disparity),
                                lens,
                                std::clamp(lens.apertureTexels * largestDifference, 1.0f, kMaxSizeTexels)};

    const Focused focused = options.method == "layered" ? FocusByLayers(device, photograph, options)
                                                        : FocusByOneTable(device, photograph, options);
    RequireFiniteSums(focused.texels, job.input);
    const SampleType sampleType = SampleTypeFor(job.format, picture.stored);
    WritePicture(FromLight(focused.texels, picture, transfer, sampleType), job.output, job.format, sampleType);
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
        "A thin lens: a texel becomes the mean over a circle whose diameter in texels, 1 at least, is\n"
        "  A |D - F|      of a disparity D (1 / distance, in any unit), where F is in focus\n"
        "  A |F / D - 1|  of a distance D\n"
        "A depth that is unknown becomes the nearest known one. A disparity of 0, where --unknown does not name "
        "zero,\n"
        "is infinitely far. --nan is for IN alone. By one table of the whole picture what is sharp bleeds into what\n"
        "is blurred beside it; in layers of depth it does not, and what is near has soft rims.\n\n"
        "Examples:\n"
        "  a stereo data set, such as Middlebury's: disparity in pixels, infinity is unknown\n"
        "    boxcar dof im0.png --depth disp0.pfm --unknown inf --focus 60 --aperture 0.4 -o focused.png\n"
        "  another, such as KITTI's: 16 bits, 256 to a pixel, 0 is unknown\n"
        "    boxcar dof left.png --depth disp.png --depth-scale 1/256 --focus 60 --aperture 0.4 -o focused.png\n"
        "  a depth camera: 16-bit millimeters, 0 is unknown; sharp at 1.2 m, 30 texels at infinity\n"
        "    boxcar dof color.png --depth depth.png --depth-is distance --focus 1200 --aperture 30 -o focused.png\n"
        "  a neural depth map: white is near, black is far and known; sharp is what is seen at 320,200\n"
        "    boxcar dof photo.jpg --depth inverse.png --unknown none --focus 320,200 --aperture 100 -o focused.png");
    AddBatchOptions(command, *options);
    AddTapsOption(command, options->taps);
    AddDepthOptions(command, options->depth);
    command
        .add_option(
            "--aperture", options->aperture,
            "Diameter of the circle, texels: for a disparity that differs by 1 from the focus; where depth is "
            "distance, of what is infinitely far")
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
