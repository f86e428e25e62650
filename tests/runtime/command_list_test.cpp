#include "runtime/command_list.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "passes_shaders.h"
#include "runtime/passes/summed_area_table.h"
#include "runtime/ping_pong.h"
#include "test_support_shaders.h"
#include "tests/hlsl/test_constants.h"
#include "tests/support/device_codes.h"
#include "tests/support/device_image.h"
#include "tests/support/expect_error.h"

namespace boxcar {
namespace {

Pipeline SubtractPipeline() {
    return {TestDevice(),
            {passes_shaders::Find("shaders/quad.vs"), test_support_shaders::Find("shaders/subtract.ps")}};
}

TEST(CommandList, TargetsAreWrittenTopRowFirstWithPixelCentresOnHalves) {
    const Extent2D extent{3, 2};
    const Pipeline pipeline(TestDevice(), {passes_shaders::Find("shaders/quad.vs"),
                                           test_support_shaders::Find("shaders/two_targets.ps"),
                                           {Format::RGBA32F, Format::RGBA32F}});
    const Image left = Upload(extent, Texels(6, glm::vec4(1))), right = Upload(extent, Texels(6, glm::vec4(2)));
    const Image address(TestDevice(), {extent, Format::RGBA32F, "address"});
    const Image sum(TestDevice(), {extent, Format::RGBA32F, "sum"});
    CommandList commands(TestDevice());
    commands.Draw({.name = "both",
                   .pipeline = pipeline,
                   .reads = {{"right", &right}, {"left", &left}},
                   .writes = {&address, &sum}});
    commands.SubmitAndWait();
    const Texels addresses = Download(address);
    for (int y = 0; y < 2; y++)
        for (int x = 0; x < 3; x++) {
            const glm::vec4 texel = addresses[3 * y + x];
            EXPECT_EQ(texel.x, x);
            EXPECT_EQ(texel.y, y);
            EXPECT_NEAR(texel.z, (x + 0.5) / 3, 1e-6);
            EXPECT_NEAR(texel.w, (y + 0.5) / 2, 1e-6);
        }
    EXPECT_EQ(Download(sum), Texels(6, glm::vec4(3)));
}

TEST(CommandList, EachRecordsIntoTheBufferOfOneThatIsGone) {
    const auto record = [](bool submits) {
        CommandList commands(TestDevice());
        const Image image(TestDevice(), {{1, 1}, Format::RGBA32F, "one texel"});
        commands.Clear(image, {1, 2, 3, 4});
        if (submits) commands.SubmitAndWait();
        return commands.Handle();
    };
    const VkCommandBuffer first = record(true);
    EXPECT_EQ(record(false), first);
    EXPECT_EQ(record(true), first);
    const CommandList one(TestDevice()), other(TestDevice());
    EXPECT_NE(one.Handle(), other.Handle());
}

TEST(CommandList, AreaLimitsWhatIsDrawnAndTheRestKeepsItsValue) {
    const Extent2D extent{4, 3};
    const Pipeline pipeline = SubtractPipeline();
    const Image source = Upload(extent, Texels(12, glm::vec4(10)));
    const Image target = Upload(extent, Texels(12, glm::vec4(-1)));
    const SubtractConstants constants{glm::vec4(4)};
    CommandList commands(TestDevice());
    commands.Draw({.name = "part",
                   .pipeline = pipeline,
                   .reads = {{"source", &source}},
                   .writes = {&target},
                   .constants = ConstantBytes(constants),
                   .area = Rect{1, 1, 2, 1}});
    commands.SubmitAndWait();
    Texels expected(12, glm::vec4(-1));
    expected[5] = expected[6] = glm::vec4(6);
    EXPECT_EQ(Download(target), expected);
}

TEST(CommandList, ClearSetsEveryTexelAndConvertsToTheFormat) {
    const Image image(TestDevice(), {{5, 5}, Format::RGBA8, "cleared"});
    CommandList commands(TestDevice());
    commands.Clear(image, {1, 0, 0.2f, 1});
    commands.SubmitAndWait();
    std::vector<uint8_t> bytes(100);
    ReadTexels(TestDevice(), image, std::as_writable_bytes(std::span(bytes)));
    for (size_t i = 0; i < 100; i += 4)
        EXPECT_EQ(std::vector<uint8_t>(&bytes[i], &bytes[i] + 4), std::vector<uint8_t>({255, 0, 51, 255}));

    const Image words(TestDevice(), {{1, 1}, Format::RGBA32UI, "cleared words"});
    CommandList more(TestDevice());
    more.Clear(words, {1, 0, 3, 65536});
    more.SubmitAndWait();
    EXPECT_EQ(DownloadWords(words)[0], glm::uvec4(1, 0, 3, 65536));
}

TEST(CommandList, RefusesPassesThatDoNotFitTheirShadersAndNamesThem) {
    const Pipeline pipeline = SubtractPipeline();
    const Image a(TestDevice(), {{4, 4}, Format::RGBA32F, "a"});
    const Image b(TestDevice(), {{4, 4}, Format::RGBA32F, "b"});
    const Image half(TestDevice(), {{4, 4}, Format::RGBA16F, "half"});
    const SubtractConstants constants{};
    const auto bytes = ConstantBytes(constants);
    CommandList commands(TestDevice());
    EXPECT_ERROR(commands.Draw({.name = "p", .pipeline = pipeline, .writes = {&b}, .constants = bytes}),
                 "pass 'p' gives nothing to read as 'source' of shaders/subtract.ps");
    EXPECT_ERROR(
        commands.Draw(
            {.name = "p", .pipeline = pipeline, .reads = {{"source", &a}}, .writes = {&a}, .constants = bytes}),
        "pass 'p' reads and writes 'a' at once: what it would read is undefined");
    EXPECT_ERROR(
        commands.Draw(
            {.name = "p", .pipeline = pipeline, .reads = {{"source", &a}}, .writes = {&half}, .constants = bytes}),
        "pass 'p' writes 'half', which is RGBA16F: its pipeline writes RGBA32F");
    EXPECT_ERROR(
        commands.Draw(
            {.name = "p", .pipeline = pipeline, .reads = {{"source", &a}}, .writes = {&b, &b}, .constants = bytes}),
        "pass 'p' writes 2 images, its pipeline 1");
    const Image volume(TestDevice(), {.extent = {4, 4}, .name = "volume", .depthTexels = 1});
    EXPECT_ERROR(
        commands.Draw(
            {.name = "p", .pipeline = pipeline, .reads = {{"source", &volume}}, .writes = {&b}, .constants = bytes}),
        "pass 'p' gives 'volume', a volume, to read as 'source' of shaders/subtract.ps, which is a 2D image");
    EXPECT_ERROR(
        commands.Draw(
            {.name = "p", .pipeline = pipeline, .reads = {{"source", &a}}, .writes = {&volume}, .constants = bytes}),
        "pass 'p' writes 'volume', which is a volume: draw into an image and read that");
    EXPECT_ERROR(commands.Draw({.name = "p", .pipeline = pipeline, .reads = {{"source", &a}}, .writes = {&b}}),
                 "pass 'p' has 0 bytes of constants, shaders/subtract.ps takes 16");
}

// More passes than one descriptor pool holds.
TEST(CommandList, TakesHundredsOfPasses) {
    const Extent2D extent{2, 2};
    const Pipeline pipeline = SubtractPipeline();
    const Image source = Upload(extent, Texels(4, glm::vec4(300)));
    PingPong targets(TestDevice(), {extent, Format::RGBA32F, "many"});
    const SubtractConstants constants{glm::vec4(1)};
    CommandList commands(TestDevice());
    const Image* from = &source;
    for (int i = 0; i < 300; i++) {
        commands.Draw({.name = "minus one",
                       .pipeline = pipeline,
                       .reads = {{"source", from}},
                       .writes = {&targets.Back()},
                       .constants = ConstantBytes(constants)});
        targets.Swap();
        from = &targets.Front();
    }
    commands.SubmitAndWait();
    EXPECT_EQ(Download(*from), Texels(4, glm::vec4(0)));
}

TEST(CommandList, TimesEachPassByName) {
    const Extent2D extent{64, 64};
    const Image source = Upload(extent, Texels(extent.Texels(), glm::vec4(1)));
    SummedAreaTable table(TestDevice(), {.extent = extent, .taps = 8});
    const Image bias = Upload({1, 1}, Texels(1, glm::vec4(1)));
    CommandList commands(TestDevice(), CommandList::Timing::On);
    table.Record(commands, source, &bias);
    commands.SubmitAndWait();
    std::vector<std::string> names;
    for (const PassTime& pass : commands.PassTimes()) {
        names.push_back(pass.name);
        EXPECT_GT(pass.milliseconds, 0);
        EXPECT_LT(pass.milliseconds, 60000);
    }
    EXPECT_EQ(names, std::vector<std::string>({"take off bias", "table x0", "table x1", "table y0", "table y1"}));
}

// More passes than one pool of timestamps holds.
TEST(CommandList, TimesHundredsOfPasses) {
    constexpr size_t kPasses = 600;
    const Pipeline pipeline = SubtractPipeline();
    const Image source = Upload({1, 1}, Texels(1));
    const Image target(TestDevice(), {{1, 1}, Format::RGBA32F, "timed"});
    const SubtractConstants constants{};
    CommandList commands(TestDevice(), CommandList::Timing::On);
    for (size_t i = 0; i < kPasses; i++)
        commands.Draw({.name = std::to_string(i),
                       .pipeline = pipeline,
                       .reads = {{"source", &source}},
                       .writes = {&target},
                       .constants = ConstantBytes(constants)});
    commands.SubmitAndWait();
    const std::vector<PassTime> times = commands.PassTimes();
    ASSERT_EQ(times.size(), kPasses);
    for (size_t i = 0; i < kPasses; i++) {
        EXPECT_EQ(times[i].name, std::to_string(i));
        EXPECT_GE(times[i].milliseconds, 0);
        EXPECT_LT(times[i].milliseconds, 60000);
    }
}

// An engine's own command buffer: Boxcar records into it, the engine ends and submits it.
TEST(CommandList, WrapsAnEnginesCommandBuffer) {
    const AdoptedDevice engine = TestDevice().Handles();
    const Extent2D extent{8, 8};
    const Image source = Upload(extent, Texels(64, glm::vec4(1)));
    SummedAreaTable table(TestDevice(), {.extent = extent});

    VkCommandPool pool;
    const VkCommandPoolCreateInfo poolInfo{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO, nullptr, 0,
                                           engine.queueFamily};
    ASSERT_EQ(vkCreateCommandPool(engine.device, &poolInfo, nullptr, &pool), VK_SUCCESS);
    VkCommandBuffer buffer;
    const VkCommandBufferAllocateInfo bufferInfo{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO, nullptr, pool,
                                                 VK_COMMAND_BUFFER_LEVEL_PRIMARY, 1};
    ASSERT_EQ(vkAllocateCommandBuffers(engine.device, &bufferInfo, &buffer), VK_SUCCESS);
    const VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO, nullptr, 0, nullptr};
    ASSERT_EQ(vkBeginCommandBuffer(buffer, &begin), VK_SUCCESS);

    CommandList commands(TestDevice(), buffer);
    EXPECT_EQ(commands.Handle(), buffer);
    const Image& sums = *table.Record(commands, source).low;

    ASSERT_EQ(vkEndCommandBuffer(buffer), VK_SUCCESS);
    VkSubmitInfo submit{};
    submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
    submit.commandBufferCount = 1;
    submit.pCommandBuffers = &buffer;
    ASSERT_EQ(vkQueueSubmit(engine.queue, 1, &submit, VK_NULL_HANDLE), VK_SUCCESS);
    ASSERT_EQ(vkQueueWaitIdle(engine.queue), VK_SUCCESS);
    EXPECT_EQ(Download(sums)[63], glm::vec4(64));
    vkDestroyCommandPool(engine.device, pool, nullptr);
}

// The validation layer must see what the runtime exists to prevent: a copy out of a target that is still being drawn.
// In the general layout no layout error can give it away, only synchronization validation can.
TEST(Validation, CatchesAMissingBarrier) {
    const Extent2D extent{16, 16};
    const Pipeline pipeline = SubtractPipeline();
    const Image source = Upload(extent, Texels(256, glm::vec4(1)));
    const Image target(TestDevice(), {extent, Format::RGBA32F, "raced"});
    const Image copy(TestDevice(), {extent, Format::RGBA32F, "copy"});
    const SubtractConstants constants{};

    CommandList commands(TestDevice());
    commands.Use(copy, ImageUse::TransferTarget);
    commands.Use(source, ImageUse::ShaderRead);
    commands.Draw({.name = "draw",
                   .pipeline = pipeline,
                   .reads = {{"source", &source}},
                   .writes = {&target},
                   .constants = ConstantBytes(constants)});
    // To the transfer layout, but after no stage: nothing waits for the draw.
    const VkImageMemoryBarrier2 barrier{.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2,
                                        .pNext = nullptr,
                                        .srcStageMask = VK_PIPELINE_STAGE_2_NONE,
                                        .srcAccessMask = VK_ACCESS_2_NONE,
                                        .dstStageMask = VK_PIPELINE_STAGE_2_TRANSFER_BIT,
                                        .dstAccessMask = VK_ACCESS_2_TRANSFER_READ_BIT,
                                        .oldLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                                        .newLayout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                                        .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                                        .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                                        .image = target.Handle(),
                                        .subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1}};
    VkDependencyInfo dependency{};
    dependency.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
    dependency.imageMemoryBarrierCount = 1;
    dependency.pImageMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands.Handle(), &dependency);
    VkImageCopy region{};
    region.srcSubresource = region.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.extent = {16, 16, 1};
    vkCmdCopyImage(commands.Handle(), target.Handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, copy.Handle(),
                   VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
    commands.SubmitAndWait();

    const std::vector<std::string> messages = TakeValidationMessages();
    if (messages.empty() && ValidationLayerVersion() < VK_MAKE_API_VERSION(0, 1, 4, 0))
        GTEST_SKIP() << "this validation layer is older than 1.4 and does not follow drawing without render passes";
    ASSERT_FALSE(messages.empty());
    EXPECT_NE(messages[0].find("WRITE_AFTER_WRITE hazard detected"), std::string::npos) << messages[0];
}

}  // namespace
}  // namespace boxcar
