// A shader that does not take exactly what the one before it writes. Locations are numbered in the order of
// declaration and semantics are ignored, so another order or a subset reads another output's value.
#include <cstdlib>
#include <map>

#include "tools/bxc/rules.h"

namespace boxcar::rules::stage_link {
namespace {

std::string WithIndexPlus(const std::string& semantic, uint32_t offset) {
    const size_t digits = semantic.find_last_not_of("0123456789") + 1;
    return fmt::format("{}{}", semantic.substr(0, digits), std::atoi(semantic.c_str() + digits) + offset);
}

// A matrix or an array takes several locations, and as many semantics.
std::map<uint32_t, LayoutVariable> ByLocation(const std::vector<LayoutVariable>& variables) {
    std::map<uint32_t, LayoutVariable> byLocation;
    for (const LayoutVariable& variable : variables)
        for (uint32_t i = 0; i < variable.locationCount; ++i)
            byLocation[variable.location + i] = {variable.name, WithIndexPlus(variable.semantic, i),
                                                 variable.location + i, 1, variable.type};
    return byLocation;
}

const char* NameOf(ShaderStage stage) {
    switch (stage) {
        case ShaderStage::Hull: return "hull";
        case ShaderStage::Domain: return "domain";
        case ShaderStage::Geometry: return "geometry";
        default: return "vertex";
    }
}

std::string Text(const LayoutVariable& variable) {
    return fmt::format("{} {} : {}", variable.type, variable.name, variable.semantic);
}

}  // namespace

void Check(const RuleSubject& shader, const RuleSubject* before, Diagnostics& diagnostics) {
    if (!before || !before->compiled.hasEntry || !shader.compiled.hasEntry) return;
    const auto error = [&](const SourcePlace& place, const std::string& text) {
        diagnostics.push_back({place, Severity::Error, text + "; use one struct for both stages"});
    };
    const auto noteWhereWritten = [&](const LayoutVariable& out) {
        diagnostics.push_back(
            {before->outline.Output(before->options.entry, out.name), Severity::Note, "it is written here"});
    };
    const std::string& entry = shader.options.entry;
    const char* const writer = NameOf(before->options.stage);
    const auto written = ByLocation(before->declared.outputs);
    const auto taken = ByLocation(shader.declared.inputs);
    for (const auto& [location, in] : taken) {
        const SourcePlace place = shader.outline.Input(entry, in.name);
        const auto out = written.find(location);
        if (out == written.end()) {
            error(place, fmt::format("the {} shader does not write '{}'", writer, Text(in)));
        } else if (in.type != out->second.type || in.semantic != out->second.semantic) {
            error(place, fmt::format("'{}' has location {}, where the {} shader writes '{}'", Text(in), location,
                                     writer, Text(out->second)));
            noteWhereWritten(out->second);
        }
    }
    for (const auto& [location, out] : written) {
        if (taken.contains(location)) continue;
        error(shader.EntryPlace(), fmt::format("'{}' does not take '{}'", entry, Text(out)));
        noteWhereWritten(out);
    }
}

}  // namespace boxcar::rules::stage_link
