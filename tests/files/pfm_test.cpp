#include "tests/files/support.h"

namespace boxcar::test {
namespace {

using namespace std::string_literals;

// 2 x 3, the numbers 1 to 6 from the top left; the file holds the bottom row first.
const std::string kLittleEndianSamples =
    "\0\0\xa0\x40\0\0\xc0\x40"
    "\0\0\x40\x40\0\0\x80\x40"
    "\0\0\x80\x3f\0\0\0\x40"s;
const std::string kBigEndianSamples =
    "\x40\xa0\0\0\x40\xc0\0\0"
    "\x40\x40\0\0\x40\x80\0\0"
    "\x3f\x80\0\0\x40\0\0\0"s;
const Picture kOneToSix = {2, 3, 1, SampleType::Float32, {1, 2, 3, 4, 5, 6}};

TEST(PfmTest, IsWrittenBottomRowFirstAndLittleEndian) {
    const TemporaryFolder folder;
    WritePicture(kOneToSix, folder.Path("p.pfm"), FileFormat::Pfm, SampleType::Float32);
    EXPECT_EQ(Contents(folder.Path("p.pfm")), ToBytes("Pf\n2 3\n-1.0\n" + kLittleEndianSamples));

    const Picture colour = {1, 2, 3, SampleType::Float32, {1, 2, 3, 4, 5, 6}};
    WritePicture(colour, folder.Path("p.pfm"), FileFormat::Pfm, SampleType::Float32);
    EXPECT_EQ(Contents(folder.Path("p.pfm")), ToBytes("PF\n1 2\n-1.0\n"
                                                      "\0\0\x80\x40\0\0\xa0\x40\0\0\xc0\x40"
                                                      "\0\0\x80\x3f\0\0\0\x40\0\0\x40\x40"s));
}

TEST(PfmTest, BothByteOrdersAreRead) {
    const TemporaryFolder folder;
    ExpectSame(ReadPicture(folder.Put("l", ToBytes("Pf\n2 3\n-1.0\n" + kLittleEndianSamples))), kOneToSix);
    ExpectSame(ReadPicture(folder.Put("b", ToBytes("Pf\n2 3\n1.0\n" + kBigEndianSamples))), kOneToSix);
}

TEST(PfmTest, HeadersMayBeLaidOutOtherwise) {
    const TemporaryFolder folder;
    for (const std::string header : {"Pf 2 3 1 ", "Pf\r\n2\n3\n+1e0\n", "Pf\n2 3\n255.5\n", "Pf\n 2\t3 \n1.000000\n"})
        ExpectSame(ReadPicture(folder.Put("p", ToBytes(header + kBigEndianSamples))), kOneToSix);
}

// Debevec has one space character between the scale and the floats; programs write more, and floats may begin with
// bytes that look like it.
TEST(PfmTest, WhateverEndsTheHeaderTheFloatsAreFound) {
    const TemporaryFolder folder;
    std::string blank = kLittleEndianSamples;
    for (const std::string start : {"", "\n", "\r\n", " \n", "\t", "\n\n"}) {
        std::copy(start.begin(), start.end(), blank.begin());
        const Picture expected = ReadPicture(folder.Put("p", ToBytes("Pf\n2 3\n-1.0\n" + blank)));
        for (const std::string end : {"\n", " ", "\r", "\r\n", " \n", "  \r\n", "\t\n", "  "})
            ExpectSame(ReadPicture(folder.Put("p", ToBytes("Pf\n2 3\n-1.0" + end + blank))), expected);
    }
    for (const std::string end : {"\n", "\r\n", " \n", " \r\n"})
        ExpectSame(ReadPicture(folder.Put("p", ToBytes("Pf\r\n2 3\r\n-1.0" + end + kLittleEndianSamples + "more"))),
                   kOneToSix);
}

TEST(PfmTest, HeadersThatSayNothingAreRefused) {
    const TemporaryFolder folder;
    const std::string path = folder.Path("p");
    const auto errorOf = [&](const std::string& header) {
        return ErrorOf([&] { ReadPicture(folder.Put("p", ToBytes(header + kBigEndianSamples))); });
    };
    for (const std::string side : {"-7", "2.5", "x"}) {
        EXPECT_EQ(errorOf("Pf\n" + side + " 3\n1\n"),
                  path + ": damaged PFM: width " + side + "; a whole number above 0 is expected");
        EXPECT_EQ(errorOf("Pf\n3 " + side + "\n1\n"),
                  path + ": damaged PFM: height " + side + "; a whole number above 0 is expected");
    }
    for (const std::string scale : {"one", "1,0"})
        EXPECT_EQ(errorOf("Pf\n2 3\n" + scale + "\n"),
                  path + ": damaged PFM: scale " + scale + "; a number not 0 is expected");
    EXPECT_EQ(errorOf("Pf\n2 3\n0.0\n"), path + ": damaged PFM: scale 0; a number not 0 is expected");
    EXPECT_EQ(errorOf("Pf\n2 3\nnan\n"), path + ": damaged PFM: scale nan; a number not 0 is expected");
}

}  // namespace
}  // namespace boxcar::test
