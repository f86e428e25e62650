#include "runtime/pipeline.h"

#include <gtest/gtest.h>

#include "hlsl/constants/sat_constants.h"
#include "passes_shaders.h"
#include "test_support_shaders.h"
#include "tests/support/device_image.h"
#include "tests/support/expect_error.h"

namespace boxcar {
namespace {

// The row 1 2 3 4 sampled `shiftTexels` to the right, through the sampler of a name.
std::vector<float> SampledRow(const std::string& sampler, float shiftTexels) {
    const Extent2D extent{4, 1};
    const Pipeline pipeline(TestDevice(), {passes_shaders::Find("shaders/quad.vs"),
                                           test_support_shaders::Find("shaders/sample.ps.SAMPLER=" + sampler)});
    const Image result(TestDevice(), {extent, Format::RGBA32F, "sampled"});
    const SATPassConstants constants{{shiftTexels / 4, 0}, {}, {}};
    const Texels row = {glm::vec4(1), glm::vec4(2), glm::vec4(3), glm::vec4(4)};
    const Texels texels = RunOnDevice(extent, row, [&](CommandList& commands, const Image& image) -> const Image& {
        commands.Draw({.name = "sample",
                       .pipeline = pipeline,
                       .reads = {{"source", &image}},
                       .writes = {&result},
                       .constants = ConstantBytes(constants)});
        return result;
    });
    return {texels[0].x, texels[1].x, texels[2].x, texels[3].x};
}

using Row = std::vector<float>;

TEST(Sampler, IsChosenByItsNameInTheHlsl) {
    EXPECT_EQ(SampledRow("nearestBorder", 1), Row({2, 3, 4, 0}));
    EXPECT_EQ(SampledRow("nearestBorder", -2), Row({0, 0, 1, 2}));
    EXPECT_EQ(SampledRow("nearestClamp", 2), Row({3, 4, 4, 4}));
    EXPECT_EQ(SampledRow("nearestRepeat", 1), Row({2, 3, 4, 1}));
    EXPECT_EQ(SampledRow("nearestMirror", 2), Row({3, 4, 4, 3}));
    EXPECT_EQ(SampledRow("linearClamp", 0.5f), Row({1.5f, 2.5f, 3.5f, 4}));
    EXPECT_EQ(SampledRow("linearBorder", 0.5f), Row({1.5f, 2.5f, 3.5f, 2}));
    EXPECT_EQ(SampledRow("linearRepeat", 0.5f), Row({1.5f, 2.5f, 3.5f, 2.5f}));
}

EmbeddedShader WithLayout(EmbeddedShader shader, std::string& json, const std::string& from, const std::string& to) {
    json = shader.layoutJson;
    const size_t at = json.find(from);
    EXPECT_NE(at, std::string::npos) << from << " is not in " << json;
    json.replace(at, from.size(), to);
    shader.layoutJson = json;
    return shader;
}

TEST(Pipeline, RefusesASamplerWhoseNameSaysNothing) {
    std::string json;
    const EmbeddedShader shader =
        WithLayout(passes_shaders::Find("shaders/sat_pass.ps.TAPS=2"), json, "nearestBorder", "fancy");
    EXPECT_ERROR(Pipeline(TestDevice(), {passes_shaders::Find("shaders/sat_pass.vs.TAPS=2"), shader}),
                 "shader shaders/sat_pass.ps.TAPS=2: sampler 'fancy' is none of "
                 "{nearest|linear|anisotropic}{Border|Clamp|Repeat|Mirror}");
}

TEST(Pipeline, RefusesShadersThatDoNotLink) {
    EXPECT_ERROR(Pipeline(TestDevice(), {passes_shaders::Find("shaders/quad.vs"),
                                         passes_shaders::Find("shaders/sat_pass.ps.TAPS=2")}),
                 "shaders/quad.vs does not link to shaders/sat_pass.ps.TAPS=2: input 'uv[0]' (float4 at location 0) "
                 "is not written as such");
}

}  // namespace
}  // namespace boxcar
