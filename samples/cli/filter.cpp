#include "samples/cli/filter.h"

#include <memory>

#include "samples/cli/batch.h"
#include "samples/cli/device_run.h"
#include "samples/cli/light.h"
#include "samples/effects/box_blur.h"

namespace boxcar {
namespace {

struct FilterOptions : BatchOptions {
    std::string width;
    std::string edgeWord = "clip";
    int bits = 0;
};

SampleType OutputSampleType(const Job& job, const Picture& picture, int bits) {
    if (bits == 0 || job.format != FileFormat::Png) return SampleTypeFor(job.format, picture.stored);
    return bits == 16 ? SampleType::Unorm16 : SampleType::Unorm8;
}

Stats Filter(Device& device, const Job& job, const FilterOptions& options) {
    const glm::vec2 sizeTexels = ParseSize("--width", options.width);
    const Picture picture = ReadForDevice(job.input, device, options.read);
    RequireWritable(job.output, job.format, picture.channels);
    const Transfer transfer = TransferFor(picture, options.read);
    const Extent2D extent{picture.widthTexels, picture.heightTexels};

    DeviceRun run{ToLight(picture, transfer), {}, 0};
    // The box of one texel is the texel: no table, and so none of its rounding.
    if (sizeTexels.x > 1 || sizeTexels.y > 1) {
        const bool bounded = picture.stored != SampleType::Float32;
        BoxBlur blur(device, {.extent = extent,
                              .taps = Taps(options.read),
                              .edge = options.edgeWord == "zero" ? BoxEdge::Zero : BoxEdge::Clip,
                              .bias = bounded ? MeanTexel(run.texels) : glm::vec4(0)});
        run = RunOnDevice(device, extent, std::move(run.texels),
                          [&](CommandList& commands, const Image& source) -> const Image& {
                              return blur.Record(commands, source, sizeTexels);
                          });
    }

    const SampleType sampleType = OutputSampleType(job, picture, options.bits);
    WritePicture(FromLight(run.texels, picture, transfer, sampleType), job.output, job.format, sampleType);
    return {job.input, job.output, extent, std::move(run.passes), run.deviceBytes};
}

}  // namespace

void AddFilterCommand(CLI::App& app) {
    const auto options = std::make_shared<FilterOptions>();
    CLI::App& command = *app.add_subcommand("filter", "Blur pictures: the mean over a box round every texel");
    command.footer(
        "The box is [c - W/2, c + W/2) about each texel's centre; its edges may cut texels. Float outputs hold the\n"
        "filtered values (under srgb: linear, colours times alpha); 8 and 16-bit outputs are encoded under srgb.\n\n"
        "Examples:\n"
        "  boxcar filter photo.jpg -o blurred.png --width 9\n"
        "  boxcar filter *.png -o blurred/ --width 33x1 --edge zero --stats\n"
        "  boxcar filter - -o - --format exr --width 4.5 < sky.exr > soft.exr");
    AddBatchOptions(command, *options);
    command.add_option("--width", options->width, "Width and height of the box in texels, real; below 1 acts as 1")
        ->required()
        ->type_name("W[xH]");
    command
        .add_option("--edge", options->edgeWord,
                    "clip: divide by the area inside the picture (default); zero: the picture is 0 outside")
        ->check(CLI::IsMember({"clip", "zero"}))
        ->type_name("E");
    command
        .add_option("--bits", options->bits, "Bits of a PNG's samples: 8 or 16 (default: as the input, float as 8)")
        ->check(CLI::IsMember({8, 16}))
        ->type_name("B");
    command.callback([options] {
        ParseSize("--width", options->width);
        RunBatch("filter", *options, PlanJobs(options->files),
                 [&](Device& device, const Job& job) { return Filter(device, job, *options); });
    });
}

}  // namespace boxcar
