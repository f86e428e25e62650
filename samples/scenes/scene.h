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
};

SceneConstants ConstantsOf(const SceneObject& object, const glm::mat4& clipFromWorld, glm::vec3 eyeWorld);

// Shaders for objects: scene.vs and a pixel shader that reads what it hands on, with a depth test.
PipelineDesc SceneShaders(const EmbeddedShader& pixel, std::vector<Format> targets = {Format::RGBA32F});

// The same with scene.ps: matt surfaces in the sample scenes' light.
PipelineDesc MattShaders();

// Draws each object as `first` says, with its mesh and constants; what `first` clears is cleared once.
//
//   blockOf(scene, object)  the constants of the object, from its SceneConstants: a struct of hlsl/constants/
void DrawObjects(CommandList& commands, Pass first, std::span<const SceneObject> objects,
                 const glm::mat4& clipFromWorld, glm::vec3 eyeWorld, const auto& blockOf) {
    for (const SceneObject& object : objects) {
        const auto block = blockOf(ConstantsOf(object, clipFromWorld, eyeWorld), object);
        first.mesh = object.mesh;
        first.constants = ConstantBytes(block);
        commands.Draw(first);
        first.clearColor.reset();
        first.clearsDepth = false;
    }
}

// The same for shaders of matt objects, whose block is MattConstants.
void DrawObjects(CommandList& commands, const Pass& first, std::span<const SceneObject> objects,
                 const glm::mat4& clipFromWorld, glm::vec3 eyeWorld);

// Where a scene shows an object of the user's, which may be of any size and shape.
struct Stand {
    const Camera& camera;
    Extent2D extent;           // texels; of the picture
    glm::vec3 offsetWorld{0};  // of the object; must be in the picture
    float scale = 1;           // world units in one of the mesh's that comes back
    float middle = 0;          // the share of its height that lies at the offset: 0 it stands there, 0.5 it floats
};

// The mesh moved so that it is round the y axis, and scaled by one number so that it is whole in the picture however
// it is turned about that axis: one unit high where it can be, and less where it would reach more than 1.25 to a
// side, out of the picture or too near to the eye. 2 % of the picture are left free at its rims.
MeshData StandingMesh(MeshData mesh, const Stand& stand);

// The same mesh with +z going up, where files have z up: it is turned, not mirrored.
MeshData TurnedZUp(MeshData mesh);

inline Mesh UploadMesh(Device& device, const MeshData& mesh, const std::string& name) {
    return {device, mesh.vertices, mesh.indices, name};
}

}  // namespace boxcar
