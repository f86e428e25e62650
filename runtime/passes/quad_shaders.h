// The shaders of an image-to-image pass.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "passes_shaders.h"
#include "runtime/pipeline.h"

namespace boxcar {

// quad.vs and a pixel shader.
inline PipelineDesc QuadShaders(const EmbeddedShader& pixel, std::vector<Format> targets = {Format::RGBA32F}) {
    return {.vertex = passes_shaders::Find("shaders/quad.vs"), .pixel = pixel, .targets = std::move(targets)};
}

// The same with a pixel shader of hlsl/passes.cfg: "shaders/`pixel`".
inline PipelineDesc QuadShaders(const std::string& pixel, std::vector<Format> targets = {Format::RGBA32F}) {
    return QuadShaders(passes_shaders::Find("shaders/" + pixel), std::move(targets));
}

}  // namespace boxcar
