// boxcar sat and boxcar devices.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

namespace boxcar {
namespace {

TEST(Sat, WritesTheTableOfRawCodesExactlyTopRowFirst) {
    const Folder folder;
    const Picture picture = RandomPicture(49, 20, 3, SampleType::Unorm8);
    WritePicture(picture, folder.Path("in.png"), FileFormat::Png, SampleType::Unorm8);
    const auto expected = reference::SummedAreaTable(ReferenceLight(picture, false));
    for (const char* name : {"out.exr", "out.pfm"}) {
        const Outcome outcome = folder.Run(std::string("sat in.png --transfer raw -o ") + name);
        ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
        const Picture table = ReadPicture(folder.Path(name));
        ASSERT_EQ(table.channels, 3u);
        for (size_t i = 0; i < expected.texels.size(); i++)
            for (int c = 0; c < 3; c++)  // a tree of depth 6 + 5 over v / 255, itself rounded
                ASSERT_NEAR(table.samples[3 * i + c], expected.texels[i][c],
                            12 * 0x1p-24 * expected.texels[i][c] + 1e-7);
    }
}

TEST(Sat, SumsLinearLightTimesAlphaUnderSrgb) {
    const Folder folder;
    const Picture picture = RandomPicture(12, 19, 4, SampleType::Unorm8);
    WritePicture(picture, folder.Path("in.png"), FileFormat::Png, SampleType::Unorm8);
    const auto expected = reference::SummedAreaTable(ReferenceLight(picture, true));
    ASSERT_EQ(folder.Run("sat in.png -o out.exr").exitCode, 0);
    const Picture table = ReadPicture(folder.Path("out.exr"));
    for (int c = 0; c < 4; c++)
        EXPECT_NEAR(table.samples[table.samples.size() - 4 + c], expected.texels.back()[c], 1e-4);
}

TEST(Sat, RefusesAnIntegerFormat) {
    const Folder folder;
    WritePicture(RandomPicture(2, 2, 3, SampleType::Unorm8), folder.Path("in.png"), FileFormat::Png,
                 SampleType::Unorm8);
    const Outcome outcome = folder.Run("sat in.png -o out.png");
    EXPECT_EQ(outcome.exitCode, 2);
    EXPECT_EQ(outcome.err, "boxcar: -o out.png: a table needs a float format, .exr or .pfm\n");
}

TEST(Devices, AreListedForPeopleAndAsJson) {
    const Folder folder;
    const Outcome people = folder.Run("devices");
    EXPECT_EQ(people.exitCode, 0);
    const auto devices = nlohmann::json::parse(folder.Run("devices --json").out);
    ASSERT_GE(devices.size(), 1u);
    for (const auto& device : devices)
        EXPECT_NE(people.out.find(device.at("name").get<std::string>()), std::string::npos) << people.out;
}

}  // namespace
}  // namespace boxcar
