#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <memory>

#include "runtime/passes/mean.h"
#include "runtime/passes/sat_filter.h"
#include "samples/app/codes.h"
#include "samples/app/device_run.h"
#include "samples/app/light.h"
#include "samples/cli/batch.h"
#include "samples/cli/commands.h"

namespace boxcar {
namespace {

struct SatOptions : BatchOptions {
    TapsOption taps;
    TableOptions table;
    uint32_t order = 1;
    bool explain = false;
};

const char* WhatIsSummed(const Picture& picture, Transfer transfer, SATPrecision precision) {
    const bool isFloat = precision == SATPrecision::FP32;
    if (picture.stored == SampleType::Float32) return isFloat ? "the file's floats" : "the file's floats times 2^24";
    if (transfer == Transfer::Srgb)
        return isFloat ? "linear light, colors times alpha" : "round(65535 linear light), colors times alpha";
    return isFloat ? "the file's codes over the largest" : "the file's codes";
}

// The largest code that integers would sum, and whether there are negative ones.
SATCodes CodesToExplain(const Picture& picture, Transfer transfer) {
    if (picture.stored != SampleType::Float32)
        return NamedCodes(picture, "", transfer, SATPrecision::U64).rounds[0].codes;
    SATCodes codes{0x1p24f, 0, false};
    for (const float sample : picture.samples) {
        codes.largest = std::max(codes.largest, std::abs(std::round(sample * 0x1p24)));
        codes.isSigned |= sample < 0;
    }
    return codes;
}

std::string WidestText(SATPrecision words, const SATCodes& codes, uint32_t order) {
    const uint32_t width = SATLargestWidthTexels(words, codes, order);
    return width >= static_cast<uint32_t>(kMaxSizeTexels) ? fmt::format("{} and more", width)
                                                          : fmt::format("{}", width);
}

// Hensley 2005, sect. 2.1 and 2.2 (the bits of a table, and of one of order n)
void Explain(const Job& job, const Picture& picture, Transfer transfer, SATPrecision precision,
             const SatOptions& options, glm::vec4 bias) {
    const Extent2D extent{picture.widthTexels, picture.heightTexels};
    const SATCodes codes = CodesToExplain(picture, transfer);
    const auto bits = static_cast<uint32_t>(std::ceil(std::log2(codes.largest + 1))) + (codes.isSigned ? 1 : 0);
    fmt::print(stderr, "{} -> {}: table of order {}, {}\n", Printable(job.input), Printable(job.output),
               options.order, SATPrecisionName(precision));
    fmt::print(stderr, "  sums     of {}, from the {}\n", WhatIsSummed(picture, transfer, precision),
               options.table.originWord == "corner" ? "upper left corner" : options.table.originWord);
    if (precision == SATPrecision::FP32)
        fmt::print(stderr, "  bias     {:.9g} {:.9g} {:.9g} {:.9g} taken off every texel\n", bias.r, bias.g, bias.b,
                   bias.a);
    fmt::print(stderr, "  papers   P_s = log2 w + log2 h + P_i = {:.2f} + {} = {:.2f} bits\n",
               SummedAreaTableBits(extent, 0), bits, SummedAreaTableBits(extent, bits));
    fmt::print(stderr, "           of order n: n (log2 w + log2 h) + P_i = {:.2f} (n = 2), {:.2f} (n = 3)\n",
               SummedAreaTableBits(extent, bits, 2), SummedAreaTableBits(extent, bits, 3));
    fmt::print(stderr, "  modular  log2(kernel's mass) + P_i, whatever w and h are:\n");
    for (const SATPrecision words : {SATPrecision::U32, SATPrecision::U64}) {
        if (words == SATPrecision::U32 && picture.stored == SampleType::Float32) continue;
        fmt::print(stderr, "           {} holds boxes {} texels wide, tents of {}, parabolic kernels of {}\n",
                   SATPrecisionName(words), WidestText(words, codes, 1), WidestText(words, codes, 2),
                   WidestText(words, codes, 3));
    }
}

std::vector<std::string> ChannelNames(uint32_t channels) {
    const std::string_view names = channels <= 2 ? "YA" : "RGBA";
    std::vector<std::string> list;
    for (uint32_t i = 0; i < channels; i++)
        list.emplace_back(1, names[i]);
    return list;
}

void AppendChannels(std::vector<UintChannel>& channels, const std::vector<glm::uvec4>& texels, uint32_t count,
                    const std::string& suffix) {
    const std::vector<std::string> names = ChannelNames(count);
    for (uint32_t c = 0; c < count; c++) {
        UintChannel channel{names[c] + suffix, {}};
        channel.samples.reserve(texels.size());
        for (const glm::uvec4& texel : texels)
            channel.samples.push_back(texel[static_cast<int>(c)]);
        channels.push_back(std::move(channel));
    }
}

Stats WriteTable(Device& device, const Job& job, const SatOptions& options) {
    const Picture picture = ReadForDevice(job.input, device, options.read);
    const SATPrecision precision = PrecisionOf(options.table).value_or(SATPrecision::FP32);
    const bool isFloat = precision == SATPrecision::FP32;
    if (isFloat) RequireWritable(job.output, job.format, picture.channels);
    const Transfer transfer = TransferOf(options.read);
    const Extent2D extent{picture.widthTexels, picture.heightTexels};

    SummedAreaTable table(device, {.extent = extent,
                                   .precision = precision,
                                   .order = options.order,
                                   .taps = options.taps.Count(),
                                   .origin = OriginOf(options.table)});
    CommandList commands(device, CommandList::Timing::On);
    Stats stats{.input = job.input,
                .output = job.output,
                .extent = extent,
                .precision = SATPrecisionName(precision),
                .tableBytes = SummedAreaTableBytes(extent, precision)};
    const auto finish = [&] {
        commands.SubmitAndWait();
        stats.passes = commands.PassTimes();
        stats.deviceBytes = device.MemoryBytes();
    };

    if (!isFloat) {
        const CodedPicture codes(picture, transfer, NamedCodes(picture, job.input, transfer, precision));
        const bool isWide = precision == SATPrecision::U64;
        const WordImages words = codes.Upload(device, 0, 0, extent.heightTexels);
        const TexelWords sums = table.Record(commands, words);
        finish();
        std::vector<UintChannel> channels;
        AppendChannels(channels, Download<glm::uvec4>(device, *sums.low), picture.channels, isWide ? ".lo" : "");
        if (isWide) AppendChannels(channels, Download<glm::uvec4>(device, *sums.high), picture.channels, ".hi");
        WriteUintExr(channels, extent.widthTexels, extent.heightTexels, job.output);
        if (options.explain) Explain(job, picture, transfer, precision, options, glm::vec4(0));
        return stats;
    }

    const std::vector<glm::vec4> texels = ToLight(picture, transfer);
    const Image source = Upload(device, extent, std::span(texels), "source");
    std::optional<Mean> mean;
    std::optional<Image> half;
    const Image* bias = nullptr;
    if (options.table.biasWord == "mean") bias = &mean.emplace(device, extent).Record(commands, source);
    if (options.table.biasWord == "half") {
        const glm::vec4 value(0.5f);
        bias = &half.emplace(Upload(device, {1, 1}, std::span(&value, 1), "half"));
    }
    const Image& sums = *table.Record(commands, source, bias).low;
    finish();
    const std::vector<glm::vec4> entries = Download<glm::vec4>(device, sums);
    RequireFiniteSums(entries, job.input);
    WritePicture(FromLight(entries, picture, transfer, SampleType::Float32), job.output, job.format,
                 SampleType::Float32);
    if (options.explain)
        Explain(job, picture, transfer, precision, options,
                bias ? Download<glm::vec4>(device, *bias)[0] : glm::vec4(0));
    return stats;
}

}  // namespace

Command AddSatCommand(CLI::App& app) {
    const auto options = std::make_shared<SatOptions>();
    CLI::App& command = *app.add_subcommand("sat", "Write the summed-area table of a picture");
    command.footer(
        "Entry (x, y) is the sum of all texels between it and the origin, itself included; for a corner, of all "
        "left\n"
        "of and above it. Rows are in the picture's order for every origin. fp32 sums are what was summed less the\n"
        "bias, as floats (.exr or .pfm); under srgb that is linear light, colors times alpha. u32 sums are of "
        "whole\n"
        "codes modulo 2^32, as an EXR of UINT channels R G B A or Y A; u64 ones modulo 2^64, as channels R.lo R.hi "
        "..\n\n"
        "Examples:\n"
        "  boxcar sat photo.png -o table.exr --transfer raw\n"
        "  boxcar sat photo.png -o table.exr --precision u64 --order 2 --explain");
    AddBatchOptions(command, *options);
    AddTapsOption(command, options->taps);
    AddTableOptions(command, options->table, "none", "fp32");
    command.add_option("--order", options->order, "How often sums are taken: 1 (default); 2 or 3, of integers")
        ->check(CLI::IsMember({1, 2, 3}))
        ->type_name("N");
    command.add_flag("--explain", options->explain,
                     "Print to stderr what was summed, the bias, and how many bits such a table needs");
    return {&command, [options] {
                RequireFloatOptionsFit(options->table, SATPrecision::FP32, SATOrigin::LowerLeft);
                const bool isFloat = PrecisionOf(options->table).value_or(SATPrecision::FP32) == SATPrecision::FP32;
                if (isFloat && options->order > 1)
                    throw UsageError("--order {} with --precision fp32: floats hold order 1; use u32 or u64",
                                     options->order);
                const std::vector<Job> jobs = PlanJobs(options->files);
                for (const Job& job : jobs) {
                    if (!isFloat && job.format != FileFormat::Exr)
                        throw UsageError("-o {}: a table of integers is written as .exr", job.output);
                    if (job.format != FileFormat::Exr && job.format != FileFormat::Pfm)
                        throw UsageError("-o {}: a table needs a float format, .exr or .pfm", job.output);
                }
                RunBatch("sat", *options, jobs,
                         [&](Device& device, const Job& job) { return WriteTable(device, job, *options); });
            }};
}

}  // namespace boxcar
