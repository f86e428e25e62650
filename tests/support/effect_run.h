// An effect, run by a test.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "samples/effects/effect.h"
#include "tests/support/device_image.h"

namespace boxcar {

// One effect on the test device, with the meshes and environments that come with the program.
class TestEffect {
public:
    using Settings = std::vector<std::pair<std::string, std::string>>;

    TestEffect(std::string_view name, Extent2D extent, const Settings& settings = {})
        : m_info(FindEffect(name)), m_values(m_info.parameters) {
        EffectInputs inputs{.extent = extent};
        if (m_info.takesEnvironment) inputs.environment = SampleEnvironment("venice");
        if (m_info.takesMesh) inputs.mesh = SampleMesh("bunny");
        for (const auto& [parameter, value] : settings)
            m_values.Set(parameter, value);
        m_effect = m_info.make(TestDevice(), inputs, m_values);
    }

    void Set(std::string_view parameter, std::string_view value) { m_values.Set(parameter, value); }

    Texels Picture(double timeSeconds = 0) {
        CommandList commands(TestDevice());
        const Image& picture = m_effect->Record(commands, {timeSeconds, m_values});
        commands.SubmitAndWait();
        return Download(picture);
    }

    // An RGBA32F image that the last picture was made from.
    Texels Stage(std::string_view name) const {
        for (const EffectStage& stage : m_effect->Stages())
            if (stage.name == name) return Download(*stage.image);
        return {};
    }

private:
    const EffectInfo& m_info;
    ParameterValues m_values;
    std::unique_ptr<Effect> m_effect;
};

}  // namespace boxcar
