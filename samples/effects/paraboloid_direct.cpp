// A scene drawn straight on the faces of a dual paraboloid, beside the same by way of a cube map.
//
//   scene  ->  dp_scene.vs  ->  front, back     |     scene  ->  cube map  ->  dual paraboloid  ->  front, back
//
// Scheuermann 2005 (direct rendering of the faces); Hensley 2005, sect. 5.1.1
#include "hlsl/constants/effect_constants.h"
#include "runtime/passes/dual_paraboloid.h"
#include "runtime/passes/quad_shaders.h"
#include "samples/effects/effect_shader.h"
#include "samples/effects/effects.h"
#include "samples/scenes/shapes.h"
#include "samples/scenes/surroundings.h"

namespace boxcar {
namespace {

constexpr float kFarWorld = 10;

PipelineDesc DirectShaders() {
    return {.vertex = EffectShader("dp_scene.vs"), .pixel = EffectShader("dp_scene.ps"), .testsDepth = true};
}

class ParaboloidDirect : public Effect {
public:
    ParaboloidDirect(Device& device, const EffectInputs& inputs, const ParameterValues& values)
        : m_side(static_cast<uint32_t>(values.Whole("face"))),
          m_surroundings(device, {{2, 1}, {glm::vec4(0), glm::vec4(0)}}, m_side),
          m_paraboloid(device, m_side),
          m_direct(device, DirectShaders()),
          m_pair(device, QuadShaders(EffectShader("dp_pair.ps"))),
          m_room(
              UploadMesh(device, Subdivided(Room(4), static_cast<uint32_t>(values.Whole("subdivisions"))), "room")),
          m_sphere(UploadMesh(device, Sphere(1, 48, 24), "sphere")),
          m_depth(device, {{m_side, m_side}, Format::Depth32F, "depth"}),
          m_picture(device, {inputs.extent, Format::RGBA32F, "picture"}) {
        for (const char* name : {"front-direct", "back-direct"})
            m_faces.emplace_back(device, ImageDesc{{m_side, m_side}, Format::RGBA32F, name});
    }

private:
    const Image& Draw(CommandList& commands, const Frame& frame) override {
        const auto time = static_cast<float>(frame.timeSeconds);
        const std::vector<SceneObject> objects = {
            {.mesh = &m_room, .turnRadians = 0.4f + 0.2f * time, .albedo = {0.8f, 0.78f, 0.7f}, .checkWorld = 0.5f},
            {.mesh = &m_sphere, .offsetWorld = {0.5f, -0.5f, -1.1f}, .scale = 0.35f, .albedo = {0.8f, 0.2f, 0.15f}},
            {.mesh = &m_sphere, .offsetWorld = {-0.6f, 0.3f, 1.0f}, .scale = 0.3f, .albedo = {0.2f, 0.35f, 0.8f}}};
        const DualParaboloidFaces viaCube = m_paraboloid.Record(commands, m_surroundings.Record(commands, objects));
        AddStage("front-cube", *viaCube.front);
        AddStage("back-cube", *viaCube.back);
        for (size_t face = 0; face < 2; face++) {
            DrawObjects(commands,
                        {.name = "direct",
                         .pipeline = m_direct,
                         .writes = {&m_faces[face]},
                         .depth = &m_depth,
                         .clearColor = glm::vec4(0),
                         .clearsDepth = true},
                        objects, glm::mat4(1), glm::vec3(0),
                        [&](const SceneConstants& scene, const SceneObject& object) {
                            return DPSceneConstants{scene, object.checkWorld, static_cast<int>(face), kFarWorld};
                        });
            AddStage(m_faces[face].Desc().name, m_faces[face]);
        }
        const bool isFront = frame.values.Choice("show") == "front";
        commands.Draw(
            {.name = "pair",
             .pipeline = m_pair,
             .reads = {{"left", &m_faces[isFront ? 0 : 1]}, {"right", isFront ? viaCube.front : viaCube.back}},
             .writes = {&m_picture}});
        return m_picture;
    }

    uint32_t m_side;
    Surroundings m_surroundings;
    DualParaboloid m_paraboloid;
    Pipeline m_direct, m_pair;
    Mesh m_room, m_sphere;
    std::vector<Image> m_faces;
    Image m_depth, m_picture;
};

}  // namespace

EffectInfo ParaboloidDirectInfo() {
    return {.name = "paraboloid-direct",
            .what = "A scene drawn straight onto a paraboloid (left) and by way of a cube map (right)",
            .paper = "Scheuermann 2005; Hensley 2005, sect. 5.1.1",
            .lookFor =
                "straight rasterization bends the walls of large triangles and tears them; small ones come out right",
            .parameters = {Parameter::Whole("subdivisions",
                                            "How many times each triangle of the walls is split into four",
                                            {.maximum = 6, .initial = 1})
                               .Fixed(),
                           Parameter::Choice("show", "Which face is shown", {"front", "back"}, "front"),
                           Parameter::Whole("face", "Side of a face",
                                            {.minimum = 16, .maximum = 1024, .initial = 512, .unit = "texels"})
                               .Fixed()},
            .make = MakeEffect<ParaboloidDirect>};
}

}  // namespace boxcar
