// The effects' own shaders, by name.
#pragma once

#include <string>

#include "effects_shaders.h"

namespace boxcar {

// "shaders/`name`" of hlsl/effects.cfg.
inline EmbeddedShader EffectShader(const std::string& name) {
    return effects_shaders::Find("shaders/" + name);
}

}  // namespace boxcar
