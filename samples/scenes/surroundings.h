// What surrounds an object, drawn into a cube map every frame: an environment, and objects that move in front of it.
//
//   environment, objects  ->  six faces, one after the other  ->  cube map
//
// Hensley 2005, sect. 5.1 (renderCubeMap)
#pragma once

#include "samples/scenes/environment.h"
#include "samples/scenes/scene.h"

namespace boxcar {

// Holds the environment, the cube map and one face of it, 16 bytes of device memory a texel, and the face's depth, 4.
// Move-only.
class Surroundings {
public:
    // sideTexels: of a face of the cube.
    Surroundings(Device& device, const Environment& environment, uint32_t sideTexels);

    // Returns the cube map, as seen from the origin; readable up to the next Record().
    const Image& Record(CommandList& commands, std::span<const SceneObject> objects);

    // The environment behind a picture.
    void DrawBackdrop(CommandList& commands, const Camera& camera, const Image& target);

    // The brightest channel of the environment.
    float LargestLight() const { return m_largestLight; }

    // What 99 of 100 channels that are not 0 are not below: what is darker is taken for noise. The brightest where
    // all are 0.
    float DarkestLight() const { return m_darkestLight; }

private:
    void DrawBackdrop(CommandList& commands, glm::vec3 right, glm::vec3 up, glm::vec3 forward, const Image& target);

    float m_largestLight = 0, m_darkestLight = 0;
    Pipeline m_backdrop, m_objects;
    Image m_environment, m_face, m_depth, m_cube;
};

}  // namespace boxcar
