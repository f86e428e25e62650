// Etched glass: objects through which the scene behind them is seen blurred, the more the thicker they are.
//
//   scene  ->  [far object: table of the picture so far, its thickness  ->  object]  ->  [next nearer ..]  -> picture
//
// Hensley 2005, sect. 5.3 (Fig. 8)
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "hlsl/constants/effect_constants.h"
#include "runtime/passes/exact_table.h"
#include "samples/effects/effect_shader.h"
#include "samples/effects/effects.h"
#include "samples/scenes/scene.h"
#include "samples/scenes/shapes.h"

namespace boxcar {
namespace {

constexpr SATCodes kCodes{65535 / 2.0f, 65535, false};  // light up to 2
constexpr float kObjectScale = 1.25f;
constexpr float kLargestEtching = 1, kThickestOverDistance = 0.6f;

PipelineDesc FarSides() {
    PipelineDesc desc = SceneShaders(EffectShader("glass_back.ps"));
    desc.cull = Cull::Front;
    return desc;
}

class Translucency : public Effect {
public:
    Translucency(Device& device, const EffectInputs& inputs, const ParameterValues&)
        : m_focalTexels(TexelsAtDepthOne(m_camera, inputs.extent)),
          m_precision(SATExactPrecision(glm::vec2(WidestTexels()), 1, false, kCodes)),
          m_opaque(device, MattShaders()),
          m_farSides(device, FarSides()),
          m_glass(device, SceneShaders(EffectShader(fmt::format("glass.ps.WORDS={}", WordsOf(m_precision))))),
          m_object(UploadMesh(
              device, StandingMesh(inputs.mesh, {m_camera, inputs.extent, glm::vec3(0), kObjectScale}), "object")),
          m_sphere(UploadMesh(device, Sphere(1, 96, 48), "sphere")),
          m_ground(UploadMesh(device, Ground(24, 1), "floor")),
          m_picture(device, {inputs.extent, Format::RGBA32F, "picture"}),
          m_back(device, {inputs.extent, Format::RGBA32F, "far side"}),
          m_depth(device, {inputs.extent, Format::Depth32F, "depth"}),
          m_backDepth(device, {inputs.extent, Format::Depth32F, "far side's depth"}),
          m_table(device, {.extent = inputs.extent, .precision = m_precision, .codes = kCodes}) {}

private:
    const Image& Draw(CommandList& commands, const Frame& frame) override {
        const glm::mat4 clip = ClipFromWorld(m_camera, m_picture.Extent());
        const auto time = static_cast<float>(frame.timeSeconds);
        DrawObjects(commands,
                    {.name = "scene",
                     .pipeline = m_opaque,
                     .writes = {&m_picture},
                     .depth = &m_depth,
                     .clearColor = glm::vec4(kSky, 1),
                     .clearsDepth = true},
                    OpaqueObjects(), clip, m_camera.eyeWorld);
        std::vector<SceneObject> glass = GlassObjects(time);
        std::ranges::sort(glass, std::greater(), [&](const SceneObject& object) {
            return glm::distance(object.offsetWorld, m_camera.eyeWorld);
        });
        TexelWords table = m_picture;  // of the object drawn last
        for (const SceneObject& object : glass) {
            DrawObjects(commands,
                        {.name = "far side",
                         .pipeline = m_farSides,
                         .writes = {&m_back},
                         .depth = &m_backDepth,
                         .clearColor = glm::vec4(0),
                         .clearsDepth = true},
                        std::span(&object, 1), clip, m_camera.eyeWorld,
                        [](const SceneConstants& scene, const SceneObject&) { return scene; });
            table = m_table.Record(commands, m_picture);
            DrawObjects(commands,
                        {.name = "glass",
                         .pipeline = m_glass,
                         .reads = TableReads(table, {{"back", &m_back}}),
                         .writes = {&m_picture},
                         .depth = &m_depth},
                        std::span(&object, 1), clip, m_camera.eyeWorld,
                        [&](const SceneConstants& scene, const SceneObject&) {
                            return GlassConstants{.scene = scene,
                                                  .blurTexels = frame.values["etching"] * m_focalTexels,
                                                  .bendTexels = frame.values["bending"] * m_focalTexels,
                                                  .codeScale = kCodes.scale};
                        });
        }
        AddTableStages("table", table);
        AddStage("far-side", m_back);
        return m_picture;
    }

    std::vector<SceneObject> OpaqueObjects() const {
        std::vector<SceneObject> objects = {{.mesh = &m_ground, .albedo = {0.8f, 0.78f, 0.72f}, .checkWorld = 0.4f}};
        constexpr glm::vec3 kColors[] = {
            {0.85f, 0.2f, 0.15f}, {0.9f, 0.6f, 0.1f}, {0.2f, 0.6f, 0.25f}, {0.15f, 0.3f, 0.8f}};
        for (int i = 0; i < 7; i++)
            objects.push_back({.mesh = &m_sphere,
                               .offsetWorld = {-2.4f + 0.8f * static_cast<float>(i),
                                               0.3f + 0.35f * static_cast<float>(i % 3), -1.6f},
                               .scale = 0.3f,
                               .albedo = kColors[i % 4]});
        return objects;
    }

    std::vector<SceneObject> GlassObjects(float time) const {
        SceneObject object{
            .mesh = &m_object, .scale = kObjectScale, .turnRadians = 0.5f * time, .albedo = {0.75f, 0.95f, 0.85f}};
        SceneObject ball = object, little = object;
        ball.mesh = little.mesh = &m_sphere;
        ball.offsetWorld = {-1.15f + 0.3f * std::sin(time), 0.5f, 0.3f};
        ball.scale = 0.5f;
        ball.albedo = {0.95f, 0.85f, 0.75f};
        little.offsetWorld = {0.5f, 0.32f, 1.1f};
        little.scale = 0.32f;
        little.albedo = {0.8f, 0.85f, 0.98f};
        return {object, ball, little};
    }

    // Of the blur, through the thickest glass in front of the camera at the largest etching.
    float WidestTexels() const { return kLargestEtching * m_focalTexels * kThickestOverDistance; }

    Camera m_camera{
        .eyeWorld = {0, 1.25f, 4.4f}, .targetWorld = {0, 0.62f, 0}, .verticalAngleRadians = 0.62f, .farDepth = 60};
    float m_focalTexels;
    SATPrecision m_precision;
    Pipeline m_opaque, m_farSides, m_glass;
    Mesh m_object, m_sphere, m_ground;
    Image m_picture, m_back, m_depth, m_backDepth;
    ExactTable m_table;
};

}  // namespace

EffectInfo TranslucencyInfo() {
    return {.name = "translucency",
            .what = "Objects of etched glass, one in front of another",
            .paper = "Hensley 2005, sect. 5.3, Fig. 8",
            .lookFor =
                "what is behind looks sharp through thin glass, blurred through thick glass, and blurrier still "
                "through two"
                " objects",
            .parameters = {Parameter::Number("etching", "Width of the blur, divided by the thickness of the glass",
                                             {.maximum = kLargestEtching, .initial = 0.12f}),
                           Parameter::Number("bending", "How far the glass displaces what is behind it",
                                             {.initial = 0.06f})},
            .takesMesh = true,
            .make = MakeEffect<Translucency>};
}

}  // namespace boxcar
