// Objects of any size and shape are whole in the picture, and large in it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <optional>

#include "samples/scenes/environment.h"
#include "samples/scenes/scene.h"

namespace boxcar {
namespace {

struct Shape {
    const char* name;
    glm::dvec3 size;
    glm::dvec3 middle{0};
};

const Shape kShapes[] = {{"cube", {1, 1, 1}},
                         {"sheet", {1000, 1, 1000}, {500, 0.5, 500}},
                         {"flat", {3, 0, 3}},
                         {"slab across", {1000, 1000, 1}},
                         {"slab along", {1, 1000, 1000}},
                         {"pole", {1, 1000, 1}},
                         {"rod", {1000, 1, 1}},
                         {"beam", {1, 2, 400}},
                         {"off center", {3, 2, 5}, {1000, -2000, 500}},
                         {"huge", {1e6, 3e6, 2e6}, {1e7, 0, -1e7}},
                         {"largest", {6e38, 2e38, 6e38}},
                         {"tiny", {3e-6, 1e-6, 1e-6}},
                         {"tiniest", {3e-40, 1e-40, 1e-40}}};

// Its corners, and the middles of its edges.
MeshData BoxOf(const Shape& shape) {
    MeshData mesh;
    for (int x = -1; x <= 1; x++)
        for (int y = -1; y <= 1; y++)
            for (int z = -1; z <= 1; z++)
                mesh.vertices.push_back({glm::vec3(shape.middle + 0.5 * shape.size * glm::dvec3(x, y, z)), {}, {}});
    return mesh;
}

struct View {
    const char* name;
    Camera camera;
    glm::vec3 offsetWorld;
    float scale, middle;
    double leastShare;  // of the picture's width or height that every object takes
};

const View kViews[] = {
    {"around", {.eyeWorld = {-1.96f, 0.48f, -1.38f}, .verticalAngleRadians = 0.62f}, {0, 0, 0}, 1, 0.5f, 0.45},
    {"floor",
     {.eyeWorld = {0, 1.5f, 4.6f}, .targetWorld = {0, 0.35f, 0}, .verticalAngleRadians = 0.75f, .farDepth = 60},
     {0, 0, 0},
     1.5f,
     0,
     0.3},
    {"aside",
     {.eyeWorld = {0, 2.6f, 5.2f}, .targetWorld = {0, 0.35f, -0.2f}, .verticalAngleRadians = 0.7f, .farDepth = 60},
     {-0.2f, 0, 0.1f},
     1.3f,
     0,
     0.3},
    {"near", {.eyeWorld = {0, 0.2f, 1.5f}, .verticalAngleRadians = 1.5f, .nearDepth = 1.2f}, {0, 0, 0}, 1, 0, 0.1}};

constexpr Extent2D kExtents[] = {{640, 360}, {160, 100}, {100, 100}, {90, 160}};

// The part of the picture that the mesh takes, from -1 to 1 on either axis, in double and without a matrix; nothing
// where a vertex is behind the near plane.
struct Seen {
    double left = INFINITY, right = -INFINITY, bottom = INFINITY, top = -INFINITY;
};
std::optional<Seen> Project(const MeshData& mesh, const View& view, Extent2D extent, double turn) {
    const glm::dvec3 eye(view.camera.eyeWorld);
    const glm::dvec3 forward = glm::normalize(glm::dvec3(view.camera.targetWorld) - eye);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(view.camera.upWorld)));
    const glm::dvec3 up = glm::cross(right, forward);
    const double rim = std::tan(view.camera.verticalAngleRadians / 2);
    Seen seen;
    for (const Vertex& vertex : mesh.vertices) {
        const glm::dvec3 p(vertex.position);
        const glm::dvec3 turned(std::cos(turn) * p.x + std::sin(turn) * p.z, p.y,
                                std::cos(turn) * p.z - std::sin(turn) * p.x);
        const glm::dvec3 ray = glm::dvec3(view.offsetWorld) + double{view.scale} * turned - eye;
        const double depth = glm::dot(ray, forward);
        if (depth < view.camera.nearDepth || depth > view.camera.farDepth) return {};
        const double x = glm::dot(ray, right) / depth / rim * extent.heightTexels / extent.widthTexels;
        const double y = glm::dot(ray, up) / depth / rim;
        seen = {std::min(seen.left, x), std::max(seen.right, x), std::min(seen.bottom, y), std::max(seen.top, y)};
    }
    return seen;
}

MeshData Stood(MeshData mesh, const View& view, Extent2D extent) {
    return StandingMesh(std::move(mesh), {view.camera, extent, view.offsetWorld, view.scale, view.middle});
}

TEST(StandingMesh, IsWholeInThePictureAndLargeInItWhateverItsShape) {
    for (const View& view : kViews)
        for (const Extent2D extent : kExtents)
            for (const Shape& shape : kShapes) {
                SCOPED_TRACE(
                    fmt::format("{}, {} in {} x {}", shape.name, view.name, extent.widthTexels, extent.heightTexels));
                const MeshData mesh = Stood(BoxOf(shape), view, extent);
                double largest = 0;
                for (int i = 0; i < 48; i++) {
                    const auto seen = Project(mesh, view, extent, glm::two_pi<double>() * i / 48);
                    ASSERT_TRUE(seen) << "before the near plane";
                    ASSERT_GE(std::min(seen->left, seen->bottom), -0.981);
                    ASSERT_LE(std::max(seen->right, seen->top), 0.981);
                    largest = std::max({largest, seen->right - seen->left, seen->top - seen->bottom});
                }
                EXPECT_GE(largest, 2 * view.leastShare);
            }
}

TEST(StandingMesh, IsScaledByOneNumberAndStandsRoundTheAxisWithinItsPlace) {
    for (const Shape& shape : kShapes)
        for (const View& view : kViews) {
            const MeshData mesh = Stood(BoxOf(shape), view, {640, 360});
            const glm::dvec3 low(mesh.vertices.front().position), high(mesh.vertices.back().position);
            const double scale = glm::length(high - low) / glm::length(shape.size);
            for (int c = 0; c < 3; c++)
                EXPECT_NEAR(high[c] - low[c], scale * shape.size[c], 1e-4) << shape.name;
            for (const int c : {0, 2})
                EXPECT_NEAR(high[c], -low[c], 1e-6) << shape.name;
            EXPECT_LE(high.y - low.y, 1.00001) << shape.name;
            EXPECT_LE(std::hypot(high.x, high.z), 1.25001) << shape.name;
            EXPECT_NEAR(low.y, -view.middle * (high.y - low.y), 1e-6) << shape.name;
        }
}

// Of what comes with the program, in every scene and the pictures that are shown of it.
TEST(StandingMesh, TheBunnyAndTheTeapotAreOneUnitHighInWidePictures) {
    for (const char* name : {"bunny", "teapot"})
        for (const View& view : {kViews[0], kViews[1], kViews[2]})
            for (const Extent2D extent : {kExtents[0], kExtents[1]}) {
                const MeshData mesh = Stood(SampleMesh(name), view, extent);
                float low = INFINITY, high = -INFINITY;
                for (const Vertex& vertex : mesh.vertices) {
                    low = std::min(low, vertex.position.y);
                    high = std::max(high, vertex.position.y);
                }
                EXPECT_NEAR(high - low, 1, 1e-6) << name << ", " << view.name << " " << extent.widthTexels;
            }
}

TEST(StandingMesh, OnePointIsLeftWhatItIs) {
    const MeshData mesh = Stood({{{{5, 6, 7}, {0, 1, 0}, {}}}, {0, 0, 0}}, kViews[1], {64, 64});
    EXPECT_EQ(mesh.vertices[0].position, glm::vec3(0));
}

TEST(TurnedZUp, PutsZUpWithoutAMirror) {
    MeshData mesh{{{{1, 2, 3}, {0, 0, 1}, {}}}, {}};
    mesh = TurnedZUp(mesh);
    EXPECT_EQ(mesh.vertices[0].position, glm::vec3(1, 3, -2));
    EXPECT_EQ(mesh.vertices[0].normal, glm::vec3(0, 1, 0));
    const auto turned = [](glm::vec3 v) { return TurnedZUp({{{v, v, {}}}, {}}).vertices[0].position; };
    EXPECT_EQ(glm::cross(turned({1, 0, 0}), turned({0, 1, 0})), turned({0, 0, 1}));
}

}  // namespace
}  // namespace boxcar
