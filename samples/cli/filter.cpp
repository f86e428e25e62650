#include "samples/cli/filter.h"

#include <memory>

#include "runtime/transfer.h"
#include "samples/cli/batch.h"
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
    Stats stats{job.input, job.output, picture.widthTexels, picture.heightTexels, {}, 0};

    std::vector<glm::vec4> texels = ToLight(picture, transfer);
    // The box of one texel is the texel: no table, and so none of its rounding.
    if (sizeTexels.x > 1 || sizeTexels.y > 1) {
        const Extent2D extent{picture.widthTexels, picture.heightTexels};
        const bool bounded = picture.stored != SampleType::Float32;
        const Image source(device, {extent, Format::RGBA32F, "source"});
        BoxBlur blur(device, {.extent = extent,
                              .taps = Taps(options.read),
                              .edge = options.edgeWord == "zero" ? BoxEdge::Zero : BoxEdge::Clip,
                              .bias = bounded ? MeanTexel(texels) : glm::vec4(0)});
        WriteTexels(device, source, std::as_bytes(std::span(texels)));
        CommandList commands(device, CommandList::Timing::On);
        const Image& blurred = blur.Record(commands, source, sizeTexels);
        commands.SubmitAndWait();
        ReadTexels(device, blurred, std::as_writable_bytes(std::span(texels)));
        stats.passes = commands.PassTimes();
        stats.deviceBytes = device.MemoryBytes();
    }

    const SampleType sampleType = OutputSampleType(job, picture, options.bits);
    WritePicture(FromLight(texels, picture, transfer, sampleType), job.output, job.format, sampleType);
    return stats;
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
    command.add_option("--bits", options->bits, "Bits of a PNG's samples: 8 or 16 (default: as the input, float as 8)")
        ->check(CLI::IsMember({8, 16}))
        ->type_name("B");
    command.callback([options] {
        ParseSize("--width", options->width);
        RunBatch("filter", *options, PlanJobs(options->files),
                 [&](Device& device, const Job& job) { return Filter(device, job, *options); });
    });
}

}  // namespace boxcar
