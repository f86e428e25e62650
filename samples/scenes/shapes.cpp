#include "samples/scenes/shapes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <map>

#include "tools/base/error.h"

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

MeshData Room(float sideLength) {
    MeshData mesh;
    for (int axis = 0; axis < 3; axis++)
        for (const float side : {-1.0f, 1.0f}) {
            glm::vec3 normal(0), across(0);
            normal[axis] = -side;
            across[(axis + 1) % 3] = 1;
            const glm::vec3 up = glm::cross(normal, across);
            const auto first = static_cast<uint32_t>(mesh.vertices.size());
            for (const float v : {-0.5f, 0.5f})
                for (const float u : {-0.5f, 0.5f})
                    mesh.vertices.push_back(
                        {sideLength * (u * across + v * up - 0.5f * normal), normal, {u + 0.5f, v + 0.5f}});
            for (const uint32_t corner : {0u, 1u, 2u, 2u, 1u, 3u})
                mesh.indices.push_back(first + corner);
        }
    return mesh;
}

MeshData Subdivided(MeshData mesh, uint32_t times) {
    for (; times > 0; times--) {
        MeshData finer{mesh.vertices, {}};
        std::map<std::pair<uint32_t, uint32_t>, uint32_t> middles;
        const auto middle = [&](uint32_t a, uint32_t b) {
            const auto [at, isNew] =
                middles.try_emplace(std::minmax(a, b), static_cast<uint32_t>(finer.vertices.size()));
            if (isNew) {
                const Vertex &from = mesh.vertices[a], &to = mesh.vertices[b];
                finer.vertices.push_back({0.5f * (from.position + to.position),
                                          glm::normalize(from.normal + to.normal), 0.5f * (from.uv + to.uv)});
            }
            return at->second;
        };
        for (size_t i = 0; i < mesh.indices.size(); i += 3) {
            const uint32_t a = mesh.indices[i], b = mesh.indices[i + 1], c = mesh.indices[i + 2];
            const uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.indices.insert(finer.indices.end(), {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca});
        }
        mesh = std::move(finer);
    }
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
