#include "samples/effects/effect.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "samples/effects/effects.h"
#include "tools/base/error.h"

namespace boxcar {
namespace {

std::string NamesOf(const auto& all, auto name) {
    std::string names;
    for (const auto& one : all)
        names += fmt::format("{}{}", names.empty() ? "" : ", ", name(one));
    return names;
}

float Parse(const Parameter& parameter, std::string_view text) {
    if (!parameter.choices.empty()) {
        const auto found = std::ranges::find(parameter.choices, text);
        if (found == parameter.choices.end())
            throw UsageError("{}={}: expected one of {}", parameter.name, text,
                             NamesOf(parameter.choices, [](std::string_view choice) { return choice; }));
        return static_cast<float>(found - parameter.choices.begin());
    }
    float value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool isNumber = error == std::errc() && end == text.data() + text.size();
    if (!isNumber || !(value >= parameter.minimum && value <= parameter.maximum) ||
        (parameter.isWhole && value != std::floor(value)))
        throw UsageError("{}={}: expected {} from {:g} to {:g}{}{}", parameter.name, text,
                         parameter.isWhole ? "a whole number" : "a number", parameter.minimum, parameter.maximum,
                         parameter.unit.empty() ? "" : " ", parameter.unit);
    return value;
}

}  // namespace

Parameter Parameter::Number(std::string_view name, std::string_view what, const Range& range) {
    return {.name = name,
            .what = what,
            .unit = range.unit,
            .minimum = range.minimum,
            .maximum = range.maximum,
            .initial = range.initial};
}

Parameter Parameter::Whole(std::string_view name, std::string_view what, const Range& range) {
    Parameter whole = Number(name, what, range);
    whole.isWhole = true;
    return whole;
}

Parameter Parameter::Choice(std::string_view name, std::string_view what, std::vector<std::string_view> words,
                            std::string_view initial) {
    const auto found = std::ranges::find(words, initial);
    BOXCAR_ASSERT(found != words.end());
    const auto index = static_cast<float>(found - words.begin());
    return {.name = name, .what = what, .unit = {}, .initial = index, .choices = std::move(words)};
}

Parameter Parameter::Fixed() const {
    Parameter fixed = *this;
    fixed.isFixed = true;
    return fixed;
}

ParameterValues::ParameterValues(std::span<const Parameter> parameters) : m_parameters(parameters) {
    for (const Parameter& parameter : parameters)
        m_values.push_back(parameter.initial);
}

void ParameterValues::Set(std::string_view name, std::string_view text) {
    const auto found = std::ranges::find(m_parameters, name, &Parameter::name);
    if (found == m_parameters.end())
        throw UsageError("no parameter '{}'; there is {}", name,
                         NamesOf(m_parameters, [](const Parameter& parameter) { return parameter.name; }));
    m_values[static_cast<size_t>(found - m_parameters.begin())] = Parse(*found, text);
}

size_t ParameterValues::IndexOf(std::string_view name) const {
    const auto found = std::ranges::find(m_parameters, name, &Parameter::name);
    BOXCAR_ASSERT(found != m_parameters.end());
    return static_cast<size_t>(found - m_parameters.begin());
}

float ParameterValues::operator[](std::string_view name) const {
    return m_values[IndexOf(name)];
}

std::string_view ParameterValues::Choice(std::string_view name) const {
    const size_t index = IndexOf(name);
    return m_parameters[index].choices.at(static_cast<size_t>(m_values[index]));
}

const Image& Effect::Record(CommandList& commands, const Frame& frame) {
    m_stages.clear();
    return AddStage("picture", Draw(commands, frame));
}

const Image& Effect::AddStage(std::string name, const Image& image) {
    BOXCAR_ASSERT(name.find(',') == std::string::npos);
    BOXCAR_ASSERT(std::ranges::find(m_stages, name, &EffectStage::name) == m_stages.end());
    m_stages.push_back({std::move(name), &image});
    return image;
}

void Effect::AddTableStages(const std::string& name, TexelWords table) {
    AddStage(name, *table.low);
    if (table.high) AddStage(name + "-high", *table.high);
}

std::span<const EffectInfo> Effects() {
    static const EffectInfo kEffects[] = {
        GlossyEnvironmentInfo(), PhongEnvironmentInfo(), ParaboloidDirectInfo(),
        PlanarReflectionInfo(),  TranslucencyInfo(),     SoftShadowInfo(),
        TextureFilteringInfo(),  DepthOfFieldInfo(),     IsosurfaceInfo(),
    };
    return kEffects;
}

const EffectInfo& FindEffect(std::string_view name) {
    const auto found = std::ranges::find(Effects(), name, &EffectInfo::name);
    if (found == Effects().end())
        throw UsageError("no effect '{}'; there is {}", name,
                         NamesOf(Effects(), [](const EffectInfo& info) { return info.name; }));
    return *found;
}

}  // namespace boxcar
