// A pixel shader that does not take exactly what its vertex shader writes. Locations are numbered in the order of
// declaration and semantics are ignored, so another order or a subset reads another output's value.
#include "tools/bxc/rules.h"

#include <map>
#include <set>

namespace boxcar::rules::stage_link {
namespace {

std::map<uint32_t, const DeclaredVariable*> ByLocation(const std::vector<DeclaredVariable>& variables) {
    std::map<uint32_t, const DeclaredVariable*> byLocation;
    for (const DeclaredVariable& variable : variables)
        if (!variable.builtIn) byLocation.emplace(variable.location, &variable);
    return byLocation;
}

std::string Text(const DeclaredVariable& variable) {
    return fmt::format("{} {} : {}", variable.type, variable.name, variable.semantic);
}

}  // namespace

void Check(const RuleInput& input, Diagnostics& diagnostics) {
    if (!input.before) return;
    const auto written = ByLocation(input.before->outputs);
    const auto taken = ByLocation(input.shader.inputs);
    for (const auto& [location, in] : taken) {
        const auto out = written.find(location);
        if (out == written.end())
            diagnostics.push_back(
                {in->place, Severity::Error,
                 fmt::format("'{}' at location {} is not written by {}", Text(*in), location, input.before->file)});
        else if (in->type != out->second->type || in->semantic != out->second->semantic)
            diagnostics.push_back({in->place, Severity::Error,
                                   fmt::format("'{}' would receive '{}' of {} (location {}); share one struct",
                                               Text(*in), Text(*out->second), input.before->file, location)});
    }
    for (const auto& [location, out] : written)
        if (!taken.contains(location))
            diagnostics.push_back({input.shader.entryPlace, Severity::Error,
                                   fmt::format("'{}' of {} (location {}) is not taken; share one struct", Text(*out),
                                               input.before->file, location)});
}

}  // namespace boxcar::rules::stage_link
