// Other people's HLSL on the device: what bxc adds to the compiler, and puts right behind it, computes what Direct3D
// does.
#include <gtest/gtest.h>

#include <functional>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>

#include "passes_shaders.h"
#include "test_support_shaders.h"
#include "tests/hlsl/test_constants.h"
#include "tests/support/device_buffer.h"
#include "tests/support/device_image.h"

namespace boxcar {
namespace {

constexpr Extent2D kExtent{12, 19};

using Choice = std::function<glm::vec4(const glm::vec4& a, const glm::vec4& b)>;

// Draws a form of select.ps of two pictures of noise, some of whose texels are alike, and compares each texel.
void ExpectSelect(int form, const Choice& expected) {
    const Texels a = RandomValues(kExtent, 1);
    Texels b = RandomValues(kExtent, 2);
    for (size_t i = 0; i < a.size(); i += 5)
        b[i].x = a[i].x;
    const Image left = Upload(kExtent, a), right = Upload(kExtent, b);
    const Image target(TestDevice(), {kExtent, Format::RGBA32F, "selected"});
    const Pipeline pipeline(TestDevice(),
                            {passes_shaders::Find("shaders/quad.vs"),
                             test_support_shaders::Find("shaders/select.ps.FORM=" + std::to_string(form))});
    CommandList commands(TestDevice());
    commands.Draw(
        {.name = "select", .pipeline = pipeline, .reads = {{"left", &left}, {"right", &right}}, .writes = {&target}});
    commands.SubmitAndWait();
    const Texels result = Download(target);
    for (size_t i = 0; i < a.size(); ++i)
        EXPECT_EQ(result[i], expected(a[i], b[i])) << "form " << form << ", texel " << i;
}

glm::vec4 EachChannel(const std::function<float(int c)>& value) {
    return {value(0), value(1), value(2), value(3)};
}

TEST(Select, ChoosesByChannel) {
    ExpectSelect(0, [](auto a, auto b) { return EachChannel([&](int c) { return a[c] > b[c] ? a[c] : b[c]; }); });
}

TEST(Select, TakesOneConditionForAllChannels) {
    ExpectSelect(1, [](auto a, auto b) { return a.x > b.x ? a : b; });
}

TEST(Select, GivesTheCommonTypeOfItsValues) {
    ExpectSelect(2, [](auto a, auto b) { return EachChannel([&](int c) { return a[c] > b[c] ? 1.0f : 0.5f; }); });
    ExpectSelect(
        3, [](auto a, auto b) { return EachChannel([&](int c) { return c < 3 && a[c] > b[c] ? 65535.0f : 0.0f; }); });
}

TEST(Select, EvaluatesBothValues) {
    ExpectSelect(6, [](auto a, auto b) { return glm::vec4(a.x > b.x ? 1 : 20, 2, 0, 0); });
}

TEST(Select, ChoosesBetweenMatrices) {
    ExpectSelect(
        7, [](auto a, auto b) { return a.x > b.x ? glm::vec4(a.x, a.y, a.z, b.z) : glm::vec4(b.x, b.y, b.z, a.z); });
}

TEST(Select, TakesANumberForACondition) {
    ExpectSelect(8, [](auto a, auto b) {
        return EachChannel([&](int c) { return static_cast<int>(a[c] * 4) != 2 ? a[c] : b[c]; });
    });
}

TEST(AndOr, AreTrueByChannel) {
    ExpectSelect(4, [](auto a, auto b) {
        return EachChannel([&](int c) { return a[c] > 0.5f && b[c] > 0.5f ? 1.0f : 0.0f; });
    });
    ExpectSelect(5, [](auto a, auto b) {
        return EachChannel([&](int c) { return a[c] > 0.5f || b.x > 0.5f ? 1.0f : 0.0f; });
    });
}

// A triangle that covers the left half of an 8 x 8 target, so that a position elsewhere shows.
TEST(InoutPosition, IsThePositionAndMovesNoOtherOutput) {
    const auto at = [](float x, float y) { return Vertex{.position = {x, y, 0}, .uv = {x / 8, y / 8}}; };
    const std::vector<Vertex> corners = {at(0, 0), at(4, 0), at(0, 8), at(4, 8)};
    const std::vector<uint32_t> indices = {0, 1, 2, 2, 1, 3};
    const Mesh mesh(TestDevice(), corners, indices, "left half");
    const glm::mat4 clipFromTexels =
        glm::translate(glm::mat4(1), {-1, 1, 0}) * glm::scale(glm::mat4(1), {0.25f, -0.25f, 1});
    const MeshConstants constants{clipFromTexels, {}};
    constexpr Extent2D kTarget{8, 8};
    for (const char* form : {"0", "1", "2"}) {
        const Image target = Upload(kTarget, Texels(kTarget.Texels(), glm::vec4(-1)));
        const Pipeline pipeline(
            TestDevice(),
            {.vertex = test_support_shaders::Find(std::string("shaders/inout_position.vs.FORM=") + form),
             .pixel = test_support_shaders::Find("shaders/inout_position.ps")});
        CommandList commands(TestDevice());
        commands.Draw({.name = "inout position",
                       .pipeline = pipeline,
                       .writes = {&target},
                       .constants = ConstantBytes(constants),
                       .mesh = &mesh});
        commands.SubmitAndWait();
        const Texels result = Download(target);
        for (uint32_t y = 0; y < 8; ++y)
            for (uint32_t x = 0; x < 8; ++x) {
                const glm::vec2 center(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
                const glm::vec4 expected =
                    x < 4 ? glm::vec4(center / 8.0f, 2 * center.x / 8, center.x) : glm::vec4(-1);
                for (int c = 0; c < 4; ++c)
                    EXPECT_NEAR(result[8 * y + x][c], expected[c], 1e-6f) << form << ": " << x << ' ' << y;
            }
    }
}

TEST(Direct3dAttributes, LeaveTheShaderAsItIs) {
    const Texels source = RandomCodes(kExtent, 3);
    const Image target(TestDevice(), {kExtent, Format::RGBA32F, "twice"});
    const Pipeline pipeline(TestDevice(), {passes_shaders::Find("shaders/quad.vs"),
                                           test_support_shaders::Find("shaders/direct3d_attributes.ps")});
    const Texels result =
        RunOnDevice(kExtent, source, [&](CommandList& commands, const Image& image) -> const Image& {
            commands.Draw(
                {.name = "twice", .pipeline = pipeline, .reads = {{"source", &image}}, .writes = {&target}});
            return target;
        });
    for (size_t i = 0; i < source.size(); ++i)
        EXPECT_EQ(result[i], 2.0f * source[i]);
}

// 64 threads; the numbers follow from the comments in atomics.cs.
TEST(Atomics, ConvertTheirOperandsToTheTypeOfTheMemory) {
    constexpr uint32_t kThreads = 64;
    NamedWords buffers = {{"bytes", Words(24, 0)}, {"results", {0, 6, 0}}, {"signedResults", {0, 0, 0}}};
    Words& bytes = buffers["bytes"];
    bytes[1] = 100;   // less 64
    bytes[2] = 50;    // its minimum with 0xffffffff
    bytes[5] = 0xff;  // less its lowest four bits
    bytes[6] = 9;     // an even number of times
    bytes[10] = 5;
    bytes[12] = 6;
    buffers["signedResults"][1] = static_cast<uint32_t>(-6);
    const NamedWords after = RunCompute(test_support_shaders::Find("shaders/atomics.cs"), buffers, 1);

    const Words& words = after.at("bytes");
    EXPECT_EQ(words[0], kThreads);
    EXPECT_EQ(words[1], 100 - kThreads);
    EXPECT_EQ(words[2], 50u);
    EXPECT_EQ(words[3], 0xffffffffu) << "the largest of 0, -1 .. -63 as uint";
    EXPECT_EQ(words[4], 0xfu);
    EXPECT_EQ(words[5], 0xf0u);
    EXPECT_EQ(words[6], 9u);
    EXPECT_EQ(words[7], kThreads);
    EXPECT_EQ(words[8], kThreads / 2);
    EXPECT_EQ(words[9], 7u);
    const int exchanged = static_cast<int>(words[10]);
    EXPECT_TRUE(exchanged <= -1 && exchanged >= -64) << exchanged;
    EXPECT_EQ(words[11], 1u);
    EXPECT_EQ(words[12], 9u);
    EXPECT_EQ(std::vector<uint32_t>(words.begin() + 13, words.begin() + 22),
              (std::vector<uint32_t>{3, 3, 4, 4, 4, 5, 5, 5, 5}));
    EXPECT_EQ(words[22], 0u) << "nothing is written behind Store4";
    EXPECT_EQ(after.at("results"), (std::vector<uint32_t>{kThreads, 9, kThreads}));
    EXPECT_EQ(after.at("signedResults"),
              (std::vector<uint32_t>{63, static_cast<uint32_t>(-9), static_cast<uint32_t>(-63)}));
}

}  // namespace
}  // namespace boxcar
