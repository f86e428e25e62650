// The surface of one value of a volume, by rays through a 3D texture: trilinear, or under the cubic B-spline.
//
//   volume  ->  largest voxel of each block, once
//   rays through blocks that reach the value  ->  points  ->  derivatives and color, once a pixel
//
// Lengths are millimetres; the world's x axis goes to the body's right, y to its front, z up. The volume's own axes
// may be turned against them: all that is drawn with is then along the volume's.
//
// Sigg 2005, sect. 20.4 (Figs 20-4 and 20-5); Kindlmann 2003 (curvature)
#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include "hlsl/constants/isosurface_constants.h"
#include "runtime/passes/quad_shaders.h"
#include "runtime/transfer.h"
#include "samples/effects/effect_shader.h"
#include "samples/effects/effects.h"
#include "tools/base/error.h"

namespace boxcar {
namespace {

constexpr uint32_t kBlockCells = ISOSURFACE_BLOCK_CELLS;
constexpr float kViewRadians = 0.45f;
constexpr float kTurnDegreesPerSecond = 20;

constexpr Word<int> kShades[] = {{"phong", ISOSURFACE_PHONG},
                                 {"curvature", ISOSURFACE_CURVATURE},
                                 {"ridges", ISOSURFACE_RIDGES},
                                 {"normal", ISOSURFACE_NORMAL},
                                 {"maximum", ISOSURFACE_MAXIMUM}};

Image Upload(Device& device, const Volume& volume) {
    BOXCAR_ASSERT(!volume.voxels.empty());
    Image image(device, {.extent = {volume.widthVoxels, volume.heightVoxels},
                         .format = Format::R32F,
                         .name = "volume",
                         .depthTexels = volume.depthVoxels});
    WriteTexels(device, image, std::as_bytes(std::span(volume.voxels)));
    return image;
}

// Blocks along each axis, and how their slices lie in an image.
struct BlockGrid {
    explicit BlockGrid(const Volume& volume)
        : blocks((glm::uvec3(volume.widthVoxels, volume.heightVoxels, volume.depthVoxels) + kBlockCells - 1u) /
                 kBlockCells),
          across(static_cast<uint32_t>(std::ceil(std::sqrt(blocks.z)))) {}

    Extent2D ImageExtent() const { return {blocks.x * across, blocks.y * ((blocks.z + across - 1) / across)}; }
    size_t TexelOf(glm::uvec3 block) const {
        const glm::uvec2 tile(block.z % across, block.z / across);
        const glm::uvec2 texel = tile * glm::uvec2(blocks) + glm::uvec2(block);
        return size_t{texel.y} * ImageExtent().widthTexels + texel.x;
    }

    glm::uvec3 blocks;
    uint32_t across;
};

struct Ball {
    glm::vec3 middle;
    float radius;
};

struct FilterPipelines {
    FilterPipelines(Device& device, const std::string& filter)
        : march(device, QuadShaders(EffectShader("isosurface_march.ps.FILTER=" + filter))),
          shade(device, QuadShaders(EffectShader("isosurface_shade.ps.FILTER=" + filter))) {}

    Pipeline march, shade;
};

class Isosurface : public Effect {
public:
    Isosurface(Device& device, const EffectInputs& inputs, const ParameterValues&)
        : m_millimetres(inputs.volume.voxelMillimetres),
          m_axesFromWorld(glm::transpose(inputs.volume.worldFromAxes)),
          m_extentVoxels(inputs.volume.widthVoxels, inputs.volume.heightVoxels, inputs.volume.depthVoxels),
          m_grid(inputs.volume),
          m_volume(Upload(device, inputs.volume)),
          m_blockMaxima(device, {m_grid.ImageExtent(), Format::RGBA32F, "largest voxels of blocks"}),
          m_trilinear(device, "TRILINEAR"),
          m_tricubic(device, "TRICUBIC"),
          m_hits(device, {inputs.extent, Format::RGBA32F, "points"}),
          m_picture(device, {inputs.extent, Format::RGBA32F, "picture"}) {
        const Pipeline pipeline(device, QuadShaders(EffectShader("isosurface_blocks.ps")));
        const IsosurfaceBlocksConstants constants{static_cast<int>(m_grid.across)};
        CommandList commands(device);
        commands.Draw({.name = "blocks",
                       .pipeline = pipeline,
                       .reads = {{"volume", &m_volume}},
                       .writes = {&m_blockMaxima},
                       .constants = ConstantBytes(constants)});
        commands.SubmitAndWait();
        m_maxima.resize(m_blockMaxima.Extent().Texels());
        ReadTexels(device, m_blockMaxima, std::as_writable_bytes(std::span(m_maxima)));
    }

private:
    const Image& Draw(CommandList& commands, const Frame& frame) override {
        const bool isCubic = frame.values.Choice("filter") == "tricubic";
        const FilterPipelines& pipelines = isCubic ? m_tricubic : m_trilinear;
        const float iso = frame.values["iso"];

        // The eye looks at the middle of what reaches the value, from as far as shows it whole on any side.
        const Ball ball = BallRoundBlocks(iso);
        const float turn =
            glm::radians(frame.values["turn"] + kTurnDegreesPerSecond * static_cast<float>(frame.timeSeconds));
        const float rise = glm::radians(frame.values["elevation"]);
        const glm::vec3 toEye = m_axesFromWorld * glm::vec3(std::sin(turn) * std::cos(rise),
                                                            std::cos(turn) * std::cos(rise), std::sin(rise));
        const glm::vec3 right = m_axesFromWorld * glm::vec3(-std::cos(turn), std::sin(turn), 0);
        const glm::vec3 up = glm::cross(toEye, right);
        const auto [width, height] = m_picture.Extent();
        const float aspect = static_cast<float>(width) / static_cast<float>(height);
        const float distance = ball.radius / (std::sin(kViewRadians / 2) * std::min(aspect, 1.0f));
        const glm::vec3 eye = m_axesFromWorld * ball.middle + distance * toEye;
        const float rim =
            std::tan(kViewRadians / 2) / frame.values["zoom"];  // of the picture, one unit before the eye

        const IsosurfaceMarchConstants march{.eyeVoxels = eye / m_millimetres,
                                             .iso = iso,
                                             .forwardVoxels = -toEye / m_millimetres,
                                             .stepVoxels = frame.values["step"],
                                             .rightVoxels = rim * aspect * right / m_millimetres,
                                             .blocksAcross = static_cast<int>(m_grid.across),
                                             .upVoxels = rim * up / m_millimetres};
        commands.Draw({.name = "march",
                       .pipeline = pipelines.march,
                       .reads = {{"volume", &m_volume}, {"blockMaxima", &m_blockMaxima}},
                       .writes = {&m_hits},
                       .constants = ConstantBytes(march)});
        AddStage("points", m_hits);
        const IsosurfaceShadeConstants shade{
            .eyeMillimetres = eye,
            .shade = ValueOf(kShades, frame.values.Choice("shade")),
            .voxelMillimetres = m_millimetres,
            .radiusMillimetres = frame.values["radius"],
            .lightMillimetres = glm::normalize(0.7f * toEye - 0.55f * right + 0.75f * up),
            .unused0 = 0,
            .worldX = m_axesFromWorld[0],
            .unused1 = 0,
            .worldY = m_axesFromWorld[1],
            .unused2 = 0,
            .worldZ = m_axesFromWorld[2]};
        commands.Draw({.name = "shade",
                       .pipeline = pipelines.shade,
                       .reads = {{"volume", &m_volume}, {"hits", &m_hits}},
                       .writes = {&m_picture},
                       .constants = ConstantBytes(shade)});
        return m_picture;
    }

    // Round the blocks that reach the value, about the middle of their box in the world; round the volume where none
    // does. From the volume's corner, along the world's axes.
    Ball BallRoundBlocks(float iso) const {
        std::vector<glm::vec3> corners;
        const auto add = [&](glm::vec3 lowVoxels, glm::vec3 highVoxels) {
            const glm::vec3 ends[] = {lowVoxels * m_millimetres, highVoxels * m_millimetres};
            for (int i = 0; i < 8; i++)
                corners.push_back(glm::vec3(ends[i & 1].x, ends[i >> 1 & 1].y, ends[i >> 2].z) * m_axesFromWorld);
        };
        for (uint32_t z = 0; z < m_grid.blocks.z; z++)
            for (uint32_t y = 0; y < m_grid.blocks.y; y++)
                for (uint32_t x = 0; x < m_grid.blocks.x; x++) {
                    if (m_maxima[m_grid.TexelOf({x, y, z})].x < iso) continue;
                    const glm::vec3 first(kBlockCells * glm::uvec3(x, y, z));
                    add(first, glm::min(first + float{kBlockCells}, m_extentVoxels));
                }
        if (corners.empty()) add(glm::vec3(0), m_extentVoxels);
        glm::vec3 least(INFINITY), largest(-INFINITY);
        for (const glm::vec3 corner : corners) {
            least = glm::min(least, corner);
            largest = glm::max(largest, corner);
        }
        Ball ball{0.5f * (least + largest), 0};
        for (const glm::vec3 corner : corners)
            ball.radius = std::max(ball.radius, glm::length(corner - ball.middle));
        return ball;
    }

    glm::vec3 m_millimetres;  // sides of a voxel
    glm::mat3 m_axesFromWorld;
    glm::vec3 m_extentVoxels;
    BlockGrid m_grid;
    Image m_volume, m_blockMaxima;
    std::vector<glm::vec4> m_maxima;  // the same, .x
    FilterPipelines m_trilinear, m_tricubic;
    Image m_hits, m_picture;
};

}  // namespace

EffectInfo IsosurfaceInfo() {
    return {
        .name = "isosurface",
        .what = "The surface of one value of a volume, by rays; trilinear or tricubic, with its curvatures",
        .paper = "Sigg 2005, sect. 20.4, Figs 20-4 and 20-5",
        .lookFor = "tricubic is smooth where trilinear shows the voxels; valleys are dark and ridges light",
        .parameters =
            {Parameter::Choice("filter", "How voxels are interpolated", {"trilinear", "tricubic"}, "tricubic"),
             Parameter::Choice("shade",
                               "Light alone, a color for each pair of curvatures, ridges and valleys, the normal, or "
                               "the larger curvature",
                               kShades, "phong"),
             Parameter::Number("iso", "The surface's value, in the volume's units",
                               {.minimum = -1e6f, .maximum = 1e6f, .initial = 92}),
             Parameter::Number("step", "Distance between looks along a ray",
                               {.minimum = 0.1f, .maximum = 2, .initial = 0.5f, .unit = "voxels"}),
             Parameter::Number("radius", "Radius of a curvature that gets its full color",
                               {.minimum = 0.1f, .maximum = 1000, .initial = 3, .unit = "mm"}),
             Parameter::Number(
                 "turn", "Angle of the eye around the z axis; at 0 it sees the front (+y), at 90 the right side (+x)",
                 {.minimum = -180, .maximum = 180, .initial = -125, .unit = "degrees"}),
             Parameter::Number("elevation", "Angle of the eye above the x-y plane",
                               {.minimum = -90, .maximum = 90, .initial = 25, .unit = "degrees"}),
             Parameter::Number("zoom", "Magnification; 1 shows the whole surface",
                               {.minimum = 0.1f, .maximum = 20, .initial = 1})},
        .takesVolume = true,
        .make = MakeEffect<Isosurface>};
}

}  // namespace boxcar
