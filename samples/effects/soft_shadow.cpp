// Shadows of a lamp that has a size: sharp where they begin, the softer the farther from what casts them.
//
//   lamp's view  ->  depth  ->  codes and their squares  ->  table
//   camera's view  ->  positions, normals, colors  ->  mean depth in the way  ->  penumbra's width  ->  share of
//   light
//
// Green 2003 (blur by the distance from the occluder); beyond the papers: variance shadow maps on tables
#include <cmath>

#include "hlsl/constants/effect_constants.h"
#include "runtime/passes/quad_shaders.h"
#include "runtime/passes/summed_area_table.h"
#include "samples/effects/effect_shader.h"
#include "samples/effects/effects.h"
#include "samples/scenes/scene.h"
#include "samples/scenes/shapes.h"

namespace boxcar {
namespace {

constexpr float kLampDistance = 7;
constexpr float kLampReach = 3.5f;  // things cast shadows up to this far before and behind the middle of the scene
constexpr glm::vec3 kObjectOffset{-0.2f, 0, 0.1f};
constexpr float kObjectScale = 1.3f;
constexpr float kLampAngleRadians = 0.9f;

Extent2D MapExtent(const ParameterValues& values) {
    const auto side = static_cast<uint32_t>(values.Whole("map"));
    return {side, side};
}

// A thin post, one unit high.
MeshData Post() {
    MeshData mesh = Sphere(1, 32, 32);
    const glm::vec3 radii(0.045f, 0.5f, 0.045f);
    for (Vertex& vertex : mesh.vertices) {
        vertex.position = vertex.position * radii + glm::vec3(0, 0.5f, 0);
        vertex.normal = glm::normalize(vertex.normal / radii);
    }
    return mesh;
}

class SoftShadow : public Effect {
public:
    SoftShadow(Device& device, const EffectInputs& inputs, const ParameterValues& values)
        : m_object(UploadMesh(
              device, StandingMesh(inputs.mesh, {m_camera, inputs.extent, kObjectOffset, kObjectScale}), "object")),
          m_sphere(UploadMesh(device, Sphere(1, 64, 32), "sphere")),
          m_post(UploadMesh(device, Post(), "post")),
          m_ground(UploadMesh(device, Ground(40, 1), "ground")),
          m_drawDepth(device, SceneShaders(EffectShader("shadow_depth.ps"))),
          m_drawMoments(device, QuadShaders(EffectShader("shadow_moments.ps"), WordFormats(SATPrecision::U64))),
          m_drawSurfaces(device, SceneShaders(EffectShader("shadow_surface.ps"), std::vector(3, Format::RGBA32F))),
          m_variance(device, QuadShaders(EffectShader("soft_shadow.ps.HARD=0"))),
          m_hard(device, QuadShaders(EffectShader("soft_shadow.ps.HARD=1"))),
          m_map(device, {MapExtent(values), Format::RGBA32F, "depth from the lamp"}),
          m_mapDepth(device, {MapExtent(values), Format::Depth32F, "lamp's depth"}),
          m_moments(device, SATPrecision::U64, MapExtent(values), "moments"),
          m_position(device, {inputs.extent, Format::RGBA32F, "positions"}),
          m_normal(device, {inputs.extent, Format::RGBA32F, "normals"}),
          m_albedo(device, {inputs.extent, Format::RGBA32F, "colors"}),
          m_depth(device, {inputs.extent, Format::Depth32F, "depth"}),
          m_picture(device, {inputs.extent, Format::RGBA32F, "picture"}),
          m_table(device, {.extent = MapExtent(values), .precision = SATPrecision::U64}) {}

private:
    const Image& Draw(CommandList& commands, const Frame& frame) override {
        const auto time = static_cast<float>(frame.timeSeconds);
        const float elevation = glm::radians(frame.values["elevation"]), azimuth = 0.75f + 0.3f * time;
        const Camera lamp{
            .eyeWorld = kLampDistance * glm::vec3(std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                                                  std::cos(elevation) * std::cos(azimuth)),
            .upWorld = {std::sin(azimuth), 0, std::cos(azimuth)},
            .verticalAngleRadians = kLampAngleRadians,
            .nearDepth = kLampDistance - kLampReach,
            .farDepth = kLampDistance + 2 * kLampReach};
        const float reach = lamp.farDepth - lamp.nearDepth;
        const std::vector<SceneObject> objects = Objects(time);

        DrawObjects(commands,
                    {.name = "depth from the lamp",
                     .pipeline = m_drawDepth,
                     .writes = {&m_map},
                     .depth = &m_mapDepth,
                     .clearColor = glm::vec4(1),
                     .clearsDepth = true},
                    objects, ClipFromWorld(lamp, m_map.Extent()), lamp.eyeWorld,
                    [&](const SceneConstants& scene, const SceneObject&) {
                        return ShadowDepthConstants{scene, lamp.nearDepth, reach};
                    });
        AddStage("depth", m_map);
        DrawObjects(commands,
                    {.name = "surfaces",
                     .pipeline = m_drawSurfaces,
                     .writes = {&m_position, &m_normal, &m_albedo},
                     .depth = &m_depth,
                     .clearColor = glm::vec4(0),
                     .clearsDepth = true},
                    objects, ClipFromWorld(m_camera, m_picture.Extent()), m_camera.eyeWorld);
        AddStage("positions", m_position);

        const SoftShadowConstants constants{ClipFromWorld(lamp, m_map.Extent()),
                                            lamp.eyeWorld,
                                            lamp.nearDepth,
                                            reach,
                                            frame.values["light-size"],
                                            TexelsAtDepthOne(lamp, m_map.Extent()),
                                            frame.values["bleed-cut"],
                                            kSky,
                                            0};
        const bool isHard = frame.values.Choice("method") == "hard";
        Pass light{
            .name = "light",
            .pipeline = isHard ? m_hard : m_variance,
            .reads = {{"position", &m_position}, {"normal", &m_normal}, {"albedo", &m_albedo}, {"depth", &m_map}},
            .writes = {&m_picture},
            .constants = ConstantBytes(constants)};
        if (!isHard) {
            commands.Draw({.name = "moments",
                           .pipeline = m_drawMoments,
                           .reads = {{"depth", &m_map}},
                           .writes = m_moments.Writes()});
            const TexelWords table = m_table.Record(commands, m_moments);
            AddTableStages("table", table);
            light.reads = TableReads(table, light.reads);
        }
        commands.Draw(light);
        return m_picture;
    }

    std::vector<SceneObject> Objects(float time) const {
        return {
            {.mesh = &m_ground, .albedo = {0.66f, 0.62f, 0.56f}, .checkWorld = 0.75f},
            {.mesh = &m_object,
             .offsetWorld = kObjectOffset,
             .scale = kObjectScale,
             .turnRadians = 0.2f * time,
             .albedo = {0.80f, 0.55f, 0.40f}},
            {.mesh = &m_post, .offsetWorld = {-1.7f, 0, 0.3f}, .scale = 1.7f, .albedo = {0.75f, 0.72f, 0.68f}},
            {.mesh = &m_sphere, .offsetWorld = {1.3f, 0.25f, 0.9f}, .scale = 0.25f, .albedo = {0.25f, 0.5f, 0.8f}},
            {.mesh = &m_sphere, .offsetWorld = {1.9f, 0.85f, 0}, .scale = 0.25f, .albedo = {0.75f, 0.25f, 0.2f}},
            {.mesh = &m_sphere, .offsetWorld = {1.0f, 1.6f, -1.2f}, .scale = 0.25f, .albedo = {0.3f, 0.6f, 0.35f}}};
    }

    Camera m_camera{
        .eyeWorld = {0, 2.6f, 5.2f}, .targetWorld = {0, 0.35f, -0.2f}, .verticalAngleRadians = 0.7f, .farDepth = 60};
    Mesh m_object, m_sphere, m_post, m_ground;
    Pipeline m_drawDepth, m_drawMoments, m_drawSurfaces, m_variance, m_hard;
    Image m_map, m_mapDepth;
    WordImages m_moments;
    Image m_position, m_normal, m_albedo, m_depth, m_picture;
    SummedAreaTable m_table;
};

}  // namespace

EffectInfo SoftShadowInfo() {
    return {.name = "soft-shadow",
            .what = "Shadows of an area light, blurred by their distance from what casts them",
            .paper = "Green 2003, soft shadows; beyond the papers: variance shadow maps on tables",
            .lookFor = "a shadow is sharp where it leaves the object that casts it and dissolves farther away",
            .parameters = {Parameter::Number("light-size", "Width of the lamp, which is 7 units away",
                                             {.maximum = 1.5f, .initial = 0.5f, .unit = "units"}),
                           Parameter::Number("bleed-cut",
                                             "Shares of light below this become dark, which hides light that leaks",
                                             {.maximum = 0.9f, .initial = 0.2f}),
                           Parameter::Whole("map", "Side of the lamp's depth map",
                                            {.minimum = 64, .maximum = 2048, .initial = 512, .unit = "texels"})
                               .Fixed(),
                           Parameter::Choice("method", "The variance of the map over boxes, or a single texel of it",
                                             {"variance", "hard"}, "variance"),
                           Parameter::Number("elevation", "Angle of the lamp above the ground",
                                             {.minimum = 20, .maximum = 85, .initial = 50, .unit = "degrees"})},
            .takesMesh = true,
            .make = MakeEffect<SoftShadow>};
}

}  // namespace boxcar
