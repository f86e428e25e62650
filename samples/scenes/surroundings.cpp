#include "samples/scenes/surroundings.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "runtime/passes/quad_shaders.h"
#include "runtime/transfer.h"
#include "scenes_shaders.h"

namespace boxcar {
namespace {

struct CubeFace {
    glm::vec3 right, up, forward;
};

// As Direct3D and Vulkan lay out a cube: seen from inside, right is left of what a right-handed camera has there.
constexpr CubeFace kCubeFaces[6] = {{{0, 0, -1}, {0, 1, 0}, {1, 0, 0}}, {{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}},
                                    {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}, {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
                                    {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},  {{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}}};

glm::mat4 ClipFromWorld(const CubeFace& face) {
    const Camera camera{.eyeWorld = {0, 0, 0},
                        .targetWorld = face.forward,
                        .upWorld = face.up,
                        .verticalAngleRadians = glm::half_pi<float>(),
                        .nearDepth = 0.01f,
                        .farDepth = 100};
    return glm::scale(glm::mat4(1), {-1, 1, 1}) * ClipFromWorld(camera, {1, 1});
}

Image UploadEnvironment(Device& device, const Environment& environment) {
    Image image(device, {environment.extent, Format::RGBA32F, "environment"});
    WriteTexels(device, image, std::as_bytes(std::span(environment.texels)));
    return image;
}

}  // namespace

Surroundings::Surroundings(Device& device, const Environment& environment, uint32_t sideTexels)
    : m_backdrop(device, QuadShaders(scenes_shaders::Find("shaders/environment.ps"))),
      m_objects(device, MattShaders()),
      m_environment(UploadEnvironment(device, environment)),
      m_face(device, {{sideTexels, sideTexels}, Format::RGBA32F, "cube face"}),
      m_depth(device, {{sideTexels, sideTexels}, Format::Depth32F, "cube face's depth"}),
      m_cube(device, {.extent = {sideTexels, sideTexels}, .name = "cube", .layers = 6}) {
    std::vector<float> lit;
    for (const glm::vec4& texel : environment.texels)
        for (const float light : {texel.r, texel.g, texel.b})
            if (light > 0) lit.push_back(light);
    if (lit.empty()) return;
    m_largestLight = *std::ranges::max_element(lit);
    const auto darkest = lit.begin() + static_cast<std::ptrdiff_t>(lit.size() / 100);
    std::ranges::nth_element(lit, darkest);
    m_darkestLight = *darkest;
}

const Image& Surroundings::Record(CommandList& commands, std::span<const SceneObject> objects) {
    for (uint32_t face = 0; face < 6; face++) {
        const auto& [right, up, forward] = kCubeFaces[face];
        DrawBackdrop(commands, right, up, forward, m_face);
        DrawObjects(
            commands,
            {.name = "cube face", .pipeline = m_objects, .writes = {&m_face}, .depth = &m_depth, .clearsDepth = true},
            objects, ClipFromWorld(kCubeFaces[face]), glm::vec3(0));
        commands.Copy(m_face, m_cube, face);
    }
    return m_cube;
}

void Surroundings::DrawBackdrop(CommandList& commands, const Camera& camera, const Image& target) {
    const auto [width, height] = target.Extent();
    const glm::vec3 forward = glm::normalize(camera.targetWorld - camera.eyeWorld);
    const glm::vec3 right = glm::normalize(glm::cross(forward, camera.upWorld));
    const float half = std::tan(camera.verticalAngleRadians / 2);
    DrawBackdrop(commands, right * (half * static_cast<float>(width) / static_cast<float>(height)),
                 glm::cross(right, forward) * half, forward, target);
}

void Surroundings::DrawBackdrop(CommandList& commands, glm::vec3 right, glm::vec3 up, glm::vec3 forward,
                                const Image& target) {
    const BackdropConstants constants{right, 0, up, 0, forward, 0};
    commands.Draw({.name = "backdrop",
                   .pipeline = m_backdrop,
                   .reads = {{"environment", &m_environment}},
                   .writes = {&target},
                   .constants = ConstantBytes(constants)});
}

}  // namespace boxcar
