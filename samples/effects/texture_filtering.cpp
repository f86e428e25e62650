// A striped ellipsoid and receding planes, their texture filtered in one of eight ways.
//
//   pattern  ->  [mip levels | table]  ->  scene, a pixel at a time
//   reference: 64 x (pattern  ->  scene, 2 x 2 samples a pixel)  ->  their mean
//
// Crow 1984, sect. 2 and 4 (Figs 3 to 7)
#include <algorithm>
#include <cmath>

#include "hlsl/constants/effect_constants.h"
#include "runtime/passes/exact_table.h"
#include "runtime/passes/mip_chain.h"
#include "runtime/passes/quad_shaders.h"
#include "runtime/ping_pong.h"
#include "samples/effects/effect_shader.h"
#include "samples/effects/effects.h"
#include "samples/scenes/scene.h"
#include "samples/scenes/shapes.h"

namespace boxcar {
namespace {

constexpr Extent2D kTexture{TEXTURE_SIDE_TEXELS, TEXTURE_SIDE_TEXELS};
constexpr float kCells = 8;          // black and white stripes of the texture
constexpr int kDrawsAlongPixel = 8;  // of the reference, each of two samples on either axis
constexpr float kPlaneLength = 80;
constexpr float kPlaneRepeats = 2.5f;  // to one of the ellipsoid's

enum class Filter { Nearest, Bilinear, Mip, MipFiltered, MipBSpline, Anisotropic, Table, Reference };

constexpr Word<Filter> kFilters[] = {{"nearest", Filter::Nearest},
                                     {"bilinear", Filter::Bilinear},
                                     {"mip", Filter::Mip},
                                     {"mip-filtered", Filter::MipFiltered},
                                     {"mip-bspline", Filter::MipBSpline},
                                     {"anisotropic", Filter::Anisotropic},
                                     {"table", Filter::Table},
                                     {"reference", Filter::Reference}};

// A sphere that is longer along its axis.
MeshData Ellipsoid() {
    const glm::vec3 radii(0.8f, 1.2f, 0.8f);
    MeshData mesh = Sphere(1, 192, 96);
    for (Vertex& vertex : mesh.vertices) {
        vertex.position *= radii;
        vertex.normal = glm::normalize(vertex.normal / radii);
    }
    return mesh;
}

// u and v exchanged: what ran away from the eye now lies across.
MeshData Ceiling() {
    MeshData mesh = Ground(kPlaneLength, 1);
    for (Vertex& vertex : mesh.vertices)
        std::swap(vertex.uv.x, vertex.uv.y);
    return mesh;
}

// Targets of twice the picture's sides, and what has been added up of them.
struct Samples {
    Samples(Device& device, Extent2D extent)
        : add(device, QuadShaders(EffectShader("texture_samples.ps"))),
          samples(device, {{2 * extent.widthTexels, 2 * extent.heightTexels}, Format::RGBA32F, "samples"}),
          depth(device, {samples.Extent(), Format::Depth32F, "samples' depth"}),
          sum(device, {extent, Format::RGBA32F, "sum of samples"}) {}

    Pipeline add;
    Image samples, depth;
    PingPong sum;
};

class TextureFiltering : public Effect {
public:
    TextureFiltering(Device& device, const EffectInputs& inputs, const ParameterValues&)
        : m_device(device),
          m_ellipsoid(UploadMesh(device, Ellipsoid(), "ellipsoid")),
          m_floor(UploadMesh(device, Ground(kPlaneLength, 1), "floor")),
          m_ceiling(UploadMesh(device, Ceiling(), "ceiling")),
          m_drawPattern(device, QuadShaders(EffectShader("texture_pattern.ps"))),
          m_nearest(device, SceneShaders(EffectShader("texture_sampled.ps.SAMPLER=nearestRepeat"))),
          m_linear(device, SceneShaders(EffectShader("texture_sampled.ps.SAMPLER=linearRepeat"))),
          m_bspline(device, SceneShaders(EffectShader("texture_bspline.ps"))),
          m_anisotropic(device, SceneShaders(EffectShader("texture_sampled.ps.SAMPLER=anisotropicRepeat"))),
          m_fromTable(device, SceneShaders(EffectShader("texture_table.ps"))),
          m_pattern(device, {kTexture, Format::RGBA32F, "pattern"}),
          m_mips(device, kTexture),
          m_filteredMips(device, kTexture, QuadShaders(EffectShader("texture_halve.ps"))),
          m_table(device,
                  {.extent = kTexture, .codes = {.scale = TEXTURE_WHITE_CODES, .largest = TEXTURE_WHITE_CODES}}),
          m_picture(device, {inputs.extent, Format::RGBA32F, "picture"}),
          m_depth(device, {inputs.extent, Format::Depth32F, "depth"}) {}

private:
    const Image& Draw(CommandList& commands, const Frame& frame) override {
        const bool isChecks = frame.values.Choice("pattern") == "checks";
        const TexturePatternConstants pattern{{kCells, isChecks ? kCells : 0}};
        commands.Draw({.name = "pattern",
                       .pipeline = m_drawPattern,
                       .writes = {&m_pattern},
                       .constants = ConstantBytes(pattern)});
        AddStage("pattern", m_pattern);
        switch (ValueOf(kFilters, frame.values.Choice("filter"))) {
            case Filter::Nearest: return DrawPicture(commands, frame, m_nearest, {"pattern", &m_pattern});
            case Filter::Bilinear: return DrawPicture(commands, frame, m_linear, {"pattern", &m_pattern});
            case Filter::Mip:
                return DrawPicture(commands, frame, m_linear, {"pattern", &m_mips.Record(commands, m_pattern)});
            case Filter::MipFiltered:
                return DrawPicture(commands, frame, m_linear,
                                   {"pattern", &m_filteredMips.Record(commands, m_pattern)});
            case Filter::MipBSpline:
                return DrawPicture(commands, frame, m_bspline, {"pattern", &m_mips.Record(commands, m_pattern)});
            case Filter::Anisotropic:
                return DrawPicture(commands, frame, m_anisotropic, {"pattern", &m_mips.Record(commands, m_pattern)});
            case Filter::Table: {
                const Image& table = *m_table.Record(commands, m_pattern).low;
                AddStage("table", table);
                return DrawPicture(commands, frame, m_fromTable, {"table", &table});
            }
            case Filter::Reference: return DrawReference(commands, frame);
        }
        BOXCAR_ASSERT(false);
        return m_picture;
    }

    const Image& DrawPicture(CommandList& commands, const Frame& frame, const Pipeline& pipeline, Read read) {
        DrawScene(commands, frame, pipeline, read, m_picture, m_depth, glm::vec2(0));
        return m_picture;
    }

    const Image& DrawReference(CommandList& commands, const Frame& frame) {
        if (!m_samples) m_samples.emplace(m_device, m_picture.Extent());
        PingPong& sum = m_samples->sum;
        commands.Clear(sum.Front(), {0, 0, 0, 0});
        for (int y = 0; y < kDrawsAlongPixel; y++)
            for (int x = 0; x < kDrawsAlongPixel; x++) {
                // No two in one row or column: upright stripes are met at as many places as there are draws.
                const glm::vec2 place =
                    glm::vec2(x, y) + (glm::vec2(y, x) + 0.5f) / static_cast<float>(kDrawsAlongPixel);
                const glm::vec2 offset = place / static_cast<float>(kDrawsAlongPixel) - 0.5f;
                DrawScene(commands, frame, m_nearest, {"pattern", &m_pattern}, m_samples->samples, m_samples->depth,
                          offset);
                commands.Draw({.name = "samples",
                               .pipeline = m_samples->add,
                               .reads = {{"before", &sum.Front()}, {"samples", &m_samples->samples}},
                               .writes = {&sum.Back()}});
                sum.Swap();
            }
        return sum.Front();
    }

    // The scene into `target`, moved by `offsetTexels` of it.
    void DrawScene(CommandList& commands, const Frame& frame, const Pipeline& pipeline, Read read,
                   const Image& target, const Image& depth, glm::vec2 offsetTexels) const {
        const bool isEllipsoid = frame.values.Choice("scene") == "ellipsoid";
        const auto time = static_cast<float>(frame.timeSeconds);
        const float repeats = frame.values["repeats"];
        const float roll = glm::radians(frame.values["roll"]);
        Camera camera{.upWorld = {std::sin(roll), std::cos(roll), 0}};
        if (isEllipsoid) {
            camera.eyeWorld = {0, 2.7f, 3.0f};
            camera.targetWorld = {0, 0.17f, 0};
            camera.verticalAngleRadians = 0.62f;
        } else {
            camera.eyeWorld = {0.3f * std::sin(time), 0, kPlaneLength / 2 - 1};
        }
        std::vector<SceneObject> objects;
        if (isEllipsoid)
            objects = {{.mesh = &m_ellipsoid, .turnRadians = 0.2f * time}};
        else
            for (const float side : {-1.0f, 1.0f})
                objects.push_back({.mesh = side < 0 ? &m_floor : &m_ceiling, .offsetWorld = {0, side, 0}});
        const glm::vec2 repeatsOfMesh =
            isEllipsoid ? glm::vec2(repeats, repeats / 2) : glm::vec2(kPlaneRepeats * repeats);
        const Extent2D extent = target.Extent();
        const glm::vec2 offsetClip = 2.0f * offsetTexels / glm::vec2(extent.widthTexels, extent.heightTexels);
        const glm::mat4 moved = glm::translate(glm::mat4(1), glm::vec3(offsetClip, 0));
        DrawObjects(commands,
                    {.name = "scene",
                     .pipeline = pipeline,
                     .reads = {read},
                     .writes = {&target},
                     .depth = &depth,
                     .clearColor = glm::vec4(kSky, 0),
                     .clearsDepth = true},
                    objects, moved * ClipFromWorld(camera, m_picture.Extent()), camera.eyeWorld,
                    [&](const SceneConstants& scene, const SceneObject&) {
                        return TexturedConstants{scene, repeatsOfMesh};
                    });
    }

    Device& m_device;
    Mesh m_ellipsoid, m_floor, m_ceiling;
    Pipeline m_drawPattern, m_nearest, m_linear, m_bspline, m_anisotropic, m_fromTable;
    Image m_pattern;
    MipChain m_mips, m_filteredMips;
    ExactTable m_table;
    Image m_picture, m_depth;
    std::optional<Samples> m_samples;  // made when they are first asked for
};

}  // namespace

EffectInfo TextureFilteringInfo() {
    return {.name = "texture-filtering",
            .what = "A striped ellipsoid and receding planes, textured through a table and in seven other ways",
            .paper = "Crow 1984, sect. 2 and 4, Figs 3 to 7",
            .lookFor = "the table blurs along the direction in which the texture is compressed, a mip map in both",
            .parameters =
                {Parameter::Choice("scene", "What the texture is on", {"ellipsoid", "planes"}, "ellipsoid"),
                 Parameter::Choice(
                     "filter",
                     "The nearest texel, the nearest four, mip levels of plain means and of weighted means, plain "
                     "levels under the cubic B-spline, 16 samples of them, the table, or 256 samples a pixel",
                     kFilters, "table"),
                 Parameter::Choice("pattern", "The texture", {"stripes", "checks"}, "stripes"),
                 Parameter::Whole("repeats",
                                  "How many times the texture goes around the ellipsoid; along the planes it is two "
                                  "and a half times as many",
                                  {.minimum = 1, .maximum = 64, .initial = 16}),
                 Parameter::Number("roll", "Roll of the camera; at 0 the texture is upright in the picture",
                                   {.minimum = -90, .maximum = 90, .initial = 0, .unit = "degrees"})},
            .make = MakeEffect<TextureFiltering>};
}

}  // namespace boxcar
