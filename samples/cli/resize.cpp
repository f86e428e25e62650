#include "runtime/passes/resize.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>

#include "runtime/passes/quad_shaders.h"
#include "samples/app/device_run.h"
#include "samples/app/light.h"
#include "samples/cli/batch.h"
#include "samples/cli/commands.h"

namespace boxcar {
namespace {

const std::map<std::string, ResizeFilter> kFilters = {{"nearest", ResizeFilter::Nearest},
                                                      {"linear", ResizeFilter::Linear},
                                                      {"bspline", ResizeFilter::BSpline},
                                                      {"interpolating-bspline", ResizeFilter::InterpolatingBSpline},
                                                      {"catmull-rom", ResizeFilter::CatmullRom}};

struct ResizeOptions : BatchOptions {
    std::string extent;
    std::optional<double> scale;
    std::string filter = "interpolating-bspline";
};

ResizeDesc DescFor(Extent2D source, const ResizeOptions& options, const Device& device) {
    ResizeDesc desc{.source = source, .filter = kFilters.at(options.filter)};
    if (!options.extent.empty()) {
        desc.result = ParseExtent(options.extent);
        desc.stepTexels = float2(source.widthTexels, source.heightTexels) /
                          float2(desc.result.widthTexels, desc.result.heightTexels);
        return desc;
    }
    const uint32_t limit = device.Limits().maxSideTexels;
    const auto side = [&](uint32_t texels) { return std::round(std::max(1.0, *options.scale * texels)); };
    const double width = side(source.widthTexels), height = side(source.heightTexels);
    if (width > limit || height > limit)
        throw Error("--scale {:g} of {} x {} texels: the device takes at most {} a side", *options.scale,
                    source.widthTexels, source.heightTexels, limit);
    desc.result = {static_cast<uint32_t>(width), static_cast<uint32_t>(height)};
    desc.stepTexels = float2(static_cast<float>(1 / *options.scale));
    return desc;
}

Stats ResizePicture(Device& device, const Job& job, const ResizeOptions& options) {
    const Picture picture = ReadForDevice(job.input, device, options.read);
    RequireWritable(job.output, job.format, picture.channels);
    const Transfer transfer = TransferOf(options.read);
    const Extent2D source{picture.widthTexels, picture.heightTexels};
    const ResizeDesc desc = DescFor(source, options, device);

    CommandList commands(device, CommandList::Timing::On);
    const std::vector<glm::vec4> light = ToLight(picture, transfer);
    const Image image = Upload(device, source, std::span(light), "source");
    Resize resize(device, desc);
    const Image& result = resize.Record(commands, image);
    commands.SubmitAndWait();
    const std::vector<glm::vec4> texels = Download<glm::vec4>(device, result);
    RequireFiniteSums(texels, job.input);
    const SampleType sampleType = SampleTypeFor(job.format, picture.stored);
    const Picture like{desc.result.widthTexels, desc.result.heightTexels, picture.channels, picture.stored, {},
                       picture.colorSpace};
    WriteResult(FromLight(texels, like, transfer, sampleType), job.output, job.format, sampleType);
    return {.input = job.input,
            .output = job.output,
            .extent = desc.result,
            .passes = commands.PassTimes(),
            .deviceBytes = device.MemoryBytes()};
}

struct DeriveOptions : BatchOptions {
    std::string what;
};

Stats Derive(Device& device, const Job& job, const DeriveOptions& options) {
    const Picture picture = ReadForDevice(job.input, device, options.read);
    const uint32_t colors = picture.channels > 2 ? 3 : 1;
    RequireWritable(job.output, job.format, colors);
    const Transfer transfer = TransferOf(options.read);
    const Extent2D extent{picture.widthTexels, picture.heightTexels};
    const std::vector<glm::vec4> light = ToLight(picture, transfer);
    const Image source = Upload(device, extent, std::span(light), "source");
    std::string word = options.what;
    std::ranges::transform(word, word.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    const Pipeline pipeline(device, QuadShaders("derive.ps.WHAT=" + word));
    const Image result(device, {extent, Format::RGBA32F, "derivative"});
    CommandList commands(device, CommandList::Timing::On);
    commands.Draw({.name = "derive", .pipeline = pipeline, .reads = {{"source", &source}}, .writes = {&result}});
    commands.SubmitAndWait();
    std::vector<glm::vec4> texels = Download<glm::vec4>(device, result);
    RequireFiniteSums(texels, job.input);
    const SampleType sampleType = SampleTypeFor(job.format, picture.stored);
    if (sampleType != SampleType::Float32 && options.what != "gradient")
        for (glm::vec4& texel : texels)
            texel = 0.5f + 0.5f * texel;
    const Picture like{picture.widthTexels, picture.heightTexels, colors, picture.stored, {}};
    WritePicture(FromLight(texels, like, Transfer::Raw, sampleType), job.output, job.format, sampleType);
    return {.input = job.input,
            .output = job.output,
            .extent = extent,
            .passes = commands.PassTimes(),
            .deviceBytes = device.MemoryBytes()};
}

}  // namespace

Command AddResizeCommand(CLI::App& app) {
    const auto options = std::make_shared<ResizeOptions>();
    CLI::App& command =
        *app.add_subcommand("resize", "A picture at another size, under filters of up to third order");
    command.footer(
        "Texel x of the result reads the picture at (x + 0.5) / S - 0.5; edge texels go on outside. For a smaller\n"
        "result the filter is as wide as its texels, so that nothing aliases.\n\n"
        "Examples:\n"
        "  boxcar resize photo.jpg -o large.png --scale 3\n"
        "  boxcar resize photo.jpg -o thumbnail.jpg --size 160x120 --filter linear");
    AddBatchOptions(command, *options);
    CLI::Option* const size =
        command.add_option("--size", options->extent, "Width and height in texels")->type_name("WxH");
    command.add_option("--scale", options->scale, "How many times larger, on both axes")
        ->type_name("S")
        ->excludes(size);
    command
        .add_option("--filter", options->filter,
                    "nearest, linear, bspline (smooths), interpolating-bspline (default) or catmull-rom")
        ->check(CLI::IsMember(kFilters))
        ->type_name("F");
    return {&command, [options] {
                if (options->extent.empty() && !options->scale)
                    throw UsageError("resize takes --size WxH or --scale S");
                if (options->scale && !(*options->scale >= 0.0001 && *options->scale <= 16384))
                    throw UsageError("--scale {:g}: expected a number from 0.0001 to 16384", *options->scale);
                RunBatch("resize", *options, PlanJobs(options->files),
                         [&](Device& device, const Job& job) { return ResizePicture(device, job, *options); });
            }};
}

Command AddDeriveCommand(CLI::App& app) {
    const auto options = std::make_shared<DeriveOptions>();
    CLI::App& command = *app.add_subcommand("derive", "Derivatives of a picture under the cubic B-spline");
    command.footer(
        "Per texel, at texel centers, of each color: first and second derivatives, the gradient's length, and the\n"
        "curvature of the line of equal value through the texel, in 1 / texel, positive round what is brighter.\n"
        "EXR and PFM hold them as they are; in PNG and JPEG 0.5 + value / 2 stands for a value, and the gradient's\n"
        "length for itself.\n\n"
        "Examples:\n"
        "  boxcar derive photo.png -o edges.png --what gradient\n"
        "  boxcar derive height.exr -o slope.exr --what dx");
    AddBatchOptions(command, *options);
    command.add_option("--what", options->what, "dx, dy, dxx, dxy, dyy, gradient or curvature")
        ->required()
        ->check(CLI::IsMember({"dx", "dy", "dxx", "dxy", "dyy", "gradient", "curvature"}))
        ->type_name("D");
    return {&command, [options] {
                RunBatch("derive", *options, PlanJobs(options->files),
                         [&](Device& device, const Job& job) { return Derive(device, job, *options); });
            }};
}

}  // namespace boxcar
