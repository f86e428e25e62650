#include "samples/cli/render.h"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>

#include "samples/cli/console.h"
#include "samples/cli/effect_run.h"
#include "samples/cli/outputs.h"
#include "samples/cli/stats.h"

namespace boxcar {
namespace {

constexpr uint32_t kMaxFrames = 100000;
constexpr double kSecondsPerFrame = 1.0 / 30;

struct RenderOptions : EffectOptions {
    std::string output;
    std::string formatWord;
    uint32_t frames = 1;
    bool stats = false;
};

// OUT.png is OUT.0000.png, OUT.0001.png, ..
std::string FrameName(const std::string& output, uint32_t frame) {
    const std::filesystem::path path(output);
    const std::string name = fmt::format("{}.{:04}{}", path.stem().string(), frame, path.extension().string());
    return (path.parent_path() / name).string();
}

void Render(const RenderOptions& options) {
    if (options.frames < 1 || options.frames > kMaxFrames)
        throw UsageError("--frames {}: expected 1 to {}", options.frames, kMaxFrames);
    const std::vector<Setting> settings = SettingsOf(options);
    const EffectInfo& info = FindEffect(options.effect);
    const Job job = PlanJobs({{std::string(info.name) + ".png"}, options.output, options.formatWord}).at(0);
    if (options.frames > 1 && job.output == "-")
        throw UsageError("-o - and --frames {}: several frames need files", options.frames);
    RequireWritable(job.output, job.format, 3);
    RequireFolder(job.output);

    CheckedDevice device(options.device);
    EffectRun run(*device, options, settings);
    run.PrintNotes();
    const SampleType sampleType = SampleTypeFor(job.format, SampleType::Unorm8);
    const bool terminal = options.frames > 1 && isatty(STDERR_FILENO);
    for (uint32_t frame = 0; frame < options.frames; frame++) {
        if (terminal) fmt::print(stderr, "\r[{}/{}]", frame + 1, options.frames);
        Stats stats{.input = std::string(info.name),
                    .output = options.frames > 1 ? FrameName(job.output, frame) : job.output,
                    .extent = run.Extent(),
                    .volume = run.VolumeLine()};
        const double time = options.timeSeconds + frame * kSecondsPerFrame;
        const Picture picture = run.Render(time, sampleType, options.stats ? &stats.passes : nullptr);
        WritePicture(picture, stats.output, job.format, sampleType);
        stats.deviceBytes = device->MemoryBytes();
        if (options.stats) PrintStats(stats, device->Info());
    }
    if (terminal) fmt::print(stderr, "\r\033[K");
    device.RequireClean();
}

nlohmann::ordered_json ToJson(const Parameter& parameter) {
    const bool isChoice = !parameter.choices.empty();
    nlohmann::ordered_json json = {{"name", parameter.name},
                                   {"what", parameter.what},
                                   {"type", isChoice            ? "choice"
                                            : parameter.isWhole ? "int"
                                                                : "float"},
                                   {"unit", parameter.unit},
                                   {"min", nullptr},
                                   {"max", nullptr}};
    if (isChoice) {
        json["default"] = parameter.choices[static_cast<size_t>(parameter.initial)];
        json["choices"] = parameter.choices;
        return json;
    }
    // As decimal as they were written: 0.12, not 0.11999999731779099.
    const auto number = [](float value) { return nlohmann::ordered_json::parse(fmt::format("{}", value)); };
    json["min"] = number(parameter.minimum);
    json["max"] = number(parameter.maximum);
    json["default"] = number(parameter.initial);
    return json;
}

void List(bool asJson) {
    if (asJson) {
        auto document = nlohmann::ordered_json::array();
        for (const EffectInfo& info : Effects()) {
            auto parameters = nlohmann::ordered_json::array();
            for (const Parameter& parameter : info.parameters)
                parameters.push_back(ToJson(parameter));
            document.push_back({{"name", info.name},
                                {"what", info.what},
                                {"paper", info.paper},
                                {"look_for", info.lookFor},
                                {"takes_environment", info.takesEnvironment},
                                {"takes_mesh", info.takesMesh},
                                {"takes_volume", info.takesVolume},
                                {"parameters", parameters}});
        }
        PrintJson(document);
        return;
    }
    std::string text;
    for (const EffectInfo& info : Effects()) {
        text += fmt::format("{}{}{}{}\n  {} ({})\n  Look for this: {}.\n", info.name,
                            info.takesEnvironment ? "  [--env F]" : "", info.takesMesh ? "  [--mesh F]" : "",
                            info.takesVolume ? "  [--volume F]" : "", info.what, info.paper, info.lookFor);
        for (const Parameter& p : info.parameters) {
            std::string range;
            for (const std::string_view choice : p.choices)
                range += fmt::format("{}{}", range.empty() ? "" : "|", choice);
            if (p.choices.empty())
                range = fmt::format("{:g}..{:g}{}{}", p.minimum, p.maximum, p.unit.empty() ? "" : " ", p.unit);
            const std::string initial =
                p.choices.empty() ? fmt::format("{:g}", p.initial) : std::string(p.choices[size_t(p.initial)]);
            text += fmt::format("    {:14} {} ({}; {})\n", p.name, p.what, range, initial);
        }
    }
    PrintDocument(text);
}

}  // namespace

void AddRenderCommand(CLI::App& app) {
    const auto options = std::make_shared<RenderOptions>();
    CLI::App& command = *app.add_subcommand("render", "Draw an effect of the papers to a picture");
    command.footer(
        "Several frames go to OUT.0000.png, OUT.0001.png, .. at 30 a second. EXR and PFM hold linear light; PNG and\n"
        "JPEG hold sRGB codes, and of glossy-environment and phong-environment bend what is beyond 0.7 to stay "
        "below\n"
        "1.\n\n"
        "Examples:\n"
        "  boxcar render planar-reflection -o floor.png\n"
        "  boxcar render planar-reflection --set roughness=0.3 --mesh teapot --size 1280x720 -o floor.png\n"
        "  boxcar render isosurface --volume scan.nii.gz --iso 92 --shade curvature --filter tricubic -o scan.png");
    AddEffectOptions(command, *options);
    AddSamplesOption(command, *options);
    command.add_option("-o,--output", options->output, "File, folder/ or - for standard output")
        ->required()
        ->type_name("OUT");
    AddFormatOption(command, options->formatWord);
    command.add_option("--frames", options->frames, "How many frames, 1/30 s apart (default 1)")->type_name("N");
    command.add_flag("--stats", options->stats,
                     "Print device, passes, milliseconds a pass and device memory to stderr");
    command.callback([options] { Render(*options); });
}

void AddListCommand(CLI::App& app) {
    const auto asJson = std::make_shared<bool>(false);
    CLI::App& command = *app.add_subcommand("list", "The effects and their parameters");
    command.footer("Example:\n  boxcar list --json");
    command.add_flag("--json", *asJson, "Print them as one JSON document");
    command.callback([asJson] { List(*asJson); });
}

}  // namespace boxcar
