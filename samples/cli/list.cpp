#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "samples/cli/commands.h"
#include "samples/cli/console.h"
#include "samples/effects/effect.h"

namespace boxcar {
namespace {

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

Command AddListCommand(CLI::App& app) {
    const auto asJson = std::make_shared<bool>(false);
    CLI::App& command = *app.add_subcommand("list", "The effects and their parameters");
    command.footer("Example:\n  boxcar list --json");
    command.add_flag("--json", *asJson, "Print them as one JSON document");
    return {&command, [asJson] { List(*asJson); }};
}

}  // namespace boxcar
