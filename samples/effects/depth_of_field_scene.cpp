// Depth of field on a scene, in the ways there are.
//
//   scene  ->  nearest: light, disparity  ->  the picture, by the method
//
//   layered       in layers of depth, with what is hidden behind the nearest surface (beyond the papers)
//   single        one table of the picture
//   mips, noise   a mip map of the picture
//   accumulation  256 views from all over the lens: what the others are measured by
//   sharp         one view from its middle
//
// Hensley 2005, sect. 5.4 (Fig. 9); Demers 2004 (noise); Green 2003; Haeberli and Akeley 1990 (accumulation)
#include <algorithm>
#include <cmath>
#include <numbers>

#include "hlsl/constants/effect_constants.h"
#include "runtime/passes/layered_depth_of_field.h"
#include "runtime/passes/mip_chain.h"
#include "runtime/passes/quad_shaders.h"
#include "runtime/transfer.h"
#include "samples/effects/effect_shader.h"
#include "samples/effects/effects.h"
#include "samples/scenes/scene.h"
#include "samples/scenes/shapes.h"

namespace boxcar {
namespace {

constexpr uint32_t kViews = 256;
constexpr float kNoiseLevels = 0.6f;
constexpr glm::vec3 kHaze{0.50f, 0.60f, 0.74f};
constexpr float kNearestWorld = 1.8f;  // depth of the nearest thing in the scene

// The scene as one mesh, that hundreds of views draw at a command each: uv.x is the number of its part's material.
class Scene {
public:
    Scene(Device& device, const MeshData& object, const Camera& camera, Extent2D extent)
        : m_mesh(UploadMesh(device, Build(object, camera, extent), "scene")),
          m_palette(device, {{static_cast<uint32_t>(m_materials.size()), 1}, Format::RGBA32F, "palette"}) {
        WriteTexels(device, m_palette, std::as_bytes(std::span(m_materials)));
    }

    const Mesh& Triangles() const { return m_mesh; }
    const Image& Palette() const { return m_palette; }

private:
    MeshData Build(const MeshData& object, const Camera& camera, Extent2D extent) {
        constexpr glm::vec3 kOffset{0.25f, 0, 0};
        constexpr float kScale = 1.35f;
        const MeshData ball = Sphere(1, 48, 24), farBall = Sphere(1, 32, 16), lamp = Sphere(1, 12, 6);
        Add(StandingMesh(object, {camera, extent, kOffset, kScale}), kOffset, kScale, {0.90f, 0.36f, 0.12f, 0});
        Add(Ground(160, 1), {0, 0, 0}, 1, {0.72f, 0.70f, 0.66f, 0.8f});
        Add(ball, {-1.0f, 0.42f, 2.75f}, 0.42f, {0.16f, 0.36f, 0.75f, 0});
        Add(ball, {1.72f, 0.2f, 2.1f}, 0.2f, {0.75f, 0.70f, 0.18f, 0});
        const glm::vec3 row[] = {{0.62f, 0.12f, 0.12f}, {0.14f, 0.50f, 0.22f}, {0.80f, 0.76f, 0.70f}};
        for (int i = 0; i < 9; i++) {
            const float away = 1.6f * std::pow(1.42f, static_cast<float>(i));
            Add(farBall, {-0.7f - 0.42f * away, 0.6f, 0.4f - away}, 0.6f, glm::vec4(row[i % 3], 0));
        }
        for (int i = 0; i < 7; i++) {
            const float x = 2.1f + 1.5f * static_cast<float>(i);
            Add(lamp, {x, 1.5f + 0.5f * static_cast<float>(i % 3), -9}, 0.06f, {16, 13, 9, 0});
        }
        for (int i = 0; i < 4; i++) {
            const auto x = static_cast<float>(i);
            Add(ball, {1.3f + 1.7f * x, 0.9f, -3.5f - 2.5f * x}, 0.9f, {0.08f, 0.10f + 0.1f * x, 0.30f, 0});
        }
        return m_data;
    }

    void Add(const MeshData& part, glm::vec3 offsetWorld, float scale, glm::vec4 material) {
        const auto first = static_cast<uint32_t>(m_data.vertices.size());
        for (const Vertex& vertex : part.vertices)
            m_data.vertices.push_back(
                {offsetWorld + scale * vertex.position, vertex.normal, {static_cast<float>(m_materials.size()), 0}});
        for (const uint32_t index : part.indices)
            m_data.indices.push_back(first + index);
        m_materials.push_back(material);
    }

    MeshData m_data;
    std::vector<glm::vec4> m_materials;  // albedo, side of the checks
    Mesh m_mesh;
    Image m_palette;
};

PipelineDesc LensShaders(int hidden) {
    PipelineDesc desc = SceneShaders(EffectShader(fmt::format("lens_scene.ps.HIDDEN={}", hidden)));
    desc.cull = Cull::Back;  // a thing's own back is not what it hides
    return desc;
}

// One point of `kViews` that fill a disc of radius 1 evenly.
glm::vec2 LensPoint(uint32_t view) {
    const float radius = std::sqrt((static_cast<float>(view) + 0.5f) / kViews);
    const float angle = static_cast<float>(view) * std::numbers::pi_v<float> * (3 - std::sqrt(5.0f));
    return radius * glm::vec2(std::cos(angle), std::sin(angle));
}

// What the camera sees from a point of its lens, sheared so that what is in focus stays where it is.
glm::mat4 ClipFromLens(const Camera& camera, Extent2D extent, glm::vec2 pointWorld, float focusWorld) {
    glm::mat4 shear(1);
    shear[2] = {-pointWorld / focusWorld, 1, 0};  // the view looks along -z
    shear[3] = {-pointWorld, 0, 1};
    return ClipFromView(camera, extent) * shear * ViewFromWorld(camera);
}

// The largest circle of confusion; larger ones become this.
float LargestTexels(Extent2D extent) {
    return std::max(127.0f, 0.3f * static_cast<float>(extent.heightTexels));
}

// One table of the whole picture.
class SingleTable {
public:
    SingleTable(Device& device, Extent2D extent, uint32_t boxes)
        : m_precision(SATExactPrecision(glm::vec2(LargestTexels(extent)), 1, false, LensCodes(16))),
          m_widths(device, extent, LargestTexels(extent)),
          m_table(device, {.extent = extent, .precision = m_precision, .codes = LensCodes(16)}),
          m_filter(device, {.extent = extent, .precision = m_precision, .boxes = boxes, .codes = LensCodes(16)}) {}

    const Image& Record(CommandList& commands, const Image& nearest, const Lens& lens) {
        const SATWidths widths = m_widths.Record(commands, nearest, lens);
        return m_filter.Record(commands, m_table.Record(commands, nearest), widths);
    }

private:
    SATPrecision m_precision;
    LensWidths m_widths;
    ExactTable m_table;
    SATFilter m_filter;
};

// A mip map of the picture, and a look at one place and level of it.
class Mips {
public:
    Mips(Device& device, Extent2D extent)
        : m_look(device, QuadShaders(EffectShader("lens_mips.ps"))),
          m_chain(device, extent),
          m_result(device, {extent, Format::RGBA32F, "picture"}) {}

    const Image& Record(CommandList& commands, const Image& nearest, const Lens& lens, float noiseLevels) {
        const Image& mips = m_chain.Record(commands, nearest);
        const LensMipsConstants constants{lens.focusDisparity, lens.apertureTexels, noiseLevels};
        commands.Draw({.name = "mips",
                       .pipeline = m_look,
                       .reads = {{"picture", &nearest}, {"mips", &mips}},
                       .writes = {&m_result},
                       .constants = ConstantBytes(constants)});
        return m_result;
    }

private:
    Pipeline m_look;
    MipChain m_chain;
    Image m_result;
};

// The sum of many views.
class Accumulation {
public:
    Accumulation(Device& device, Extent2D extent)
        : m_add(device, QuadShaders(EffectShader("lens_views.ps"))), m_sum(device, {extent, Format::RGBA32F, "sum"}) {
        for (uint32_t i = 0; i < kAtOnce; i++)
            m_views.emplace_back(device, ImageDesc{extent, Format::RGBA32F, "view"});
    }

    // draw(target, view) records view number `view` of `kViews`.
    const Image& Record(CommandList& commands, const auto& draw) {
        commands.Clear(m_sum.Front(), {0, 0, 0, 0});
        for (uint32_t first = 0; first < kViews; first += kAtOnce) {
            for (uint32_t i = 0; i < kAtOnce; i++)
                draw(m_views[i], first + i);
            const LensViewsConstants constants{1.0f / kViews};
            Pass pass{.name = "add views",
                      .pipeline = m_add,
                      .reads = {{"before", &m_sum.Front()}},
                      .writes = {&m_sum.Back()},
                      .constants = ConstantBytes(constants)};
            constexpr const char* kNames[] = {"view0", "view1", "view2", "view3", "view4", "view5", "view6", "view7"};
            for (uint32_t i = 0; i < kAtOnce; i++)
                pass.reads.push_back({kNames[i], &m_views[i]});
            commands.Draw(pass);
            m_sum.Swap();
        }
        return m_sum.Front();
    }

private:
    static constexpr uint32_t kAtOnce = 8;

    Pipeline m_add;
    PingPong m_sum;
    std::vector<Image> m_views;
};

class DepthOfFieldScene : public Effect {
public:
    DepthOfFieldScene(Device& device, const EffectInputs& inputs, const ParameterValues& values)
        : m_scene(device, inputs.mesh, m_camera, inputs.extent),
          m_drawNearest(device, LensShaders(0)),
          m_nearest(device, {inputs.extent, Format::RGBA32F, "nearest"}),
          m_depth(device, {inputs.extent, Format::Depth32F, "depth"}) {
        const std::string_view method = values.Choice("method");
        const auto boxes = static_cast<uint32_t>(values.Whole("boxes"));
        if (method == "layered") {
            m_drawHidden.emplace(device, LensShaders(1));
            m_hidden.emplace(device, ImageDesc{inputs.extent, Format::RGBA32F, "hidden"});
            m_layered.emplace(
                device, LayeredDepthOfFieldDesc{
                            .extent = inputs.extent, .boxes = boxes, .largestTexels = LargestTexels(inputs.extent)});
        }
        if (method == "single") m_single.emplace(device, inputs.extent, boxes);
        if (method == "mips" || method == "noise") m_mips.emplace(device, inputs.extent);
        if (method == "accumulation") m_accumulation.emplace(device, inputs.extent);
    }

private:
    const Image& Draw(CommandList& commands, const Frame& frame) override {
        const Extent2D extent = m_nearest.Extent();
        const float focusWorld = frame.values["focus"], lensWorld = frame.values["lens"];
        Camera camera = m_camera;
        camera.eyeWorld.x = 0.35f * std::sin(static_cast<float>(frame.timeSeconds));

        const auto draw = [&](const Pipeline& pipeline, const Image& target, glm::vec2 pointWorld) {
            const SceneObject object{.mesh = &m_scene.Triangles()};
            Pass pass{.name = target.Desc().name,
                      .pipeline = pipeline,
                      .reads = {{"palette", &m_scene.Palette()}},
                      .writes = {&target},
                      .depth = &m_depth,
                      .clearColor = glm::vec4(kHaze, 0),  // infinitely far
                      .clearsDepth = true};
            if (m_hidden && &target == &*m_hidden) pass.reads.push_back({"nearest", &m_nearest});
            DrawObjects(commands, pass, std::span(&object, 1), ClipFromLens(camera, extent, pointWorld, focusWorld),
                        camera.eyeWorld, [&](const SceneConstants& scene, const SceneObject&) {
                            return LensSceneConstants{scene, frame.values["object"]};
                        });
        };
        if (m_accumulation)
            return m_accumulation->Record(commands, [&](const Image& target, uint32_t view) {
                draw(m_drawNearest, target, 0.5f * lensWorld * LensPoint(view));
            });

        draw(m_drawNearest, m_nearest, {0, 0});
        AddStage("nearest", m_nearest);
        // A lens spreads a point at depth z over lensWorld * |z - focus| / z of the plane in focus, where a texel is
        // focus / (texels across a unit at depth 1) wide.
        const Lens lens{1 / focusWorld, lensWorld * TexelsAtDepthOne(camera, extent)};
        if (m_layered) {
            draw(*m_drawHidden, *m_hidden, {0, 0});
            AddStage("hidden", *m_hidden);
            const Image& picture = m_layered->Record(commands, m_nearest, &*m_hidden, lens, 1 / kNearestWorld,
                                                     frame.values.Whole("layers"));
            AddStage("farthest-layer", m_layered->Layer());
            return picture;
        }
        if (m_single) return m_single->Record(commands, m_nearest, lens);
        if (m_mips)
            return m_mips->Record(commands, m_nearest, lens,
                                  frame.values.Choice("method") == "noise" ? kNoiseLevels : 0.0f);
        return m_nearest;
    }

    Camera m_camera{.eyeWorld = {0, 1.25f, 5},
                    .targetWorld = {0, 0.72f, 0},
                    .verticalAngleRadians = 0.62f,
                    .nearDepth = 1,
                    .farDepth = 120};
    Scene m_scene;
    Pipeline m_drawNearest;
    Image m_nearest, m_depth;
    std::optional<Pipeline> m_drawHidden;
    std::optional<Image> m_hidden;
    // One of these, or none.
    std::optional<LayeredDepthOfField> m_layered;
    std::optional<SingleTable> m_single;
    std::optional<Mips> m_mips;
    std::optional<Accumulation> m_accumulation;
};

}  // namespace

EffectInfo DepthOfFieldInfo() {
    return {
        .name = "depth-of-field",
        .what = "What lies in front of and behind the focus of a lens, blurred by its distance from it",
        .paper = "Hensley 2005, sect. 5.4, Fig. 9; layers: beyond the papers",
        .lookFor =
            "layered: the sharp object keeps its light to itself, and what is near has soft edges; single: "
            "the sharp object glows into the background",
        .parameters = {Parameter::Choice("method", "How the picture is made",
                                         {"layered", "single", "mips", "noise", "accumulation", "sharp"}, "layered")
                           .Fixed(),
                       Parameter::Number("focus", "Depth at which things are sharp",
                                         {.minimum = 1.5f, .maximum = 40, .initial = 5, .unit = "world units"}),
                       Parameter::Number("lens", "Diameter of the lens",
                                         {.maximum = 2, .initial = 0.2f, .unit = "world units"}),
                       Parameter::Number("object", "Brightness of the object in the middle",
                                         {.maximum = 2, .initial = 1}),
                       Parameter::Whole("layers", "Layers of depth on either side of the focus",
                                        {.minimum = 1, .maximum = 16, .initial = 7}),
                       Parameter::Whole("boxes", "Number of boxes that stand for a circle",
                                        {.minimum = 1, .maximum = 32, .initial = 8})
                           .Fixed()},
        .takesMesh = true,
        .make = MakeEffect<DepthOfFieldScene>};
}

}  // namespace boxcar
