#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>

#include "samples/cli/commands.h"
#include "samples/cli/console.h"
#include "samples/effects/lobe_fit.h"
#include "tools/base/error.h"

namespace boxcar {
namespace {

struct FitOptions {
    std::optional<double> phong;
    std::optional<double> ggx;
    int boxes = 4;
    bool json = false;
};

void Fit(const FitOptions& options) {
    if (options.phong.has_value() == options.ggx.has_value())
        throw UsageError("fit-lobe takes one lobe: --phong N or --ggx ALPHA");
    if (options.phong && !(*options.phong >= 1 && *options.phong <= 1e6))
        throw UsageError("--phong {:g}: expected an exponent from 1 to 1e6", *options.phong);
    if (options.ggx && !(*options.ggx >= 1e-3 && *options.ggx <= 1))
        throw UsageError("--ggx {:g}: expected alpha from 0.001 to 1", *options.ggx);
    if (options.boxes < 1 || options.boxes > 6) throw UsageError("--boxes {}: expected 1 to 6", options.boxes);

    const BoxStackFit fit =
        FitBoxStack(options.phong ? PhongLobe(*options.phong) : GgxLobe(*options.ggx), options.boxes);
    if (options.json) {
        const nlohmann::ordered_json document = {
            {"half_widths", fit.halfWidths}, {"weights", fit.weights}, {"relative_error", fit.relativeError}};
        PrintJson(document);
        return;
    }
    std::string text = "half-width  of a cone  texels of 256   weight\n";
    for (size_t i = 0; i < fit.weights.size(); i++) {
        const double degrees = 2 * std::atan(fit.halfWidths[i]) * 180 / std::numbers::pi;
        text += fmt::format("{:10.5f}  {:6.2f} deg  {:13.2f}  {:7.4f}\n", fit.halfWidths[i], degrees,
                            256 * fit.halfWidths[i], fit.weights[i]);
    }
    text += fmt::format("relative L2 error {:.1f} %\n", 100 * fit.relativeError);
    if (fit.halfWidths.back() > std::tan(std::numbers::pi / 8))
        text += "boxes of more than 45 degrees are cut at that by hlsl/boxcar/dual_paraboloid_sat.hlsli\n";
    PrintDocument(text);
}

}  // namespace

Command AddFitLobeCommand(CLI::App& app) {
    const auto options = std::make_shared<FitOptions>();
    CLI::App& command = *app.add_subcommand("fit-lobe", "Stacks of boxes that stand for a lobe of reflected light");
    command.footer(
        "Half-widths are in the radius of a paraboloid's disc; texels are full widths on a face of 256. Weights are "
        "of\n"
        "each box's mean and add up to 1.\n\n"
        "Examples:\n  boxcar fit-lobe --phong 50 --boxes 4\n  boxcar fit-lobe --ggx 0.1 --boxes 6 --json");
    command.add_option("--phong", options->phong, "The lobe cos^N")->type_name("N");
    command.add_option("--ggx", options->ggx, "The lobe of a GGX surface seen from above")->type_name("ALPHA");
    command.add_option("--boxes", options->boxes, "1 to 6 (default 4)")->type_name("K");
    command.add_flag("--json", options->json, "Print one JSON document");
    return {&command, [options] { Fit(*options); }};
}

}  // namespace boxcar
