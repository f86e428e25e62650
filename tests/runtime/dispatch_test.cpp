// Compute passes, beside draws and on their own.
#include <gtest/gtest.h>
#include <vulkan/vulkan.h>

#include <numeric>

#include "passes_shaders.h"
#include "runtime/command_list.h"
#include "test_support_shaders.h"
#include "tests/hlsl/test_constants.h"
#include "tests/support/device_buffer.h"
#include "tests/support/device_image.h"
#include "tests/support/expect_error.h"

namespace boxcar {
namespace {

ComputePipeline SubtractCompute() {
    return {TestDevice(), test_support_shaders::Find("shaders/subtract.cs")};
}

ComputePipeline TwicePlusOne() {
    return {TestDevice(), test_support_shaders::Find("shaders/twice_plus_one.cs")};
}

Pipeline DrawingPipeline(const char* pixelShader) {
    return {TestDevice(), {passes_shaders::Find("shaders/quad.vs"), test_support_shaders::Find(pixelShader)}};
}

TEST(Dispatch, AndDrawsReadInTurnWhatTheOtherWrote) {
    const Extent2D extent{13, 6};  // groups have 8 x 4 threads: some lie beyond
    const Texels texels = RandomCodes(extent, 1);
    const Image source = Upload(extent, texels);
    const Image one(TestDevice(), {extent, Format::RGBA32F, "one"});
    const Image other(TestDevice(), {extent, Format::RGBA32F, "other"});
    const ComputePipeline compute = SubtractCompute();
    const Pipeline pipeline = DrawingPipeline("shaders/subtract.ps");
    const ThreadGroups groups = compute.GroupsOver(extent.widthTexels, extent.heightTexels);
    EXPECT_EQ(groups, (ThreadGroups{2, 2, 1}));
    const SubtractConstants constants[] = {{glm::vec4(1, 2, 3, 4)}, {glm::vec4(10)}};
    CommandList commands(TestDevice());
    const Image* from = &source;
    for (int round = 0; round < 3; round++) {
        commands.Draw({.name = "draw",
                       .pipeline = pipeline,
                       .reads = {{"source", from}},
                       .writes = {&one},
                       .constants = ConstantBytes(constants[0])});
        commands.Dispatch({.name = "compute",
                           .pipeline = compute,
                           .reads = {{"source", &one}},
                           .storage = {{"target", &other}},
                           .constants = ConstantBytes(constants[1]),
                           .groups = groups});
        from = &other;
    }
    commands.SubmitAndWait();
    const Texels result = Download(other);
    for (size_t i = 0; i < texels.size(); i++)
        EXPECT_EQ(result[i], texels[i] - 3.0f * (constants[0].value + constants[1].value)) << "texel " << i;
}

TEST(Dispatch, PassesABufferToAndFro) {
    Words words(1000);
    std::iota(words.begin(), words.end(), 0u);
    const StorageBuffer one = UploadBuffer(words), other = UploadBuffer(Words(1000));
    const ComputePipeline pipeline = TwicePlusOne();
    const ThreadGroups groups = pipeline.GroupsOver(1000);
    EXPECT_EQ(groups, (ThreadGroups{16, 1, 1}));
    CommandList commands(TestDevice());
    const StorageBuffer* turns[] = {&one, &other};
    for (int i = 0; i < 5; i++)
        commands.Dispatch({.name = "twice plus one",
                           .pipeline = pipeline,
                           .storage = {{"before", turns[i % 2]}, {"after", turns[(i + 1) % 2]}},
                           .groups = groups});
    commands.SubmitAndWait();
    for (uint32_t& word : words)
        word = 32 * word + 31;
    EXPECT_EQ(DownloadBuffer(other), words);
}

TEST(Dispatch, AndDrawsShareBuffers) {
    const Extent2D extent{7, 5};
    const StorageBuffer counts = UploadBuffer({0}), shown = UploadBuffer({100}), result = UploadBuffer({0});
    const Image target(TestDevice(), {extent, Format::RGBA32F, "target"});
    const Pipeline pipeline = DrawingPipeline("shaders/count_pixels.ps");
    const ComputePipeline compute = TwicePlusOne();
    CommandList commands(TestDevice());
    const auto dispatch = [&](const StorageBuffer& before, const StorageBuffer& after) {
        commands.Dispatch(
            {.name = "compute", .pipeline = compute, .storage = {{"before", &before}, {"after", &after}}});
    };
    dispatch(result, shown);  // the draw shows 1
    commands.Draw({.name = "count",
                   .pipeline = pipeline,
                   .storage = {{"shown", &shown}, {"counts", &counts}},
                   .writes = {&target}});
    dispatch(counts, result);
    commands.SubmitAndWait();
    for (const glm::vec4& texel : Download(target))
        EXPECT_EQ(texel.x, 1);
    EXPECT_EQ(DownloadBuffer(counts), Words{35});
    EXPECT_EQ(DownloadBuffer(result), Words{71});
}

TEST(Dispatch, IsTimedByName) {
    const StorageBuffer before = UploadBuffer({1}), after = UploadBuffer({0});
    const ComputePipeline pipeline = TwicePlusOne();
    CommandList commands(TestDevice(), CommandList::Timing::On);
    commands.Dispatch({.name = "timed", .pipeline = pipeline, .storage = {{"before", &before}, {"after", &after}}});
    commands.SubmitAndWait();
    const std::vector<PassTime> times = commands.PassTimes();
    ASSERT_EQ(times.size(), 1u);
    EXPECT_EQ(times[0].name, "timed");
    EXPECT_GT(times[0].milliseconds, 0);
}

TEST(Dispatch, RefusesImagesThatDoNotFitAndNamesThem) {
    const ComputePipeline pipeline = SubtractCompute();
    const auto image = [](const char* name, Format format = Format::RGBA32F) {
        return Image(TestDevice(), {{4, 4}, format, name});
    };
    const Image a = image("a"), b = image("b"), half = image("half", Format::RGBA16F);
    const Image volume(TestDevice(), {.extent = {4, 4}, .name = "volume", .depthTexels = 2});
    const Image mips(TestDevice(), {.extent = {4, 4}, .name = "mips", .levels = 3});
    const StorageBuffer buffer = UploadBuffer({1}, "words");
    const SubtractConstants constants{};
    CommandList commands(TestDevice());
    const auto dispatch = [&](std::vector<Read> reads, std::vector<Storage> storage) {
        commands.Dispatch({.name = "p",
                           .pipeline = pipeline,
                           .reads = std::move(reads),
                           .storage = std::move(storage),
                           .constants = ConstantBytes(constants)});
    };
    EXPECT_ERROR(dispatch({}, {{"target", &b}}), "pass 'p' gives nothing to read as 'source' of shaders/subtract.cs");
    EXPECT_ERROR(dispatch({{"source", &a}}, {}), "pass 'p' gives no storage for 'target' of shaders/subtract.cs");
    EXPECT_ERROR(dispatch({{"source", &a}, {"target", &b}}, {}),
                 "pass 'p' gives no storage for 'target' of shaders/subtract.cs");
    EXPECT_ERROR(dispatch({{"source", &a}}, {{"target", &a}}),
                 "pass 'p' reads and writes 'a' at once: what it would read is undefined");
    EXPECT_ERROR(dispatch({{"source", &a}}, {{"target", &buffer}}),
                 "pass 'p' gives 'words', a buffer, as 'target' of shaders/subtract.cs, which is an image");
    EXPECT_ERROR(dispatch({{"source", &a}}, {{"target", &volume}}),
                 "pass 'p' gives 'volume', a volume, to write as 'target' of shaders/subtract.cs, which is a 2D "
                 "image");
    EXPECT_ERROR(dispatch({{"source", &a}}, {{"target", &mips}}),
                 "pass 'p' gives 'mips', which has 1 layers and 3 levels, to write as 'target' of "
                 "shaders/subtract.cs: write an image of one and copy it");
    EXPECT_ERROR(dispatch({{"source", &a}}, {{"target", &half}}),
                 "pass 'p' gives 'half', which is RGBA16F, to write as 'target' of shaders/subtract.cs: shaders "
                 "write RGBA32F, R32F and RGBA32UI");
    EXPECT_ERROR(commands.Dispatch(
                     {.name = "p", .pipeline = pipeline, .reads = {{"source", &a}}, .storage = {{"target", &b}}}),
                 "pass 'p' has 0 bytes of constants, shaders/subtract.cs takes 16");
}

TEST(Dispatch, RefusesBuffersAndGroupsThatDoNotFitAndNamesThem) {
    const ComputePipeline pipeline = TwicePlusOne();
    const Image image(TestDevice(), {{4, 4}, Format::RGBA32F, "image"});
    const StorageBuffer before = UploadBuffer({1}, "before"), after = UploadBuffer({1}, "after");
    CommandList commands(TestDevice());
    const auto dispatch = [&](std::vector<Storage> storage, ThreadGroups groups) {
        commands.Dispatch({.name = "p", .pipeline = pipeline, .storage = std::move(storage), .groups = groups});
    };
    EXPECT_ERROR(dispatch({{"before", &before}}, {}),
                 "pass 'p' gives no storage for 'after' of shaders/twice_plus_one.cs");
    EXPECT_ERROR(dispatch({{"before", &image}, {"after", &after}}, {}),
                 "pass 'p' gives 'image', an image, as 'before' of shaders/twice_plus_one.cs, which is a buffer");
    EXPECT_ERROR(dispatch({{"before", &after}, {"after", &after}}, {}),
                 "pass 'p' gives 'after' as storage under two names");
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(TestDevice().Handles().physicalDevice, &properties);
    const auto& most = properties.limits.maxComputeWorkGroupCount;
    const std::string limits =
        fmt::format("at least 1 x 1 x 1 and, on this device, at most {} x {} x {}", most[0], most[1], most[2]);
    EXPECT_ERROR(dispatch({{"before", &before}, {"after", &after}}, {.x = 1, .y = 0}),
                 "pass 'p' runs 1 x 0 x 1 groups: " + limits);
    if (most[2] < UINT32_MAX)
        EXPECT_ERROR(dispatch({{"before", &before}, {"after", &after}}, {.z = most[2] + 1}),
                     fmt::format("pass 'p' runs 1 x 1 x {} groups: {}", most[2] + 1, limits));
}

TEST(Dispatch, RefusesADrawThatStoresToItsTarget) {
    const Pipeline pipeline = DrawingPipeline("shaders/subtract.ps");
    const Image a(TestDevice(), {{4, 4}, Format::RGBA32F, "a"}), b(TestDevice(), {{4, 4}, Format::RGBA32F, "b"});
    const SubtractConstants constants{};
    CommandList commands(TestDevice());
    EXPECT_ERROR(commands.Draw({.name = "p",
                                .pipeline = pipeline,
                                .reads = {{"source", &a}},
                                .storage = {{"target", &b}},
                                .writes = {&b},
                                .constants = ConstantBytes(constants)}),
                 "pass 'p' stores to and draws 'b' at once: what it would read is undefined");
}

TEST(ComputePipeline, RefusesOtherShadersAndGroupsThatTheDeviceCannotRun) {
    EXPECT_ERROR(ComputePipeline(TestDevice(), test_support_shaders::Find("shaders/subtract.ps")),
                 "shader shaders/subtract.ps is not a compute shader");
    EmbeddedShader wide = test_support_shaders::Find("shaders/twice_plus_one.cs");
    ShaderLayout layout = ShaderLayoutFromJson(wide.layoutJson);
    layout.threadGroup[2] = 1u << 31;
    const std::string json = ShaderLayoutToJson(layout);
    wide.layoutJson = json;
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(TestDevice().Handles().physicalDevice, &properties);
    const auto& most = properties.limits.maxComputeWorkGroupSize;
    EXPECT_ERROR(ComputePipeline(TestDevice(), wide),
                 fmt::format("shader shaders/twice_plus_one.cs has groups of 64 x 1 x 2147483648 threads: the device "
                             "runs at most {} x {} x {}, {} in all",
                             most[0], most[1], most[2], properties.limits.maxComputeWorkGroupInvocations));
}

TEST(StorageBuffer, HoldsMoreThanItsStagingBuffer) {
    Words words((64 << 20) / sizeof(uint32_t) + 5);
    std::iota(words.begin(), words.end(), 7u);
    const uint64_t before = TestDevice().MemoryBytes();
    const StorageBuffer buffer = UploadBuffer(words);
    EXPECT_GE(TestDevice().MemoryBytes() - before, buffer.Bytes());
    EXPECT_TRUE(DownloadBuffer(buffer) == words);
}

TEST(StorageBuffer, RefusesSizesThatNoBufferHasAndNamesThem) {
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(TestDevice().Handles().physicalDevice, &properties);
    const uint64_t most = properties.limits.maxStorageBufferRange;
    EXPECT_ERROR(StorageBuffer(TestDevice(), 0, "none"),
                 fmt::format("buffer 'none' of 0 bytes: the device takes 1 to {}", most));
    EXPECT_ERROR(StorageBuffer(TestDevice(), most + 1, "huge"),
                 fmt::format("buffer 'huge' of {} bytes: the device takes 1 to {}", most + 1, most));
}

}  // namespace
}  // namespace boxcar
