// An effect, made and run as a command line asks for it: what render, sweep and inspect have in common.
#pragma once

#include <CLI/CLI.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "samples/cli/options.h"
#include "samples/effects/effect.h"

namespace boxcar {

struct EffectOptions {
    std::string effect;
    std::string extent = "640x360";
    double timeSeconds = 0;
    std::vector<std::string> sets;  // NAME=VALUE
    std::string environment;        // a file, or one of ours
    std::string mesh;
    std::string volume;
    std::string volumeFrame;  // a number; empty: the first
    std::string upWord = "y";
    std::string nanWord = "refuse";
    uint32_t samples = 1;  // along each side of a pixel
    DeviceOptions device;
};

void AddEffectOptions(CLI::App& command, EffectOptions& options);
void AddSamplesOption(CLI::App& command, EffectOptions& options);

// NAME=VALUE apart. Throws UsageError.
struct Setting {
    std::string name;
    std::string value;
};
Setting ParseSetting(const std::string& text);

// Everything that a frame needs, ready to draw.
class EffectRun {
public:
    // Throws UsageError: no such effect; a size, a parameter or a flag that it does not take. Throws Error: a mesh, a
    // volume or an environment that cannot be read; what the device cannot do.
    EffectRun(Device& device, const EffectOptions& options, const std::vector<Setting>& settings);

    // A frame's samples as the effect gives them: as many times wider and higher than the picture as a
    // pixel's side has samples.
    std::vector<glm::vec4> Samples(double timeSeconds, std::vector<PassTime>* passes = nullptr);

    // The picture for a file of samples of such a type: the mean of the samples of each pixel. Floats hold light; for
    // integers what goes beyond 0.7 is bent so that it stays below 1, where the effect has such light, and all is
    // sRGB.
    //
    //   passes  how long they took, if asked for
    Picture Render(double timeSeconds, SampleType sampleType, std::vector<PassTime>* passes = nullptr);

    const EffectInfo& Info() const { return m_info; }
    Extent2D Extent() const { return m_extent; }
    const std::vector<EffectStage>& Stages() const { return m_effect->Stages(); }

    // The file that the volume was read from, and what was read of it; empty where the effect takes none.
    const std::string& VolumeLine() const { return m_volumeLine; }

    // To stderr, a line each: what of the environment's and the volume's file is not drawn without having been asked
    // about.
    void PrintNotes() const;

private:
    Device& m_device;
    const EffectInfo& m_info;
    Extent2D m_extent;
    uint32_t m_samples;
    std::vector<std::string> m_notes;
    EffectInputs m_inputs;
    std::string m_volumeLine;
    ParameterValues m_values;
    std::unique_ptr<Effect> m_effect;
};

// The settings of a command line. Throws UsageError.
std::vector<Setting> SettingsOf(const EffectOptions& options);

}  // namespace boxcar
