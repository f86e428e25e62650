#include "runtime/device.h"

#include <gtest/gtest.h>

#include "runtime/passes/summed_area_table.h"
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

}  // namespace
}  // namespace boxcar
