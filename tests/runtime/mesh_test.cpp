#include "runtime/mesh.h"

#include <gtest/gtest.h>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include "passes_shaders.h"
#include "test_support_shaders.h"
#include "tests/hlsl/test_constants.h"
#include "tests/support/device_image.h"
#include "tests/support/expect_error.h"

namespace boxcar {
namespace {

constexpr Extent2D kExtent{8, 8};
constexpr float kValueBefore = -1;

PipelineDesc MeshPipeline() {
    return {.vertex = test_support_shaders::Find("shaders/mesh.vs"),
            .pixel = test_support_shaders::Find("shaders/mesh.ps")};
}

PipelineDesc DepthPipeline() {
    PipelineDesc desc = MeshPipeline();
    desc.testsDepth = true;
    return desc;
}

// Positions in texels from the upper left corner of an 8 x 8 target; exact, because 8 is a power of two.
glm::mat4 ClipFromTexels() {
    return glm::translate(glm::mat4(1), {-1, 1, 0}) * glm::scale(glm::mat4(1), {0.25f, -0.25f, 1});
}

Vertex At(float xTexels, float yTexels, float depth = 0) {
    return {.position = {xTexels, yTexels, depth}, .normal = {0, 0, 0.5f}, .uv = {xTexels / 8, yTexels / 8}};
}

Mesh MakeMesh(const std::vector<Vertex>& vertices, const std::vector<uint32_t>& indices) {
    return {TestDevice(), vertices, indices, "test mesh"};
}

// Covers the target; its depth goes from `leftDepth` to `rightDepth`.
Mesh Sheet(float leftDepth, float rightDepth) {
    return MakeMesh({At(0, 0, leftDepth), At(8, 0, rightDepth), At(0, 8, leftDepth), At(8, 8, rightDepth)},
                    {0, 1, 2, 2, 1, 3});
}

Image Target() {
    return Upload(kExtent, Texels(64, glm::vec4(kValueBefore)), "target");
}

// What each texel was drawn with.
std::vector<float> Values(const Image& target) {
    std::vector<float> values;
    for (const glm::vec4& texel : Download(target))
        values.push_back(texel.w);
    return values;
}

std::vector<float> Depths(const Image& depth) {
    std::vector<float> depths(depth.Extent().Texels());
    ReadTexels(TestDevice(), depth, std::as_writable_bytes(std::span(depths)));
    return depths;
}

// 0, 1, .. for texels (0, 0), (1, 0), ..
std::vector<float> EachTexel(const std::function<float(uint32_t x, uint32_t y)>& value) {
    std::vector<float> values;
    for (uint32_t y = 0; y < 8; y++)
        for (uint32_t x = 0; x < 8; x++)
            values.push_back(value(x, y));
    return values;
}

// Direct3D's rule: texels whose centre is inside, or on an edge that is a top or a left one. Whole numbers: positions
// are in half texels.
struct Point {
    int x, y;
};
int TwiceArea(Point a, Point b, Point p) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}
bool Covers(std::array<Point, 3> corners, Point centre) {
    if (TwiceArea(corners[0], corners[1], corners[2]) < 0) std::swap(corners[1], corners[2]);  // now clockwise
    for (int i = 0; i < 3; i++) {
        const Point from = corners[i], to = corners[(i + 1) % 3];
        const bool isTop = from.y == to.y && from.x<to.x, isLeft = from.y> to.y;
        const int side = TwiceArea(from, to, centre);
        if (side < 0 || (side == 0 && !isTop && !isLeft)) return false;
    }
    return true;
}

TEST(Mesh, CoversTheTexelsThatTheTopLeftRuleGivesIt) {
    const Pipeline pipeline(TestDevice(), MeshPipeline());
    std::mt19937 random(1);
    int onEdges = 0;
    for (int round = 0; round < 60; round++) {
        std::array<Point, 3> corners;
        for (Point& corner : corners)
            corner = {static_cast<int>(random() % 17), static_cast<int>(random() % 17)};
        const auto corner = [&](int i) {
            return At(static_cast<float>(corners[i].x) / 2, static_cast<float>(corners[i].y) / 2);
        };
        const Mesh mesh = MakeMesh({corner(0), corner(1), corner(2)}, {0, 1, 2});
        const Image target = Target();
        const MeshConstants constants{ClipFromTexels(), glm::vec4(1)};
        CommandList commands(TestDevice());
        commands.Draw({.name = "triangle",
                       .pipeline = pipeline,
                       .writes = {&target},
                       .constants = ConstantBytes(constants),
                       .mesh = &mesh});
        commands.SubmitAndWait();
        EXPECT_EQ(Values(target), EachTexel([&](uint32_t x, uint32_t y) {
                      const Point centre{static_cast<int>(2 * x + 1), static_cast<int>(2 * y + 1)};
                      for (int i = 0; i < 3; i++)
                          onEdges += TwiceArea(corners[i], corners[(i + 1) % 3], centre) == 0;
                      return Covers(corners, centre) ? 1 : kValueBefore;
                  }))
            << "triangle " << round;
    }
    EXPECT_GT(onEdges, 100) << "the rule was hardly tried";
}

TEST(Mesh, DrawsTheTrianglesOfItsIndicesWithAllThatItsVerticesHold) {
    const Pipeline pipeline(TestDevice(), MeshPipeline());
    // Corners of the target's right half, of which only the indices know; the others are off the grid.
    const Mesh mesh = MakeMesh({At(0, 0), At(4, 0), At(8, 0), At(0, 8), At(4, 8), At(8, 8)}, {1, 2, 4, 4, 2, 5});
    const Image target = Target();
    const MeshConstants constants{ClipFromTexels(), glm::vec4(3)};
    CommandList commands(TestDevice());
    commands.Draw({.name = "right half",
                   .pipeline = pipeline,
                   .writes = {&target},
                   .constants = ConstantBytes(constants),
                   .mesh = &mesh});
    commands.SubmitAndWait();
    const Texels texels = Download(target);
    for (uint32_t y = 0; y < 8; y++)
        for (uint32_t x = 0; x < 8; x++) {
            const glm::vec2 uv = (glm::vec2(x, y) + 0.5f) / 8.0f;
            const glm::vec4 expected = x < 4 ? glm::vec4(kValueBefore) : glm::vec4(uv, 0.5f, 3);
            for (int c = 0; c < 4; c++)
                EXPECT_NEAR(texels[8 * y + x][c], expected[c], 1e-6) << x << ", " << y;
        }
}

// A floor seen at a slant. In double: a texel's (x, y, 1) is a multiple of H (u, v, 1), with H the rows x, y and w of
// the matrix; the inverse leads back to the uv. The device puts corners on a grid of 1/256 texel, which moves the uv
// by as much of its change from texel to texel, at most.
TEST(Mesh, InterpolatesUvRightInPerspective) {
    const Extent2D extent{64, 48};
    const Pipeline pipeline(TestDevice(), MeshPipeline());
    const Mesh mesh =
        MakeMesh({{{0, 0, 0}, {}, {0, 0}}, {{1, 0, 0}, {}, {1, 0}}, {{0, 1, 0}, {}, {0, 1}}, {{1, 1, 0}, {}, {1, 1}}},
                 {0, 1, 2, 2, 1, 3});
    const glm::mat4 clipFromMesh = glm::perspectiveRH_ZO(1.0f, 64.0f / 48, 0.1f, 10.0f) *
                                   glm::lookAtRH(glm::vec3(0.4f, -0.3f, 0.3f), {0.5f, 0.6f, 0}, {0, 0, 1});
    const Image target = Upload(extent, Texels(extent.Texels(), glm::vec4(kValueBefore)));
    const MeshConstants constants{clipFromMesh, glm::vec4(1)};
    CommandList commands(TestDevice());
    commands.Draw({.name = "floor",
                   .pipeline = pipeline,
                   .writes = {&target},
                   .constants = ConstantBytes(constants),
                   .mesh = &mesh});
    commands.SubmitAndWait();

    const glm::dmat4 m(clipFromMesh);
    const glm::dmat3 h({m[0].x, m[0].y, m[0].w}, {m[1].x, m[1].y, m[1].w}, {m[3].x, m[3].y, m[3].w});
    const auto uvAt = [&](double xTexels, double yTexels) {
        const glm::dvec3 p = glm::inverse(h) * glm::dvec3(xTexels / 32 - 1, 1 - yTexels / 24, 1);
        return glm::dvec2(p) / p.z;
    };
    const Texels texels = Download(target);
    int drawn = 0;
    for (int y = 0; y < 48; y++)
        for (int x = 0; x < 64; x++) {
            const glm::vec4 texel = texels[64 * y + x];
            if (texel.w != 1) continue;
            drawn++;
            const glm::dvec2 uv = uvAt(x + 0.5, y + 0.5);
            const glm::dvec2 step = glm::abs(uvAt(x + 1.5, y + 0.5) - uv) + glm::abs(uvAt(x + 0.5, y - 0.5) - uv);
            EXPECT_NEAR(texel.x, uv.x, step.x / 256 + 1e-5) << x << ", " << y;
            EXPECT_NEAR(texel.y, uv.y, step.y / 256 + 1e-5) << x << ", " << y;
        }
    EXPECT_GT(drawn, 600);
    EXPECT_LT(drawn, 64 * 48);
}

TEST(Mesh, NearerWinsWhateverTheOrder) {
    const Pipeline pipeline(TestDevice(), DepthPipeline());
    const Mesh even = Sheet(0.5f, 0.5f), slanted = Sheet(0, 1);
    const Image depth(TestDevice(), {kExtent, Format::Depth32F, "depth"});
    const MeshConstants ofEven{ClipFromTexels(), glm::vec4(1)}, ofSlanted{ClipFromTexels(), glm::vec4(2)};
    for (const bool evenFirst : {true, false}) {
        const Image target = Target();
        CommandList commands(TestDevice());
        for (const bool isFirst : {true, false})
            commands.Draw({.name = "sheet",
                           .pipeline = pipeline,
                           .writes = {&target},
                           .constants = ConstantBytes(evenFirst == isFirst ? ofEven : ofSlanted),
                           .mesh = evenFirst == isFirst ? &even : &slanted,
                           .depth = &depth,
                           .clearsDepth = isFirst});
        commands.SubmitAndWait();
        // The slanted sheet has depth (x + 0.5) / 8 at the centres.
        EXPECT_EQ(Values(target), EachTexel([](uint32_t x, uint32_t) { return x < 4 ? 2 : 1; }));
        const std::vector<float> depths = Depths(depth);
        for (uint32_t i = 0; i < 64; i++)
            EXPECT_NEAR(depths[i], std::min(0.5, (i % 8 + 0.5) / 8), 1e-6) << i;
    }
}

TEST(Mesh, WithoutDepthTheLastOneWins) {
    const Pipeline pipeline(TestDevice(), MeshPipeline());
    const Mesh near = Sheet(0.25f, 0.25f), far = Sheet(0.75f, 0.75f);
    const Image target = Target();
    const MeshConstants ofNear{ClipFromTexels(), glm::vec4(1)}, ofFar{ClipFromTexels(), glm::vec4(2)};
    CommandList commands(TestDevice());
    for (const bool isNear : {true, false})
        commands.Draw({.name = "sheet",
                       .pipeline = pipeline,
                       .writes = {&target},
                       .constants = ConstantBytes(isNear ? ofNear : ofFar),
                       .mesh = isNear ? &near : &far});
    commands.SubmitAndWait();
    EXPECT_EQ(Values(target), std::vector<float>(64, 2));
}

// What is cleared is cleared in `area` alone; what is not keeps its value, depth too.
TEST(Mesh, ClearsTargetsAndDepthWhereItIsToldTo) {
    const Pipeline pipeline(TestDevice(), DepthPipeline());
    const Mesh corner =
        MakeMesh({At(0, 0, 0.5f), At(2, 0, 0.5f), At(0, 2, 0.5f), At(2, 2, 0.5f)}, {0, 1, 2, 2, 1, 3});
    const Mesh behind = Sheet(0.75f, 0.75f);
    const Image target = Target();
    const Image depth(TestDevice(), {kExtent, Format::Depth32F, "depth"});
    const MeshConstants ofCorner{ClipFromTexels(), glm::vec4(1)}, ofBehind{ClipFromTexels(), glm::vec4(2)};
    CommandList commands(TestDevice());
    commands.Draw({.name = "corner",
                   .pipeline = pipeline,
                   .writes = {&target},
                   .constants = ConstantBytes(ofCorner),
                   .area = Rect{0, 0, 4, 8},
                   .mesh = &corner,
                   .depth = &depth,
                   .clearColor = glm::vec4(7),
                   .clearsDepth = true});
    commands.SubmitAndWait();
    const auto inCorner = [](uint32_t x, uint32_t y) { return x < 2 && y < 2; };
    EXPECT_EQ(Values(target), EachTexel([&](uint32_t x, uint32_t y) {
                  return inCorner(x, y) ? 1 : x < 4 ? 7 : kValueBefore;
              }));

    CommandList more(TestDevice());
    more.Draw({.name = "behind",
               .pipeline = pipeline,
               .writes = {&target},
               .constants = ConstantBytes(ofBehind),
               .area = Rect{0, 0, 4, 4},
               .mesh = &behind,
               .depth = &depth});
    more.SubmitAndWait();
    EXPECT_EQ(Values(target), EachTexel([&](uint32_t x, uint32_t y) {
                  return inCorner(x, y) ? 1 : x < 4 ? y < 4 ? 2 : 7 : kValueBefore;
              }));
}

TEST(Mesh, ItsDepthIsReadByALaterPass) {
    const Pipeline pipeline(TestDevice(), DepthPipeline());
    const Pipeline subtract(TestDevice(), {.vertex = passes_shaders::Find("shaders/quad.vs"),
                                           .pixel = test_support_shaders::Find("shaders/subtract.ps")});
    const Mesh sheet = Sheet(0.25f, 0.25f);
    const Image target = Target(), result = Target();
    const Image depth(TestDevice(), {kExtent, Format::Depth32F, "depth"});
    const MeshConstants constants{ClipFromTexels(), glm::vec4(1)};
    const SubtractConstants nothing{};
    CommandList commands(TestDevice());
    commands.Draw({.name = "sheet",
                   .pipeline = pipeline,
                   .writes = {&target},
                   .constants = ConstantBytes(constants),
                   .mesh = &sheet,
                   .depth = &depth,
                   .clearsDepth = true});
    commands.Draw({.name = "read",
                   .pipeline = subtract,
                   .reads = {{"source", &depth}},
                   .writes = {&result},
                   .constants = ConstantBytes(nothing)});
    commands.SubmitAndWait();
    for (const glm::vec4& texel : Download(result))
        EXPECT_EQ(texel.x, 0.25f);
}

TEST(Mesh, FrontFacesGoCounterClockwiseOnTheScreen) {
    // The left one's corners go counter-clockwise: down, right, up.
    const Mesh mesh = MakeMesh({At(0, 0), At(0, 8), At(4, 8), At(4, 0), At(8, 0), At(8, 8)}, {0, 1, 2, 3, 4, 5});
    const MeshConstants constants{ClipFromTexels(), glm::vec4(1)};
    for (const Cull cull : {Cull::None, Cull::Back, Cull::Front}) {
        PipelineDesc desc = MeshPipeline();
        desc.cull = cull;
        const Pipeline pipeline(TestDevice(), desc);
        const Image target = Target();
        CommandList commands(TestDevice());
        commands.Draw({.name = "both",
                       .pipeline = pipeline,
                       .writes = {&target},
                       .constants = ConstantBytes(constants),
                       .mesh = &mesh});
        commands.SubmitAndWait();
        const std::vector<float> values = Values(target);
        EXPECT_EQ(values[8 * 6 + 0] == 1, cull != Cull::Front);
        EXPECT_EQ(values[8 * 1 + 7] == 1, cull != Cull::Back);
    }
}

TEST(Mesh, IsCountedInTheDevicesMemory) {
    Device& device = TestDevice();
    const uint64_t before = device.MemoryBytes();
    {
        Mesh mesh = MakeMesh(std::vector<Vertex>(1000), std::vector<uint32_t>(3000));
        const Mesh moved = std::move(mesh);
        EXPECT_GE(device.MemoryBytes() - before, 1000 * 32 + 3000 * 4);
        EXPECT_LE(device.MemoryBytes() - before, 1000 * 32 + 3000 * 4 + 65536);
    }
    EXPECT_EQ(device.MemoryBytes(), before);
}

TEST(Mesh, RefusesIndicesThatMakeNoTriangles) {
    const std::vector<Vertex> three(3);
    EXPECT_ERROR(MakeMesh(three, {}),
                 "mesh 'test mesh' has 0 indices: three a triangle, of 1 to 1431655765 triangles, are expected");
    EXPECT_ERROR(MakeMesh(three, {0, 1}),
                 "mesh 'test mesh' has 2 indices: three a triangle, of 1 to 1431655765 triangles, are expected");
    EXPECT_ERROR(MakeMesh(three, {0, 1, 3}), "mesh 'test mesh' has the index 3, but 3 vertices");
}

TEST(Mesh, RefusesPassesThatDoNotFitAndNamesThem) {
    const Pipeline draws(TestDevice(), MeshPipeline()), tests(TestDevice(), DepthPipeline());
    const Pipeline quad(TestDevice(), {.vertex = passes_shaders::Find("shaders/quad.vs"),
                                       .pixel = test_support_shaders::Find("shaders/subtract.ps")});
    const Mesh mesh = Sheet(0, 0);
    const Image target = Target();
    const Image depth(TestDevice(), {kExtent, Format::Depth32F, "depth"});
    const Image small(TestDevice(), {{4, 8}, Format::Depth32F, "small"});
    CommandList commands(TestDevice());
    EXPECT_ERROR(commands.Draw({.name = "p", .pipeline = draws, .writes = {&target}}),
                 "pass 'p' gives no mesh: shaders/mesh.ps draws one");
    EXPECT_ERROR(commands.Draw({.name = "p", .pipeline = quad, .writes = {&target}, .mesh = &mesh}),
                 "pass 'p' gives a mesh: shaders/subtract.ps draws a quad");
    EXPECT_ERROR(commands.Draw({.name = "p", .pipeline = tests, .writes = {&target}, .mesh = &mesh}),
                 "pass 'p' gives no depth image: its pipeline tests depth");
    EXPECT_ERROR(commands.Draw({.name = "p", .pipeline = draws, .writes = {&target}, .mesh = &mesh, .depth = &depth}),
                 "pass 'p' gives a depth image: its pipeline tests none");
    EXPECT_ERROR(
        commands.Draw({.name = "p", .pipeline = tests, .writes = {&target}, .mesh = &mesh, .depth = &target}),
        "pass 'p' writes 'target', which is RGBA32F: its pipeline writes Depth32F");
    EXPECT_ERROR(commands.Draw({.name = "p", .pipeline = tests, .writes = {&target}, .mesh = &mesh, .depth = &small}),
                 "pass 'p' writes 'target' and 'small', which differ in extent");
    EXPECT_ERROR(commands.Draw({.name = "p",
                                .pipeline = tests,
                                .reads = {{"source", &depth}},
                                .writes = {&target},
                                .mesh = &mesh,
                                .depth = &depth}),
                 "pass 'p' reads and writes 'depth' at once: what it would read is undefined");
}

TEST(Mesh, RefusesVertexInputsThatItDoesNotHave) {
    for (const auto& [from, to, shown] :
         {std::tuple{"NORMAL0", "COLOR0", "float3 COLOR0"}, std::tuple{"float3", "uint3", "uint3 NORMAL0"}}) {
        PipelineDesc desc = MeshPipeline();
        std::string json(desc.vertex.layoutJson);
        const size_t input = json.find("\"normal\""), at = json.find(from, input);
        ASSERT_NE(at, std::string::npos) << json;
        json.replace(at, std::string_view(from).size(), to);
        desc.vertex.layoutJson = json;
        EXPECT_ERROR(Pipeline(TestDevice(), desc),
                     fmt::format("shader shaders/mesh.vs: vertex input 'normal' ({}) is not in a mesh, which has "
                                 "float3 POSITION, float3 NORMAL and float2 TEXCOORD0",
                                 shown));
    }
}

}  // namespace
}  // namespace boxcar
