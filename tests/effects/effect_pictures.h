// Pictures of effects, as tests ask for them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "samples/effects/effect.h"
#include "tests/support/device_image.h"

namespace boxcar {

using Settings = std::vector<std::pair<std::string, std::string>>;

inline Texels PictureOf(std::string_view effectName, const EffectInputs& inputs, const Settings& settings,
                        double timeSeconds = 0) {
    const EffectInfo& info = FindEffect(effectName);
    ParameterValues values(info.parameters);
    for (const auto& [name, value] : settings)
        values.Set(name, value);
    const auto effect = info.make(TestDevice(), inputs, values);
    CommandList commands(TestDevice());
    const Image& picture = effect->Record(commands, {timeSeconds, values});
    commands.SubmitAndWait();
    return Download(picture);
}

}  // namespace boxcar
