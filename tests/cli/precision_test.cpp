// boxcar precision.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

namespace boxcar {
namespace {

using Json = nlohmann::json;

// Adds up as the table of cases in the command's help: 4 precisions x 3 biases x 2 origins x 4 taps, 4 of u32, then
// 3 frames, 2 lines and the blocks.
TEST(Precision, JsonHoldsEveryCaseOnce) {
    const Folder folder;
    WritePicture(RandomPicture(33, 20, 4, SampleType::Unorm8), folder.Path("in.png"), FileFormat::Png,
                 SampleType::Unorm8);
    const Outcome outcome = folder.Run("precision in.png --json");
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    const Json document = Json::parse(outcome.out);
    ASSERT_EQ(document.size(), 1u);
    EXPECT_EQ(document[0].at("image"), "in.png");
    const Json& results = document[0].at("results");
    std::map<std::string, int> builders;
    std::set<std::string> cases;
    for (const Json& result : results) {
        builders[result.at("builder")]++;
        cases.insert(Json({result.at("builder"), result.at("precision"), result.at("bias"), result.at("origin"),
                           result.at("taps")})
                         .dump());
        for (const char* width : {"1", "3", "9", "33", "129"})
            EXPECT_TRUE(result.at("rms_by_width").at(width).is_number()) << result;
        EXPECT_FALSE(result.contains("overflow"));
        if (result.at("precision") == "u32") {
            EXPECT_TRUE(result.at("snr_db").is_null()) << result;
            EXPECT_EQ(result.at("rms_by_width").at("9"), 0.0);
        } else {
            EXPECT_GT(result.at("snr_db"), 10.0) << result;
        }
    }
    EXPECT_EQ(builders, (std::map<std::string, int>{{"raster", 100}, {"frame", 3}, {"lines", 2}, {"blocks", 1}}));
    EXPECT_EQ(cases.size(), results.size());
}

TEST(Precision, OverflowIsToldApartFromExact) {
    const Folder folder;
    Picture white = RandomPicture(256, 257, 1, SampleType::Unorm8);
    std::fill(white.samples.begin(), white.samples.end(), 1.0f);
    WritePicture(white, folder.Path("white.png"), FileFormat::Png, SampleType::Unorm8);
    const Json document = Json::parse(folder.Run("precision white.png --json").out);
    int overflows = 0;
    for (const Json& result : document.at(0).at("results")) {
        if (!result.contains("overflow")) continue;
        overflows++;
        EXPECT_EQ(result.at("precision"), "fp16");
        EXPECT_EQ(result.at("bias"), "none");
        EXPECT_EQ(result.at("origin"), "corner");
        EXPECT_EQ(result.at("overflow"), true);
        EXPECT_TRUE(result.at("snr_db").is_null());
        EXPECT_TRUE(result.at("rms_by_width").at("1").is_null());
    }
    EXPECT_EQ(overflows, 5);  // four numbers of taps, and the lines
    const std::string people = folder.Run("precision white.png").out;
    EXPECT_NE(people.find("overflow"), std::string::npos);
    EXPECT_NE(people.find("exact"), std::string::npos);
}

TEST(Precision, FloatPicturesAndLinearLightHaveNoWholeCodes) {
    const Folder folder;
    WritePicture(RandomPicture(12, 9, 3, SampleType::Unorm8), folder.Path("in.exr"), FileFormat::Exr,
                 SampleType::Float32);
    WritePicture(RandomPicture(12, 9, 3, SampleType::Unorm8), folder.Path("in.png"), FileFormat::Png,
                 SampleType::Unorm8);
    const Json floats = Json::parse(folder.Run("precision in.exr --json").out);
    for (const Json& result : floats.at(0).at("results"))
        EXPECT_NE(result.at("precision"), "u32");
    // Linear light is rounded to 16 bits, which is an error of its own: one part in 65535 sqrt(12), or 107 dB
    // below 1.
    const Json light = Json::parse(folder.Run("precision in.png --transfer srgb --json").out);
    for (const Json& result : light.at(0).at("results")) {
        EXPECT_NE(result.at("builder"), "blocks");
        if (result.at("precision") == "u32") {
            EXPECT_NEAR(result.at("snr_db"), 102, 5);
        }
    }
}

TEST(Precision, MistakesGetOneLine) {
    const Folder folder;
    WritePicture(RandomPicture(4, 4, 3, SampleType::Unorm8), folder.Path("ok.png"), FileFormat::Png,
                 SampleType::Unorm8);
    const auto refused = [&](const std::string& arguments, int exitCode, const std::string& line) {
        const Outcome outcome = folder.Run("precision " + arguments);
        EXPECT_EQ(outcome.exitCode, exitCode) << arguments;
        EXPECT_EQ(outcome.err, "boxcar: " + line + "\n") << arguments;
        EXPECT_EQ(outcome.out, "") << arguments;
    };
    refused("missing.png", 1, "missing.png: cannot be read: No such file or directory");
    refused("ok.png --taps 4", 2, "The following argument was not expected: --taps");
    refused("ok.png --transfer linear", 2, "--transfer: linear not in {srgb,raw}");
    refused("", 2, "IN is required");
}

TEST(Precision, GoesOnAfterAPictureThatFails) {
    const Folder folder;
    WritePicture(RandomPicture(4, 4, 3, SampleType::Unorm8), folder.Path("ok.png"), FileFormat::Png,
                 SampleType::Unorm8);
    const Outcome outcome = folder.Run("precision missing.png ok.png --json");
    EXPECT_EQ(outcome.exitCode, 1);
    const Json document = Json::parse(outcome.out);
    EXPECT_EQ(document.at(0).at("error"), "missing.png: cannot be read: No such file or directory");
    EXPECT_EQ(document.at(1).at("results").size(), 106u);
}

}  // namespace
}  // namespace boxcar
