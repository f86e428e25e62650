// An effect, drawn again and again as tests ask for it.
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "samples/effects/effect.h"
#include "samples/scenes/volumes.h"
#include "tests/support/device_image.h"
#include "tools/base/error.h"

namespace boxcar {

using Settings = std::vector<std::pair<std::string, std::string>>;  // name, value; the rest is at its initial value

inline std::vector<std::string> EffectNames() {
    std::vector<std::string> names;
    for (const EffectInfo& info : Effects())
        names.emplace_back(info.name);
    return names;
}

class EffectPictures {
public:
    // With the bunny in venice and the head, where the effect takes them. `fixed` holds for every picture.
    EffectPictures(std::string_view effectName, Extent2D extent, Settings fixed = {})
        : m_info(FindEffect(effectName)),
          m_fixed(std::move(fixed)),
          m_effect(m_info.make(TestDevice(), InputsFor(m_info, extent), ValuesOf({}))) {}

    // What an effect is made for where nothing else is asked: the bunny, venice.
    static EffectInputs InputsFor(const EffectInfo& info, Extent2D extent) {
        return {.extent = extent,
                .environment = info.takesEnvironment ? SampleEnvironment("venice") : Environment(),
                .mesh = info.takesMesh ? SampleMesh("bunny") : MeshData(),
                .volume = info.takesVolume ? SampleVolume("head") : Volume()};
    }

    Texels Picture(const Settings& settings = {}, double timeSeconds = 0) {
        const ParameterValues values = ValuesOf(settings);
        CommandList commands(TestDevice());
        const Image& picture = m_effect->Record(commands, {timeSeconds, values});
        commands.SubmitAndWait();
        return Download(picture);
    }

    // Of the last picture; RGBA32F.
    Texels Stage(std::string_view name) const {
        const auto found = std::ranges::find(m_effect->Stages(), name, &EffectStage::name);
        BOXCAR_ASSERT(found != m_effect->Stages().end());
        return Download(*found->image);
    }

private:
    ParameterValues ValuesOf(const Settings& settings) const {
        ParameterValues values(m_info.parameters);
        for (const Settings& list : {m_fixed, settings})
            for (const auto& [name, value] : list)
                values.Set(name, value);
        return values;
    }

    const EffectInfo& m_info;
    Settings m_fixed;
    std::unique_ptr<Effect> m_effect;
};

}  // namespace boxcar
