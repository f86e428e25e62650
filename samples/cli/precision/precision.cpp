#include "samples/cli/precision/precision.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "samples/app/light.h"
#include "samples/cli/commands.h"
#include "samples/cli/console.h"
#include "samples/files/color.h"

namespace boxcar {
namespace {

using Measurements = std::vector<Measurement>;

nlohmann::ordered_json ToJson(const Measurement& measured) {
    const auto orNull = [](std::optional<double> value) {
        return value && std::isfinite(*value) ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
    };
    nlohmann::ordered_json json = {{"precision", Name(measured.setup.precision)}, {"bias", Name(measured.setup.bias)},
                                   {"origin", Name(measured.setup.origin)},       {"taps", measured.setup.taps},
                                   {"builder", Name(measured.setup.builder)},     {"snr_db", orNull(measured.snrDb)}};
    if (!measured.snrDb) json["overflow"] = true;
    for (const auto& [sizeTexels, rms] : measured.widths)
        json["rms_by_width"][std::to_string(sizeTexels)] = orNull(rms);
    return json;
}

std::string Numbers(const Measurement& measured) {
    std::string text = !measured.snrDb               ? fmt::format("{:>9}", "overflow")
                       : std::isinf(*measured.snrDb) ? fmt::format("{:>9}", "exact")
                                                     : fmt::format("{:9.2f}", *measured.snrDb);
    for (const auto& width : measured.widths)
        text += width.rms ? fmt::format("  {:8.2e}", *width.rms) : fmt::format("  {:>8}", "-");
    return text;
}

// One row for all numbers of taps that give the same numbers.
std::string Table(const std::string& name, const Subject& subject, const Measurements& all) {
    std::string text =
        fmt::format("{}: {} x {} texels, {} colour channel{}\n", Printable(name), subject.extent.widthTexels,
                    subject.extent.heightTexels, subject.colors, subject.colors == 1 ? "" : "s");
    text += fmt::format("{:8}{:10}{:6}{:8}{:10}{:>9}  RMS error of boxes of width", "builder", "precision", "bias",
                        "origin", "taps", "SNR dB");
    text += fmt::format("\n{:51}", "");
    for (const uint32_t width : kMeasuredWidths)
        text += fmt::format("  {:>8}", width);
    text += fmt::format("\n");
    for (size_t i = 0; i < all.size();) {
        const Case& setup = all[i].setup;
        const std::string numbers = Numbers(all[i]);
        std::string taps;
        const auto sameRow = [&](const Measurement& other) {
            return other.setup.builder == setup.builder && other.setup.precision == setup.precision &&
                   other.setup.bias == setup.bias && other.setup.origin == setup.origin && Numbers(other) == numbers;
        };
        size_t next = i;
        for (; next < all.size() && sameRow(all[next]); next++)
            taps += fmt::format("{}{}", taps.empty() ? "" : " ", all[next].setup.taps);
        text += fmt::format("{:8}{:10}{:6}{:8}{:10}{}\n", Name(setup.builder), Name(setup.precision),
                            Name(setup.bias), Name(setup.origin), taps, numbers);
        i = next;
    }
    return text;
}

struct PrecisionOptions {
    std::vector<std::string> inputs;
    DeviceOptions device;
    ReadOptions read{.transferWord = "raw"};
    bool json = false;
};

void MeasurePictures(const PrecisionOptions& options) {
    CheckedDevice device(options.device);
    const bool terminal = isatty(STDERR_FILENO);
    nlohmann::ordered_json document = nlohmann::ordered_json::array();
    size_t failed = 0;
    for (const std::string& input : options.inputs) {
        try {
            const Picture picture = ReadForDevice(input, *device, options.read);
            Meter meter(*device, SubjectOf(picture, TransferOf(options.read)));
            Measurements all;
            const std::vector<Case> cases = AllCases(meter.Picture().largestCode);
            for (const Case& setup : cases) {
                if (terminal) fmt::print(stderr, "\r[{}/{}] {}", all.size() + 1, cases.size(), Printable(input));
                all.push_back(meter.Measure(setup));
            }
            if (terminal) fmt::print(stderr, "\r\033[K");
            auto& results = document.emplace_back(nlohmann::ordered_json{{"image", input}})["results"];
            for (const Measurement& measured : all)
                results.push_back(ToJson(measured));
            if (!options.json) PrintDocument(Table(input, meter.Picture(), all));
        } catch (const Error& error) {
            if (terminal) fmt::print(stderr, "\r\033[K");
            if (options.inputs.size() == 1) throw;
            PrintProblem(error.what());
            document.push_back({{"image", input}, {"error", error.what()}});
            failed++;
        }
    }
    if (options.json) PrintJson(document);
    device.RequireClean();
    if (failed > 0) throw Error("{} of {} inputs failed", failed, options.inputs.size());
}

}  // namespace

Subject SubjectOf(const Picture& picture, Transfer transfer) {
    const bool floats = picture.stored == SampleType::Float32;
    const bool wholeCodes = !floats && transfer == Transfer::Raw;
    const uint32_t largestCode = floats ? 0 : wholeCodes && picture.stored == SampleType::Unorm8 ? 255 : 65535;
    return {{picture.widthTexels, picture.heightTexels},
            ToLight(picture, transfer),
            picture.channels < 3 ? 1 : 3,
            largestCode,
            wholeCodes};
}

Command AddPrecisionCommand(CLI::App& app) {
    const auto options = std::make_shared<PrecisionOptions>();
    CLI::App& command = *app.add_subcommand(
        "precision", "Measure how well tables of several precisions give a picture back, on the device");
    command.footer(
        "Each row is a table: precision fp16, fp24 (ATI's 1-7-16; fp24t is truncated), fp32 or u32 (whole codes);\n"
        "bias taken off every texel; origin of the sums; texels added a pass; builder. SNR is that of the 1 x 1 "
        "box;\n"
        "RMS is the error of the mean over wider boxes, clipped to the picture. Float pictures have no u32 rows, "
        "and\n"
        "only 8-bit pictures under raw have blocks.\n\n"
        "Example:\n"
        "  boxcar precision photo.png --json");
    command.add_option("IN", options->inputs, "PNG, JPEG, HDR, EXR or PFM pictures; - is standard input")->required();
    command
        .add_option("--transfer", options->read.transferWord,
                    "raw (default): measure values as they stand; srgb: linear light of 8 and 16-bit files")
        ->check(CLI::IsMember({"srgb", "raw"}))
        ->type_name("T");
    command.add_option("--nan", options->read.nanWord, "What to do with NaN and infinity: refuse (default) or zero")
        ->check(CLI::IsMember({"refuse", "zero"}))
        ->type_name("N");
    AddDeviceOptions(command, options->device);
    command.add_flag("--json", options->json, "Print one JSON array on stdout, an object a picture");
    return {&command, [options] { MeasurePictures(*options); }};
}

}  // namespace boxcar
