#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "runtime/transfer.h"
#include "samples/cli/commands.h"
#include "samples/cli/console.h"
#include "samples/cli/effect_run.h"
#include "tools/base/printable.h"

namespace boxcar {
namespace {

struct InspectOptions : EffectOptions {
    std::string stage;
    std::string pixel;
    std::string output;
    bool json = false;
};

// An image of any format, in doubles: exact for all of them.
struct StageTexels {
    Extent2D extent;
    int channels = 4;
    std::vector<double> samples;
};

StageTexels ReadStage(Device& device, const Image& image) {
    const Format format = image.Desc().format;
    std::vector<std::byte> bytes(image.Extent().Texels() * BytesPerTexel(format));
    ReadTexels(device, image, bytes);
    StageTexels stage{image.Extent(), format == Format::R32F || format == Format::Depth32F ? 1 : 4, {}};
    const size_t count = image.Extent().Texels() * static_cast<size_t>(stage.channels);
    const auto convert = [&]<typename T>(const T* samples, auto toDouble) {
        for (size_t i = 0; i < count; i++)
            stage.samples.push_back(toDouble(samples[i]));
    };
    const auto asDouble = [](auto value) { return static_cast<double>(value); };
    switch (format) {
        case Format::RGBA32UI: convert(reinterpret_cast<const uint32_t*>(bytes.data()), asDouble); break;
        case Format::RGBA16F:
            convert(reinterpret_cast<const uint16_t*>(bytes.data()),
                    [](uint16_t half) { return static_cast<double>(glm::unpackHalf1x16(half)); });
            break;
        case Format::RGBA8:
            convert(reinterpret_cast<const uint8_t*>(bytes.data()), [](uint8_t code) { return code / 255.0; });
            break;
        default: convert(reinterpret_cast<const float*>(bytes.data()), asDouble); break;
    }
    return stage;
}

const Image& FindStage(const std::vector<EffectStage>& stages, const std::string& name) {
    const auto found = std::ranges::find(stages, name, &EffectStage::name);
    if (found != stages.end()) return *found->image;
    std::string names;
    for (const EffectStage& stage : stages)
        names += fmt::format("{}{}", names.empty() ? "" : ", ", stage.name);
    throw UsageError("--stage {}: there is {}", name, names);
}

nlohmann::ordered_json Summary(const std::string& name, const StageTexels& stage,
                               const std::optional<glm::uvec2>& pixel) {
    const auto channels = static_cast<size_t>(stage.channels);
    constexpr double kNone = std::numeric_limits<double>::infinity();
    std::vector<double> least(channels, kNone), largest(channels, -kNone), sum(channels, 0), count(channels, 0);
    uint64_t nan = 0, inf = 0;
    for (size_t i = 0; i < stage.samples.size(); i++) {
        const double value = stage.samples[i];
        nan += std::isnan(value);
        inf += std::isinf(value);
        if (!std::isfinite(value)) continue;
        const size_t c = i % channels;
        least[c] = std::min(least[c], value);
        largest[c] = std::max(largest[c], value);
        sum[c] += value;
        count[c]++;
    }
    for (size_t c = 0; c < channels; c++)
        sum[c] /= count[c];
    nlohmann::ordered_json json = {
        {"stage", name},    {"size", {stage.extent.widthTexels, stage.extent.heightTexels}},
        {"pixel", nullptr}, {"min", least},
        {"max", largest},   {"mean", sum},
        {"nan", nan},       {"inf", inf}};
    if (pixel) {
        const size_t at = (size_t{pixel->y} * stage.extent.widthTexels + pixel->x) * channels;
        json["pixel"] = std::vector(stage.samples.begin() + static_cast<std::ptrdiff_t>(at),
                                    stage.samples.begin() + static_cast<std::ptrdiff_t>(at + channels));
    }
    return json;
}

void WriteStage(const StageTexels& stage, const Image& image, const std::string& path) {
    const auto [width, height] = stage.extent;
    if (image.Desc().format == Format::RGBA32UI) {
        std::vector<UintChannel> channels = {{"R", {}}, {"G", {}}, {"B", {}}, {"A", {}}};
        for (size_t i = 0; i < stage.samples.size(); i++)
            channels[i % 4].samples.push_back(static_cast<uint32_t>(stage.samples[i]));
        WriteUintExr(channels, width, height, path);
        return;
    }
    const Picture picture{width,
                          height,
                          static_cast<uint32_t>(stage.channels),
                          SampleType::Float32,
                          {stage.samples.begin(), stage.samples.end()}};
    WritePicture(picture, path, FileFormat::Exr, SampleType::Float32);
}

void Inspect(const InspectOptions& options) {
    const std::vector<Setting> settings = SettingsOf(options);
    if (!options.output.empty()) {
        if (FormatFromName(options.output) != FileFormat::Exr)
            throw UsageError("-o {}: a stage is written as .exr", options.output);
        RequireFolder(options.output);
    }
    CheckedDevice device(options.device);
    EffectRun run(*device, options, settings);
    run.PrintNotes();
    run.Samples(options.timeSeconds);
    const Image& image = FindStage(run.Stages(), options.stage);
    std::optional<glm::uvec2> pixel;
    if (!options.pixel.empty()) pixel = ParseTexel("--pixel", options.pixel, image.Extent());
    const StageTexels stage = ReadStage(*device, image);
    if (!options.output.empty()) WriteStage(stage, image, options.output);
    nlohmann::ordered_json summary = Summary(options.stage, stage, pixel);
    if (run.Info().takesVolume) summary["volume"] = run.VolumeLine();
    if (options.json) {
        PrintJson(summary);
    } else {
        std::string text;
        for (const auto& [key, value] : summary.items())
            if (!value.is_null())
                text += fmt::format("{:6} {}\n", key,
                                    value.is_string() ? Printable(value.get<std::string>()) : value.dump());
        PrintDocument(text);
    }
    device.RequireClean();
}

}  // namespace

Command AddInspectCommand(CLI::App& app) {
    const auto options = std::make_shared<InspectOptions>();
    CLI::App& command = *app.add_subcommand("inspect", "Numbers of any image that an effect makes on its way");
    command.footer(
        "Minimum, maximum and mean a channel over what is finite; how many samples are not; of a volume how its file "
        "says that it lies.\n\n"
        "Example:\n  boxcar inspect planar-reflection --stage reflected --pixel 320,200 --json");
    AddEffectOptions(command, *options);
    command.add_option("--stage", options->stage, "Name of the image; a wrong one lists them")
        ->required()
        ->type_name("NAME");
    command.add_option("--pixel", options->pixel, "A texel to print as well")->type_name("X,Y");
    command.add_option("-o,--output", options->output, "The image as an EXR file")->type_name("F.exr");
    command.add_flag("--json", options->json, "Print one JSON document");
    return {&command, [options] { Inspect(*options); }};
}

}  // namespace boxcar
