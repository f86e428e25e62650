// Objects and how they are drawn. hlsl/shaders/scene.vs.hlsl places them.
#pragma once

#include <span>

#include "hlsl/constants/scene_constants.h"
#include "runtime/command_list.h"
#include "samples/files/mesh.h"
#include "samples/scenes/camera.h"

namespace boxcar {

constexpr glm::vec3 kSky{0.52f, 0.62f, 0.75f};  // its light behind the sample scenes

struct SceneObject {
    const Mesh* mesh;
    glm::vec3 offsetWorld{0};  // of the mesh's origin
    float scale = 1;           // world units in one of the mesh's
    float turnRadians = 0;     // about +y, from +z towards +x
    glm::vec3 albedo{0.7f};
    float checkWorld = 0;  // side of its checks in world units; 0 for none
    // What the pixel shader of an effect makes of them.
    float optionA = 0;
    float optionB = 0;
    float optionC = 0;
};

SceneConstants ConstantsOf(const SceneObject& object, const glm::mat4& clipFromWorld, glm::vec3 eyeWorld);

// Shaders for objects: scene.vs and "shaders/`pixel`", with a depth test.
PipelineDesc SceneShaders(const std::string& pixel, std::vector<Format> targets = {Format::RGBA32F});

// Draws each object as `first` says, with its mesh and constants; what `first` clears is cleared once.
void DrawObjects(CommandList& commands, Pass first, std::span<const SceneObject> objects,
                 const glm::mat4& clipFromWorld, glm::vec3 eyeWorld);

// The mesh moved and scaled so that it stands on y = 0, round the y axis, and is one unit high.
MeshData StandingMesh(MeshData mesh);

inline Mesh UploadMesh(Device& device, const MeshData& mesh, const std::string& name) {
    return {device, mesh.vertices, mesh.indices, name};
}

}  // namespace boxcar
