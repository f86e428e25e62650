// A pixel shader that does not take exactly what its vertex shader writes. Locations are numbered in the order of
// declaration and semantics are ignored, so another order or a subset reads another output's value.
#include "tools/bxc/rules.h"

#include <map>

namespace boxcar::rules::stage_link {
namespace {

std::map<uint32_t, const LayoutVariable*> ByLocation(const std::vector<LayoutVariable>& variables) {
    std::map<uint32_t, const LayoutVariable*> byLocation;
    for (const LayoutVariable& variable : variables)
        byLocation.emplace(variable.location, &variable);
    return byLocation;
}

std::string Text(const LayoutVariable& variable) {
    return fmt::format("{} {} : {}", variable.type, variable.name, variable.semantic);
}

bool Match(const LayoutVariable& a, const LayoutVariable& b) {
    return a.type == b.type && a.locationCount == b.locationCount && a.semantic == b.semantic;
}

}  // namespace

void Check(const RuleSubject& shader, const RuleSubject* before, Diagnostics& diagnostics) {
    if (!before || !before->compiled.hasEntry || !shader.compiled.hasEntry) return;
    const auto error = [&](const SourcePlace& place, const std::string& text) {
        diagnostics.push_back({place, Severity::Error, text + "; let both stages share one struct"});
    };
    const auto noteWhereWritten = [&](const LayoutVariable& out) {
        diagnostics.push_back({before->outline.Output(before->options.entry, out.name), Severity::Note,
                               fmt::format("'{}' is written here", Text(out))});
    };
    const std::string& entry = shader.options.entry;
    const auto written = ByLocation(before->declared.outputs);
    const auto taken = ByLocation(shader.declared.inputs);
    for (const auto& [location, in] : taken) {
        const SourcePlace place = shader.outline.Input(entry, in->name);
        const auto out = written.find(location);
        if (out == written.end()) {
            error(place, fmt::format("the vertex shader does not write '{}'", Text(*in)));
        } else if (!Match(*in, *out->second)) {
            error(place, fmt::format("'{}' would receive another output, for it has the same location, {}", Text(*in),
                                     location));
            noteWhereWritten(*out->second);
        }
    }
    for (const auto& [location, out] : written) {
        if (taken.contains(location)) continue;
        error(shader.EntryPlace(), fmt::format("'{}' takes only a part of what the vertex shader writes", entry));
        noteWhereWritten(*out);
    }
}

}  // namespace boxcar::rules::stage_link
