#include "samples/scenes/environment.h"

#include <algorithm>
#include <cmath>

#include "samples/files/color.h"
#include "tools/base/error.h"

extern "C" const uint8_t scenes_bunny_obj[], scenes_bunny_obj_end[];
extern "C" const uint8_t scenes_city_exr[], scenes_city_exr_end[];
extern "C" const uint8_t scenes_studio_exr[], scenes_studio_exr_end[];
extern "C" const uint8_t scenes_teapot_obj[], scenes_teapot_obj_end[];
extern "C" const uint8_t scenes_venice_exr[], scenes_venice_exr_end[];

namespace boxcar {

Environment EnvironmentFrom(Picture picture, const std::string& name) {
    const uint32_t width = picture.widthTexels, height = picture.heightTexels;
    if (width != 2 * height)
        throw Error("{}: {} x {} texels; an environment is twice as wide as high", name, width, height);
    if (picture.stored != SampleType::Float32) {
        DecodeSrgb(picture);
        Premultiply(picture);
    }
    Environment environment{{width, height}, {}};
    const uint32_t colors = picture.channels >= 3 ? 3 : 1;
    for (size_t i = 0; i < picture.samples.size(); i += picture.channels) {
        glm::vec4 texel(1);
        for (uint32_t c = 0; c < 3; c++) {
            const float value = picture.samples[i + std::min(c, colors - 1)];
            if (!std::isfinite(value))
                throw Error("{}: {} in it; light is finite (--nan zero replaces it)", name, value);
            texel[static_cast<int>(c)] = std::max(value, 0.0f);
        }
        environment.texels.push_back(texel);
    }
    return environment;
}

Environment SampleEnvironment(std::string_view name) {
    const std::span<const uint8_t> file = name == "city"     ? std::span(scenes_city_exr, scenes_city_exr_end)
                                          : name == "studio" ? std::span(scenes_studio_exr, scenes_studio_exr_end)
                                                             : std::span(scenes_venice_exr, scenes_venice_exr_end);
    return EnvironmentFrom(DecodePicture(file, std::string(name)), std::string(name));
}

MeshData SampleMesh(std::string_view name) {
    const std::span<const uint8_t> file = name == "teapot" ? std::span(scenes_teapot_obj, scenes_teapot_obj_end)
                                                           : std::span(scenes_bunny_obj, scenes_bunny_obj_end);
    return DecodeMesh(file, std::string(name));
}

}  // namespace boxcar
