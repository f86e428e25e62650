// The comparator is tested too.
#include "tests/reference/similarity.h"

#include <gtest/gtest.h>

namespace boxcar {
namespace {

using Picture = std::vector<glm::vec4>;

TEST(Similarity, OfEqualPicturesIsOne) {
    Picture picture;
    for (int i = 0; i < 20 * 11; i++)
        picture.emplace_back(0.37f * static_cast<float>(i % 7) / 3, 0.1f * static_cast<float>(i % 3), 0.5f, 1);
    EXPECT_DOUBLE_EQ(reference::StructuralSimilarity(20, 11, picture, picture), 1);
}

// Without structure only the means are left: luminances 0 and 1 give C1 / (1 + C1).
TEST(Similarity, OfBlackAndWhiteIsAlmostNothing) {
    const Picture black(9 * 8, glm::vec4(0)), white(9 * 8, glm::vec4(1));
    EXPECT_NEAR(reference::StructuralSimilarity(9, 8, black, white), 1e-4 / 1.0001, 1e-12);
}

// Stripes of 0 and 1 against their negative: means 1/2, variances 1/4, covariance -1/4.
TEST(Similarity, OfANegativeIsNegative) {
    Picture stripes, negative;
    for (int i = 0; i < 64; i++) {
        stripes.emplace_back(static_cast<float>(i % 2));
        negative.emplace_back(static_cast<float>(1 - i % 2));
    }
    EXPECT_NEAR(reference::StructuralSimilarity(8, 8, stripes, negative), (-0.5 + 9e-4) / (0.5 + 9e-4), 1e-9);
}

}  // namespace
}  // namespace boxcar
