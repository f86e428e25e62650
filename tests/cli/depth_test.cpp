// boxcar dof: depth in the file's own units, against the thin lens's formula in double.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/cli/program.h"
#include "tests/reference/order.h"

namespace boxcar {
namespace {

constexpr int kWidth = 40, kHeight = 30;

// A lens of 50 mm at f/2, sharp at 1.2 m, over texels of 0.04 mm.
constexpr double kFocalMm = 50, kLensMm = 25, kSharpMm = 1200, kTexelMm = 0.04;
// A second camera, 120 mm beside it, sees what is at the distance d moved by so many texels.
constexpr double kDisparityTimesMm = 120 * kFocalMm / kTexelMm;

// c = D f |d - s| / (d (s - f)): similar triangles behind the lens, after Gauss's 1/f = 1/d + 1/d'.
double CircleTexels(double distanceMm) {
    if (std::isinf(distanceMm)) return kLensMm * kFocalMm / (kSharpMm - kFocalMm) / kTexelMm;
    return kLensMm * kFocalMm * std::abs(distanceMm - kSharpMm) / (distanceMm * (kSharpMm - kFocalMm)) / kTexelMm;
}

class Depth : public testing::Test {
protected:
    void SetUp() override {
        WritePicture(m_picture, m_folder.Path("in.png"), FileFormat::Png, SampleType::Unorm8);
        std::mt19937 random(3);
        for (int i = 0; i < kWidth * kHeight; i++)
            m_distanceMm.push_back(static_cast<double>(600 + random() % 6000));
    }

    void WriteDepth(const std::string& name, SampleType stored, const std::vector<double>& numbers) {
        const double largest = stored == SampleType::Unorm8 ? 255 : stored == SampleType::Unorm16 ? 65535 : 1;
        Picture depth{kWidth, kHeight, 1, stored, {}};
        for (const double number : numbers)
            depth.samples.push_back(static_cast<float>(number / largest));
        WritePicture(depth, m_folder.Path(name), stored == SampleType::Float32 ? FileFormat::Pfm : FileFormat::Png,
                     stored);
    }

    Picture Focused(const std::string& arguments) {
        const Outcome outcome = m_folder.Run("dof in.png -o out.exr " + arguments);
        EXPECT_EQ(outcome.exitCode, 0) << arguments << ": " << outcome.err;
        return outcome.exitCode == 0 ? ReadPicture(m_folder.Path("out.exr")) : Picture{};
    }

    void ExpectCircles(const std::string& arguments, const std::vector<double>& diameterTexels) {
        const Picture focused = Focused(arguments);
        ASSERT_EQ(focused.samples.size(), size_t{3} * kWidth * kHeight);
        for (size_t i = 0; i < diameterTexels.size(); i++) {
            const auto expected = reference::DiscMean(m_light, static_cast<double>(i % kWidth) + 0.5,
                                                      static_cast<double>(i / kWidth) + 0.5,
                                                      std::max(1.0, diameterTexels[i]), 16, reference::Border::Clip);
            for (int c = 0; c < 3; c++)
                ASSERT_NEAR(focused.samples[3 * i + static_cast<size_t>(c)], expected[c], 2e-5)
                    << arguments << ", texel " << i << ", circle " << diameterTexels[i];
        }
    }

    void ExpectSame(const std::string& one, const std::string& other) {
        EXPECT_EQ(Focused(one).samples, Focused(other).samples) << one << " and " << other;
    }

    void ExpectRefused(const std::string& arguments, int exitCode, const std::string& line) {
        const Outcome outcome = m_folder.Run("dof in.png -o out.png " + arguments);
        EXPECT_EQ(outcome.exitCode, exitCode) << arguments;
        EXPECT_EQ(outcome.err, "boxcar: " + line + "\n") << arguments;
    }

    Folder m_folder;
    Picture m_picture = RandomPicture(kWidth, kHeight, 3, SampleType::Unorm8);
    reference::DoubleImage m_light = ReferenceLight(m_picture, true);
    std::vector<double> m_distanceMm;  // whole numbers
};

const double kAtInfinity = CircleTexels(INFINITY);

// One scene in each of the units that files come in.
TEST_F(Depth, EveryUnitGivesTheThinLensesCircles) {
    m_distanceMm[7] = kSharpMm;
    std::vector<double> circles, meters, pixels, code256ths, code256thsCircles;
    for (const double d : m_distanceMm) {
        circles.push_back(CircleTexels(d));
        meters.push_back(static_cast<float>(d / 1000));
        pixels.push_back(static_cast<float>(kDisparityTimesMm / d));
        code256ths.push_back(std::round(256 * kDisparityTimesMm / d));
        code256thsCircles.push_back(CircleTexels(256 * kDisparityTimesMm / code256ths.back()));
    }
    const double sharpPixels = kDisparityTimesMm / kSharpMm;
    const auto lens = [](double focus, double aperture) {
        return fmt::format("--focus {} --aperture {}", focus, aperture);
    };

    WriteDepth("mm.png", SampleType::Unorm16, m_distanceMm);
    ExpectCircles("--depth mm.png --depth-is distance " + lens(1200, kAtInfinity), circles);
    ExpectCircles("--depth mm.png --depth-is distance --depth-scale 0.001 " + lens(1.2, kAtInfinity), circles);
    WriteDepth("m.pfm", SampleType::Float32, meters);
    ExpectCircles("--depth m.pfm --depth-is distance " + lens(1.2, kAtInfinity), circles);

    WriteDepth("px.pfm", SampleType::Float32, pixels);
    ExpectCircles("--depth px.pfm " + lens(sharpPixels, kAtInfinity / sharpPixels), circles);
    WriteDepth("px.png", SampleType::Unorm16, code256ths);
    ExpectCircles("--depth px.png --depth-scale 1/256 " + lens(sharpPixels, kAtInfinity / sharpPixels),
                  code256thsCircles);
    ExpectCircles("--depth px.png --depth-scale 1 " + lens(256 * sharpPixels, kAtInfinity / sharpPixels / 256),
                  code256thsCircles);
    const double white = 65535 / 256.0;
    ExpectCircles("--depth px.png " + lens(sharpPixels / white, kAtInfinity / sharpPixels * white),
                  code256thsCircles);
}

TEST_F(Depth, InfinityIsFarAwayAndZeroWhereItIsKnown) {
    std::vector<double> distances = m_distanceMm, circles;
    for (size_t i = 0; i < distances.size(); i += 3)
        distances[i] = INFINITY;
    std::vector<double> inverse;
    for (const double d : distances) {
        circles.push_back(CircleTexels(d));
        inverse.push_back(static_cast<float>(1000 / d));
    }
    WriteDepth("far.pfm", SampleType::Float32, distances);
    ExpectCircles(fmt::format("--depth far.pfm --depth-is distance --focus 1200 --aperture {}", kAtInfinity),
                  circles);
    WriteDepth("inverse.pfm", SampleType::Float32, inverse);
    ExpectCircles(
        fmt::format("--depth inverse.pfm --unknown none --focus {} --aperture {}", 1 / 1.2, 1.2 * kAtInfinity),
        circles);
    EXPECT_FALSE(
        Focused("--depth far.pfm --depth-is distance --focus 1200 --aperture 9 --method layered").samples.empty());
}

// One column of three is known: those beside it are nearer to it than to any other.
TEST_F(Depth, UnknownValuesTakeTheNearestKnown) {
    const auto writeFiles = [&](const std::string& name, const std::vector<double>& depth) {
        std::vector<double> whole, zero, nan, inf;
        for (size_t i = 0; i < depth.size(); i++) {
            const size_t x = i % kWidth, known = std::min<size_t>(x / 3 * 3 + 1, 37);
            whole.push_back(depth[i - x + known]);
            zero.push_back(x == known ? depth[i] : 0);
            nan.push_back(x == known ? depth[i] : NAN);
            inf.push_back(x == known ? depth[i] : INFINITY);
        }
        WriteDepth(name + ".pfm", SampleType::Float32, whole);
        WriteDepth(name + "-zero.pfm", SampleType::Float32, zero);
        WriteDepth(name + "-nan.pfm", SampleType::Float32, nan);
        WriteDepth(name + "-inf.pfm", SampleType::Float32, inf);
    };
    std::vector<double> disparity;
    for (const double d : m_distanceMm)
        disparity.push_back(kDisparityTimesMm / d);
    writeFiles("mm", m_distanceMm);
    writeFiles("px", disparity);

    const std::string distance = " --depth-is distance --focus 1200 --aperture 20";
    const auto whole = Focused("--depth mm.pfm" + distance).samples;
    for (const char* holes : {"mm-zero.pfm", "mm-nan.pfm", "mm-zero.pfm --unknown zero",
                              "mm-nan.pfm --unknown inf,nan", "mm-inf.pfm --unknown inf"})
        EXPECT_EQ(Focused(fmt::format("--depth {}{}", holes, distance)).samples, whole) << holes;
    EXPECT_NE(Focused("--depth mm-inf.pfm" + distance).samples, whole);  // far away

    const std::string stereo = " --focus 125 --aperture 0.2";
    const auto wholeStereo = Focused("--depth px.pfm" + stereo).samples;
    for (const char* holes :
         {"px-zero.pfm", "px-nan.pfm", "px-inf.pfm", "px-inf.pfm --unknown inf", "px-zero.pfm --unknown zero"})
        EXPECT_EQ(Focused(fmt::format("--depth {}{}", holes, stereo)).samples, wholeStereo) << holes;
    EXPECT_NE(Focused("--depth px-zero.pfm --unknown inf" + stereo).samples, wholeStereo);  // far away
}

TEST_F(Depth, FocusOnATexelIsFocusOnWhatIsSeenThere) {
    WriteDepth("mm.png", SampleType::Unorm16, m_distanceMm);
    const auto seen = m_distanceMm[9 * kWidth + 31];
    ExpectSame("--depth mm.png --depth-is distance --aperture 20 --focus 31,9",
               fmt::format("--depth mm.png --depth-is distance --aperture 20 --focus {}", seen));
    ExpectSame("--depth mm.png --depth-scale 1 --aperture 0.01 --focus 31,9",
               fmt::format("--depth mm.png --depth-scale 1 --aperture 0.01 --focus {}", seen));
    ExpectSame("--depth mm.png --aperture 100 --focus 31,9",
               fmt::format("--depth mm.png --aperture 100 --focus {}", static_cast<float>(seen / 65535)));
    m_distanceMm[9 * kWidth + 31] = 0;  // unknown
    m_distanceMm[9 * kWidth + 30] = 2345;
    for (const int at : {9 * kWidth + 32, 8 * kWidth + 31, 10 * kWidth + 31})
        m_distanceMm[static_cast<size_t>(at)] = 0;
    WriteDepth("mm.png", SampleType::Unorm16, m_distanceMm);
    ExpectSame("--depth mm.png --depth-is distance --aperture 20 --focus 31,9",
               "--depth mm.png --depth-is distance --aperture 20 --focus 2345");
}

TEST_F(Depth, RefusesWhatHasNoMeaningInOneLine) {
    const std::string aperture = " --aperture 9";
    m_distanceMm[kWidth + 2] = 0;
    WriteDepth("mm.png", SampleType::Unorm16, m_distanceMm);
    m_distanceMm[kWidth + 2] = INFINITY;
    WriteDepth("inf.pfm", SampleType::Float32, m_distanceMm);
    m_distanceMm[kWidth + 2] = NAN;
    WriteDepth("nan.pfm", SampleType::Float32, m_distanceMm);
    m_distanceMm[kWidth + 2] = -1;
    WriteDepth("negative.pfm", SampleType::Float32, m_distanceMm);
    WriteDepth("nothing.png", SampleType::Unorm8, std::vector<double>(kWidth * kHeight, 0));

    ExpectRefused("--depth inf.pfm --focus 9 --unknown zero" + aperture, 1,
                  "inf.pfm: inf at (2, 1); a disparity is finite; --unknown inf takes it as unknown");
    ExpectRefused("--depth nan.pfm --focus 9 --unknown zero,inf" + aperture, 1,
                  "nan.pfm: nan at (2, 1); --unknown nan takes it as unknown");
    ExpectRefused("--depth negative.pfm --focus 9" + aperture, 1, "negative.pfm: -1 at (2, 1); depth is 0 or more");
    ExpectRefused("--depth mm.png --depth-is distance --unknown none --focus 9" + aperture, 1,
                  "mm.png: 0 at (2, 1); a distance is more; --unknown zero takes it as unknown");
    ExpectRefused("--depth nothing.png --focus 0.5" + aperture, 1,
                  "nothing.png: the depth of every texel is unknown; --unknown says which values mean that");
    ExpectRefused("--depth inf.pfm --depth-is distance --focus 2,1" + aperture, 2,
                  "--focus 2,1: what is seen there is infinitely far; give a distance or another texel");
    ExpectRefused("--depth mm.png --focus 40,1" + aperture, 2, "--focus 40,1: expected x,y from 0,0 to 39,29");
    ExpectRefused("--depth mm.png --depth-is distance --focus 0.5" + aperture, 2,
                  "--focus 0.5: nearer than 1, a single step of mm.png; expected a distance in its units");
    ExpectRefused("--depth mm.png --depth-is distance --focus inf" + aperture, 2,
                  "--focus inf: expected a distance above 0, finite, or x,y of a texel");
    ExpectRefused("--depth mm.png --focus far" + aperture, 2,
                  "--focus far: expected a disparity, 0 (infinitely far) or more, or x,y of a texel");
    ExpectRefused("--depth mm.png --focus 1 --unknown none,zero" + aperture, 2,
                  "--unknown none: with other words; expected none alone, or some of zero, nan, inf");
    for (const char* scale : {"0", "-1", "1/0", "1/", "x", "nan", "inf", "1e10"})
        ExpectRefused(fmt::format("--depth mm.png --focus 1 --depth-scale={}{}", scale, aperture), 2,
                      fmt::format("--depth-scale {}: expected a number or A/B, above 0 and at most 1e+09", scale));
}

}  // namespace
}  // namespace boxcar
