// Texture filters against 256 samples a pixel. Alpha of the effect's picture is the light that white would give off,
// so a texel over it is what the filter made of the texture; 0 where nothing is.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "effects_shaders.h"
#include "hlsl/constants/effect_constants.h"
#include "samples/scenes/camera.h"
#include "tests/effects/effect_pictures.h"
#include "tests/support/offsets.h"

namespace boxcar {
namespace {

constexpr Extent2D kExtent{240, 136};
constexpr int kWidth = kExtent.widthTexels, kHeight = kExtent.heightTexels;

EffectPictures Pictures(const Settings& fixed) {
    return {"texture-filtering", kExtent, fixed};
}

size_t At(int x, int y) {
    return static_cast<size_t>(y * kWidth + x);
}

// What the filter made of the texture there.
double Value(const Texels& picture, int x, int y) {
    const glm::vec4 texel = picture[At(x, y)];
    return texel.y / texel.w;
}

// Pixels that a thing covers wholly: those whose neighbours it covers too. Silhouettes take no part.
std::vector<glm::ivec2> CoveredPixels(const Texels& picture) {
    std::vector<glm::ivec2> covered;
    for (int y = 1; y < kHeight - 1; y++)
        for (int x = 1; x < kWidth - 1; x++) {
            bool isCovered = true;
            for (int dy = -1; dy <= 1; dy++)
                for (int dx = -1; dx <= 1; dx++)
                    isCovered = isCovered && picture[At(x + dx, y + dy)].w > 0;
            if (isCovered) covered.emplace_back(x, y);
        }
    return covered;
}

// Of what the filter made of the texture: light that varies over the picture takes no part. Peak 1.
double Psnr(const Texels& picture, const Texels& reference, const std::vector<glm::ivec2>& pixels) {
    double sum = 0;
    for (const glm::ivec2 p : pixels) {
        const double difference = Value(picture, p.x, p.y) - Value(reference, p.x, p.y);
        sum += difference * difference;
    }
    return -10 * std::log10(sum / static_cast<double>(pixels.size()));
}

std::map<std::string, double> PsnrOfFilters(EffectPictures& pictures, const Settings& settings) {
    const auto picture = [&](const char* filter) {
        Settings all = settings;
        all.emplace_back("filter", filter);
        return pictures.Picture(all);
    };
    const Texels reference = picture("reference");
    const auto pixels = CoveredPixels(picture("nearest"));
    EXPECT_GT(pixels.size(), 4000u);
    std::map<std::string, double> psnr;
    for (const auto& [name, value] : settings)
        std::printf("%s ", value.c_str());
    for (const char* filter : {"nearest", "bilinear", "mip", "mip-filtered", "mip-bspline", "anisotropic", "table"}) {
        psnr[filter] = Psnr(picture(filter), reference, pixels);
        std::printf("| %s %.2f ", filter, psnr[filter]);
    }
    std::printf("dB\n");
    return psnr;
}

// Mip maps of weighted means are printed beside them: no order is claimed. 16 samples of plain ones lead them on
// planes.
TEST(TextureFiltering, TheTableLeadsMipMapsWhereTheTextureLiesUpright) {
    EffectPictures pictures = Pictures({});
    const std::pair<const char*, const char*> textures[] = {{"stripes", "8"}, {"stripes", "24"}, {"checks", "16"}};
    for (const char* scene : {"ellipsoid", "planes"})
        for (const auto& [pattern, repeats] : textures) {
            SCOPED_TRACE(fmt::format("{}, {}, {}", scene, pattern, repeats));
            auto psnr = PsnrOfFilters(pictures, {{"scene", scene}, {"pattern", pattern}, {"repeats", repeats}});
            EXPECT_LT(psnr["nearest"], psnr["bilinear"]);
            EXPECT_LT(psnr["bilinear"], psnr["mip"]);
            EXPECT_LT(psnr["mip"] + 1.5, psnr["table"]);
            if (std::string_view(scene) == "planes") {
                EXPECT_LT(psnr["mip"] + 3, psnr["anisotropic"]);
            }
        }
}

// Turned by 25 degrees, the upright rectangle is no longer what a pixel covers. The ellipsoid's stripes are
// compressed along u nearly everywhere, for which a mip level is right: there the two are equal. On planes the table
// still leads.
TEST(TextureFiltering, ATurnedTextureCostsTheTableItsLeadOnTheEllipsoidButNotOnPlanes) {
    EffectPictures pictures = Pictures({{"repeats", "8"}, {"roll", "25"}});
    for (const char* scene : {"ellipsoid", "planes"}) {
        SCOPED_TRACE(scene);
        auto psnr = PsnrOfFilters(pictures, {{"scene", scene}});
        EXPECT_LT(psnr["nearest"], psnr["bilinear"]);
        EXPECT_LT(psnr["bilinear"] + 10, psnr["table"]);
        if (std::string(scene) == "planes")
            EXPECT_LT(psnr["mip"] + 1.5, psnr["table"]);
        else
            EXPECT_NEAR(psnr["mip"], psnr["table"], 0.5);
    }
}

// Crow 1984, sect. 4: a uniform grey is what a filter should make of stripes that meet. 256 black ones meet at the
// pole: 8 pixels away from it there are four or more a pixel.
TEST(TextureFiltering, StripesBecomeGreyWhereTheyMeetAtAPole) {
    const Camera camera{
        .eyeWorld = {0, 2.7f, 3.0f}, .targetWorld = {0, 0.17f, 0}, .verticalAngleRadians = 0.62f};  // the effect's
    const glm::vec4 clip = ClipFromWorld(camera, kExtent) * glm::vec4(0, 1.2f, 0, 1);
    const glm::vec2 pole = (glm::vec2(clip.x, -clip.y) / clip.w * 0.5f + 0.5f) * glm::vec2(kWidth, kHeight);
    ASSERT_GT(pole.y, 8);
    EffectPictures pictures = Pictures({{"scene", "ellipsoid"}, {"repeats", "64"}});
    const auto covered = CoveredPixels(pictures.Picture({{"filter", "nearest"}}));
    const auto farthestFromGrey = [&](const char* filter) {
        const Texels picture = pictures.Picture({{"filter", filter}});
        double farthest = 0;
        for (const glm::ivec2 p : covered)
            if (glm::length((glm::vec2(p) + 0.5f - pole) * glm::vec2(1, 2)) < 8)
                farthest = std::max(farthest, std::abs(Value(picture, p.x, p.y) - 0.5));
        std::printf("farthest from grey, %s: %.3f\n", filter, farthest);
        return farthest;
    };
    EXPECT_LT(farthestFromGrey("table"), 0.1);
    EXPECT_LT(farthestFromGrey("reference"), 4 * 0.5 / 16) << "256 samples, each black or white: 0.5 / 16 of noise";
    EXPECT_EQ(farthestFromGrey("nearest"), 0.5);
    EXPECT_GT(farthestFromGrey("bilinear"), 0.4);
}

// The rows of a plane one unit above the eye, `k` pixels over the horizon, are f / k away, for a picture of f = H /
// (2 tan(angle / 2)) pixels a unit at distance 1.
double RowDistance(double k) {
    return kHeight / (2 * std::tan(0.4)) / k;
}

constexpr double kCyclesPerUnitAndRepeat =
    4 * 2.5 / 80;  // black and white: of the texture, of a plane, of its length

// A box of n cycles of stripes is off from their mean by 1 / (4 n) at the most. Neighbouring rows share their
// derivative, which may be half of its own for the nearest ones: 1 / (2 n).
TEST(TextureFiltering, SeveralRepetitionsInAPixelTendToTheirMean) {
    const Texels table = Pictures({{"scene", "planes"}, {"filter", "table"}, {"repeats", "64"}}).Picture({});
    int rows = 0, beyondATexture = 0;
    for (int y = 1; y < kHeight / 2; y++) {
        const double k = kHeight / 2.0 - y - 0.5;
        if (RowDistance(k) > 76) break;
        const double cycles = (RowDistance(k - 0.5) - RowDistance(k + 0.5)) * 64 * kCyclesPerUnitAndRepeat;
        if (cycles < 2) continue;
        rows++;
        beyondATexture += cycles > 8;
        for (const int x : {kWidth / 2 - 9, kWidth / 2, kWidth / 2 + 9})
            EXPECT_NEAR(Value(table, x, y), 0.5, 0.5 / cycles) << "row " << y << ", " << cycles << " cycles a pixel";
    }
    EXPECT_GT(rows, 10);
    EXPECT_GT(beyondATexture, 3) << "rows where two textures and more lie in a pixel";
}

// Stripes that run away from the eye are compressed along their length only, and stay two pixels wide and more where
// a pixel is longer than many of them are wide.
TEST(TextureFiltering, AMipMapBlursAcrossTheDirectionOfCompressionAndTheTableDoesNot) {
    EffectPictures pictures = Pictures({{"scene", "planes"}, {"repeats", "16"}});
    const auto contrast = [&](const char* filter) {
        const Texels picture = pictures.Picture({{"filter", filter}});
        double sum = 0;
        for (int k = 10; k < 15; k++) {
            double least = 1, most = 0;
            for (int x = kWidth / 2 - 30; x < kWidth / 2 + 30; x++) {
                const double value = Value(picture, x, kHeight / 2 + k);
                least = std::min(least, value);
                most = std::max(most, value);
            }
            sum += (most - least) / (most + least) / 5;
        }
        std::printf("contrast, %s: %.3f\n", filter, sum);
        return sum;
    };
    EXPECT_GT(contrast("reference"), 0.95);
    EXPECT_GT(contrast("table"), 0.95);
    EXPECT_LT(contrast("mip"), 0.3);
    EXPECT_LT(contrast("mip-filtered"), 0.3);
}

// Where a texel is larger than a pixel nothing is to be averaged, and the table is what a bilinear filter is. The
// nearest rows of the floor are up to 4 units away, a row is 0.1 long there, and a texel 80 / (2.5 * 256) = 0.125.
TEST(TextureFiltering, MagnifiedTheTableIsBilinear) {
    EffectPictures pictures = Pictures({{"scene", "planes"}, {"repeats", "1"}, {"pattern", "checks"}});
    const Texels table = pictures.Picture({{"filter", "table"}});
    const Texels bilinear = pictures.Picture({{"filter", "bilinear"}});
    size_t between = 0;
    for (int y = kHeight - 25; y < kHeight; y++)
        for (int x = 0; x < kWidth; x++) {
            EXPECT_NEAR(Value(table, x, y), Value(bilinear, x, y), 1e-3);
            between += Value(table, x, y) > 0.1 && Value(table, x, y) < 0.9;
        }
    EXPECT_GT(between, 100u);
}

TEST(TextureFiltering, OffsetsInCppEqualThoseInTheShaders) {
    EXPECT_EQ(OffsetsIn(effects_shaders::Find("shaders/texture_pattern.ps")),
              (Offsets{OFFSET(TexturePatternConstants, cells)}));
}

}  // namespace
}  // namespace boxcar
