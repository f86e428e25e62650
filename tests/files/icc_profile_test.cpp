#include "samples/files/icc_profile.h"

#include <cmath>

#include "samples/files/color.h"
#include "tests/files/support.h"

namespace boxcar::test {
namespace {

struct Tag {
    std::string name;
    std::string data;
};

std::string Word(uint32_t word) {
    return {static_cast<char>(word >> 24), static_cast<char>(word >> 16 & 255), static_cast<char>(word >> 8 & 255),
            static_cast<char>(word & 255)};
}

std::string Fixed(double number) {
    return Word(static_cast<uint32_t>(static_cast<int32_t>(std::lround(number * 65536))));
}

const std::string kReserved(4, '\0');

std::string Formula(uint32_t kind, const std::vector<double>& numbers) {
    std::string data = "para" + kReserved + Word(kind << 16);
    for (const double number : numbers)
        data += Fixed(number);
    return data;
}

std::string Table(const std::vector<uint32_t>& entries) {
    std::string data = "curv" + kReserved + Word(static_cast<uint32_t>(entries.size()));
    for (const uint32_t entry : entries)
        data += Word(entry).substr(2);
    return data;
}

std::string Colorant(double x, double y, double z) {
    return "XYZ " + kReserved + Fixed(x) + Fixed(y) + Fixed(z);
}

Bytes WithTags(const std::string& space, const std::vector<Tag>& tags) {
    const Bytes header = MakeProfile(space, 132);
    std::string table = Word(static_cast<uint32_t>(tags.size())), data;
    for (const Tag& tag : tags) {
        const auto offset = static_cast<uint32_t>(128 + 4 + 12 * tags.size() + data.size());
        table += tag.name + Word(offset) + Word(static_cast<uint32_t>(tag.data.size()));
        data += tag.data + std::string((4 - tag.data.size() % 4) % 4, '\0');
    }
    Bytes profile(header.begin(), header.begin() + 128);
    const Bytes rest = ToBytes(table + data);
    profile.insert(profile.end(), rest.begin(), rest.end());
    const std::string size = Word(static_cast<uint32_t>(profile.size()));
    std::copy(size.begin(), size.end(), profile.begin());
    return profile;
}

std::optional<double> HalfBy(const std::string& curve) {
    return LightOfHalf(WithTags("RGB ", {{"rTRC", curve}}));
}

const std::string kSrgbCurve = Formula(3, {2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045});

Bytes SrgbProfile() {
    return WithTags("RGB ", {{"rXYZ", Colorant(0.43607, 0.22249, 0.01392)},
                             {"gXYZ", Colorant(0.38515, 0.71687, 0.09708)},
                             {"bXYZ", Colorant(0.14307, 0.06061, 0.71410)},
                             {"rTRC", kSrgbCurve}});
}

TEST(IccProfileTest, AllKindsOfCurvesAreEvaluatedAtOneHalf) {
    constexpr double kTolerance = 1e-4;
    EXPECT_EQ(HalfBy(Table({})), 0.5);
    EXPECT_NEAR(*HalfBy(Table({0x1cd})), std::pow(0.5, 0x1cd / 256.0), kTolerance);
    EXPECT_NEAR(*HalfBy(Table({0, 13107, 65535})), 0.2, kTolerance);
    EXPECT_NEAR(*HalfBy(Table({0, 6553, 13107, 65535})), 0.15, kTolerance);
    EXPECT_NEAR(*HalfBy(Formula(0, {1.8})), std::pow(0.5, 1.8), kTolerance);
    EXPECT_NEAR(*HalfBy(Formula(1, {2, 0.9, 0.1})), 0.55 * 0.55, kTolerance);
    EXPECT_NEAR(*HalfBy(Formula(2, {2, 0.9, 0.1, 0.05})), 0.55 * 0.55 + 0.05, kTolerance);
    EXPECT_NEAR(*HalfBy(kSrgbCurve), SrgbToLinear(0.5), kTolerance);
    EXPECT_NEAR(*HalfBy(Formula(4, {2, 0.9, 0.1, 1, 0.1, 0.05, 0})), 0.55 * 0.55 + 0.05, kTolerance);
    EXPECT_EQ(LightOfHalf(WithTags("GRAY", {{"kTRC", Table({})}})), 0.5);
}

TEST(IccProfileTest, WhatIsNoCurveSaysNothing) {
    EXPECT_EQ(HalfBy(Formula(5, {1, 1, 1, 1, 1, 1, 1})), std::nullopt);
    EXPECT_EQ(HalfBy(Formula(3, {1, 1})), std::nullopt);
    EXPECT_EQ(HalfBy("curv" + kReserved + Word(0xffffffff) + "ab"), std::nullopt);
    EXPECT_EQ(HalfBy("mft2" + kReserved + Word(0)), std::nullopt);
    EXPECT_EQ(HalfBy("curv"), std::nullopt);
    EXPECT_EQ(LightOfHalf(WithTags("RGB ", {})), std::nullopt);
    const Bytes whole = SrgbProfile();
    for (size_t length = 0; length < whole.size(); ++length)
        LightOfHalf(ByteView(whole).first(length));
}

TEST(IccProfileTest, SrgbIsKnownByItsCurveAndPrimaries) {
    EXPECT_TRUE(IsSrgbProfile(SrgbProfile()));
    EXPECT_TRUE(IsSrgbProfile(WithTags("GRAY", {{"kTRC", Formula(0, {2.2})}})));
    EXPECT_FALSE(IsSrgbProfile(WithTags("GRAY", {{"kTRC", Formula(0, {1.8})}})));
    EXPECT_FALSE(IsSrgbProfile(WithTags("RGB ", {{"rTRC", kSrgbCurve}})));
    EXPECT_FALSE(IsSrgbProfile(WithTags("RGB ", {{"rXYZ", Colorant(0.5151, 0.2412, -0.0011)},  // Display P3
                                                 {"gXYZ", Colorant(0.2920, 0.6922, 0.0419)},
                                                 {"bXYZ", Colorant(0.1571, 0.0666, 0.7841)},
                                                 {"rTRC", kSrgbCurve}})));
    EXPECT_EQ(LostColorSpace({0, {}, SrgbProfile()}, FileFormat::Exr), "");
    EXPECT_TRUE(HasSrgbColors({0, {}, SrgbProfile()}));
}

TEST(IccProfileTest, ACurveUnlikeSrgbsIsANote) {
    const auto notesOf = [](const Bytes& profile) {
        const TemporaryFolder folder;
        JpegFile file{{8, 8}, 3, Bytes(192, 50)};
        file.profile = profile;
        const Picture picture = ReadPicture(folder.Put("p", MakeJpeg(file)));
        EXPECT_EQ(picture.colorSpace.iccProfile, profile);
        return picture.notes;
    };
    EXPECT_TRUE(notesOf(SrgbProfile()).empty());
    EXPECT_TRUE(notesOf(WithTags("RGB ", {{"rTRC", Formula(0, {563 / 256.0})}})).empty());  // Adobe RGB (1998)
    EXPECT_EQ(notesOf(WithTags("RGB ", {{"rTRC", Formula(0, {1})}})),
              std::vector<std::string>{"its ICC profile's curve is not used: 0.5 is light of 0.50 by it "
                                       "and of 0.21 by sRGB's"});
}

}  // namespace
}  // namespace boxcar::test
