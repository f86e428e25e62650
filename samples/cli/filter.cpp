#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <memory>

#include "samples/app/filter_picture.h"
#include "samples/app/light.h"
#include "samples/cli/batch.h"
#include "samples/cli/commands.h"
#include "samples/cli/console.h"

namespace boxcar {
namespace {

struct FilterOptions : BatchOptions {
    TapsOption taps;
    TableOptions table;
    std::string width;
    std::string widthMap;
    std::string widthMin;
    std::string widthMax;
    std::string shapeWord = "box";
    std::optional<double> gaussPercent;
    DiscOptions disc;
    std::string edgeWord = "clip";
    int bits = 0;
};

SATEdge EdgeOf(const FilterOptions& options) {
    const std::string& word = options.edgeWord;
    return word == "clip"     ? SATEdge::Clip
           : word == "zero"   ? SATEdge::Zero
           : word == "repeat" ? SATEdge::Repeat
                              : SATEdge::Mirror;
}

FilterRequest ParseRequest(const FilterOptions& options) {
    FilterRequest kernel{.edge = EdgeOf(options),
                         .taps = options.taps.Count(),
                         .precision = PrecisionOf(options.table),
                         .bias = BiasOf(options.table),
                         .origin = OriginOf(options.table)};
    float factor = 1;
    if (options.shapeWord == "tent") kernel.order = 2;
    if (options.shapeWord == "parabolic") kernel.order = 3;
    if (options.shapeWord == "disc") {
        kernel.boxes = options.disc.Boxes();
        kernel.sides = options.disc.Sides();
    }
    if (options.shapeWord == "gauss") {
        const double percent = options.gaussPercent.value_or(5);
        if (!(percent > 0)) throw UsageError("--gauss-error {:g}: expected percent, above 0", percent);
        try {
            const SATGaussian gaussian = SATGaussianWithin(static_cast<float>(percent / 100));
            kernel.order = gaussian.order;
            factor = gaussian.widthOverSigma;
        } catch (const Error& error) {
            throw UsageError("--gauss-error {:g}: {}", percent, error.what());
        }
    }
    if (options.gaussPercent && options.shapeWord != "gauss")
        throw UsageError("--gauss-error with --shape {}: it is for --shape gauss", options.shapeWord);
    if ((options.disc.boxes || options.disc.sides) && options.shapeWord != "disc")
        throw UsageError("--disc-{} with --shape {}: it is for --shape disc", options.disc.boxes ? "boxes" : "sides",
                         options.shapeWord);
    if (options.widthMap.empty()) {
        if (options.width.empty()) throw UsageError("--width is missing: W or WxH in texels, or a --width-map");
        if (!options.widthMin.empty() || !options.widthMax.empty())
            throw UsageError("--width-min and --width-max belong to --width-map");
        kernel.minTexels = kernel.maxTexels = factor * ParseSize("--width", options.width);
    } else {
        if (!options.width.empty()) throw UsageError("--width and --width-map: give one of them");
        if (options.widthMin.empty() || options.widthMax.empty())
            throw UsageError("--width-map needs --width-min and --width-max, the widths for 0 and for white");
        kernel.minTexels = factor * ParseSize("--width-min", options.widthMin);
        kernel.maxTexels = factor * ParseSize("--width-max", options.widthMax);
    }
    const glm::vec2 widest = glm::max(kernel.minTexels, kernel.maxTexels);
    if (std::max(widest.x, widest.y) > kMaxSizeTexels)
        throw UsageError("--shape gauss of that width is made of boxes of {:.0f} texels; at most {:.0f} are possible",
                         std::max(widest.x, widest.y), kMaxSizeTexels);
    return kernel;
}

void RequirePossible(const FilterOptions& options) {
    const FilterRequest request = ParseRequest(options);
    RequireFloatOptionsFit(options.table, SATPrecision::U64, SATOrigin::Corner);
    if (options.widthMap == "-" && std::ranges::count(options.files.inputs, "-") > 0)
        throw UsageError("--width-map - and IN -: both would read standard input");
    if (request.order > 1 && request.precision == SATPrecision::FP32)
        throw UsageError("--shape {} with --precision fp32: floats hold boxes and discs; leave out --precision",
                         options.shapeWord);
    if (request.origin != SATOrigin::Corner && (request.edge == SATEdge::Repeat || request.edge == SATEdge::Mirror))
        throw UsageError("--origin {} with --edge {}: sums over a repeated picture start at the corner",
                         options.table.originWord, options.edgeWord);
}

SampleType OutputSampleType(const Job& job, const Picture& picture, int bits) {
    if (bits == 0 || job.format != FileFormat::Png) return SampleTypeFor(job.format, picture.stored);
    return bits == 16 ? SampleType::Unorm16 : SampleType::Unorm8;
}

// A map of widths, of the picture's extent, for the device.
std::vector<glm::vec4> ReadWidthMap(const std::string& path, const Picture& picture, const Device& device,
                                    const ReadOptions& options) {
    const Picture map = ReadBeside(picture, path, "map of widths", device, options);
    std::vector<glm::vec4> texels = ToLight(map, Transfer::Raw);
    for (const glm::vec4& texel : texels)
        if (texel.r < 0 || texel.r > 1)
            throw Error("{}: {:g} in the red of the map of widths; it takes 0 (--width-min) to 1 (--width-max)", path,
                        texel.r);
    return texels;
}

Stats Filter(Device& device, const Job& job, const FilterOptions& options) {
    const FilterRequest request = ParseRequest(options);
    const Picture picture = ReadForDevice(job.input, device, options.read);
    RequireWritable(job.output, job.format, picture.channels);
    const Transfer transfer = TransferOf(options.read);
    const SampleType sampleType = OutputSampleType(job, picture, options.bits);
    std::vector<glm::vec4> map;
    if (!options.widthMap.empty()) map = ReadWidthMap(options.widthMap, picture, device, options.read);

    Stats stats{.input = job.input, .output = job.output, .extent = {picture.widthTexels, picture.heightTexels}};
    const std::vector<glm::vec4> texels =
        FilterPicture(device, picture, job.input, transfer, request, map, sampleType, stats, PrintProblem);
    WriteResult(FromLight(texels, picture, transfer, sampleType), job.output, job.format, sampleType);
    return stats;
}

}  // namespace

Command AddFilterCommand(CLI::App& app) {
    const auto options = std::make_shared<FilterOptions>();
    CLI::App& command = *app.add_subcommand("filter", "Blur pictures: the mean under a kernel around every texel");
    command.footer(
        R"(Shapes, by the width W of the box that they are made of: box; tent, two boxes in a row (2 W wide);
parabolic, three (3 W wide); gauss, of standard deviation W, as the box, tent or parabolic kernel that is
within --gauss-error of it; disc, of diameter W. Boxes are [c - W/2, c + W/2) about each texel's center;
edges may cut texels. Tents of whole W, and parabolic kernels of odd W, are the box of W texels taken two
and three times, exactly, on each axis by itself; others, and all of a map, are the continuous kernel over
the picture, which at width 1 still spreads a texel a little.

Without --precision the result is right: sums are of whole numbers, as fine as it takes. 8 and 16-bit files
are within 0.51 of a code of the true mean, float files within 1e-5 of what lies under the kernel. --stats
says which words and which step were used.

8 and 16-bit files hold sRGB codes and straight alpha; float files hold linear light, and colors times
alpha. What is filtered is light, and what is read as the one and written as the other is converted.
--transfer raw filters and writes the numbers as they stand.

Applied to what is read: rotation (EXIF, in JPEG and PNG), PNG's gAMA, EXR's display window, HDR's
orientation. Kept, where the output holds them: ICC profiles (PNG, JPEG) and primaries (PNG, EXR). A line
says so where they are lost, and where an HDR's EXPOSURE, a PNG's cICP, other parts of an EXR or texels
outside its display window are not used.

Examples:
  boxcar filter photo.jpg -o blurred.png --width 9
  boxcar filter photo.jpg -o soft.png --shape gauss --width 6.5 --edge mirror
  boxcar filter photo.jpg -o tilt.png --width-map depth.png --width-min 1 --width-max 40 --shape disc
  boxcar filter *.png -o blurred/ --width 33x1 --precision u32 --transfer raw --stats
  boxcar filter - -o - --format exr --width 4.5 < sky.exr > soft.exr)");
    AddBatchOptions(command, *options);
    AddTapsOption(command, options->taps);
    command.add_option("--width", options->width, "Width and height in texels, real; below 1 acts as 1")
        ->type_name("W[xH]");
    command
        .add_option("--width-map", options->widthMap,
                    "A width for each texel: a picture as large as IN; its red, raw, is 0 for --width-min, 1 for "
                    "--width-max")
        ->type_name("M");
    command.add_option("--width-min", options->widthMin, "Width where the map is 0")->type_name("A[xB]");
    command.add_option("--width-max", options->widthMax, "Width where the map is 1 (white)")->type_name("A[xB]");
    command.add_option("--shape", options->shapeWord, "box (default), tent, parabolic, gauss or disc")
        ->check(CLI::IsMember({"box", "tent", "parabolic", "gauss", "disc"}))
        ->type_name("S");
    command
        .add_option(
            "--gauss-error", options->gaussPercent,
            "gauss: distance to a Gaussian that is accepted, relative L2 in percent: 4.2 and more is parabolic "
            "(default 5), 9.8 tent, 53 box")
        ->type_name("P");
    AddDiscOptions(command, options->disc);
    command
        .add_option("--edge", options->edgeWord,
                    "clip: divide by what of the kernel lies inside the picture (default); zero: the picture is 0 "
                    "outside; repeat; mirror (the edge texel comes twice)")
        ->check(CLI::IsMember({"clip", "zero", "repeat", "mirror"}))
        ->type_name("E");
    AddTableOptions(command, options->table, "with fp32 mean; none for float files",
                    "integers as fine as the result needs, u32 where it is wide enough, or u64");
    command
        .add_option("--bits", options->bits, "Bits of a PNG's samples: 8 or 16 (default: as the input, float as 8)")
        ->check(CLI::IsMember({8, 16}))
        ->type_name("B");
    return {&command, [options] {
                RequirePossible(*options);
                const std::vector<Job> jobs = PlanJobs(options->files);
                for (const Job& job : jobs)
                    if (options->bits != 0 && job.format != FileFormat::Png)
                        throw UsageError("--bits {} with -o {}: it is for PNG", options->bits, job.output);
                RunBatch("filter", *options, jobs,
                         [&](Device& device, const Job& job) { return Filter(device, job, *options); });
            }};
}

}  // namespace boxcar
