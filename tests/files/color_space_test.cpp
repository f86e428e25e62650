// What files say of their colors, on its way from format to format.
#include <cmath>

#include "samples/files/color.h"
#include "tests/files/support.h"

namespace boxcar::test {
namespace {

const Primaries kP3 = {0.68f, 0.32f, 0.265f, 0.69f, 0.15f, 0.06f, 0.3127f, 0.329f};
const Primaries kAces = {0.7347f, 0.2653f, 0, 1, 0.0001f, -0.077f, 0.32168f, 0.33767f};

TEST(ColorSpaceTest, LightIsTheCodeToTheInverseOfTheGamma) {
    for (const double code : {0.0, 0.02, 0.5, 1.0}) {
        EXPECT_EQ(ToLinear({1, {}, {}}, code), code);
        EXPECT_DOUBLE_EQ(ToLinear({0.5, {}, {}}, code), code * code);
        EXPECT_EQ(ToLinear({}, code), SrgbToLinear(code));
    }
    EXPECT_EQ(ToLinear({0.3, {}, {}}, -1), 0);
    Picture picture{1, 1, 4, SampleType::Unorm8, {0.5f, 0.25f, 1, 0.5f}};
    picture.colorSpace.gamma = 0.5;
    DecodeSrgb(picture);
    EXPECT_EQ(picture.samples, (std::vector<float>{0.25f, 0.0625f, 1, 0.5f}));
}

TEST(ColorSpaceTest, WhatAFormatCannotHoldIsNamed) {
    const ColorSpace profile{0, {}, MakeProfile("RGB ")}, p3{0, kP3, {}}, linear{1, {}, {}}, all{0.5, kAces, {}};
    for (const FileFormat format : {FileFormat::Png, FileFormat::Jpeg, FileFormat::Exr, FileFormat::Pfm})
        EXPECT_EQ(LostColorSpace({}, format), "");
    EXPECT_EQ(LostColorSpace(profile, FileFormat::Png), "");
    EXPECT_EQ(LostColorSpace(profile, FileFormat::Jpeg), "");
    EXPECT_EQ(
        LostColorSpace(profile, FileFormat::Exr),
        "EXR cannot hold the input's ICC profile: its colors will be taken for linear light of sRGB's primaries");
    EXPECT_EQ(LostColorSpace(p3, FileFormat::Png), "");
    EXPECT_EQ(LostColorSpace(p3, FileFormat::Exr), "");
    EXPECT_EQ(LostColorSpace(p3, FileFormat::Jpeg),
              "JPEG cannot hold the input's primaries: its colors will be taken for sRGB");
    EXPECT_EQ(LostColorSpace(linear, FileFormat::Png), "");
    EXPECT_EQ(LostColorSpace(linear, FileFormat::Jpeg),
              "JPEG cannot hold the input's gamma of 1: its colors will be taken for sRGB");
    EXPECT_EQ(LostColorSpace(all, FileFormat::Pfm),
              "PFM cannot hold the input's gamma of 0.5, primaries: its colors will be taken for linear light of "
              "sRGB's primaries");
    // cHRM has no sign, and one primary of ACES lies below the axis.
    EXPECT_EQ(LostColorSpace({0, kAces, {}}, FileFormat::Png),
              "PNG cannot hold the input's primaries: its colors will be taken for sRGB");
}

TEST(ColorSpaceTest, PrimariesGoBetweenPngAndExr) {
    const TemporaryFolder folder;
    Picture picture = PatternPicture({3, 2}, 3, SampleType::Unorm8);
    picture.colorSpace.primaries = kP3;
    WritePicture(picture, folder.Path("p.png"), FileFormat::Png, SampleType::Unorm8);
    WritePicture(ReadPicture(folder.Path("p.png")), folder.Path("p.exr"), FileFormat::Exr, SampleType::Float32);
    EXPECT_EQ(ReadPicture(folder.Path("p.exr")).colorSpace.primaries, kP3);
}

// Whatever is in the file, notes are lines for a terminal.
TEST(ColorSpaceTest, NotesArePrintableAndShortAndFew) {
    const TemporaryFolder folder;
    std::string text = "#?RADIANCE\nGAMMA=2 \x1b[31m" + std::string(5000, 'x') + "\n";
    for (int i = 0; i < 1000; ++i)
        text += "GAMMA=3\n";
    const std::vector<std::string> notes = ReadPicture(folder.Put("p", ToBytes(text + "\n-Y 1 +X 1\nabcd"))).notes;
    ASSERT_EQ(notes.size(), 8u);
    EXPECT_TRUE(notes[0].starts_with("its GAMMA=2 \\x1b[31mxxx"));
    EXPECT_EQ(notes[0].size(), 200u + 3);  // of the escape
}

}  // namespace
}  // namespace boxcar::test
