#include "samples/scenes/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/gtc/constants.hpp>

#include "scenes_shaders.h"

namespace boxcar {
namespace {

constexpr double kWidestRadius = 1.25;  // a teapot's is 1.08
constexpr double kWithinRims = 0.98;

// About the y axis.
struct Ring {
    double radius, height;
};

// Rings about all that the mesh sweeps when it is turned: of each of 64 bands of its height the widest place.
std::vector<Ring> RingsRound(const MeshData& mesh) {
    constexpr int kBands = 64;
    double low = INFINITY, high = -INFINITY;
    for (const Vertex& vertex : mesh.vertices) {
        low = std::min(low, double{vertex.position.y});
        high = std::max(high, double{vertex.position.y});
    }
    std::array<double, kBands> widest = {};
    const double band = (high - low) / kBands;
    for (const auto& [position, normal, uv] : mesh.vertices) {
        const double at = band > 0 ? (position.y - low) / band : 0;
        double& radius = widest[static_cast<size_t>(std::min(at, kBands - 1.0))];
        radius = std::max(radius, std::hypot(double{position.x}, double{position.z}));
    }
    std::vector<Ring> rings;
    for (int i = 0; i < kBands; i++)
        for (const int edge : {i, i + 1})
            rings.push_back({widest[static_cast<size_t>(i)], low + edge * band});
    return rings;
}

// How many times what the rings are round may be larger about the stand's offset, and still be whole in the picture.
// Each side of what the camera sees is a plane, which a point passes at a factor that is found by a division.
double LargestWithin(const Stand& stand, const std::vector<Ring>& rings) {
    constexpr int kSides = 64;
    const double outside = 1 / std::cos(glm::pi<double>() / kSides);  // a polygon round the ring
    const glm::dmat4 clip(ClipFromWorld(stand.camera, stand.extent));
    const auto distances = [](const glm::dvec4& p) {  // to the planes; of clip space, positive inside
        return std::array{kWithinRims * p.w - p.x,
                          kWithinRims * p.w + p.x,
                          kWithinRims * p.w - p.y,
                          kWithinRims * p.w + p.y,
                          p.z,
                          p.w - p.z};
    };
    const std::array middle = distances(clip * glm::dvec4(stand.offsetWorld, 1));
    double largest = INFINITY;
    for (const auto& [radius, height] : rings)
        for (int i = 0; i < kSides; i++) {
            const double angle = 2 * glm::pi<double>() * i / kSides, reach = outside * radius;
            const glm::dvec3 point =
                double{stand.scale} * glm::dvec3(reach * std::cos(angle), height, reach * std::sin(angle));
            const std::array steps = distances(clip * glm::dvec4(point, 0));
            for (size_t plane = 0; plane < middle.size(); plane++)
                if (steps[plane] < 0 && middle[plane] > 0) largest = std::min(largest, -middle[plane] / steps[plane]);
        }
    return largest;
}

}  // namespace

SceneConstants ConstantsOf(const SceneObject& object, const glm::mat4& clipFromWorld, glm::vec3 eyeWorld) {
    return {clipFromWorld, object.offsetWorld,          object.scale, object.albedo, std::cos(object.turnRadians),
            eyeWorld,      std::sin(object.turnRadians)};
}

PipelineDesc SceneShaders(const EmbeddedShader& pixel, std::vector<Format> targets) {
    return {.vertex = scenes_shaders::Find("shaders/scene.vs"),
            .pixel = pixel,
            .targets = std::move(targets),
            .testsDepth = true};
}

PipelineDesc MattShaders() {
    return SceneShaders(scenes_shaders::Find("shaders/scene.ps"));
}

void DrawObjects(CommandList& commands, const Pass& first, std::span<const SceneObject> objects,
                 const glm::mat4& clipFromWorld, glm::vec3 eyeWorld) {
    DrawObjects(commands, first, objects, clipFromWorld, eyeWorld,
                [](const SceneConstants& scene, const SceneObject& object) {
                    return MattConstants{scene, object.checkWorld};
                });
}

MeshData StandingMesh(MeshData mesh, const Stand& stand) {
    glm::dvec3 lo(INFINITY), hi(-INFINITY);
    for (const Vertex& vertex : mesh.vertices) {
        lo = glm::min(lo, glm::dvec3(vertex.position));
        hi = glm::max(hi, glm::dvec3(vertex.position));
    }
    const glm::dvec3 size = hi - lo, origin(0.5 * (lo.x + hi.x), lo.y + stand.middle * size.y, 0.5 * (lo.z + hi.z));
    double radius = 0;
    for (const Vertex& vertex : mesh.vertices)
        radius = std::max(radius, std::hypot(vertex.position.x - origin.x, vertex.position.z - origin.z));
    double scale = std::min(1 / size.y, kWidestRadius / radius);
    if (!std::isfinite(scale)) scale = 1;  // all of it is one point
    for (Vertex& vertex : mesh.vertices)
        vertex.position = scale * (glm::dvec3(vertex.position) - origin);
    const auto within = static_cast<float>(LargestWithin(stand, RingsRound(mesh)));
    if (within < 1)
        for (Vertex& vertex : mesh.vertices)
            vertex.position *= within;
    return mesh;
}

MeshData TurnedZUp(MeshData mesh) {
    const auto turned = [](glm::vec3 v) { return glm::vec3(v.x, v.z, -v.y); };
    for (Vertex& vertex : mesh.vertices) {
        vertex.position = turned(vertex.position);
        vertex.normal = turned(vertex.normal);
    }
    return mesh;
}

}  // namespace boxcar
