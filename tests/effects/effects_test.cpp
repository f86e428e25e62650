// What holds for every effect of the table.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <set>

#include "tests/effects/effect_pictures.h"
#include "tests/support/expect_error.h"

namespace boxcar {
namespace {

bool IsFinite(const glm::vec4& texel) {
    return std::isfinite(texel.x) && std::isfinite(texel.y) && std::isfinite(texel.z) && std::isfinite(texel.w);
}

class EveryEffect : public testing::TestWithParam<std::string> {};

TEST_P(EveryEffect, IsFiniteAtEverySizeWithoutAValidationMessage) {
    for (const Extent2D extent : {Extent2D{1, 1}, Extent2D{63, 37}, Extent2D{1920, 1080}}) {
        EffectPictures effect(GetParam(), extent);
        const Texels picture = effect.Picture({}, 0.7);
        ASSERT_EQ(picture.size(), extent.Texels());
        const auto wrong = std::ranges::find_if_not(picture, IsFinite);
        EXPECT_EQ(wrong, picture.end()) << extent.widthTexels << " x " << extent.heightTexels << ", texel "
                                        << wrong - picture.begin();
        EXPECT_EQ(TakeValidationMessages(), std::vector<std::string>());
    }
}

TEST_P(EveryEffect, TheSameTimeIsTheSamePicture) {
    EffectPictures effect(GetParam(), {80, 50});
    const Texels first = effect.Picture({}, 1.25);
    effect.Picture({}, 7);
    EXPECT_EQ(effect.Picture({}, 1.25), first);
    EXPECT_EQ(EffectPictures(GetParam(), {80, 50}).Picture({}, 1.25), first);
}

// Every choice of every parameter, and both ends of every range.
TEST_P(EveryEffect, TakesEveryValueThatItSaysItTakes) {
    const EffectInfo& info = FindEffect(GetParam());
    for (const Parameter& parameter : info.parameters) {
        std::vector<std::string> values;
        for (const std::string_view choice : parameter.choices)
            values.emplace_back(choice);
        if (values.empty()) values = {fmt::format("{}", parameter.minimum), fmt::format("{}", parameter.maximum)};
        for (const std::string& value : values) {
            EffectPictures effect(info.name, {48, 30}, {{std::string(parameter.name), value}});
            const Texels picture = effect.Picture({}, 0.3);
            EXPECT_TRUE(std::ranges::all_of(picture, IsFinite)) << parameter.name << "=" << value;
        }
    }
}

uint64_t ResidentBytes() {
    uint64_t pages = 0, resident = 0;
    std::ifstream("/proc/self/statm") >> pages >> resident;
    return resident * static_cast<uint64_t>(sysconf(_SC_PAGESIZE));
}

// 300 frames of each take minutes: --long. Else of the ones that come first to mind.
TEST_P(EveryEffect, KeepsItsMemoryOverManyFrames) {
    if (!std::getenv("BOXCAR_LONG_TESTS") && GetParam() != "planar-reflection")
        GTEST_SKIP() << "300 frames: tools/run test --long";
    // Without the validation layer, which remembers some 20 KB of every frame that copies into a cube map.
    Device device(DeviceDesc{.selector = TestDeviceSelector()});
    const EffectInfo& info = FindEffect(GetParam());
    const ParameterValues values(info.parameters);
    const auto effect = info.make(device, EffectPictures::InputsFor(info, {320, 200}), values);
    uint64_t atFrame50 = 0;
    for (int frame = 0; frame < 300; frame++) {
        if (frame == 50) atFrame50 = ResidentBytes();
        CommandList commands(device);
        effect->Record(commands, {frame / 30.0, values});
        commands.SubmitAndWait();
    }
    EXPECT_LE(static_cast<double>(ResidentBytes()), 1.02 * static_cast<double>(atFrame50));
}

INSTANTIATE_TEST_SUITE_P(All, EveryEffect, testing::ValuesIn(EffectNames()), [](const auto& test) {
    std::string name = test.param;
    std::ranges::replace(name, '-', '_');
    return name;
});

TEST(Effects, NamesAreUniqueAndEveryParameterHasAnInitialValueOfItsRange) {
    std::set<std::string_view> names;
    for (const EffectInfo& info : Effects()) {
        EXPECT_TRUE(names.insert(info.name).second) << info.name;
        EXPECT_FALSE(info.what.empty() || info.paper.empty() || info.lookFor.empty()) << info.name;
        std::set<std::string_view> parameters;
        for (const Parameter& parameter : info.parameters) {
            EXPECT_TRUE(parameters.insert(parameter.name).second) << info.name << " " << parameter.name;
            if (!parameter.choices.empty()) {
                EXPECT_LT(parameter.initial, parameter.choices.size());
                continue;
            }
            EXPECT_LE(parameter.minimum, parameter.initial) << info.name << " " << parameter.name;
            EXPECT_LE(parameter.initial, parameter.maximum) << info.name << " " << parameter.name;
        }
    }
}

TEST(Effects, WrongNamesAndValuesAreRefusedInOneLine) {
    const Parameter parameters[] = {{"width", "", "texels", 1, 100, 9},
                                    {"boxes", "", "", 1, 6, 2, {}, true},
                                    {"lobe", "", "", 0, 0, 0, {"box", "tent"}}};
    ParameterValues values(parameters);
    EXPECT_ERROR(values.Set("size", "3"), "no parameter 'size'; there is width, boxes, lobe");
    EXPECT_ERROR(values.Set("width", "101"), "width=101: expected a number from 1 to 100 texels");
    EXPECT_ERROR(values.Set("width", "nan"), "width=nan: expected a number from 1 to 100 texels");
    EXPECT_ERROR(values.Set("width", "9x"), "width=9x: expected a number from 1 to 100 texels");
    EXPECT_ERROR(values.Set("boxes", "2.5"), "boxes=2.5: expected a whole number from 1 to 6");
    EXPECT_ERROR(values.Set("lobe", "disc"), "lobe=disc: expected one of box, tent");
    values.Set("width", "2.5");
    values.Set("lobe", "tent");
    EXPECT_EQ(values["width"], 2.5f);
    EXPECT_EQ(values.Whole("boxes"), 2);
    EXPECT_EQ(values.Choice("lobe"), "tent");
}

}  // namespace
}  // namespace boxcar
