// The mean through the mip chain, against a sum in double.
#include "runtime/passes/mean.h"

#include <gtest/gtest.h>

#include <bit>

#include "tests/support/device_image.h"

namespace boxcar {
namespace {

TEST(Mean, OfAnySizeIsTheMeanOfAllTexels) {
    for (const Extent2D extent : {Extent2D{1, 1}, Extent2D{1, 6}, Extent2D{3, 3}, Extent2D{12, 19}, Extent2D{49, 2},
                                  Extent2D{100, 300}, Extent2D{513, 255}}) {
        const Texels source = RandomValues(extent, 51);
        glm::dvec4 sum(0);
        for (const glm::vec4& texel : source)
            sum += glm::dvec4(texel);
        Mean mean(TestDevice(), extent);
        const Image image = Upload(extent, source);
        CommandList commands(TestDevice());
        const Image& result = mean.Record(commands, image);
        commands.SubmitAndWait();
        ASSERT_EQ(result.Extent(), (Extent2D{1, 1}));
        const double depth = std::bit_width(extent.widthTexels - 1) + std::bit_width(extent.heightTexels - 1) + 1;
        for (int c = 0; c < 4; c++)
            EXPECT_NEAR(Download(result)[0][c], sum[c] / static_cast<double>(source.size()), 2 * depth * 0x1p-24)
                << extent.widthTexels << " x " << extent.heightTexels;
    }
}

TEST(Mean, OfWholeCodesIsExactBeforeItsDivision) {
    const Extent2D extent{37, 21};
    const Texels source = RandomCodes(extent, 52);
    double sum = 0;
    for (const glm::vec4& texel : source)
        sum += texel.x;
    Mean mean(TestDevice(), extent);
    const Texels result = RunOnDevice(extent, source, [&](CommandList& commands, const Image& image) -> const Image& {
        return mean.Record(commands, image);
    });
    EXPECT_FLOAT_EQ(result[0].x, static_cast<float>(sum / (37 * 21)));
}

}  // namespace
}  // namespace boxcar
