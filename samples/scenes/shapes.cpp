#include "samples/scenes/shapes.h"

#include <cmath>
#include <glm/gtc/constants.hpp>

#include "tools/layout/error.h"

namespace boxcar {

MeshData Ground(float sideLength, float uvRepeats) {
    MeshData mesh;
    for (const float z : {0.0f, 1.0f})
        for (const float x : {0.0f, 1.0f})
            mesh.vertices.push_back(
                {{(x - 0.5f) * sideLength, 0, (z - 0.5f) * sideLength}, {0, 1, 0}, {x * uvRepeats, z * uvRepeats}});
    mesh.indices = {0, 2, 1, 1, 2, 3};
    return mesh;
}

MeshData Sphere(float radius, uint32_t segments, uint32_t rings) {
    BOXCAR_ASSERT(segments >= 3 && rings >= 2);
    MeshData mesh;
    for (uint32_t ring = 0; ring <= rings; ring++)
        for (uint32_t segment = 0; segment <= segments; segment++) {
            const double v = static_cast<double>(ring) / rings;
            const double u = static_cast<double>(segment) / segments;
            // Both ends of the seam, and all of a pole, are the same to the last bit: no crack.
            const double longitude = glm::two_pi<double>() * (segment % segments) / segments - glm::pi<double>();
            const double fromAxis = ring % rings == 0 ? 0 : std::sin(glm::pi<double>() * v);
            const glm::dvec3 normal(fromAxis * std::sin(longitude), std::cos(glm::pi<double>() * v),
                                    fromAxis * std::cos(longitude));
            mesh.vertices.push_back({normal * static_cast<double>(radius), normal, glm::dvec2(u, v)});
        }
    for (uint32_t ring = 0; ring < rings; ring++)
        for (uint32_t segment = 0; segment < segments; segment++) {
            const uint32_t leftTop = ring * (segments + 1) + segment, rightTop = leftTop + 1;
            const uint32_t leftBottom = leftTop + segments + 1, rightBottom = leftBottom + 1;
            if (ring > 0) mesh.indices.insert(mesh.indices.end(), {leftTop, leftBottom, rightTop});
            if (ring < rings - 1) mesh.indices.insert(mesh.indices.end(), {rightTop, leftBottom, rightBottom});
        }
    return mesh;
}

}  // namespace boxcar
