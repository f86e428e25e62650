#include "samples/scenes/shapes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <map>

namespace boxcar {
namespace {

using Corners = std::array<Vertex, 3>;

std::vector<Corners> TrianglesOf(const MeshData& mesh) {
    std::vector<Corners> triangles;
    for (size_t i = 0; i < mesh.indices.size(); i += 3)
        triangles.push_back({mesh.vertices.at(mesh.indices[i]), mesh.vertices.at(mesh.indices[i + 1]),
                             mesh.vertices.at(mesh.indices[i + 2])});
    return triangles;
}

// Along the normal of the side from which the corners go counter-clockwise.
glm::dvec3 AreaVector(const Corners& corners) {
    const glm::dvec3 a(corners[0].position), b(corners[1].position), c(corners[2].position);
    return 0.5 * glm::cross(b - a, c - a);
}

double Area(const MeshData& mesh) {
    double area = 0;
    for (const Corners& corners : TrianglesOf(mesh))
        area += glm::length(AreaVector(corners));
    return area;
}

TEST(Ground, IsASquareSeenFromAboveWithItsTextureRepeated) {
    const MeshData ground = Ground(6, 4);
    EXPECT_NEAR(Area(ground), 36, 1e-5);
    for (const Corners& corners : TrianglesOf(ground))
        EXPECT_EQ(glm::normalize(AreaVector(corners)), glm::dvec3(0, 1, 0));
    for (const Vertex& vertex : ground.vertices) {
        EXPECT_EQ(vertex.normal, glm::vec3(0, 1, 0));
        EXPECT_EQ(vertex.uv, (glm::vec2(vertex.position.x, vertex.position.z) / 6.0f + 0.5f) * 4.0f);
        EXPECT_EQ(vertex.position.y, 0);
    }
}

struct Sizes {
    uint32_t segments, rings;
};
constexpr Sizes kSizes[] = {{3, 2}, {4, 3}, {17, 8}, {64, 32}};

TEST(Sphere, HasTheNormalsOfASphereAndUvRoundIt) {
    for (const auto& [segments, rings] : kSizes)
        for (const Vertex& vertex : Sphere(2, segments, rings).vertices) {
            EXPECT_NEAR(glm::length(glm::dvec3(vertex.position)), 2, 1e-6);
            EXPECT_NEAR(glm::length(vertex.position / 2.0f - vertex.normal), 0, 1e-6);
            EXPECT_NEAR(vertex.normal.y, std::cos(glm::pi<double>() * vertex.uv.y), 1e-6);
            // From the seam at -z by -x to +z: an angle of 2 pi u.
            const double angle = glm::two_pi<double>() * vertex.uv.x;
            const double fromAxis = std::sin(glm::pi<double>() * vertex.uv.y);
            EXPECT_NEAR(vertex.normal.x, -fromAxis * std::sin(angle), 1e-6);
            EXPECT_NEAR(vertex.normal.z, -fromAxis * std::cos(angle), 1e-6);
        }
}

// Each ring of n segments is n trapezoids between circles of latitude, or triangles at the poles: their parallel
// sides are 2 r sin(latitude) sin(pi / n), and their middles r sin(latitude) cos(pi / n) from the axis.
TEST(Sphere, HasTheAreaOfItsTrapezoidsAndComesNearThatOfASphere) {
    const double r = 2;
    for (const auto& [segments, rings] : kSizes) {
        double expected = 0;
        for (uint32_t i = 0; i < rings; i++) {
            const double top = glm::pi<double>() * i / rings, bottom = glm::pi<double>() * (i + 1) / rings;
            const double half = glm::pi<double>() / segments;
            const double sides = 2 * r * std::sin(half) * (std::sin(top) + std::sin(bottom));
            const double height =
                r * std::hypot(std::cos(half) * (std::sin(bottom) - std::sin(top)), std::cos(top) - std::cos(bottom));
            expected += segments * sides / 2 * height;
        }
        const MeshData sphere = Sphere(static_cast<float>(r), segments, rings);
        EXPECT_EQ(sphere.indices.size(), 3 * 2 * segments * (rings - 1));
        EXPECT_NEAR(Area(sphere) / expected, 1, 1e-6);
        EXPECT_LT(Area(sphere), 4 * glm::pi<double>() * r * r);
    }
    EXPECT_NEAR(Area(Sphere(2, 64, 32)) / (16 * glm::pi<double>()), 1, 0.005);
}

// Every edge is run through once each way, by position, so there is no crack at the seam; every face looks outwards.
TEST(Sphere, IsClosedAndFacesOutwards) {
    const auto less = [](const std::array<glm::vec3, 2>& a, const std::array<glm::vec3, 2>& b) {
        for (int i = 0; i < 6; i++)
            if (a[i / 3][i % 3] != b[i / 3][i % 3]) return a[i / 3][i % 3] < b[i / 3][i % 3];
        return false;
    };
    for (const auto& [segments, rings] : kSizes) {
        std::map<std::array<glm::vec3, 2>, int, decltype(less)> edges(less);
        for (const Corners& corners : TrianglesOf(Sphere(1, segments, rings))) {
            const glm::dvec3 outwards(corners[0].position + corners[1].position + corners[2].position);
            EXPECT_GT(glm::dot(AreaVector(corners), outwards), 0);
            for (int i = 0; i < 3; i++)
                edges[{corners[i].position, corners[(i + 1) % 3].position}]++;
        }
        for (const auto& [edge, times] : edges) {
            EXPECT_EQ(times, 1);
            EXPECT_TRUE(edges.contains({edge[1], edge[0]}));
        }
    }
}

}  // namespace
}  // namespace boxcar
