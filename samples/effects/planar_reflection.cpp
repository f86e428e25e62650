// Glossy planar reflection: sharp where objects touch the floor, blurred the more the farther from it.
//
//   mirrored scene  ->  color, height  ->  table of the color  ->  floor: a box as wide as the ray's cone
//
// Hensley 2005, sect. 5.2 (Fig. 1)
#include <cmath>

#include "hlsl/constants/effect_constants.h"
#include "runtime/passes/exact_table.h"
#include "samples/effects/effect_shader.h"
#include "samples/effects/effects.h"
#include "samples/scenes/scene.h"
#include "samples/scenes/shapes.h"

namespace boxcar {
namespace {

constexpr float kFarWorld = 40;  // how far the sky is, for the reflection's width
constexpr float kBrightest = 2;  // of the reflected light, which is coded in 16 bits
constexpr float kObjectScale = 1.5f;
constexpr float kLargestRoughness = 1;  // of the parameter

class PlanarReflection : public Effect {
public:
    PlanarReflection(Device& device, const EffectInputs& inputs, const ParameterValues&)
        : m_coneTexels(TexelsAtDepthOne(m_camera, inputs.extent)),
          m_codes{65535 / kBrightest, 65535, false},
          m_precision(SATExactPrecision(glm::vec2(kLargestRoughness * m_coneTexels), 1, false, m_codes)),
          m_object(UploadMesh(
              device, StandingMesh(inputs.mesh, {m_camera, inputs.extent, glm::vec3(0), kObjectScale}), "object")),
          m_sphere(UploadMesh(device, Sphere(1, 64, 32), "sphere")),
          m_ground(UploadMesh(device, Ground(24, 1), "floor")),
          m_mirrored(device, SceneShaders(EffectShader("planar_reflected.ps"))),
          m_direct(device, MattShaders()),
          m_floor(device, SceneShaders(EffectShader(fmt::format("planar_floor.ps.WORDS={}", WordsOf(m_precision))))),
          m_reflected(device, {inputs.extent, Format::RGBA32F, "reflected"}),
          m_picture(device, {inputs.extent, Format::RGBA32F, "picture"}),
          m_depth(device, {inputs.extent, Format::Depth32F, "depth"}),
          m_table(device, {.extent = inputs.extent, .precision = m_precision, .codes = m_codes}) {}

private:
    const Image& Draw(CommandList& commands, const Frame& frame) override {
        const auto turn = static_cast<float>(frame.timeSeconds);
        const SceneObject objects[] = {
            {.mesh = &m_object, .scale = kObjectScale, .turnRadians = 0.5f * turn, .albedo = {0.80f, 0.55f, 0.40f}},
            {.mesh = &m_sphere, .offsetWorld = {-1.45f, 0.4f, -0.3f}, .scale = 0.4f, .albedo = {0.25f, 0.5f, 0.8f}},
            {.mesh = &m_sphere,
             .offsetWorld = {1.45f, 1.0f + 0.35f * std::sin(turn), -0.5f},
             .scale = 0.45f,
             .albedo = {0.75f, 0.25f, 0.2f}}};
        const glm::mat4 clip = ClipFromWorld(m_camera, m_picture.Extent());
        const glm::mat4 mirror = glm::scale(glm::mat4(1), {1, -1, 1});

        DrawObjects(commands,
                    {.name = "reflected",
                     .pipeline = m_mirrored,
                     .writes = {&m_reflected},
                     .depth = &m_depth,
                     .clearColor = glm::vec4(kSky, kFarWorld),
                     .clearsDepth = true},
                    objects, clip * mirror, m_camera.eyeWorld);
        AddStage("reflected", m_reflected);
        const TexelWords table = m_table.Record(commands, m_reflected);
        AddTableStages("table", table);

        DrawObjects(commands,
                    {.name = "direct",
                     .pipeline = m_direct,
                     .writes = {&m_picture},
                     .depth = &m_depth,
                     .clearColor = glm::vec4(kSky, 1),
                     .clearsDepth = true},
                    objects, clip, m_camera.eyeWorld);
        const SceneObject floor{.mesh = &m_ground, .albedo = {0.55f, 0.52f, 0.48f}, .checkWorld = 0.75f};
        DrawObjects(commands,
                    {.name = "floor",
                     .pipeline = m_floor,
                     .reads = TableReads(table, {{"reflected", &m_reflected}}),
                     .writes = {&m_picture},
                     .depth = &m_depth},
                    std::span(&floor, 1), clip, m_camera.eyeWorld,
                    [&](const SceneConstants& scene, const SceneObject& object) {
                        return PlanarFloorConstants{.scene = scene,
                                                    .checkWorld = object.checkWorld,
                                                    .coneTexels = frame.values["roughness"] * m_coneTexels,
                                                    .codeScale = m_codes.scale,
                                                    .mirrorShare = frame.values["mirror"]};
                    });
        return m_picture;
    }

    Camera m_camera{
        .eyeWorld = {0, 1.5f, 4.6f}, .targetWorld = {0, 0.35f, 0}, .verticalAngleRadians = 0.75f, .farDepth = 60};
    float m_coneTexels;  // width of a cone that is as wide as the ray is long
    SATCodes m_codes;
    SATPrecision m_precision;
    Mesh m_object, m_sphere, m_ground;
    Pipeline m_mirrored, m_direct, m_floor;
    Image m_reflected, m_picture, m_depth;
    ExactTable m_table;
};

}  // namespace

EffectInfo PlanarReflectionInfo() {
    return {.name = "planar-reflection",
            .what = "Objects on a glossy floor; the higher they are, the blurrier their reflections",
            .paper = "Hensley 2005, sect. 5.2, Fig. 1",
            .lookFor = "the reflection is sharp where an object touches the floor and dissolves farther away",
            .parameters = {Parameter::Number("roughness", "Width of a ray's cone, divided by its length",
                                             {.maximum = kLargestRoughness, .initial = 0.12f}),
                           Parameter::Number("mirror", "Share of the light that the floor reflects straight on",
                                             {.initial = 0.35f})},
            .takesMesh = true,
            .make = MakeEffect<PlanarReflection>};
}

}  // namespace boxcar
