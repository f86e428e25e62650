// boxcar render, sweep, inspect, list and fit-lobe.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "samples/files/bytes.h"
#include "tests/cli/program.h"

namespace boxcar {
namespace {

using nlohmann::json;

TEST(List, NamesEveryEffectAndItsParametersWithTheirRanges) {
    const Folder folder;
    const Outcome outcome = folder.Run("list --json");
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const json effects = json::parse(outcome.out);
    ASSERT_GE(effects.size(), 5u);
    for (const json& effect : effects) {
        for (const char* key : {"name", "what", "paper"})
            EXPECT_FALSE(effect.at(key).get<std::string>().empty());
        for (const json& parameter : effect.at("parameters")) {
            const std::string type = parameter.at("type");
            if (type == "choice") {
                const auto choices = parameter.at("choices").get<std::vector<std::string>>();
                EXPECT_NE(std::ranges::find(choices, parameter.at("default").get<std::string>()), choices.end());
            } else {
                EXPECT_TRUE(type == "float" || type == "int") << type;
                EXPECT_LE(parameter.at("min").get<double>(), parameter.at("default").get<double>());
                EXPECT_LE(parameter.at("default").get<double>(), parameter.at("max").get<double>());
            }
            EXPECT_TRUE(parameter.contains("unit"));
        }
    }
    EXPECT_NE(folder.Run("list").out.find("planar-reflection"), std::string::npos);
}

TEST(Render, WritesOnePictureOrNumberedFrames) {
    const Folder folder;
    ASSERT_EQ(folder.Run("render planar-reflection --size 48x32 -o one.png").exitCode, 0);
    const Outcome frames = folder.Run("render planar-reflection --size 48x32 --frames 3 --time 0.5 -o many.png");
    ASSERT_EQ(frames.exitCode, 0) << frames.err;
    EXPECT_EQ(folder.Names(),
              std::vector<std::string>({"many.0000.png", "many.0001.png", "many.0002.png", "one.png"}));
    // Frame i is the picture at time + i / 30.
    ASSERT_EQ(folder.Run("render planar-reflection --size 48x32 --time 0.53333333333333333 -o second.png").exitCode,
              0);
    EXPECT_EQ(ReadPicture(folder.Path("second.png")).samples, ReadPicture(folder.Path("many.0001.png")).samples);
    EXPECT_NE(ReadPicture(folder.Path("one.png")).samples, ReadPicture(folder.Path("many.0001.png")).samples);
}

TEST(Render, ExrHoldsTheLightAndPngShowsIt) {
    const Folder folder;
    ASSERT_EQ(folder.Run("render planar-reflection --size 40x24 -o light.exr").exitCode, 0);
    ASSERT_EQ(folder.Run("render planar-reflection --size 40x24 -o shown.png").exitCode, 0);
    const Picture light = ReadPicture(folder.Path("light.exr")), shown = ReadPicture(folder.Path("shown.png"));
    ASSERT_EQ(light.samples.size(), shown.samples.size());
    for (size_t i = 0; i < light.samples.size(); i++)
        EXPECT_NEAR(shown.samples[i], std::min(ReferenceEncode(light.samples[i]), 1.0), 0.51 / 255) << i;
}

TEST(Render, TakesAMeshAndAnEnvironmentFromFiles) {
    const Folder folder;
    folder.WriteText("tile.obj", "v -1 0 0\nv 1 0 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n");
    Picture environment{8, 4, 3, SampleType::Float32, std::vector<float>(8 * 4 * 3, 0.25f)};
    WritePicture(environment, folder.Path("grey.exr"), FileFormat::Exr, SampleType::Float32);
    const Outcome outcome =
        folder.Run("render glossy-environment --mesh tile.obj --env grey.exr --set face=32 --size 40x30 -o out.exr");
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    for (const float sample :
         ReadPicture(folder.Path("out.exr")).samples)  // the tile reflects 0.25 and is in front of it
        EXPECT_NEAR(sample, 0.25, 0.04);
}

TEST(Render, RefusesWhatItCannotDoInOneLine) {
    const Folder folder;
    folder.WriteText("broken.obj", "v 1 2\n");
    WritePicture(RandomPicture(8, 8, 3, SampleType::Unorm8), folder.Path("square.png"), FileFormat::Png,
                 SampleType::Unorm8);
    const auto expect = [&](const std::string& arguments, int exitCode, const std::string& line) {
        const Outcome outcome = folder.Run("render " + arguments);
        EXPECT_EQ(outcome.exitCode, exitCode) << arguments;
        EXPECT_EQ(outcome.err, "boxcar: " + line + "\n");
        EXPECT_EQ(folder.Names(), std::vector<std::string>({"broken.obj", "square.png"}));
    };
    const Outcome unknown = folder.Run("render glossy -o out.png");
    EXPECT_EQ(unknown.exitCode, 2);
    EXPECT_TRUE(unknown.err.starts_with("boxcar: no effect 'glossy'; there is glossy-environment, ")) << unknown.err;
    expect("planar-reflection --set rough=1 -o out.png", 2, "no parameter 'rough'; there is roughness, mirror");
    expect("planar-reflection --set roughness=2 -o out.png", 2, "roughness=2: expected a number from 0 to 1");
    expect("planar-reflection --set roughness -o out.png", 2, "--set roughness: expected NAME=VALUE");
    expect("planar-reflection --size 0x9 -o out.png", 2,
           "--size 0x9: expected WxH, two whole numbers from 1 to 8192");
    expect("planar-reflection --frames 0 -o out.png", 2, "--frames 0: expected 1 to 100000");
    expect("planar-reflection --env square.png -o out.png", 2,
           "--env square.png: planar-reflection has no use for it");
    expect("glossy-environment --env square.png -o out.png", 1,
           "square.png: 8 x 8 texels; an environment is twice as wide as high");
    expect("glossy-environment --env none.exr -o out.png", 1, "none.exr: cannot be read: No such file or directory");
    expect("planar-reflection --mesh broken.obj -o out.png", 1,
           "broken.obj: line 1 is a position without 3 finite numbers");
    expect("planar-reflection -o out.gif", 2,
           "out.gif: the name says no format; an ending .png, .jpg, .jpeg, .exr or .pfm is expected");
}

TEST(Inspect, SaysWhatAnIntermediateImageHolds) {
    const Folder folder;
    const Outcome outcome =
        folder.Run("inspect planar-reflection --size 64x40 --stage picture --pixel 10,5 -o stage.exr --json");
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const json summary = json::parse(outcome.out);
    EXPECT_EQ(summary.at("stage"), "picture");
    EXPECT_EQ(summary.at("size"), json({64, 40}));
    EXPECT_EQ(summary.at("nan"), 0);
    EXPECT_EQ(summary.at("inf"), 0);
    const Picture stage = ReadPicture(folder.Path("stage.exr"));
    double sum = 0;
    float least = INFINITY, largest = 0;
    for (size_t i = 0; i < stage.samples.size(); i += 4) {
        sum += stage.samples[i];
        least = std::min(least, stage.samples[i]);
        largest = std::max(largest, stage.samples[i]);
    }
    EXPECT_EQ(summary.at("min")[0].get<float>(), least);
    EXPECT_EQ(summary.at("max")[0].get<float>(), largest);
    EXPECT_NEAR(summary.at("mean")[0].get<double>(), sum / (64 * 40), 1e-9);
    for (size_t c = 0; c < 4; c++)
        EXPECT_EQ(summary.at("pixel")[c].get<float>(), stage.samples[(5 * 64 + 10) * 4 + c]);
}

TEST(Inspect, KnowsTablesOfIntegersAndRefusesWrongStagesAndPixels) {
    const Folder folder;
    const Outcome table = folder.Run("inspect planar-reflection --size 16x16 --stage table --json");
    ASSERT_EQ(table.exitCode, 0) << table.err;
    // The last entry is the sum of all codes: it is the largest.
    const Outcome last = folder.Run("inspect planar-reflection --size 16x16 --stage table --pixel 15,15 --json");
    EXPECT_EQ(json::parse(last.out).at("pixel"), json::parse(table.out).at("max"));
    const Outcome stage = folder.Run("inspect planar-reflection --stage depths");
    EXPECT_EQ(stage.exitCode, 2);
    EXPECT_EQ(stage.err, "boxcar: --stage depths: there is reflected, table, table-high, picture\n");
    const Outcome pixel = folder.Run("inspect planar-reflection --size 16x16 --stage table --pixel 16,0");
    EXPECT_EQ(pixel.exitCode, 2);
    EXPECT_EQ(pixel.err, "boxcar: --pixel 16,0: expected x,y from 0,0 to 15,15\n");
}

TEST(Sweep, PutsThePicturesOfEachValueSideBySide) {
    const Folder folder;
    const Outcome outcome = folder.Run(
        "sweep planar-reflection --set roughness=0,0.5 --set mirror=0.1,0.5,0.9 --size 60x40 -o sheet.png");
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const Picture sheet = ReadPicture(folder.Path("sheet.png"));
    EXPECT_EQ(sheet.widthTexels, 2 * 60u);
    EXPECT_EQ(sheet.heightTexels % 3, 0u);
    ASSERT_EQ(
        folder.Run("render planar-reflection --set roughness=0.5 --set mirror=0.9 --size 60x40 -o one.png").exitCode,
        0);
    const Picture one = ReadPicture(folder.Path("one.png"));
    const uint32_t top = 2 * sheet.heightTexels / 3;
    for (uint32_t y = 0; y < 40; y++)
        for (uint32_t i = 0; i < 60 * 3; i++)
            ASSERT_EQ(sheet.samples[((top + y) * 120 + 60) * 3 + i], one.samples[y * 60 * 3 + i]) << i << ", " << y;
    const Outcome none = folder.Run("sweep planar-reflection --set roughness=0.5 -o sheet.png");
    EXPECT_EQ(none.exitCode, 2);
    EXPECT_EQ(
        none.err,
        "boxcar: 0 lists in --set: sweep takes one (a row) or two (columns and rows), as in --set width=1,9,33\n");
}

// As EXR the sheet holds light, with the same letters on it: as codes it is the PNG.
TEST(Sweep, AnExrHoldsLinearLight) {
    const Folder folder;
    const std::string sweep = "sweep planar-reflection --set roughness=0,0.5 --size 60x40 -o ";
    for (const char* out : {"sheet.png", "sheet.exr", "sheet.pfm"}) {
        const Outcome outcome = folder.Run(sweep + out);
        ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    }
    const Picture png = ReadPicture(folder.Path("sheet.png"));
    for (const char* in : {"sheet.exr", "sheet.pfm"}) {
        ASSERT_EQ(folder.Run(std::string("filter --width 1 -o codes.png ") + in).exitCode, 0);
        const Picture codes = ReadPicture(folder.Path("codes.png"));
        ASSERT_EQ(codes.samples.size(), png.samples.size());
        for (size_t i = 0; i < png.samples.size(); i++)
            ASSERT_NEAR(codes.samples[i], png.samples[i], 1.01 / 255) << in << ", sample " << i;
    }
}

// A PNG holds codes and straight alpha, an EXR light times alpha.
TEST(Render, AlphaOfAnEnvironmentCountsTheSameInEveryFormat) {
    const Folder folder;
    Picture png = RandomPicture(8, 4, 4, SampleType::Unorm8);
    Picture exr{8, 4, 4, SampleType::Float32, png.samples};
    for (size_t i = 0; i < exr.samples.size(); i++)
        if (i % 4 != 3)
            exr.samples[i] = static_cast<float>(ReferenceDecode(png.samples[i]) * png.samples[i / 4 * 4 + 3]);
    WritePicture(png, folder.Path("env.png"), FileFormat::Png, SampleType::Unorm8);
    WritePicture(exr, folder.Path("env.exr"), FileFormat::Exr, SampleType::Float32);
    for (const std::string in : {"png", "exr"})
        ASSERT_EQ(
            folder.Run("render glossy-environment --set face=32 --size 40x30 --env env." + in + " -o " + in + ".exr")
                .exitCode,
            0);
    const Picture fromPng = ReadPicture(folder.Path("png.exr")), fromExr = ReadPicture(folder.Path("exr.exr"));
    for (size_t i = 0; i < fromExr.samples.size(); i++)
        ASSERT_NEAR(fromPng.samples[i], fromExr.samples[i], 1e-5) << i;
}

TEST(FitLobe, PrintsAStackWhoseWeightsAddUpToOne) {
    const Folder folder;
    const Outcome outcome = folder.Run("fit-lobe --phong 100 --boxes 4 --json");
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const json fit = json::parse(outcome.out);
    double sum = 0;
    for (const json& weight : fit.at("weights"))
        sum += weight.get<double>();
    EXPECT_NEAR(sum, 1, 1e-9);
    EXPECT_NEAR(fit.at("relative_error").get<double>(), 0.221, 0.005);
    EXPECT_EQ(folder.Run("fit-lobe").err, "boxcar: fit-lobe takes one lobe: --phong N or --ggx ALPHA\n");
    EXPECT_EQ(folder.Run("fit-lobe --ggx 2").err, "boxcar: --ggx 2: expected alpha from 0.001 to 1\n");
    EXPECT_EQ(folder.Run("fit-lobe --phong 9 --boxes 7").exitCode, 2);
}

}  // namespace
}  // namespace boxcar
