#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "samples/app/focus_picture.h"
#include "samples/app/light.h"
#include "samples/cli/batch.h"
#include "samples/cli/commands.h"
#include "samples/cli/depth.h"

namespace boxcar {
namespace {

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

Stats Focus(Device& device, const Job& job, const DofOptions& options) {
    const Picture picture = ReadForDevice(job.input, device, options.read);
    RequireWritable(job.output, job.format, picture.channels);
    const Transfer transfer = TransferOf(options.read);
    const DepthMap depth = ReadDepth(options.depth, picture, device);
    float largestDifference = 0;
    for (const float disparity : depth.disparity)
        largestDifference = std::max(largestDifference, std::abs(disparity - depth.focusDisparity));
    const auto aperture = static_cast<float>(options.aperture);
    const FocusRequest request{.lens = {depth.focusDisparity, aperture},
                               .largestTexels = std::clamp(aperture * largestDifference, 1.0f, kMaxSizeTexels),
                               .boxes = options.disc.Boxes(),
                               .sides = options.disc.Sides(),
                               .taps = options.taps.Count()};
    const SampleType sampleType = SampleTypeFor(job.format, picture.stored);
    Stats stats{.input = job.input, .output = job.output, .extent = {picture.widthTexels, picture.heightTexels}};
    const auto focus = options.method == "layered" ? FocusPictureByLayers : FocusPicture;
    const std::vector<glm::vec4> focused =
        focus(device, picture, job.input, transfer, request, InAlpha(depth.disparity), sampleType, stats);
    RequireFiniteSums(focused, job.input);
    WriteResult(FromLight(focused, picture, transfer, sampleType), job.output, job.format, sampleType);
    return stats;
}

}  // namespace

Command AddDofCommand(CLI::App& app) {
    const auto options = std::make_shared<DofOptions>();
    CLI::App& command = *app.add_subcommand("dof", "Depth of field on a photograph whose depth is known");
    command.footer(
        "A thin lens: a texel becomes the mean over a circle whose diameter in texels, 1 at least, is\n"
        "  A |D - F|      of a disparity D (1 / distance, in any unit), where F is in focus\n"
        "  A |F / D - 1|  of a distance D\n"
        "A depth that is unknown becomes the nearest known one. A disparity of 0, where --unknown does not name "
        "zero,\n"
        "is infinitely far. --nan is for IN alone. By one table of the whole picture what is sharp bleeds into what\n"
        "is blurred beside it; in layers of depth it does not, and what is near has soft rims. --method layered has\n"
        "its own definition: a circle in a layer is made of whole boxes, with edges right to half a texel. It takes\n"
        "light up to 16, and no alpha.\n\n"
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
    return {&command, [options] {
                RequirePossible(*options);
                RunBatch("dof", *options, PlanJobs(options->files),
                         [&](Device& device, const Job& job) { return Focus(device, job, *options); });
            }};
}

}  // namespace boxcar
