// The cubic B-spline of mip-mapped pictures. Every level holds noise of its own, so that a level that was not meant
// shows.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "passes_shaders.h"
#include "runtime/base_level.h"
#include "runtime/passes/meta_mipmap.h"
#include "test_support_shaders.h"
#include "tests/hlsl/test_constants.h"
#include "tests/reference/bspline.h"
#include "tests/support/device_image.h"
#include "tests/support/expect_error.h"
#include "tests/support/spirv_fetches.h"

namespace boxcar {
namespace {

constexpr Extent2D kScreen{48, 32};
constexpr uint32_t kLineTexels = 1024;
constexpr double kSamplersLogarithm = 0.045;  // lavapipe's is straight from one power of 2 to the next, on squares
constexpr Extent2D kExtents[] = {{64, 64}, {128, 64}, {48, 144}, {200, 1}};

std::string Text(Extent2D extent) {
    return fmt::format("{} x {}", extent.widthTexels, extent.heightTexels);
}

// A picture with its levels, here and on the device.
struct Picture {
    explicit Picture(Extent2D size)
        : extent(size), image(TestDevice(), {.extent = size, .name = "picture", .levels = MipLevels(size)}) {
        CommandList commands(TestDevice());
        for (uint32_t level = 0; level < MipLevels(size); level++) {
            const Extent2D levelExtent = LevelExtent(size, level);
            const Texels noise = RandomValues(levelExtent, 100 + level);
            texels.push_back(ToDouble(levelExtent, noise));
            levels.push_back(Upload(levelExtent, noise));
            commands.Copy(levels.back(), image, 0, level);
        }
        commands.SubmitAndWait();
    }

    int LastLevel() const { return static_cast<int>(levels.size()) - 1; }

    glm::dvec4 Spline(int level, glm::dvec2 uv) const {
        const auto& of = texels[static_cast<size_t>(level)];
        const auto kernel = [](double x) { return reference::BSpline(3, x); };
        return reference::CubicSum(of, uv.x * of.width, uv.y * of.height, kernel, kernel);
    }

    Extent2D extent;
    Image image;
    std::vector<Image> levels;
    std::vector<reference::DoubleImage> texels;
};

// How a picture lies on the screen: texels of level 0 from one pixel to the next.
struct Footprint {
    glm::vec2 acrossTexels;
    glm::vec2 downTexels;

    // Of the sampler (Vulkan's scale factor): the longer one.
    double Level() const {
        return std::log2(std::max(glm::length(glm::dvec2(acrossTexels)), glm::length(glm::dvec2(downTexels))));
    }
};

// Larger across, larger down, alike, mirrored; times a size.
std::vector<Footprint> Footprints(float size) {
    return {{{size, 0}, {0, size}},
            {{size, 0}, {0, 0.25f * size}},
            {{0.375f * size, 0}, {0, size}},
            {{-size, 0}, {0, 0.5f * size}}};
}

MipConstants Constants(Extent2D extent, const Footprint& footprint) {
    const glm::vec2 size(extent.widthTexels, extent.heightTexels);
    return {.acrossUv = footprint.acrossTexels / size,
            .downUv = footprint.downTexels / size,
            .startUv = glm::vec2(0.1f),
            .extentTexels = {extent.widthTexels, extent.heightTexels},
            .baseLevel = static_cast<int>(MetaBaseLevel(kLineTexels, extent)),
            .level = 0};
}

glm::dvec2 UvAt(const MipConstants& constants, uint32_t x, uint32_t y) {
    return glm::dvec2(constants.acrossUv) * (x + 0.5) + glm::dvec2(constants.downUv) * (y + 0.5) +
           glm::dvec2(constants.startUv);
}

struct Drawn {
    Texels colours;
    std::vector<float> levels;
};

class Bench {
public:
    Bench() : m_line(TestDevice(), {kLineTexels, 1}) {}

    Drawn Draw(const std::string& form, const Image& source, const MipConstants& constants, const Image& meta) {
        if (!m_pipelines.contains(form))
            m_pipelines.emplace(
                form,
                Pipeline(TestDevice(), {.vertex = passes_shaders::Find("shaders/quad.vs"),
                                        .pixel = test_support_shaders::Find("shaders/bspline_mip.ps.FORM=" + form),
                                        .targets = {Format::RGBA32F, Format::RGBA32F}}));
        const Image colour(TestDevice(), {kScreen, Format::RGBA32F, "colour"});
        const Image level(TestDevice(), {kScreen, Format::RGBA32F, "level"});
        const Image metaLine =
            FromBaseLevel(TestDevice(), m_line.Levels(), static_cast<uint32_t>(constants.baseLevel));
        CommandList commands(TestDevice());
        commands.Draw({.name = form,
                       .pipeline = m_pipelines.at(form),
                       .reads = {{"source", &source}, {"meta", &meta}, {"metaLine", &metaLine}},
                       .writes = {&colour, &level},
                       .constants = ConstantBytes(constants)});
        commands.SubmitAndWait();
        Drawn drawn{Download(colour), {}};
        for (const glm::vec4& texel : Download(level))
            drawn.levels.push_back(texel.x);
        return drawn;
    }

private:
    MetaMipmap m_line;
    std::map<std::string, Pipeline> m_pipelines;
};

void ExpectNear(const glm::vec4& value, const glm::dvec4& expected, double tolerance, const std::string& what) {
    for (int c = 0; c < 4; c++)
        ASSERT_NEAR(value[c], expected[c], tolerance) << what;
}

TEST(BSplineMip, OneLevelIsThePlainFormOnItsPicture) {
    Bench bench;
    for (const Extent2D extent : kExtents) {
        const Picture picture(extent);
        const MetaMipmap meta(TestDevice(), extent);
        for (int level = 0; level <= picture.LastLevel(); level++) {
            MipConstants constants = Constants(extent, {{1.25f, 0.25f}, {-0.25f, 1.5f}});
            constants.level = level;
            const Drawn ofMips = bench.Draw("ONE_LEVEL", picture.image, constants, meta.Levels());
            const Image& alone = picture.levels[static_cast<size_t>(level)];
            constants.extentTexels = {alone.Extent().widthTexels, alone.Extent().heightTexels};
            const Drawn plain = bench.Draw("PLAIN", alone, constants, meta.Levels());
            for (uint32_t i = 0; i < kScreen.Texels(); i++) {
                ExpectNear(ofMips.colours[i], plain.colours[i], 2e-6, Text(extent));
                ExpectNear(plain.colours[i],
                           picture.Spline(level, UvAt(constants, i % kScreen.widthTexels, i / kScreen.widthTexels)),
                           2e-5, Text(extent));
            }
        }
    }
}

TEST(BSplineMip, NearestTakesTheLevelOfTheFootprint) {
    Bench bench;
    for (const Extent2D extent : kExtents) {
        const Picture picture(extent);
        const MetaMipmap meta(TestDevice(), extent);
        for (const float size : {0.5f, 1.25f, 2.0f, 3.25f, 8.0f, 1000.0f})
            for (const Footprint& footprint : Footprints(size)) {
                const MipConstants constants = Constants(extent, footprint);
                const int level =
                    std::clamp(static_cast<int>(std::lround(footprint.Level())), 0, picture.LastLevel());
                for (const std::string form : {"META_NEAREST", "LINE_NEAREST"}) {
                    const Drawn drawn = bench.Draw(form, picture.image, constants, meta.Levels());
                    for (uint32_t i = 0; i < kScreen.Texels(); i += 7) {
                        ASSERT_EQ(drawn.levels[i], level) << form << " " << Text(extent) << " " << size;
                        ExpectNear(
                            drawn.colours[i],
                            picture.Spline(level, UvAt(constants, i % kScreen.widthTexels, i / kScreen.widthTexels)),
                            size > 100 ? 1e-3 : 3e-5, fmt::format("{} {} {}", form, Text(extent), size));
                    }
                }
            }
    }
}

TEST(BSplineMip, LinearBlendsBothLevelsByTheFraction) {
    Bench bench;
    double worst = 0;
    for (const Extent2D extent : kExtents) {
        const Picture picture(extent);
        const MetaMipmap meta(TestDevice(), extent);
        for (const float size : {0.5f, 1.25f, 2.0f, 3.25f, 11.0f})
            for (const Footprint& footprint : Footprints(size)) {
                const MipConstants constants = Constants(extent, footprint);
                const double level = std::clamp(footprint.Level(), 0.0, static_cast<double>(picture.LastLevel()));
                for (const std::string form : {"META_LINEAR", "LINE_LINEAR", "QUERY"}) {
                    const Drawn drawn = bench.Draw(form, picture.image, constants, meta.Levels());
                    for (uint32_t i = 0; i < kScreen.Texels(); i += 7) {
                        const double taken = drawn.levels[i];
                        worst = std::max(worst, std::abs(taken - level));
                        ASSERT_GE(taken, 0);
                        ASSERT_LE(taken, picture.LastLevel());
                        const int finer = static_cast<int>(std::floor(taken));
                        const glm::dvec2 uv = UvAt(constants, i % kScreen.widthTexels, i / kScreen.widthTexels);
                        glm::dvec4 expected = picture.Spline(finer, uv);
                        if (taken > finer)
                            expected = glm::mix(expected, picture.Spline(finer + 1, uv), taken - finer);
                        ExpectNear(drawn.colours[i], expected, 3e-5,
                                   fmt::format("{} {} {}", form, Text(extent), size));
                    }
                }
            }
    }
    RecordProperty("level_error", fmt::format("{:.3g}", worst));
    EXPECT_LE(worst, kSamplersLogarithm);
}

// Turned footprints: samplers may take lengths loosely, but the line must do as the picture's own sampler does.
TEST(BSplineMip, TheLineFindsTheLevelsOfEveryAspectRatio) {
    Bench bench;
    double worst = 0, worstQuery = 0;
    for (const Extent2D extent : kExtents) {
        const MetaMipmap meta(TestDevice(), extent);
        for (const Footprint& footprint :
             {Footprint{{3, 1}, {-1, 3}}, {{5, -4}, {0.5f, 0.25f}}, {{1, 1}, {-2, 6}}, {{0.1f, 1.9f}, {0.7f, 0}}}) {
            const MipConstants constants = Constants(extent, footprint);
            const Drawn square = bench.Draw("META_LINEAR", meta.Levels(), constants, meta.Levels());
            const Drawn line = bench.Draw("LINE_LINEAR", meta.Levels(), constants, meta.Levels());
            const Drawn query = bench.Draw("QUERY", meta.Levels(), constants, meta.Levels());
            for (size_t i = 0; i < square.levels.size(); i++) {
                worst = std::max(worst, static_cast<double>(std::abs(line.levels[i] - square.levels[i])));
                worstQuery = std::max(worstQuery, static_cast<double>(std::abs(query.levels[i] - square.levels[i])));
            }
        }
    }
    RecordProperty("by_line", fmt::format("{:.3g}", worst));
    RecordProperty("by_query", fmt::format("{:.3g}", worstQuery));
    EXPECT_LE(worst, kSamplersLogarithm);
    EXPECT_LE(worstQuery, kSamplersLogarithm);
}

TEST(BSplineMip, ABaseLevelLeavesAsManyLevelsAsTheTextureHas) {
    for (const Extent2D extent : kExtents) {
        const MetaMipmap line(TestDevice(), {kLineTexels, 1});
        const uint32_t base = MetaBaseLevel(kLineTexels, extent);
        const Image left = FromBaseLevel(TestDevice(), line.Levels(), base);
        EXPECT_EQ(left.Desc().levels, MipLevels(extent)) << Text(extent);
        EXPECT_EQ(left.Extent(), (Extent2D{kLineTexels >> base, 1})) << Text(extent);
    }
    EXPECT_EQ(MetaBaseLevel(1024, {1024, 512}), 0u);
    EXPECT_EQ(MetaBaseLevel(1024, {1, 1}), 10u);
    EXPECT_ERROR(MetaBaseLevel(1024, {16, 2048}),
                 "a meta-mipmap of 1024 texels for a texture of 16 x 2048: it serves textures up to its own size");
}

// Sigg 2005: the chapter fetches at the moved coordinates without naming a level. They are those of a few places a
// texel, with jumps between them.
TEST(BSplineMip, MovedCoordinatesFindOtherLevels) {
    Bench bench;
    const Extent2D extent{128, 64};
    const MetaMipmap meta(TestDevice(), extent);
    MipConstants constants = Constants(extent, {{2.5f, 0}, {0, 2.5f}});
    constants.level = 1;
    const Drawn smooth = bench.Draw("QUERY", meta.Levels(), constants, meta.Levels());
    const Drawn moved = bench.Draw("MOVED", meta.Levels(), constants, meta.Levels());
    double least = 99, most = 0;
    for (size_t i = 0; i < smooth.levels.size(); i++) {
        ASSERT_NEAR(smooth.levels[i], std::log2(2.5), kSamplersLogarithm);
        least = std::min<double>(least, moved.levels[i]);
        most = std::max<double>(most, moved.levels[i]);
    }
    RecordProperty("moved", fmt::format("{:.3g} to {:.3g}", least, most));
    EXPECT_LT(least, std::log2(2.5) - 0.2);
    EXPECT_GT(most, std::log2(2.5) + 0.2);
}

TEST(BSplineMip, CountsAreFourAndEightAndOneOfTheMetaMipmap) {
    const auto fetches = [](const std::string& form) {
        return FetchesIn(test_support_shaders::Find("shaders/bspline_mip.ps.FORM=" + form).spirv);
    };
    using Counts = std::map<std::string, int>;
    EXPECT_EQ(fetches("ONE_LEVEL"), (Counts{{"source", 4}}));
    EXPECT_EQ(fetches("LINE_NEAREST"), (Counts{{"source", 4}, {"metaLine", 1}}));
    EXPECT_EQ(fetches("LINE_LINEAR"), (Counts{{"source", 8}, {"metaLine", 1}}));
    EXPECT_EQ(fetches("META_LINEAR"), (Counts{{"source", 8}, {"meta", 1}}));
    EXPECT_EQ(fetches("QUERY"), (Counts{{"source", 8}}));
}

}  // namespace
}  // namespace boxcar
