// Light from all around, and the meshes and environments that come with the program.
#pragma once

#include <glm/vec4.hpp>
#include <string>
#include <vector>

#include "runtime/format.h"
#include "samples/files/mesh.h"
#include "samples/files/picture.h"

namespace boxcar {

// Equirectangular: u = 0.5 + atan2(x, -z) / (2 pi), v = acos(y) / pi; twice as wide as high.
struct Environment {
    Extent2D extent;
    std::vector<glm::vec4> texels;  // linear light, rows from the top; alpha 1
};

// Integer pictures are taken as sRGB and straight alpha; light is colors times alpha. Negative light, as lossy
// compression leaves it, becomes 0. Throws Error, which begins with `name`: it is not twice as wide as high; a sample
// is not finite.
Environment EnvironmentFrom(Picture picture, const std::string& name);

// "city", "studio" or "venice".
Environment SampleEnvironment(std::string_view name);

// "bunny" or "teapot".
MeshData SampleMesh(std::string_view name);

}  // namespace boxcar
