#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <filesystem>

#include "samples/cli/commands.h"
#include "samples/cli/console.h"
#include "samples/cli/effect_run.h"
#include "samples/cli/outputs.h"
#include "samples/cli/print_stats.h"

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

}  // namespace

Command AddRenderCommand(CLI::App& app) {
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
    return {&command, [options] { Render(*options); }};
}

}  // namespace boxcar
