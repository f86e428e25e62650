// An object that reflects its surroundings, blurred by a lobe whose width may differ at every pixel.
//
//   surroundings  ->  cube map  ->  dual paraboloid  ->  tables of both faces  ->  object: cones round the
//   reflections
//
// Hensley 2005, sect. 5.1 (Figs 5, 6); Scheuermann 2005
#include <algorithm>
#include <cmath>

#include "hlsl/boxcar/dual_paraboloid_range.h"
#include "hlsl/constants/effect_constants.h"
#include "runtime/passes/dual_paraboloid.h"
#include "runtime/passes/quad_shaders.h"
#include "runtime/transfer.h"
#include "samples/effects/effect_shader.h"
#include "samples/effects/effects.h"
#include "samples/scenes/shapes.h"
#include "samples/scenes/surroundings.h"

namespace boxcar {
namespace {

constexpr float kBrightestObject = 2;
constexpr float kLargestWidth = 128;

// How an object reflects.
struct Reflection {
    const char* pixelShader;
    uint32_t order = 1;        // of the tables
    bool readsFloats = false;  // the papers' tables
};

constexpr Word<Reflection> kLobes[] = {{"box", {"glossy.ps.LOBE=BOX"}},
                                       {"stack", {"glossy.ps.LOBE=STACK"}},
                                       {"tent", {.pixelShader = "glossy.ps.LOBE=ORDER2", .order = 2}},
                                       {"parabolic", {.pixelShader = "glossy.ps.LOBE=ORDER3", .order = 3}},
                                       {"papers", {.pixelShader = "glossy_papers.ps", .readsFloats = true}}};

// Red: 1, or waves between a mirror and the full width.
Image GlossTexture(Device& device, bool isUniform) {
    const uint32_t side = isUniform ? 1 : 64;
    Image image(device, {{side, side}, Format::RGBA32F, "gloss"});
    std::vector<glm::vec4> texels;
    for (uint32_t y = 0; y < side; y++)
        for (uint32_t x = 0; x < side; x++) {
            const float wave =
                std::sin(2 * 3.14159265f * static_cast<float>(3 * x + 2 * y) / static_cast<float>(side));
            texels.emplace_back(isUniform ? 1.0f : 1 / (1 + std::exp(-8 * wave)), 0, 0, 0);
        }
    WriteTexels(device, image, std::as_bytes(std::span(texels)));
    return image;
}

// With tables of what rounding left over; orders 2 and 3.
PipelineDesc FineReflectionShaders(uint32_t order) {
    return SceneShaders(EffectShader(fmt::format("glossy.ps.LOBE=ORDER{}.FINE=1", order)));
}

// The largest box of a lobe's kernels, anywhere on the faces.
//
//   widthTexels  of the box that a lobe is as wide as, at a face's middle
uint32_t LargestBox(uint32_t order, uint32_t side, float widthTexels) {
    if (order == 1) return side;
    const float overSigma = order == 2 ? kDPTentOverSigma : kDPParabolicOverSigma;
    return static_cast<uint32_t>(
        DPWidestBox(static_cast<int>(order), static_cast<int>(side), overSigma * widthTexels / kDPBoxOverSigma));
}

// The papers' tables: floats, what is outside of the disc 0.
struct FloatTables {
    FloatTables(Device& device, uint32_t side)
        : mask(device, QuadShaders(EffectShader("dp_mask.ps"))),
          masked(device, {{side, side}, Format::RGBA32F, "masked face"}),
          front(device, {.extent = {side, side}}),
          back(device, {.extent = {side, side}}) {}

    const Image& Record(CommandList& commands, SummedAreaTable& table, const Image& face) {
        commands.Draw({.name = "mask", .pipeline = mask, .reads = {{"face", &face}}, .writes = {&masked}});
        return *table.Record(commands, masked).low;
    }

    Pipeline mask;
    Image masked;
    SummedAreaTable front, back;
};

// Round the y axis, so that whatever is seen whole from one place is so from all.
Camera CameraAt(float time) {
    const float angle = 0.3f * time + 4.1f;
    return {.eyeWorld = 2.4f * glm::vec3(std::sin(angle), 0.2f, std::cos(angle)), .verticalAngleRadians = 0.62f};
}

// What a frame shows.
struct ReflectionFrame {
    float widthTexels = 0;  // of the lobe
    glm::vec3 albedo{1};
    bool hasMovingObjects = false;
    bool hasGlossTexture = false;
};

// What the object's pixel shader reads of a frame, and what it must know of it.
struct Tables {
    std::vector<Read> reads;
    float codeScale = 0;         // what 1 is in codes; 0 for floats
    uint32_t largestTexels = 0;  // width of the widest box that they hold; 0 for floats
};

// The chain of both effects, which differ in the object's pixel shader.
class EnvironmentReflection : public Effect {
protected:
    EnvironmentReflection(Device& device, const EffectInputs& inputs, uint32_t side, const Reflection& reflection,
                          DPMapping mapping)
        : m_device(device),
          m_side(side),
          m_order(reflection.order),
          m_surroundings(device, inputs.environment, side),
          m_paraboloid(device, side, mapping),
          m_reflecting(device, SceneShaders(EffectShader(reflection.pixelShader))),
          m_matt(device, MattShaders()),
          m_object(UploadMesh(device, StandingMesh(inputs.mesh, {CameraAt(0), inputs.extent, glm::vec3(0), 1, 0.5f}),
                              "object")),
          m_sphere(UploadMesh(device, Sphere(1, 48, 24), "sphere")),
          m_uniform(GlossTexture(device, true)),
          m_waves(GlossTexture(device, false)),
          m_picture(device, {inputs.extent, Format::RGBA32F, "picture"}),
          m_depth(device, {inputs.extent, Format::Depth32F, "depth"}) {
        if (reflection.readsFloats)
            m_floats.emplace(device, side);
        else
            m_tables.emplace(device, DualParaboloidTablesDesc{
                                         .sideTexels = side,
                                         .order = m_order,
                                         .largestLight = std::max(m_surroundings.LargestLight(), kBrightestObject),
                                         .darkestLight = m_surroundings.DarkestLight()});
    }

private:
    virtual ReflectionFrame Chosen(const ParameterValues& values) const = 0;

    // The object, with the constants of its pixel shader.
    virtual void DrawReflecting(CommandList& commands, const Pass& pass, const SceneObject& object,
                                const glm::mat4& clipFromWorld, glm::vec3 eyeWorld, const ParameterValues& values,
                                const Tables& tables) const = 0;

    const Image& Draw(CommandList& commands, const Frame& frame) override {
        const ReflectionFrame chosen = Chosen(frame.values);
        const auto time = static_cast<float>(frame.timeSeconds);
        const std::vector<SceneObject> around =
            chosen.hasMovingObjects ? MovingObjects(time) : std::vector<SceneObject>();
        const DualParaboloidFaces faces = m_paraboloid.Record(commands, m_surroundings.Record(commands, around));
        AddStage("front", *faces.front);
        AddStage("back", *faces.back);

        const Camera camera = CameraAt(time);
        const glm::mat4 clip = ClipFromWorld(camera, m_picture.Extent());
        const SceneObject object{.mesh = &m_object, .albedo = chosen.albedo};
        Tables tables = ReadTables(commands, faces, chosen.widthTexels);
        Pass pass{.name = "object",
                  .pipeline = m_isFine ? *m_reflectingFine : m_reflecting,
                  .reads = std::move(tables.reads),
                  .writes = {&m_picture},
                  .depth = &m_depth,
                  .clearsDepth = true};
        pass.reads.push_back({"gloss", chosen.hasGlossTexture ? &m_waves : &m_uniform});
        m_surroundings.DrawBackdrop(commands, camera, m_picture);
        DrawReflecting(commands, pass, object, clip, camera.eyeWorld, frame.values, tables);
        DrawObjects(commands, {.name = "around", .pipeline = m_matt, .writes = {&m_picture}, .depth = &m_depth},
                    around, clip, camera.eyeWorld);
        return m_picture;
    }

    std::vector<SceneObject> MovingObjects(float time) const {
        constexpr glm::vec3 kColors[] = {
            {0.9f, 0.15f, 0.1f}, {0.15f, 0.6f, 0.2f}, {0.1f, 0.25f, 0.9f}, {0.9f, 0.6f, 0.1f}};
        std::vector<SceneObject> objects;
        for (const glm::vec3 color : kColors) {
            const float angle = 0.8f * time + 1.5708f * static_cast<float>(objects.size());
            objects.push_back(
                {.mesh = &m_sphere,
                 .offsetWorld = {1.3f * std::sin(angle), 0.35f * std::sin(2 * angle), 1.3f * std::cos(angle)},
                 .scale = 0.25f,
                 .albedo = color});
        }
        return objects;
    }

    Tables ReadTables(CommandList& commands, const DualParaboloidFaces& faces, float widthTexels) {
        if (m_floats)
            return {{{"frontTable", &m_floats->Record(commands, m_floats->front, *faces.front)},
                     {"backTable", &m_floats->Record(commands, m_floats->back, *faces.back)}}};
        const uint32_t largestTexels = LargestBox(m_order, m_side, widthTexels);
        const DualParaboloidSums sums = m_tables->Record(commands, faces, largestTexels);
        std::vector<Read> reads{{"frontLow", sums.tables.front.low},
                                {"frontHigh", sums.tables.front.high},
                                {"backLow", sums.tables.back.low},
                                {"backHigh", sums.tables.back.high}};
        AddTableStages("front-table", sums.tables.front);
        AddTableStages("back-table", sums.tables.back);
        m_isFine = sums.fine.has_value();
        if (!m_isFine) return {std::move(reads), sums.codeScale, largestTexels};
        if (!m_reflectingFine) m_reflectingFine.emplace(m_device, FineReflectionShaders(m_order));
        AddTableStages("front-table-fine", sums.fine->front);
        AddTableStages("back-table-fine", sums.fine->back);
        reads.insert(reads.end(), {{"fineFrontLow", sums.fine->front.low},
                                   {"fineFrontHigh", sums.fine->front.high},
                                   {"fineBackLow", sums.fine->back.low},
                                   {"fineBackHigh", sums.fine->back.high}});
        return {std::move(reads), sums.codeScale, largestTexels};
    }

    Device& m_device;
    uint32_t m_side, m_order;
    bool m_isFine = false;  // of this frame
    Surroundings m_surroundings;
    DualParaboloid m_paraboloid;
    std::optional<DualParaboloidTables> m_tables;
    std::optional<FloatTables> m_floats;
    Pipeline m_reflecting, m_matt;
    std::optional<Pipeline> m_reflectingFine;  // from the first frame on that needs it
    Mesh m_object, m_sphere;
    Image m_uniform, m_waves, m_picture, m_depth;
};

class GlossyEnvironment : public EnvironmentReflection {
public:
    GlossyEnvironment(Device& device, const EffectInputs& inputs, const ParameterValues& values)
        : EnvironmentReflection(device, inputs, static_cast<uint32_t>(values.Whole("face")),
                                ValueOf(kLobes, values.Choice("lobe")),
                                values.Choice("mapping") == "lookup" ? DPMapping::Lookup : DPMapping::Arithmetic) {}

private:
    ReflectionFrame Chosen(const ParameterValues& values) const override {
        return {.widthTexels = values["width"],
                .albedo = {0.95f, 0.93f, 0.88f},
                .hasMovingObjects = values.Choice("source") == "scene",
                .hasGlossTexture = values.Choice("gloss") == "texture"};
    }

    void DrawReflecting(CommandList& commands, const Pass& pass, const SceneObject& object,
                        const glm::mat4& clipFromWorld, glm::vec3 eyeWorld, const ParameterValues& values,
                        const Tables& tables) const override {
        DrawObjects(commands, pass, std::span(&object, 1), clipFromWorld, eyeWorld,
                    [&](const SceneConstants& scene, const SceneObject&) {
                        return GlossyConstants{.scene = scene,
                                               .widthTexels = values["width"],
                                               .codeScale = tables.codeScale,
                                               .largestTexels = static_cast<int>(tables.largestTexels)};
                    });
    }
};

class PhongEnvironment : public EnvironmentReflection {
public:
    PhongEnvironment(Device& device, const EffectInputs& inputs, const ParameterValues& values)
        : EnvironmentReflection(device, inputs, static_cast<uint32_t>(values.Whole("face")), {"phong.ps"},
                                DPMapping::Arithmetic) {}

private:
    ReflectionFrame Chosen(const ParameterValues&) const override { return {.albedo = {0.62f, 0.30f, 0.20f}}; }

    void DrawReflecting(CommandList& commands, const Pass& pass, const SceneObject& object,
                        const glm::mat4& clipFromWorld, glm::vec3 eyeWorld, const ParameterValues& values,
                        const Tables& tables) const override {
        DrawObjects(commands, pass, std::span(&object, 1), clipFromWorld, eyeWorld,
                    [&](const SceneConstants& scene, const SceneObject&) {
                        return PhongConstants{.scene = scene,
                                              .exponent = values["exponent"],
                                              .shine = values["shine"],
                                              .boxes = values.Whole("boxes"),
                                              .codeScale = tables.codeScale};
                    });
    }
};

Parameter FaceParameter() {
    return Parameter::Whole("face", "Side of a face of the paraboloid map",
                            {.minimum = 16, .maximum = 1024, .initial = 256, .unit = "texels"})
        .Fixed();
}

}  // namespace

EffectInfo GlossyEnvironmentInfo() {
    return {
        .name = "glossy-environment",
        .what = "An object that reflects its surroundings, blurred by a lobe of any width",
        .paper = "Hensley 2005, sect. 5.1, Figs 5 and 6; Scheuermann 2005",
        .lookFor = "the reflection stays smooth at every width and over the seam of the two faces",
        .parameters =
            {Parameter::Number("width", "Width of the box at the middle of a face; at most 45 degrees to either side",
                               {.minimum = 1, .maximum = kLargestWidth, .initial = 24, .unit = "texels"}),
             Parameter::Choice(
                 "lobe",
                 "Kernel: one box, four boxes, a tent, a parabola, or the papers' box of one size, summed in floats",
                 kLobes, "stack")
                 .Fixed(),
             Parameter::Choice("gloss", "One width everywhere, or widths from a texture", {"uniform", "texture"},
                               "uniform"),
             Parameter::Choice("source", "The environment alone, or with objects moving in it",
                               {"environment", "scene"}, "environment"),
             Parameter::Choice("mapping", "Directions computed, or from a lookup texture", {"arithmetic", "lookup"},
                               "arithmetic")
                 .Fixed(),
             FaceParameter()},
        .takesEnvironment = true,
        .takesMesh = true,
        .isHighRange = true,
        .make = MakeEffect<GlossyEnvironment>};
}

EffectInfo PhongEnvironmentInfo() {
    return {
        .name = "phong-environment",
        .what = "The Phong model under light from all around",
        .paper = "Hensley 2005, sect. 5.1.2, Fig. 7",
        .lookFor = "diffuse light comes from boxes around the normal, the highlight from boxes around the reflection",
        .parameters = {Parameter::Number("exponent", "Exponent n of the highlight's lobe, cos^n",
                                         {.minimum = 7, .maximum = 1000, .initial = 60}),
                       Parameter::Number("shine", "The highlight's share of the light", {.initial = 0.35f}),
                       Parameter::Whole("boxes", "Number of boxes in each of the two stacks",
                                        {.minimum = 1, .maximum = 6, .initial = 2}),
                       FaceParameter()},
        .takesEnvironment = true,
        .takesMesh = true,
        .isHighRange = true,
        .make = MakeEffect<PhongEnvironment>};
}

}  // namespace boxcar
