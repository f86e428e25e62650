#include "samples/scenes/scene.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "passes_shaders.h"

namespace boxcar {

SceneConstants ConstantsOf(const SceneObject& object, const glm::mat4& clipFromWorld, glm::vec3 eyeWorld) {
    return {clipFromWorld,     object.offsetWorld,
            object.scale,      {std::cos(object.turnRadians), std::sin(object.turnRadians)},
            object.checkWorld, object.optionA,
            object.albedo,     object.optionB,
            eyeWorld,          object.optionC};
}

PipelineDesc SceneShaders(const std::string& pixel, std::vector<Format> targets) {
    return {.vertex = passes_shaders::Find("shaders/scene.vs"),
            .pixel = passes_shaders::Find("shaders/" + pixel),
            .targets = std::move(targets),
            .testsDepth = true};
}

void DrawObjects(CommandList& commands, Pass first, std::span<const SceneObject> objects,
                 const glm::mat4& clipFromWorld, glm::vec3 eyeWorld) {
    for (const SceneObject& object : objects) {
        const SceneConstants constants = ConstantsOf(object, clipFromWorld, eyeWorld);
        first.mesh = object.mesh;
        first.constants = ConstantBytes(constants);
        commands.Draw(first);
        first.clearColor.reset();
        first.clearsDepth = false;
    }
}

MeshData StandingMesh(MeshData mesh) {
    glm::vec3 lo(INFINITY), hi(-INFINITY);
    for (const Vertex& vertex : mesh.vertices) {
        lo = glm::min(lo, vertex.position);
        hi = glm::max(hi, vertex.position);
    }
    const glm::vec3 size = hi - lo;
    const float scale = 1 / (size.y > 0 ? size.y : std::max({size.x, size.z, 1e-30f}));
    const glm::vec3 foot(0.5f * (lo.x + hi.x), lo.y, 0.5f * (lo.z + hi.z));
    for (Vertex& vertex : mesh.vertices)
        vertex.position = scale * (vertex.position - foot);
    return mesh;
}

}  // namespace boxcar
