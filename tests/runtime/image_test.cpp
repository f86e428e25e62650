#include "runtime/image.h"

#include <gtest/gtest.h>

#include "tests/support/device_image.h"
#include "tests/support/expect_error.h"

namespace boxcar {
namespace {

TEST(Image, RefusesASideOfZeroOrOverTheLimit) {
    const uint32_t limit = TestDevice().Limits().maxSideTexels;
    EXPECT_ERROR(Image(TestDevice(), {{0, 5}, Format::R32F, "empty"}),
                 "image 'empty' of 0 x 5 texels: both sides must be at least 1");
    EXPECT_ERROR(Image(TestDevice(), {{limit + 1, 1}, Format::R32F, "wide"}),
                 fmt::format("image 'wide' of {} x 1 texels: the device takes at most {} a side", limit + 1, limit));
}

TEST(Image, RefusesAVolumeOverTheLimitOfItsSides) {
    const uint32_t limit = TestDevice().Limits().maxVolumeSideTexels;
    EXPECT_ERROR(
        Image(TestDevice(), {.extent = {4, 5}, .format = Format::R32F, .name = "deep", .depthTexels = limit + 1}),
        fmt::format("image 'deep' of 4 x 5 x {} texels: the device takes at most {} a side", limit + 1, limit));
    EXPECT_ERROR(Image(TestDevice(), {.extent = {4, 0}, .format = Format::R32F, .name = "flat", .depthTexels = 3}),
                 "image 'flat' of 4 x 0 x 3 texels: both sides must be at least 1");
}

TEST(Image, RefusesWhatFitsTheSidesButNotTheMemoryAndNamesBothSizes) {
    const DeviceLimits& limits = TestDevice().Limits();
    const uint64_t bytes = uint64_t{limits.maxSideTexels} * limits.maxSideTexels * 16;
    if (bytes <= limits.maxImageBytes) GTEST_SKIP() << "this device gives one image all that its sides allow";
    try {
        Image(TestDevice(), {{limits.maxSideTexels, limits.maxSideTexels}, Format::RGBA32F, "huge"});
        FAIL() << "it was made";
    } catch (const Error& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find(fmt::format("takes {} MiB", bytes >> 20)), std::string::npos) << text;
        EXPECT_NE(text.find(fmt::format("at most {} MiB", limits.maxImageBytes >> 20)), std::string::npos) << text;
    }
}

TEST(Image, MovesAndKeepsWhatItHolds) {
    Image a = Upload({2, 1}, {glm::vec4(1), glm::vec4(2)});
    Image b = std::move(a);
    EXPECT_EQ(Download(b)[1], glm::vec4(2));
    b = Upload({1, 1}, {glm::vec4(9)});
    EXPECT_EQ(Download(b)[0], glm::vec4(9));
}

// A wrapped image is the engine's: Boxcar transitions it from where the engine left it, and does not destroy it.
TEST(Image, WrappedIsReadFromTheStateTheEngineLeftItInAndStaysAlive) {
    const Image engines = Upload({3, 2}, Texels(6, glm::vec4(5)));
    const WrappedImage handles{.image = engines.Handle(),
                               .view = engines.View(),
                               .layout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                               .lastStages = VK_PIPELINE_STAGE_2_TRANSFER_BIT,
                               .lastAccess = VK_ACCESS_2_TRANSFER_WRITE_BIT};
    {
        const Image wrapped(TestDevice(), engines.Desc(), handles);
        EXPECT_EQ(Download(wrapped), Texels(6, glm::vec4(5)));
        CommandList commands(TestDevice());
        commands.Use(wrapped, ImageUse::TransferTarget);  // where `engines` believes it to be
        commands.SubmitAndWait();
    }
    const Texels sevens(6, glm::vec4(7));
    WriteTexels(TestDevice(), engines, std::as_bytes(std::span(sevens)));
    EXPECT_EQ(Download(engines), sevens);
}

}  // namespace
}  // namespace boxcar
