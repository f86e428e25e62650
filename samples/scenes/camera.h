// Where a scene is looked at from.
//
// The world is right-handed, and so is the camera's view of it: x to the right, y up, and it looks along -z. Clip
// space is Direct3D's: y up, depth 0 at nearDepth and 1 at farDepth.
//
// Non-goals: parallel projection, infinite or reversed depth.
#pragma once

#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "runtime/format.h"
#include "tools/base/error.h"

namespace boxcar {

struct Camera {
    glm::vec3 eyeWorld{0, 0, 1};
    glm::vec3 targetWorld{0};           // the middle of the picture; not the eye
    glm::vec3 upWorld{0, 1, 0};         // of any length; not along the line of sight
    float verticalAngleRadians = 0.8f;  // from the lower to the upper rim of the picture; between 0 and pi
    float nearDepth = 0.1f;             // in the world's units, along the line of sight; more than 0
    float farDepth = 100;               // more than nearDepth
};

// Takes a point of the world to the camera's view: mul(viewFromWorld, float4(position, 1)) in HLSL.
inline glm::mat4 ViewFromWorld(const Camera& camera) {
    return glm::lookAtRH(camera.eyeWorld, camera.targetWorld, camera.upWorld);
}

// Takes a point of the view to clip space; w is its depth along the line of sight. `extent` is of the picture, whose
// texels are squares.
inline glm::mat4 ClipFromView(const Camera& camera, Extent2D extent) {
    BOXCAR_ASSERT(camera.verticalAngleRadians > 0 && camera.verticalAngleRadians < 3.1415f);
    BOXCAR_ASSERT(camera.nearDepth > 0 && camera.farDepth > camera.nearDepth);
    const float aspect = static_cast<float>(extent.widthTexels) / static_cast<float>(extent.heightTexels);
    return glm::perspectiveRH_ZO(camera.verticalAngleRadians, aspect, camera.nearDepth, camera.farDepth);
}

inline glm::mat4 ClipFromWorld(const Camera& camera, Extent2D extent) {
    return ClipFromView(camera, extent) * ViewFromWorld(camera);
}

// Texels of the picture across a unit of the world at depth 1.
inline float TexelsAtDepthOne(const Camera& camera, Extent2D extent) {
    return static_cast<float>(extent.heightTexels) / (2 * std::tan(camera.verticalAngleRadians / 2));
}

}  // namespace boxcar
