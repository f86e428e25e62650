#include "runtime/device.h"

#include <gtest/gtest.h>
#include <vulkan/vulkan.h>

#include <algorithm>

#include "hlsl/constants/sat_constants.h"
#include "passes_shaders.h"
#include "runtime/passes/mip_chain.h"
#include "runtime/passes/summed_area_table.h"
#include "test_support_shaders.h"
#include "tests/support/device_image.h"
#include "tests/support/expect_error.h"

namespace boxcar {
namespace {

std::string KnownDevices() {
    std::string known;
    for (const DeviceInfo& info : ListDevices()) {
        known += fmt::format("{}{}: {}", known.empty() ? "" : "; ", info.index, info.name);
        if (!info.unusable.empty()) known += fmt::format(" ({})", info.unusable);
    }
    return known;
}

TEST(Device, IsListedWithNameDriverAndVersion) {
    const DeviceInfo& info = TestDevice().Info();
    const std::vector<DeviceInfo> all = ListDevices();
    ASSERT_LT(info.index, all.size());
    EXPECT_EQ(all[info.index].name, info.name);
    EXPECT_FALSE(info.driver.empty());
    EXPECT_TRUE(info.apiVersion.starts_with("1.")) << info.apiVersion;
    EXPECT_EQ(info.unusable, "");
}

TEST(Device, IsFoundByIndexAndByAPartOfItsNameInAnyCase) {
    const DeviceInfo& info = TestDevice().Info();
    EXPECT_EQ(Device({.selector = std::to_string(info.index)}).Info().name, info.name);
    std::string part = info.name.substr(1, 5);
    for (char& c : part)
        c = static_cast<char>(std::toupper(c));
    EXPECT_EQ(Device({.selector = part}).Info().name, info.name);
}

TEST(Device, RefusesASelectorThatMatchesNothingAndListsWhatThereIs) {
    EXPECT_ERROR(Device({.selector = "Voodoo2"}),
                 fmt::format("no Vulkan device matches 'Voodoo2'; there is {}", KnownDevices()));
    EXPECT_ERROR(Device({.selector = "99"}),
                 fmt::format("no Vulkan device matches '99'; there is {}", KnownDevices()));
}

TEST(Device, CountsTheMemoryOfWhatLivesOnIt) {
    Device& device = TestDevice();
    const uint64_t before = device.MemoryBytes();
    {
        const Image image(device, {{256, 128}, Format::RGBA32F, "counted"});
        EXPECT_GE(device.MemoryBytes() - before, 256u * 128 * 16);
        EXPECT_LE(device.MemoryBytes() - before, 256u * 128 * 16 + 65536);
    }
    EXPECT_EQ(device.MemoryBytes(), before);
    EXPECT_GE(device.PeakMemoryBytes(), before + 256 * 128 * 16);
}

// An engine hands over its own handles; when Boxcar's Device is gone, the engine's still work.
TEST(Device, AdoptedFromAnEnginesHandlesWorksAndDestroysNothingOfIt) {
    const Extent2D extent{4, 4};
    for (int round = 0; round < 2; round++) {
        Device adopted(TestDevice().Handles());
        EXPECT_EQ(adopted.Info().name, TestDevice().Info().name);
        const Image source(adopted, {extent, Format::RGBA32F, "engine's"});
        const Texels ones(16, glm::vec4(1));
        WriteTexels(adopted, source, std::as_bytes(std::span(ones)));
        SummedAreaTable table(adopted, {.extent = extent});
        CommandList commands(adopted);
        const Image& sums = *table.Record(commands, source).low;
        commands.SubmitAndWait();
        Texels result(16);
        ReadTexels(adopted, sums, std::as_writable_bytes(std::span(result)));
        EXPECT_EQ(result[15], glm::vec4(16));
    }
    EXPECT_EQ(Download(Upload(extent, Texels(16, glm::vec4(3))))[5], glm::vec4(3));
}

// Stripes of two texels, seen through an anisotropic sampler in pixels of 1 x 8 texels: the range of what is left.
float StripesSeenOn(Device& device) {
    const Extent2D stripes{64, 64}, squashed{64, 8};
    Texels texels;
    for (uint32_t i = 0; i < stripes.Texels(); i++)
        texels.emplace_back(static_cast<float>(i / 2 % 2));
    const Image source(device, {stripes, Format::RGBA32F, "stripes"});
    WriteTexels(device, source, std::as_bytes(std::span(texels)));
    const Image seen(device, {squashed, Format::RGBA32F, "seen"});
    MipChain mips(device, stripes);
    const Pipeline pipeline(device, {passes_shaders::Find("shaders/quad.vs"),
                                     test_support_shaders::Find("shaders/sample.ps.SAMPLER=anisotropicRepeat")});
    const SATPassConstants unmoved{};
    CommandList commands(device);
    commands.Draw({.name = "squash",
                   .pipeline = pipeline,
                   .reads = {{"source", &mips.Record(commands, source)}},
                   .writes = {&seen},
                   .constants = ConstantBytes(unmoved)});
    commands.SubmitAndWait();
    texels.resize(squashed.Texels());
    ReadTexels(device, seen, std::as_writable_bytes(std::span(texels)));
    const auto [least, most] = std::ranges::minmax(texels, {}, &glm::vec4::x);
    return most.x - least.x;
}

TEST(Device, AdoptedHasTheAnisotropyThatItsEngineEnabled) {
    AdoptedDevice engine = TestDevice().Handles();
    if (!engine.hasSamplerAnisotropy) GTEST_SKIP() << "this device has none";
    Device with(engine);
    EXPECT_TRUE(with.Handles().hasSamplerAnisotropy);
    EXPECT_GT(StripesSeenOn(with), 0.5f);
    engine.hasSamplerAnisotropy = false;
    Device without(engine);
    EXPECT_FALSE(without.Handles().hasSamplerAnisotropy);
    EXPECT_LT(StripesSeenOn(without), 0.1f);
}

// What the validation layer says of a clear in a layout that no clear can have; the clear never runs.
std::string MessageAboutAWrongClearOn(Device& device) {
    const Image image(device, {{1, 1}, Format::RGBA32F, "misused"});
    const CommandList commands(device);
    const VkClearColorValue black{};
    const VkImageSubresourceRange all{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    vkCmdClearColorImage(commands.Handle(), image.Handle(), VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, &black, 1,
                         &all);
    std::string text;
    for (const std::string& message : TakeValidationMessages())
        text += message;
    return text;
}

TEST(Device, AdoptedNamesItsObjectsWhereItsEngineEnabledDebugUtils) {
    AdoptedDevice engine = TestDevice().Handles();
    ASSERT_TRUE(engine.hasDebugUtils) << "the validation layer has it";
    Device with(engine);
    EXPECT_TRUE(with.Handles().hasDebugUtils);
    const std::string named = MessageAboutAWrongClearOn(with);
    EXPECT_NE(named.find("misused"), std::string::npos) << named;
    engine.hasDebugUtils = false;
    Device without(engine);
    EXPECT_FALSE(without.Handles().hasDebugUtils);
    const std::string unnamed = MessageAboutAWrongClearOn(without);
    EXPECT_NE(unnamed, "");
    EXPECT_EQ(unnamed.find("misused"), std::string::npos) << unnamed;
}

}  // namespace
}  // namespace boxcar
