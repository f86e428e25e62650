// Small pictures of every effect, as they were when somebody looked at them. What they prove is that nothing has
// changed; what is right is proven by the tests of each effect.
//
//   BOXCAR_BLESS=1 test_effects --gtest_filter='*Golden*'   writes them anew: only on lavapipe, and look at them
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "samples/files/color.h"
#include "tests/effects/effect_pictures.h"
#include "tests/support/compare_pictures.h"

namespace boxcar {
namespace {

constexpr Extent2D kExtent{160, 100};

// Between Mesa 22 and 25 (goldens.txt says which made them) edges fall to the other side of a pixel and a code or two
// differ elsewhere.
constexpr PictureTolerance kTolerance{.perSample = 3.01f / 255, .failingFraction = 0.005, .meanDifference = 0.001};

Picture Shown(const Texels& texels) {
    Picture picture{kExtent.widthTexels, kExtent.heightTexels, 3, SampleType::Unorm8, {}};
    for (const glm::vec4& texel : texels)
        for (int c = 0; c < 3; c++)
            picture.samples.push_back(std::clamp(texel[c], 0.0f, 1.0f));
    EncodeSrgb(picture);
    for (float& sample : picture.samples)
        sample = std::round(sample * 255) / 255;
    return picture;
}

bool IsBlessing() {
    return std::getenv("BOXCAR_BLESS") != nullptr;
}

class Golden : public testing::TestWithParam<std::string> {};

TEST_P(Golden, IsWhatItWas) {
    const std::string path = std::string(BOXCAR_GOLDENS "/") + GetParam() + ".png";
    const Picture picture = Shown(EffectPictures(GetParam(), kExtent).Picture({}, 0.5));
    if (IsBlessing()) {
        ASSERT_EQ(TestDevice().Info().kind, "CPU") << "goldens are made on lavapipe";
        WritePicture(picture, path, FileFormat::Png, SampleType::Unorm8);
        std::ofstream(BOXCAR_GOLDENS "/goldens.txt") << TestDevice().Info().driver << "\n";
        return;
    }
    const PictureDifference difference = ComparePictures(picture, ReadPicture(path), kTolerance);
    if (difference.isWithin) return;
    const std::string left =
        (std::filesystem::temp_directory_path() / ("difference-" + GetParam() + ".png")).string();
    if (!difference.picture.samples.empty())
        WritePicture(difference.picture, left, FileFormat::Png, SampleType::Unorm8);
    ADD_FAILURE() << difference.report << "\nthe difference: " << left;
}

INSTANTIATE_TEST_SUITE_P(All, Golden, testing::ValuesIn(EffectNames()), [](const auto& test) {
    std::string name = test.param;
    std::ranges::replace(name, '-', '_');
    return name;
});

// The comparator itself.
Picture Grey(uint32_t width, uint32_t height, float value) {
    return {width, height, 1, SampleType::Unorm8, std::vector(size_t{width} * height, value)};
}

TEST(ComparePictures, SaysWhereAndWhatAndWhatWouldPass) {
    Picture actual = Grey(4, 3, 0.5f);
    actual.samples[6] = 0.75f;
    const PictureDifference difference = ComparePictures(actual, Grey(4, 3, 0.5f), {.perSample = 0.1f});
    EXPECT_FALSE(difference.isWithin);
    EXPECT_EQ(
        difference.report,
        "worst at (2, 1), channel 0: expected 0.5, actual 0.75; 1 of 12 pixels (8.3333 %) differ by more than 0.1, "
        "the mean by 0.020833; perSample 0.25 would have passed");
    EXPECT_EQ(difference.picture.samples[6], 1);
    EXPECT_EQ(difference.picture.samples[5], 0);
    EXPECT_TRUE(ComparePictures(actual, Grey(4, 3, 0.5f), {.perSample = 0.25f}).isWithin);
    EXPECT_TRUE(ComparePictures(actual, Grey(4, 3, 0.5f), {.perSample = 0.1f, .failingFraction = 0.1}).isWithin);
}

TEST(ComparePictures, SeesAnotherBrightnessThatNoPixelShows) {
    const PictureTolerance tolerance{.perSample = 0.02f, .meanDifference = 0.001};
    EXPECT_FALSE(ComparePictures(Grey(9, 9, 0.51f), Grey(9, 9, 0.5f), tolerance).isWithin);
}

TEST(ComparePictures, PassesOverWhatIsMaskedAndFailsOnNaNAndOtherSizes) {
    Picture actual = Grey(4, 3, 0.5f);
    actual.samples[6] = 0;
    std::vector<bool> mask(12, true);
    mask[6] = false;
    EXPECT_TRUE(ComparePictures(actual, Grey(4, 3, 0.5f), {}, mask).isWithin);
    actual.samples[6] = NAN;
    EXPECT_FALSE(ComparePictures(actual, Grey(4, 3, 0.5f), {.perSample = 1}).isWithin);
    EXPECT_FALSE(ComparePictures(actual, Grey(3, 4, 0.5f), {.perSample = 1}).isWithin);
}

}  // namespace
}  // namespace boxcar
