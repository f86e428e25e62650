// Dual paraboloids: the mapping against its definition, exact constants, lobes against integrals over the sphere. All
// references in double, from Scheuermann 2005 and Hensley 2005, sect. 5.1, not from the shaders.
#include "runtime/passes/dual_paraboloid.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "hlsl/boxcar/dual_paraboloid_range.h"
#include "passes_shaders.h"
#include "samples/scenes/surroundings.h"
#include "test_support_shaders.h"
#include "tests/effects/effect_pictures.h"
#include "tests/hlsl/test_constants.h"
#include "tests/support/device_image.h"

namespace boxcar {
namespace {

constexpr double kPi = glm::pi<double>();

Image Drawn(const std::string& shader, Extent2D extent, std::vector<Read> reads = {},
            std::span<const std::byte> constants = {}) {
    const Pipeline pipeline(
        TestDevice(), {passes_shaders::Find("shaders/quad.vs"), test_support_shaders::Find("shaders/" + shader)});
    Image image(TestDevice(), {extent, Format::RGBA32F, shader});
    CommandList commands(TestDevice());
    commands.Draw({.name = shader,
                   .pipeline = pipeline,
                   .reads = std::move(reads),
                   .writes = {&image},
                   .constants = constants});
    commands.SubmitAndWait();
    return image;
}

Image UploadDirections(const std::vector<glm::dvec3>& directions, float alpha = 0) {
    Texels texels;
    for (const glm::dvec3& direction : directions)
        texels.emplace_back(direction, alpha);
    return Upload({static_cast<uint32_t>(texels.size()), 1}, texels, "directions");
}

// The direction at an angle `tilt` from the axis of a face, turned by `azimuth` from +x.
glm::dvec3 Tilted(int face, double tilt, double azimuth) {
    const double sine = std::sin(tilt);
    return {sine * std::cos(azimuth), sine * std::sin(azimuth), (face == 0 ? -1 : 1) * std::cos(tilt)};
}

// Blythe's formulas, the front face looking along -z.
glm::dvec3 ReferenceDirection(double u, double v, int face) {
    const double x = 2 * u - 1, y = 1 - 2 * v, s = x * x + y * y;
    return glm::dvec3(2 * x, 2 * y, (face == 0 ? s - 1 : 1 - s)) / (s + 1);
}

TEST(DualParaboloid, EveryPlaceOfAFaceIsADirectionAndBack) {
    constexpr Extent2D kExtent{96, 96};
    for (const int face : {0, 1}) {
        const Texels texels = Download(Drawn(fmt::format("dp_round_trip.ps.FACE={}", face), kExtent));
        for (uint32_t y = 0; y < 96; y++)
            for (uint32_t x = 0; x < 96; x++) {
                const glm::vec4& texel = texels[y * 96 + x];
                EXPECT_NEAR(texel.x, (x + 0.5) / 96, 4e-7);
                EXPECT_NEAR(texel.y, (y + 0.5) / 96, 4e-7);
                EXPECT_NEAR(texel.z, 1, 3e-7);
            }
    }
}

// A cube map in which the light is the direction itself.
Image DirectionCube(uint32_t side) {
    // Direct3D's layout: for each face the direction of its middle, of u to the right and of v down.
    constexpr glm::vec3 kMiddle[6] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    constexpr glm::vec3 kRight[6] = {{0, 0, -1}, {0, 0, 1}, {1, 0, 0}, {1, 0, 0}, {1, 0, 0}, {-1, 0, 0}};
    constexpr glm::vec3 kDown[6] = {{0, -1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}, {0, -1, 0}, {0, -1, 0}};
    Image cube(TestDevice(), {.extent = {side, side}, .name = "directions", .layers = 6});
    CommandList commands(TestDevice());
    std::vector<Image> faces;
    for (uint32_t face = 0; face < 6; face++) {
        Texels texels;
        for (uint32_t y = 0; y < side; y++)
            for (uint32_t x = 0; x < side; x++) {
                const float u = (2 * static_cast<float>(x) + 1) / static_cast<float>(side) - 1;
                const float v = (2 * static_cast<float>(y) + 1) / static_cast<float>(side) - 1;
                texels.emplace_back(glm::normalize(kMiddle[face] + u * kRight[face] + v * kDown[face]), 1);
            }
        faces.push_back(Upload({side, side}, texels));
    }
    for (uint32_t face = 0; face < 6; face++)
        commands.Copy(faces[face], cube, face);
    commands.SubmitAndWait();
    return cube;
}

std::array<Texels, 2> FacesOf(const Image& cube, uint32_t side, DPMapping mapping) {
    DualParaboloid paraboloid(TestDevice(), side, mapping);
    CommandList commands(TestDevice());
    const DualParaboloidFaces faces = paraboloid.Record(commands, cube);
    commands.SubmitAndWait();
    return {Download(*faces.front), Download(*faces.back)};
}

TEST(DualParaboloid, FacesShowWhatTheCubeMapHasInTheirDirections) {
    const Image cube = DirectionCube(128);
    const auto faces = FacesOf(cube, 64, DPMapping::Arithmetic);
    for (const int face : {0, 1})
        for (uint32_t y = 0; y < 64; y++)
            for (uint32_t x = 0; x < 64; x++) {
                const glm::dvec3 expected = ReferenceDirection((x + 0.5) / 64, (y + 0.5) / 64, face);
                const glm::dvec3 shown(faces[face][y * 64 + x]);
                ASSERT_LT(glm::length(shown - expected), 0.008) << "face " << face << " at " << x << ", " << y;
            }
}

TEST(DualParaboloid, LookupAndArithmeticGiveTheSameBits) {
    const Image cube = DirectionCube(32);
    EXPECT_EQ(FacesOf(cube, 50, DPMapping::Lookup), FacesOf(cube, 50, DPMapping::Arithmetic));
}

TEST(DualParaboloid, WeightsOfBothFacesAddUpToTheSphere) {
    const Image cube = DirectionCube(4);
    for (const uint32_t side : {16u, 64u, 256u}) {
        double sum = 0;
        for (const Texels& face : FacesOf(cube, side, DPMapping::Arithmetic))
            for (const glm::vec4& texel : face)
                sum += texel.a;
        // A texel at the middle stands for 4 / (side / 2)^2 of the sphere's 4 pi.
        EXPECT_NEAR(sum * 16 / (side * side) / (4 * kPi), 1, side == 16 ? 0.01 : 0.002) << side;
    }
}

// Both poles, both sides of the rim and the rim itself, and all between.
std::vector<glm::dvec3> DirectionsAllOver() {
    std::vector<glm::dvec3> directions;
    for (int tilt = 0; tilt <= 36; tilt++)
        for (int azimuth = 0; azimuth < 24; azimuth++)
            directions.push_back(Tilted(0, tilt * kPi / 36, (azimuth + 0.1 * tilt) * kPi / 12));
    for (const double tilt : {89.99, 90.01, 89.5, 90.5})
        for (int azimuth = 0; azimuth < 24; azimuth++)
            directions.push_back(Tilted(0, tilt * kPi / 180, azimuth * kPi / 12));
    return directions;
}

TEST(DualParaboloid, OneSampleIsTheLightOfItsDirection) {
    const Image cube = DirectionCube(128);
    DualParaboloid paraboloid(TestDevice(), 128);
    CommandList commands(TestDevice());
    const DualParaboloidFaces faces = paraboloid.Record(commands, cube);
    commands.SubmitAndWait();
    const std::vector<glm::dvec3> directions = DirectionsAllOver();
    const Image image = UploadDirections(directions);
    const Texels light = Download(Drawn("dp_single.ps.FIXED=0", image.Extent(),
                                        {{"front", faces.front}, {"back", faces.back}, {"directions", &image}}));
    for (size_t i = 0; i < directions.size(); i++)
        EXPECT_LT(glm::length(glm::dvec3(light[i]) - directions[i]), 0.008) << i;  // half a texel of the cube
}

// Why not cube maps: a cone is an ellipse on a cube's face, the longer the nearer to its corner, and all six may be
// hit.
TEST(DualParaboloid, ConesAreCirclesOnParaboloidsAndNotOnCubes) {
    const double angle = 0.15;
    for (const double tilt : {0.0, 0.4, 0.8}) {
        const glm::dvec3 dir = Tilted(0, tilt, kPi / 4);
        const glm::dvec3 across = glm::normalize(glm::cross(dir, glm::dvec3(0, 0, 1) + 1e-3));
        const glm::dvec3 other = glm::cross(dir, across);
        const double cosT = std::cos(angle), sinT = std::sin(angle);
        const glm::dvec2 centre = glm::dvec2(dir) / (cosT - dir.z);
        double cubeMin = 1e9, cubeMax = 0, paraboloidMin = 1e9, paraboloidMax = 0;
        const glm::dvec3 ends[] = {cosT * dir + sinT * across, cosT * dir - sinT * across, cosT * dir + sinT * other,
                                   cosT * dir - sinT * other};
        for (int axis = 0; axis < 2; axis++) {
            const glm::dvec3 &a = ends[2 * axis], &b = ends[2 * axis + 1];
            const double cube = glm::length(glm::dvec2(a) / -a.z - glm::dvec2(b) / -b.z);
            cubeMin = std::min(cubeMin, cube);
            cubeMax = std::max(cubeMax, cube);
        }
        for (const glm::dvec3& end : ends) {
            const double radius = glm::length(glm::dvec2(end) / (1 - end.z) - centre);
            paraboloidMin = std::min(paraboloidMin, radius);
            paraboloidMax = std::max(paraboloidMax, radius);
        }
        EXPECT_NEAR(paraboloidMax / paraboloidMin, 1, 1e-9);
        EXPECT_NEAR(cubeMax / cubeMin, 1 / std::cos(tilt), 0.05) << tilt;  // 1.44 at 46 degrees
    }
}

// The widest cones, where they are about to come over the rim: nothing of the disc but its rim is in the circle.
TEST(DualParaboloid, TheWidestConesComeInFromNothing) {
    std::vector<glm::dvec3> directions;
    for (const double before : {1e-1, 1e-2, 5e-3, 3e-3, 2e-3, 1e-3, 5e-4, 1e-4, 1e-5, 1e-6, -1e-4})
        for (const double azimuth : {0.0, 0.6, kPi / 4})
            directions.push_back(Tilted(0, 0.75 * kPi - before, azimuth));
    const Image image = UploadDirections(directions, 1);  // more than 45 degrees, taken as that
    const Texels circles = Download(Drawn("dp_circle.ps.FACE=0", image.Extent(), {{"directions", &image}}));
    int seen = 0;
    for (size_t i = 0; i < directions.size(); i++) {
        if (circles[i].w == 0) continue;
        seen++;
        const double tilt = std::acos(-directions[i].z);
        const double nearest = glm::length(glm::dvec2(circles[i])) - static_cast<double>(circles[i].z);
        EXPECT_NEAR(nearest, std::tan((tilt - kPi / 4) / 2), 0.01) << "before the rim by " << 0.75 * kPi - tilt;
    }
    EXPECT_GE(seen, 12);
}

// A cone's rim lies on the circle that is said to be its picture.
TEST(DualParaboloid, ConesAreCircles) {
    std::vector<glm::dvec3> directions;
    for (const double tilt : {0.0, 0.3, 0.9, 1.4, 1.6, 2.0})
        for (const double azimuth : {0.2, 2.0, 4.5})
            directions.push_back(Tilted(0, tilt, azimuth));
    for (const double angle : {0.02, 0.3, 0.75}) {
        const Image image = UploadDirections(directions, static_cast<float>(std::tan(angle / 2)));
        const Texels circles = Download(Drawn("dp_circle.ps.FACE=0", image.Extent(), {{"directions", &image}}));
        for (size_t i = 0; i < directions.size(); i++) {
            const double tilt = std::acos(-directions[i].z);
            const bool isSeen = tilt - angle < kPi / 2;
            EXPECT_EQ(circles[i].w, isSeen ? 1 : 0) << tilt << ", " << angle;
            if (!isSeen) continue;
            const glm::dvec3 across = glm::normalize(glm::cross(directions[i], glm::dvec3(0.3, 0.5, 0.8)));
            const glm::dvec3 other = glm::cross(directions[i], across);
            for (int k = 0; k < 12; k++) {
                const double turn = k * kPi / 6;
                const glm::dvec3 rim = std::cos(angle) * directions[i] +
                                       std::sin(angle) * (std::cos(turn) * across + std::sin(turn) * other);
                const glm::dvec2 place = glm::dvec2(rim) / (1 - rim.z);
                EXPECT_NEAR(glm::length(place - glm::dvec2(circles[i])) / circles[i].z, 1, 2e-5);
            }
        }
    }
}

// Faces and tables of an environment, and light under lobes round any directions.
class Reflections {
public:
    Reflections(const Environment& environment, uint32_t side, uint32_t order, uint32_t largestTexels)
        : m_surroundings(TestDevice(), environment, side),
          m_paraboloid(TestDevice(), side),
          m_tables(TestDevice(), {.sideTexels = side,
                                  .order = order,
                                  .largestLight = m_surroundings.LargestLight(),
                                  .darkestLight = m_surroundings.DarkestLight()}),
          m_largestTexels(largestTexels) {}

    Texels Sample(const std::string& lobe, const std::vector<glm::dvec3>& directions, double widthTexels,
                  int boxes = 4) {
        const Image image = UploadDirections(directions);
        Image result(TestDevice(), {image.Extent(), Format::RGBA32F, "light"});
        CommandList commands(TestDevice());
        const DualParaboloidSums sums = m_tables.Record(
            commands, m_paraboloid.Record(commands, m_surroundings.Record(commands, {})), m_largestTexels);
        const DPSampleConstants constants{static_cast<float>(widthTexels), sums.codeScale,
                                          static_cast<int>(m_largestTexels), boxes};
        std::vector<Read> reads = {{"frontLow", sums.tables.front.low},
                                   {"frontHigh", sums.tables.front.high},
                                   {"backLow", sums.tables.back.low},
                                   {"backHigh", sums.tables.back.high},
                                   {"directions", &image}};
        m_isFine = sums.fine.has_value();
        if (m_isFine)
            reads.insert(reads.end(), {{"fineFrontLow", sums.fine->front.low},
                                       {"fineFrontHigh", sums.fine->front.high},
                                       {"fineBackLow", sums.fine->back.low},
                                       {"fineBackHigh", sums.fine->back.high}});
        const Pipeline pipeline(TestDevice(), {passes_shaders::Find("shaders/quad.vs"),
                                               test_support_shaders::Find("shaders/dp_sample.ps.LOBE=" + lobe +
                                                                          (m_isFine ? ".FINE=1" : ""))});
        commands.Draw({.name = "sample",
                       .pipeline = pipeline,
                       .reads = std::move(reads),
                       .writes = {&result},
                       .constants = ConstantBytes(constants)});
        commands.SubmitAndWait();
        return Download(result);
    }

    // Whether the last Sample() needed what rounding left over.
    bool IsFine() const { return m_isFine; }

private:
    Surroundings m_surroundings;
    DualParaboloid m_paraboloid;
    DualParaboloidTables m_tables;
    uint32_t m_largestTexels;
    bool m_isFine = false;
};

TEST(DualParaboloid, AConstantEnvironmentStaysConstant) {
    constexpr glm::vec4 kLight(0.7f, 12.3f, 0.0314f, 1);
    const Environment constant{{64, 32}, std::vector(64 * 32, kLight)};
    const struct {
        const char* lobe;
        uint32_t order, largest;
        std::vector<double> widths;
    } kCases[] = {{"BOX", 1, 256, {1, 1.3, 2, 3, 17.4, 64, 106, 200}},
                  {"STACK", 1, 256, {0.2, 1, 5, 20, 45}},
                  {"ORDER2", 2, 256, {1, 2.5, 8, 40}},
                  {"ORDER3", 3, 101, {1, 3, 9, 30}}};
    for (const auto& [lobe, order, largest, widths] : kCases) {
        Reflections reflections(constant, 256, order, largest);
        for (const double width : widths) {
            const Texels light = reflections.Sample(lobe, DirectionsAllOver(), width);
            for (const glm::vec4& texel : light)
                for (int c = 0; c < 3; c++)
                    ASSERT_NEAR(static_cast<double>(texel[c]) / kLight[c], 1, 1e-4) << lobe << ", width " << width;
        }
    }
}

// The papers' tables of floats: alpha counts whole texels, so only colours are rounded.
TEST(DualParaboloid, ThePapersLookupKeepsAConstantWithinItsBound) {
    constexpr glm::vec4 kLight(0.7f, 12.3f, 0.0314f, 1);
    constexpr uint32_t kSide = 256;
    Texels masked;
    for (uint32_t y = 0; y < kSide; y++)
        for (uint32_t x = 0; x < kSide; x++)
            masked.push_back(std::hypot(x - 127.5, y - 127.5) <= 128 ? kLight : glm::vec4(0));
    const Image source = Upload({kSide, kSide}, masked);
    SummedAreaTable table(TestDevice(), {.extent = {kSide, kSide}});
    CommandList commands(TestDevice());
    const Image& sums = *table.Record(commands, source).low;
    commands.SubmitAndWait();
    const std::vector<glm::dvec3> directions = DirectionsAllOver();
    const Image image = UploadDirections(directions);
    for (const auto& [width, bound] : {std::pair(1, 0.02), std::pair(3, 0.0013), std::pair(17, 0.00006)}) {
        const Texels light = Download(Drawn(fmt::format("dp_single.ps.FIXED={}", width), image.Extent(),
                                            {{"front", &sums}, {"back", &sums}, {"directions", &image}}));
        double largest = 0;
        for (const glm::vec4& texel : light)
            for (int c = 0; c < 3; c++)
                largest = std::max(largest, std::abs(static_cast<double>(texel[c]) / kLight[c] - 1));
        RecordProperty(fmt::format("width_{}", width), fmt::format("{}", largest));
        EXPECT_LE(largest, bound) << width;
        EXPECT_GT(largest, 1e-6) << "floats would be exact";
    }
}

// An environment made coarser, each texel the mean of `by` x `by`.
Environment Coarser(const Environment& fine, uint32_t by) {
    Environment coarse{{fine.extent.widthTexels / by, fine.extent.heightTexels / by}, {}};
    for (uint32_t y = 0; y < coarse.extent.heightTexels; y++)
        for (uint32_t x = 0; x < coarse.extent.widthTexels; x++) {
            glm::vec4 sum(0);
            for (uint32_t i = 0; i < by * by; i++)
                sum += fine.texels[(by * y + i / by) * fine.extent.widthTexels + by * x + i % by];
            coarse.texels.push_back(sum / static_cast<float>(by * by));
        }
    return coarse;
}

constexpr double kExponents[] = {10, 30, 80, 200};

// Light under the lobe cos^n, as an integral over the sphere.
glm::dvec3 ReferenceLobe(const Environment& environment, const glm::dvec3& dir, double exponent) {
    const auto [width, height] = environment.extent;
    glm::dvec4 sum(0);
    for (uint32_t y = 0; y < height; y++) {
        const double polar = kPi * (y + 0.5) / height;
        for (uint32_t x = 0; x < width; x++) {
            const double longitude = 2 * kPi * ((x + 0.5) / width - 0.5);
            const glm::dvec3 from(std::sin(polar) * std::sin(longitude), std::cos(polar),
                                  -std::sin(polar) * std::cos(longitude));
            const double cosine = glm::dot(from, dir);
            if (cosine > 0.2 && exponent * (1 - cosine) < 40)  // what is left out is below 1e-7
                sum += std::sin(polar) * std::pow(cosine, exponent) *
                       glm::dvec4(glm::dvec3(environment.texels[y * width + x]), 1);
        }
    }
    return glm::dvec3(sum) / sum.w;
}

struct LobeCase {
    const char* name;
    uint32_t order, largest;
    double widthOverSigma;
    double bound, lampBound;
};
constexpr LobeCase kLobes[] = {
    {"STACK", 1, 256, 1, 0.06, 0.28}, {"ORDER2", 2, 256, 2.316, 0.05, 0.37}, {"ORDER3", 3, 101, 1.923, 0.06, 0.35}};

// Spread evenly over the sphere.
std::vector<glm::dvec3> EvenDirections(int count) {
    std::vector<glm::dvec3> directions;
    for (int i = 0; i < count; i++) {
        const double z = 1 - (2 * i + 1.0) / count, turn = i * kPi * (3 - std::sqrt(5.0));
        directions.emplace_back(std::sqrt(1 - z * z) * std::cos(turn), std::sqrt(1 - z * z) * std::sin(turn), z);
    }
    return directions;
}

// In bands of the angle from the nearer face's axis: 0 to 30, 60, 80, 90 degrees. Errors are over what the lobe shows
// of the environment on the mean. The studio is two small lamps near the rim and little else: what it shows are the
// kernels themselves, which at the rim are not as near to the lobe as in the middle.
TEST(DualParaboloid, LobesAreWithinTheirBoundsOfTheIntegralOverRealEnvironments) {
    const std::vector<glm::dvec3> directions = EvenDirections(1000);
    for (const char* name : {"city", "studio", "venice"}) {
        const Environment environment = Coarser(SampleEnvironment(name), 4);
        const bool isLamps = std::string_view(name) == "studio";
        std::array<std::vector<glm::dvec3>, 4> expected;
        for (size_t n = 0; n < 4; n++)
            for (const glm::dvec3& dir : directions)
                expected[n].push_back(ReferenceLobe(environment, dir, kExponents[n]));
        for (const LobeCase& lobe : kLobes) {
            for (size_t n = 0; n < 4; n++) {
                // A wide lobe needs no more, and a parabolic kernel in 64 bits has no more.
                const uint32_t side = kExponents[n] < 20 ? 128 : 256;
                Reflections reflections(environment, side, lobe.order, std::min(lobe.largest, side));
                const double sigmaTexels = 0.5 / std::sqrt(kExponents[n]) * side / 2;
                const Texels light = reflections.Sample(lobe.name, directions, lobe.widthOverSigma * sigmaTexels);
                double whole = 0;
                std::array<double, 4> difference{};
                std::array<int, 4> count{};
                for (size_t i = 0; i < directions.size(); i++) {
                    const glm::dvec3 error = glm::dvec3(light[i]) - expected[n][i];
                    const double tilt = std::acos(std::abs(directions[i].z)) * 180 / kPi;
                    const size_t band = tilt < 30 ? 0 : tilt < 60 ? 1 : tilt < 80 ? 2 : 3;
                    difference[band] += glm::dot(error, error);
                    count[band]++;
                    whole += glm::dot(expected[n][i], expected[n][i]) / static_cast<double>(directions.size());
                }
                for (size_t band = 0; band < 4; band++) {
                    const double error = std::sqrt(difference[band] / count[band] / whole);
                    RecordProperty(fmt::format("{}_{}_n{}_band{}", name, lobe.name, kExponents[n], band),
                                   fmt::format("{:.2f} %", 100 * error));
                    EXPECT_LE(error, isLamps ? lobe.lampBound : lobe.bound)
                        << name << ", " << lobe.name << ", exponent " << kExponents[n] << ", band " << band;
                }
            }
        }
    }
}

// Where a lobe shows nothing of a lamp, it shows the dark, however bright the lamp: over 100 degrees away from it,
// for kernels end before. On faces of 1024 the widest tent of glossy-environment.
TEST(DualParaboloid, TheDarkBesideALampIsRight) {
    constexpr uint32_t kWidth = 64, kHeight = 32;
    const glm::dvec3 towardsLamp = [] {
        const double polar = kPi * 10.5 / kHeight, longitude = 2 * kPi * (20.5 / kWidth - 0.5);
        return glm::dvec3(std::sin(polar) * std::sin(longitude), std::cos(polar),
                          -std::sin(polar) * std::cos(longitude));
    }();
    std::vector<glm::dvec3> directions;
    for (const glm::dvec3& dir : DirectionsAllOver())
        if (glm::dot(dir, towardsLamp) < std::cos(100 * kPi / 180)) directions.push_back(dir);
    ASSERT_GT(directions.size(), 300u);
    const struct {
        const char* name;
        uint32_t order, side;
        double exponent;
        float lamp;
        bool isFine;
    } kCases[] = {{"ORDER2", 2, 256, 80, 1e6f, false},  {"ORDER2", 2, 1024, 43, 1e6f, true},
                  {"ORDER2", 2, 256, 80, 65504, false}, {"ORDER3", 3, 128, 40, 1e6f, true},
                  {"ORDER3", 3, 256, 80, 1e6f, true},   {"ORDER3", 3, 256, 1600, 1e6f, false},
                  {"ORDER3", 3, 256, 80, 65504, false}, {"ORDER3", 3, 256, 43, 65504, true},
                  {"ORDER3", 3, 512, 24, 1e6f, true}};
    for (const auto& [name, order, side, exponent, lamp, isFine] : kCases) {
        Environment environment{{kWidth, kHeight}, std::vector(kWidth * kHeight, glm::vec4(0.02f))};
        environment.texels[10 * kWidth + 20] = glm::vec4(lamp);
        const double overSigma = static_cast<double>(order == 2 ? kDPTentOverSigma : kDPParabolicOverSigma);
        const double widthTexels = overSigma * 0.5 / std::sqrt(exponent) * side / 2;
        const int largest =
            DPWidestBox(static_cast<int>(order), static_cast<int>(side), static_cast<float>(widthTexels));
        Reflections reflections(environment, side, order, static_cast<uint32_t>(largest));
        const Texels light = reflections.Sample(name, directions, widthTexels);
        double largestError = 0;
        for (size_t i = 0; i < directions.size(); i++) {
            const double expected = ReferenceLobe(environment, directions[i], exponent).r;
            for (int c = 0; c < 3; c++)
                largestError = std::max(largestError, std::abs(static_cast<double>(light[i][c]) / expected - 1));
        }
        const std::string which = fmt::format("{}_{}_n{}_lamp{}", name, side, exponent, lamp);
        RecordProperty(which, fmt::format("{:.4f} %, boxes up to {}", 100 * largestError, largest));
        EXPECT_LE(largestError, 0.001) << which;
        EXPECT_EQ(reflections.IsFine(), isFine) << which;
    }
}

// In the effect no place is darker than the dark, at any width of a frame: whether rounding's rest is needed changes.
TEST(DualParaboloid, ReflectionsAreNoDarkerThanTheDarkBesideALamp) {
    const EffectInfo& info = FindEffect("glossy-environment");
    EffectInputs inputs = EffectPictures::InputsFor(info, {80, 50});
    inputs.environment = {{64, 32}, std::vector(64 * 32, glm::vec4(0.02f))};
    inputs.environment.texels[10 * 64 + 20] = glm::vec4(1e6f);
    for (const char* lobe : {"tent", "parabolic"}) {
        ParameterValues values(info.parameters);
        values.Set("lobe", lobe);
        const std::unique_ptr<Effect> effect = info.make(TestDevice(), inputs, values);
        for (const char* width : {"2", "128", "24"}) {
            values.Set("width", width);
            CommandList commands(TestDevice());
            const Image& picture = effect->Record(commands, {0, values});
            commands.SubmitAndWait();
            float darkest = 1;
            for (const glm::vec4& texel : Download(picture))
                darkest = std::min(darkest, texel.r);
            EXPECT_NEAR(darkest, 0.95f * 0.02f, 0.95f * 0.02f * 1e-3f) << lobe << ", " << width;
            EXPECT_EQ(TakeValidationMessages(), std::vector<std::string>());
        }
    }
}

// Kernels are not cut narrower than they are: wider words show the same.
TEST(DualParaboloid, NoBoxIsWiderThanTheWidestOne) {
    const Environment environment = Coarser(SampleEnvironment("city"), 4);
    const std::vector<glm::dvec3> directions = EvenDirections(1000);
    for (const int order : {2, 3})
        for (const double width : {1.0, 5.0, 11.3, 17.0}) {
            const int side = order == 2 ? 256 : 200;
            const int widest = DPWidestBox(order, side, static_cast<float>(width));
            const std::string lobe = fmt::format("ORDER{}", order);
            const auto sample = [&](int largest) {
                return Reflections(environment, static_cast<uint32_t>(side), static_cast<uint32_t>(order),
                                   static_cast<uint32_t>(largest))
                    .Sample(lobe, directions, width);
            };
            EXPECT_LT(widest, 5 * width + 2);
            const Texels light = sample(widest), wider = sample(order == 2 ? side : 101);
            for (size_t i = 0; i < directions.size(); i++)
                EXPECT_NEAR(static_cast<double>(light[i].r / wider[i].r), 1, 2e-4) << lobe << ", " << width;
        }
    EXPECT_EQ(DPWidestBox(3, 64, 60), 63);  // odd: SATSumWhole takes no other
    EXPECT_EQ(DPWidestBox(3, 256, 75), 101);
    EXPECT_EQ(DPWidestBox(2, 256, 90), 256);
}

// How narrow a lobe may be: on faces of 256 texels the texels of the faces and of the cube map blur it too.
TEST(DualParaboloid, NarrowLobesAreWithinTheirBoundDownToAWidthOfOneTexel) {
    const std::vector<glm::dvec3> directions = EvenDirections(100);
    for (const char* name : {"city", "venice"}) {
        const Environment environment = SampleEnvironment(name);
        Reflections reflections(environment, 256, 1, 256);
        for (const auto& [widthTexels, bound] :
             {std::pair(16.0, 0.01), std::pair(5.0, 0.01), std::pair(2.0, 0.03), std::pair(1.0, 0.05)}) {
            const double sigmaTexels = widthTexels / 3.274;
            const double exponent = std::pow(0.5 * 128 / sigmaTexels, 2);
            double difference = 0, whole = 0;
            const Texels light = reflections.Sample("STACK", directions, sigmaTexels);
            for (size_t i = 0; i < directions.size(); i++) {
                const glm::dvec3 expected = ReferenceLobe(environment, directions[i], exponent);
                const glm::dvec3 error = glm::dvec3(light[i]) - expected;
                difference += glm::dot(error, error);
                whole += glm::dot(expected, expected);
            }
            RecordProperty(fmt::format("{}_{}", name, widthTexels),
                           fmt::format("{:.2f} %", 100 * std::sqrt(difference / whole)));
            EXPECT_LE(std::sqrt(difference / whole), bound) << name << ", width " << widthTexels;
        }
    }
}

}  // namespace
}  // namespace boxcar
