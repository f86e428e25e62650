// An effect, drawn again and again as tests ask for it.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "samples/effects/effect.h"
#include "tests/support/device_image.h"

namespace boxcar {

using Settings = std::vector<std::pair<std::string, std::string>>;  // name, value; the rest is at its initial value

class EffectPictures {
public:
    // `fixed` holds for every picture.
    EffectPictures(std::string_view effectName, EffectInputs inputs, Settings fixed = {})
        : m_info(FindEffect(effectName)),
          m_fixed(std::move(fixed)),
          m_effect(m_info.make(TestDevice(), inputs, ValuesOf({}))) {}

    Texels Picture(const Settings& settings, double timeSeconds = 0) {
        const ParameterValues values = ValuesOf(settings);
        CommandList commands(TestDevice());
        const Image& picture = m_effect->Record(commands, {timeSeconds, values});
        commands.SubmitAndWait();
        return Download(picture);
    }

    // Of the last picture; RGBA32F.
    Texels Stage(size_t index) const { return Download(*m_effect->Stages().at(index).image); }

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
