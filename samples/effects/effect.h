// What every effect that draws a scene has in common, and the one table of them: `boxcar list`, `render`, `sweep` and
// `inspect` and the gallery read it.
//
//   EffectInputs, ParameterValues  ->  EffectInfo::make  ->  Effect  ->  Record, once a frame  ->  picture
//
// Non-goals: composition of effects; anything that is prefiltered before the first frame.
#pragma once

#include <algorithm>
#include <iterator>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/command_list.h"
#include "runtime/passes/texel_words.h"
#include "samples/files/volume.h"
#include "samples/scenes/environment.h"
#include "tools/base/error.h"

namespace boxcar {

// A word on the command line, and what it stands for.
template <typename T>
struct Word {
    std::string_view word;
    T value;
};

// What `word`, one of the table's, stands for.
template <typename T, size_t N>
const T& ValueOf(const Word<T> (&table)[N], std::string_view word) {
    const auto found = std::ranges::find(table, word, &Word<T>::word);
    BOXCAR_ASSERT(found != std::end(table));
    return found->value;
}

// Something about an effect that can be set: a number, a whole number, or one of some words.
struct Parameter {
    struct Range {
        float minimum = 0;
        float maximum = 1;
        float initial = 0;
        std::string_view unit = {};  // "texels", "degrees", ..; empty for a bare number
    };

    static Parameter Number(std::string_view name, std::string_view what, const Range& range);
    static Parameter Whole(std::string_view name, std::string_view what, const Range& range);

    // initial: one of the words.
    static Parameter Choice(std::string_view name, std::string_view what, std::vector<std::string_view> words,
                            std::string_view initial);

    // The words of a table; ValueOf(table, ParameterValues::Choice(name)) is what the chosen one stands for.
    template <typename T, size_t N>
    static Parameter Choice(std::string_view name, std::string_view what, const Word<T> (&table)[N],
                            std::string_view initial) {
        std::vector<std::string_view> words;
        for (const Word<T>& one : table)
            words.push_back(one.word);
        return Choice(name, what, std::move(words), initial);
    }

    // The same, but it must be known when the effect is made; the others may change every frame.
    Parameter Fixed() const;

    std::string_view name;
    std::string_view what;
    std::string_view unit;
    float minimum = 0;
    float maximum = 1;
    float initial = 0;                           // of a choice: its index
    std::vector<std::string_view> choices = {};  // not empty: one of these words; minimum and maximum do not count
    bool isWhole = false;
    bool isFixed = false;
};

// A value for each parameter of an effect.
class ParameterValues {
public:
    // The initial values. `parameters` must live on.
    explicit ParameterValues(std::span<const Parameter> parameters);

    // Throws UsageError: no such parameter; the text is no such value. The line names what would be right.
    void Set(std::string_view name, std::string_view text);

    float operator[](std::string_view name) const;
    int Whole(std::string_view name) const { return static_cast<int>((*this)[name]); }
    std::string_view Choice(std::string_view name) const;

private:
    size_t IndexOf(std::string_view name) const;

    std::span<const Parameter> m_parameters;
    std::vector<float> m_values;
};

// What an effect is made for.
struct EffectInputs {
    Extent2D extent;  // texels; of the picture
    Environment environment = {};
    MeshData mesh = {};
    Volume volume = {};
};

struct Frame {
    double timeSeconds = 0;  // the same time, the same picture
    const ParameterValues& values;
};

// An image on the way to the picture.
struct EffectStage {
    std::string name;
    const Image* image;
};

// Move-only. Not thread-safe.
class Effect {
public:
    Effect() = default;
    virtual ~Effect() = default;
    Effect(Effect&&) = delete;

    // Appends a frame; returns the picture, RGBA32F, linear light, readable up to the next Record(). Throws Error
    // where the values ask for more than the device can do.
    const Image& Record(CommandList& commands, const Frame& frame);

    // What the last Record() made on the way, in order; the last is the picture.
    const std::vector<EffectStage>& Stages() const { return m_stages; }

protected:
    // `name`: of its own in the frame, without a comma.
    const Image& AddStage(std::string name, const Image& image);

    // The words of a table: `name`, and for two words `name`-high.
    void AddTableStages(const std::string& name, TexelWords table);

private:
    virtual const Image& Draw(CommandList& commands, const Frame& frame) = 0;

    std::vector<EffectStage> m_stages;
};

struct EffectInfo {
    std::string_view name;
    std::string_view what;     // one line
    std::string_view paper;    // the figure or section it shows
    std::string_view lookFor;  // one sentence
    std::vector<Parameter> parameters;
    bool takesEnvironment = false;
    bool takesMesh = false;
    bool takesVolume = false;  // and has a parameter iso, a value of it
    bool isHighRange = false;  // its light goes beyond 1: what shows it brings the lights down
    std::unique_ptr<Effect> (*make)(Device& device, const EffectInputs& inputs,
                                    const ParameterValues& values) = nullptr;
};

template <typename T>
std::unique_ptr<Effect> MakeEffect(Device& device, const EffectInputs& inputs, const ParameterValues& values) {
    return std::make_unique<T>(device, inputs, values);
}

// All of them, in the order of the gallery.
std::span<const EffectInfo> Effects();

// Throws UsageError, which lists the names.
const EffectInfo& FindEffect(std::string_view name);

}  // namespace boxcar
