#include "samples/cli/filter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <memory>

#include "samples/cli/bands.h"
#include "samples/cli/batch.h"
#include "samples/cli/codes.h"
#include "samples/cli/device_run.h"
#include "samples/cli/light.h"
#include "samples/effects/blur.h"

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

// What the command line asks for.
struct Kernel {
    uint32_t order = 1;
    uint32_t boxes = 1;
    uint32_t sides = 0;
    glm::vec2 minTexels{1};  // of the box that it is made of; the same twice without a map
    glm::vec2 maxTexels{1};
};

SATEdge EdgeOf(const FilterOptions& options) {
    const std::string& word = options.edgeWord;
    return word == "clip"     ? SATEdge::Clip
           : word == "zero"   ? SATEdge::Zero
           : word == "repeat" ? SATEdge::Repeat
                              : SATEdge::Mirror;
}

Kernel ParseKernel(const FilterOptions& options) {
    Kernel kernel;
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
    const Kernel kernel = ParseKernel(options);
    const SATOrigin origin = OriginOf(options.table);
    const SATEdge edge = EdgeOf(options);
    const auto precision = PrecisionOf(options.table);
    RequireFloatOptionsFit(options.table);
    if (options.widthMap == "-" && std::ranges::count(options.files.inputs, "-") > 0)
        throw UsageError("--width-map - and IN -: both would read standard input");
    const bool integers = precision ? *precision != SATPrecision::FP32 : kernel.order > 1;
    if (kernel.order > 1 && !integers)
        throw UsageError("--shape {} with --precision fp32: floats hold boxes and discs; use u32 or u64",
                         options.shapeWord);
    if (integers && !options.table.biasWord.empty() && options.table.biasWord != "none")
        throw UsageError(
            "--bias {} with --shape {}: it is summed in integers, which do not round; a bias is for fp32",
            options.table.biasWord, options.shapeWord);
    if (integers && origin != SATOrigin::Corner)
        throw UsageError("--origin {} with integers: they do not round; sums from elsewhere are for --precision fp32",
                         options.table.originWord);
    if (origin != SATOrigin::Corner && (edge == SATEdge::Repeat || edge == SATEdge::Mirror))
        throw UsageError("--origin {} with --edge {}: sums over a repeated picture start at the corner",
                         options.table.originWord, options.edgeWord);
}

SampleType OutputSampleType(const Job& job, const Picture& picture, int bits) {
    if (bits == 0 || job.format != FileFormat::Png) return SampleTypeFor(job.format, picture.stored);
    return bits == 16 ? SampleType::Unorm16 : SampleType::Unorm8;
}

// Of u32 and u64 the first that holds the kernel, or u64.
SATPrecision ExactPrecision(const Picture& picture, const std::string& name, Transfer transfer, const Kernel& kernel,
                            bool hasMap) {
    if (picture.stored == SampleType::Float32) return SATPrecision::U64;
    const SATCodes codes = CodesFor(picture, name, transfer, SATPrecision::U32);
    const glm::vec2 size = glm::max(kernel.minTexels, kernel.maxTexels);
    const bool isWhole = !hasMap && SATIsWhole(size, kernel.order);
    return SATExactPrecision(size, kernel.order, isWhole, codes);
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

template <typename Texel>
std::span<const Texel> RowsOf(const std::vector<Texel>& texels, uint32_t widthTexels, uint32_t first, uint32_t rows) {
    return std::span(texels).subspan(size_t{first} * widthTexels, size_t{rows} * widthTexels);
}

// Adds what passes of the same name took.
void AddTimes(std::vector<PassTime>& total, const std::vector<PassTime>& times) {
    auto at = total.begin();
    for (const PassTime& time : times) {
        at = std::find_if(at, total.end(), [&](const PassTime& t) { return t.name == time.name; });
        if (at == total.end())
            at = total.insert(at, time);
        else
            at->milliseconds += time.milliseconds;
        ++at;
    }
}

BlurDesc BlurFor(const Picture& picture, const std::string& name, Transfer transfer, const Kernel& kernel,
                 const FilterOptions& options) {
    BlurDesc desc{.extent = {picture.widthTexels, picture.heightTexels},
                  .order = kernel.order,
                  .boxes = kernel.boxes,
                  .sides = kernel.sides,
                  .edge = EdgeOf(options),
                  .taps = options.taps.Count(),
                  .origin = OriginOf(options.table),
                  .largestTexels = glm::max(kernel.minTexels, kernel.maxTexels)};
    if (const auto asked = PrecisionOf(options.table))
        desc.precision = *asked;
    else if (kernel.order > 1)
        desc.precision = ExactPrecision(picture, name, transfer, kernel, !options.widthMap.empty());
    if (desc.precision != SATPrecision::FP32)
        // Who asks for integers wants them exact; who asks for a tent wants a tent.
        desc.codes = CodesFor(picture, name, transfer, desc.precision,
                              PrecisionOf(options.table) ? Rounding::Refuse : Rounding::Allow);
    else if (options.table.biasWord == "half")
        desc.bias = BlurBias::Half;
    else if (options.table.biasWord == "mean" ||
             (options.table.biasWord.empty() && picture.stored != SampleType::Float32))
        desc.bias = BlurBias::Mean;
    return desc;
}

// A picture, and perhaps a map of widths, of which bands of rows go to the device.
class BandedPicture {
public:
    // `map`: empty if there is none.
    BandedPicture(const Picture& picture, Transfer transfer, SATPrecision precision, std::vector<glm::vec4> map)
        : m_picture(picture), m_transfer(transfer), m_precision(precision), m_map(std::move(map)) {
        if (precision == SATPrecision::FP32) m_texels = ToLight(picture, transfer);
    }

    UploadedWords UploadWords(Device& device, const Band& band) const {
        if (m_precision != SATPrecision::FP32)
            return UploadCodes(device, m_picture, m_transfer, m_precision, band.firstRead, band.rowsRead);
        const Extent2D extent{m_picture.widthTexels, band.rowsRead};
        UploadedWords words;
        words.images.push_back(
            Upload(device, extent, RowsOf(m_texels, extent.widthTexels, band.firstRead, band.rowsRead), "source"));
        return words;
    }

    std::optional<Image> UploadMap(Device& device, const Band& band) const {
        if (m_map.empty()) return {};
        const Extent2D extent{m_picture.widthTexels, band.rowsRead};
        return Upload(device, extent, RowsOf(m_map, extent.widthTexels, band.firstRead, band.rowsRead), "widths");
    }

private:
    const Picture& m_picture;
    Transfer m_transfer;
    SATPrecision m_precision;
    std::vector<glm::vec4> m_map;
    std::vector<glm::vec4> m_texels;  // FP32 only
};

// The whole picture filtered, band by band.
std::vector<glm::vec4> FilterBands(Device& device, const BandedPicture& source, BlurDesc desc, const Kernel& kernel,
                                   Stats& stats) {
    const Extent2D extent = desc.extent;
    const bool isRepeated = desc.edge == SATEdge::Repeat || desc.edge == SATEdge::Mirror;
    const Extent2D reach = BlurReach(kernel.order, desc.largestTexels);
    const uint32_t extendedWidth = extent.widthTexels + 2 * reach.widthTexels;
    const uint32_t extendedHeight = extent.heightTexels + 2 * reach.heightTexels;
    const uint32_t largestSide = device.Limits().maxSideTexels;
    if (isRepeated && desc.order > 1 && std::max(extendedWidth, extendedHeight) > largestSide)
        throw Error(
            "a kernel that reaches {} x {} texels over a repeated picture extends it to {} x {}; "
            "this device takes {} a side: a smaller --width, a box, or --edge clip",
            reach.widthTexels, reach.heightTexels, extendedWidth, extendedHeight, largestSide);
    const std::vector<Band> bands = isRepeated ? std::vector<Band>{{0, extent.heightTexels, 0, extent.heightTexels}}
                                               : PlanBands(extent, reach.heightTexels);
    std::vector<glm::vec4> filtered;
    filtered.reserve(extent.Texels());
    for (const Band& band : bands) {
        desc.extent.heightTexels = band.rowsRead;
        Blur blur(device, desc);
        const UploadedWords words = source.UploadWords(device, band);
        const std::optional<Image> map = source.UploadMap(device, band);
        CommandList commands(device, CommandList::Timing::On);
        const Image& result = blur.Record(
            commands, words, map ? SATWidths(*map, kernel.minTexels, kernel.maxTexels) : SATWidths(kernel.maxTexels));
        commands.SubmitAndWait();
        const auto rows = Download<glm::vec4>(device, result);
        const auto own = RowsOf(rows, extent.widthTexels, band.firstRow - band.firstRead, band.rows);
        filtered.insert(filtered.end(), own.begin(), own.end());
        AddTimes(stats.passes, commands.PassTimes());
        stats.deviceBytes = std::max(stats.deviceBytes, device.MemoryBytes());
        stats.tableBytes = std::max(stats.tableBytes, blur.TableBytes());
    }
    stats.precision = SATPrecisionName(desc.precision);
    return filtered;
}

// One line for texels that the filter marked as NaN, because their width asks for more than the words hold. Throws
// Error where floats have overflowed.
void ReportMarked(const std::vector<glm::vec4>& texels, const BlurDesc& desc, const Picture& picture,
                  SampleType sampleType, const std::string& name) {
    if (desc.precision == SATPrecision::FP32) return RequireFiniteSums(texels, name);
    const auto marked = std::ranges::count_if(texels, [](const glm::vec4& texel) { return !IsFinite(texel); });
    if (marked == 0) return;
    const uint32_t side = SATLargestWidthTexels(desc.precision, desc.codes, desc.order, false);
    fmt::print(stderr, "boxcar: {} of {} texels ask for wider sums than {} holds ({} x {}) and are marked, as {}\n",
               marked, texels.size(), SATPrecisionName(desc.precision), side, side,
               sampleType == SampleType::Float32 ? "NaN"
               : picture.channels > 2            ? "magenta"
                                                 : "white");
}

Stats Filter(Device& device, const Job& job, const FilterOptions& options) {
    const Kernel kernel = ParseKernel(options);
    const Picture picture = ReadForDevice(job.input, device, options.read);
    RequireWritable(job.output, job.format, picture.channels);
    const Transfer transfer = TransferFor(picture, options.read);
    const SampleType sampleType = OutputSampleType(job, picture, options.bits);
    const BlurDesc desc = BlurFor(picture, job.input, transfer, kernel, options);

    Stats stats{.input = job.input, .output = job.output, .extent = desc.extent, .passes = {}};
    std::vector<glm::vec4> texels;
    const bool isIdentity = options.widthMap.empty() && kernel.maxTexels.x <= 1 && kernel.maxTexels.y <= 1;
    if (isIdentity && desc.precision == SATPrecision::FP32) {
        // The box of one texel is the texel: no table, and so none of its rounding.
        texels = ToLight(picture, transfer);
    } else {
        try {
            std::vector<glm::vec4> map;
            if (!options.widthMap.empty()) map = ReadWidthMap(options.widthMap, picture, device, options.read);
            texels = FilterBands(device, {picture, transfer, desc.precision, std::move(map)}, desc, kernel, stats);
        } catch (const Error& error) {
            throw Error("{}: {}", job.input, error.what());
        }
        ReportMarked(texels, desc, picture, sampleType, job.input);
    }
    WriteResult(FromLight(texels, picture, transfer, sampleType), job.output, job.format, sampleType);
    return stats;
}

}  // namespace

void AddFilterCommand(CLI::App& app) {
    const auto options = std::make_shared<FilterOptions>();
    CLI::App& command = *app.add_subcommand("filter", "Blur pictures: the mean under a kernel round every texel");
    command.footer(
        "Shapes, by the width W of the box that they are made of: box; tent, two boxes in a row (2 W wide); "
        "parabolic,\n"
        "three (3 W wide); gauss, of standard deviation W, as the box, tent or parabolic kernel that is within\n"
        "--gauss-error of it; disc, of diameter W. Boxes are [c - W/2, c + W/2) about each texel's centre; edges may "
        "cut\n"
        "texels. Tents of whole W, and parabolic kernels of odd W, are the box of W texels taken two and three "
        "times,\n"
        "exactly; others, and all of a map, are the continuous kernel over the picture, which at width 1 still "
        "spreads a\n"
        "texel a little. They are summed in integers, float files as multiples of 2^-24. Float outputs hold the "
        "filtered values (under\n"
        "srgb: linear, colours times alpha); 8 and 16-bit outputs are encoded under srgb.\n\n"
        "Of what files say beside their samples: applied are the rotation (EXIF, in JPEG and PNG), PNG's gAMA "
        "(under\n"
        "srgb), EXR's display window and HDR's orientation; kept as they are, where the output holds them, ICC "
        "profiles\n"
        "(PNG, JPEG) and primaries (PNG, EXR); a line says so where they are lost, and where an HDR's EXPOSURE, a "
        "PNG's\n"
        "cICP, other parts of an EXR or texels outside its display window are not used.\n\n"
        "Examples:\n"
        "  boxcar filter photo.jpg -o blurred.png --width 9\n"
        "  boxcar filter photo.jpg -o soft.png --shape gauss --width 6.5 --edge mirror\n"
        "  boxcar filter photo.jpg -o tilt.png --width-map depth.png --width-min 1 --width-max 40 --shape disc\n"
        "  boxcar filter *.png -o blurred/ --width 33x1 --precision u32 --transfer raw --stats\n"
        "  boxcar filter - -o - --format exr --width 4.5 < sky.exr > soft.exr");
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
    AddTableOptions(command, options->table, "mean; none for float files",
                    "fp32 for boxes and discs; else u32 where it is wide enough, or u64");
    command
        .add_option("--bits", options->bits, "Bits of a PNG's samples: 8 or 16 (default: as the input, float as 8)")
        ->check(CLI::IsMember({8, 16}))
        ->type_name("B");
    command.callback([options] {
        RequirePossible(*options);
        const std::vector<Job> jobs = PlanJobs(options->files);
        for (const Job& job : jobs)
            if (options->bits != 0 && job.format != FileFormat::Png)
                throw UsageError("--bits {} with -o {}: it is for PNG", options->bits, job.output);
        RunBatch("filter", *options, jobs,
                 [&](Device& device, const Job& job) { return Filter(device, job, *options); });
    });
}

}  // namespace boxcar
