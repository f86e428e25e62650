#include "samples/cli/resize.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <memory>

#include "passes_shaders.h"
#include "samples/cli/batch.h"
#include "samples/cli/codes.h"
#include "samples/cli/light.h"
#include "samples/effects/resize.h"

namespace boxcar {
namespace {

const std::map<std::string, ResizeFilter> kFilters = {{"nearest", ResizeFilter::Nearest},
                                                      {"linear", ResizeFilter::Linear},
                                                      {"bspline", ResizeFilter::BSpline},
                                                      {"interpolating-bspline", ResizeFilter::InterpolatingBSpline},
                                                      {"catmull-rom", ResizeFilter::CatmullRom}};

struct ResizeOptions : BatchOptions {
    std::string extent;
    double scale = 0;
    std::string filter = "interpolating-bspline";
};

Extent2D ResultExtent(Extent2D source, const ResizeOptions& options, const Device& device) {
    if (!options.extent.empty()) return ParseExtent(options.extent);
    const uint32_t limit = device.Limits().maxSideTexels;
    const auto side = [&](uint32_t texels) { return std::round(std::max(1.0, options.scale * texels)); };
    const double width = side(source.widthTexels), height = side(source.heightTexels);
    if (width > limit || height > limit)
        throw Error("--scale {:g} of {} x {} texels: the device takes at most {} a side", options.scale,
                    source.widthTexels, source.heightTexels, limit);
    return {static_cast<uint32_t>(width), static_cast<uint32_t>(height)};
}

Stats Resize(Device& device, const Job& job, const ResizeOptions& options) {
    const Picture picture = ReadForDevice(job.input, device, options.read);
    RequireWritable(job.output, job.format, picture.channels);
    const Transfer transfer = TransferFor(picture, options.read);
    const Extent2D source{picture.widthTexels, picture.heightTexels};
    const Extent2D result = ResultExtent(source, options, device);
    const ResizeFilter filter = kFilters.at(options.filter);
    const bool isSmaller = result.widthTexels < source.widthTexels || result.heightTexels < source.heightTexels;

    CommandList commands(device, CommandList::Timing::On);
    std::vector<glm::vec4> texels;
    std::string precision;
    if (isSmaller && filter != ResizeFilter::Nearest) {
        const SATCodes codes = CodesFor(picture, job.input, transfer, SATPrecision::U64, Rounding::Allow);
        const UploadedWords words = UploadCodes(device, picture, transfer, SATPrecision::U64, 0, source.heightTexels);
        const uint32_t order = filter == ResizeFilter::BSpline ? 3 : 2;
        Shrink shrink(device, {.source = source, .result = result, .order = order, .codes = codes});
        const Image& shrunk = shrink.Record(commands, words);
        commands.SubmitAndWait();
        texels = Download<glm::vec4>(device, shrunk);
        precision = SATPrecisionName(SATPrecision::U64);
    } else {
        const std::vector<glm::vec4> light = ToLight(picture, transfer);
        const Image image = Upload(device, source, std::span(light), "source");
        Enlarge enlarge(device, source, result, filter);
        const Image& enlarged = enlarge.Record(commands, image);
        commands.SubmitAndWait();
        texels = Download<glm::vec4>(device, enlarged);
    }
    const SampleType sampleType = SampleTypeFor(job.format, picture.stored);
    const Picture like{result.widthTexels, result.heightTexels, picture.channels, picture.stored, {}};
    WritePicture(FromLight(texels, like, transfer, sampleType), job.output, job.format, sampleType);
    return {.input = job.input,
            .output = job.output,
            .extent = result,
            .precision = precision,
            .tableBytes = precision.empty() ? 0 : SummedAreaTableBytes(source, SATPrecision::U64),
            .passes = commands.PassTimes(),
            .deviceBytes = device.MemoryBytes()};
}

struct DeriveOptions : BatchOptions {
    std::string what;
};

Stats Derive(Device& device, const Job& job, const DeriveOptions& options) {
    const Picture picture = ReadForDevice(job.input, device, options.read);
    RequireWritable(job.output, job.format, picture.channels);
    const Transfer transfer = TransferFor(picture, options.read);
    const Extent2D extent{picture.widthTexels, picture.heightTexels};
    const std::vector<glm::vec4> light = ToLight(picture, transfer);
    const Image source = Upload(device, extent, std::span(light), "source");
    std::string word = options.what;
    std::ranges::transform(word, word.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    const Pipeline pipeline(
        device, {passes_shaders::Find("shaders/quad.vs"), passes_shaders::Find("shaders/derive.ps.WHAT=" + word)});
    const Image result(device, {extent, Format::RGBA32F, "derivative"});
    CommandList commands(device, CommandList::Timing::On);
    commands.Draw({.name = "derive", .pipeline = pipeline, .reads = {{"source", &source}}, .writes = {&result}});
    commands.SubmitAndWait();
    const std::vector<glm::vec4> texels = Download<glm::vec4>(device, result);
    WritePicture(FromLight(texels, picture, transfer, SampleType::Float32), job.output, job.format,
                 SampleType::Float32);
    return {.input = job.input,
            .output = job.output,
            .extent = extent,
            .passes = commands.PassTimes(),
            .deviceBytes = device.MemoryBytes()};
}

}  // namespace

void AddResizeCommand(CLI::App& app) {
    const auto options = std::make_shared<ResizeOptions>();
    CLI::App& command =
        *app.add_subcommand("resize", "A picture at another size, under filters of up to third order");
    command.footer(
        "Texel x of the result reads the picture at (x + 0.5) / S - 0.5; edge texels go on outside. Smaller results "
        "are\n"
        "made under kernels as wide as their texels, from a table of whole numbers: a tent, for bspline a "
        "parabola.\n\n"
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
    command.callback([options] {
        if (options->extent.empty() && options->scale == 0) throw UsageError("resize takes --size WxH or --scale S");
        if (options->extent.empty() && !(options->scale > 0 && options->scale <= 16384))
            throw UsageError("--scale {:g}: expected a number above 0 and at most 16384", options->scale);
        RunBatch("resize", *options, PlanJobs(options->files),
                 [&](Device& device, const Job& job) { return Resize(device, job, *options); });
    });
}

void AddDeriveCommand(CLI::App& app) {
    const auto options = std::make_shared<DeriveOptions>();
    CLI::App& command = *app.add_subcommand("derive", "Derivatives of a picture under the cubic B-spline");
    command.footer(
        "Per texel, at texel centres, of each channel: first and second derivatives, the gradient's length, and the\n"
        "curvature of the line of equal value through the texel, in 1 / texel.\n\n"
        "Example:\n  boxcar derive photo.png -o edges.exr --what gradient");
    AddBatchOptions(command, *options);
    command.add_option("--what", options->what, "dx, dy, dxx, dxy, dyy, gradient or curvature")
        ->required()
        ->check(CLI::IsMember({"dx", "dy", "dxx", "dxy", "dyy", "gradient", "curvature"}))
        ->type_name("D");
    command.callback([options] {
        const std::vector<Job> jobs = PlanJobs(options->files);
        for (const Job& job : jobs)
            if (job.format != FileFormat::Exr && job.format != FileFormat::Pfm)
                throw UsageError("-o {}: derivatives are signed, which needs .exr or .pfm", job.output);
        RunBatch("derive", *options, jobs,
                 [&](Device& device, const Job& job) { return Derive(device, job, *options); });
    });
}

}  // namespace boxcar
