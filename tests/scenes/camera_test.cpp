#include "samples/scenes/camera.h"

#include <gtest/gtest.h>

#include "samples/scenes/shapes.h"
#include "test_support_shaders.h"
#include "tests/hlsl/test_constants.h"
#include "tests/support/device_image.h"

namespace boxcar {
namespace {

constexpr Extent2D kWide{200, 100};

glm::vec3 Project(const Camera& camera, const glm::vec3& world) {
    const glm::vec4 clip = ClipFromWorld(camera, kWide) * glm::vec4(world, 1);
    return glm::vec3(clip) / clip.w;
}

void ExpectNear(const glm::vec3& got, const glm::vec3& expected) {
    for (int c = 0; c < 3; c++)
        EXPECT_NEAR(got[c], expected[c], 1e-5) << "component " << c;
}

// Looking along +x from (1, 2, 3), z is to the right.
TEST(Camera, PutsTheRimsOfThePictureAndTheDepthsWhereClipSpaceEnds) {
    const Camera camera{.eyeWorld = {1, 2, 3},
                        .targetWorld = {5, 2, 3},
                        .upWorld = {0, 7, 0},
                        .verticalAngleRadians = 1.2f,
                        .nearDepth = 0.5f,
                        .farDepth = 20};
    const float rim = std::tan(0.6f);
    ExpectNear(Project(camera, {1.5f, 2, 3}), {0, 0, 0});
    ExpectNear(Project(camera, {21, 2, 3}), {0, 0, 1});
    ExpectNear(Project(camera, {21, 2 + 20 * rim, 3}), {0, 1, 1});
    ExpectNear(Project(camera, {21, 2, 3 + 2 * 20 * rim}), {1, 0, 1});
    // In between depth is f / (f - n) * (1 - n / z), and w is z.
    ExpectNear(Project(camera, {4, 2, 3}), {0, 0, 20 / 19.5 * (1 - 0.5 / 3)});
    EXPECT_NEAR((ClipFromWorld(camera, kWide) * glm::vec4(4, 8, -1, 1)).w, 3, 1e-5);
}

// Camera, shape, culling and depth together: a sphere of radius 1 seen from 3 away. A ray is in the picture of it
// where it passes the centre by less than 1, and the depth is of the nearer hit, or of the farther where front faces
// are left out. The mesh is inside the sphere by less than 1 - cos(pi / 128) = 3e-4.
TEST(Camera, SeesASphereWhereItIsFromTheSideThatIsNotCulled) {
    const Extent2D extent{64, 64};
    const MeshData sphere = Sphere(1, 256, 128);
    const Mesh mesh(TestDevice(), sphere.vertices, sphere.indices, "sphere");
    const Camera camera{.eyeWorld = {3, 0, 0}, .verticalAngleRadians = 0.9f, .nearDepth = 1, .farDepth = 5};
    const MeshConstants constants{ClipFromWorld(camera, extent), glm::vec4(1)};
    const Image target(TestDevice(), {extent, Format::RGBA32F, "target"});
    const Image depth(TestDevice(), {extent, Format::Depth32F, "depth"});
    for (const Cull cull : {Cull::None, Cull::Back, Cull::Front}) {
        const Pipeline pipeline(TestDevice(), {.vertex = test_support_shaders::Find("shaders/mesh.vs"),
                                               .pixel = test_support_shaders::Find("shaders/mesh.ps"),
                                               .testsDepth = true,
                                               .cull = cull});
        CommandList commands(TestDevice());
        commands.Draw({.name = "sphere",
                       .pipeline = pipeline,
                       .writes = {&target},
                       .constants = ConstantBytes(constants),
                       .mesh = &mesh,
                       .depth = &depth,
                       .clearColor = glm::vec4(0),
                       .clearsDepth = true});
        commands.SubmitAndWait();
        const Texels texels = Download(target);
        std::vector<float> depths(extent.Texels());
        ReadTexels(TestDevice(), depth, std::as_writable_bytes(std::span(depths)));
        int hits = 0;
        for (int y = 0; y < 64; y++)
            for (int x = 0; x < 64; x++) {
                // The ray reaches this far to the side at a depth of 1.
                const double side = std::hypot(x + 0.5 - 32, y + 0.5 - 32) / 32 * std::tan(0.45);
                const double passes = 3 * side / std::hypot(1, side);
                if (std::abs(passes - 1) < 0.02) continue;  // on the rim
                const bool isHit = passes < 1;
                EXPECT_EQ(texels[64 * y + x].w, isHit ? 1 : 0) << x << ", " << y;
                // (1 + side^2) z^2 - 6 z + 8 = 0
                const double root = std::sqrt(std::max(0.0, 9 - 8 * (1 + side * side)));
                const double z = (3 + (cull == Cull::Front ? root : -root)) / (1 + side * side);
                EXPECT_NEAR(depths[64 * y + x], isHit ? 5 / 4.0 * (1 - 1 / z) : 1, 0.003) << x << ", " << y;
                hits += isHit;
            }
        EXPECT_GT(hits, 1000);
    }
}

}  // namespace
}  // namespace boxcar
