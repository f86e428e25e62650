#include "tools/layout/registers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace boxcar {
namespace {

TEST(RegistersTest, BindingBelongsToTheClassWithTheLastBaseBeforeIt) {
    EXPECT_EQ(RegisterAt(0), (HlslRegister{'b', 0}));
    EXPECT_EQ(RegisterAt(15), (HlslRegister{'b', 15}));
    EXPECT_EQ(RegisterAt(16), (HlslRegister{'s', 0}));
    EXPECT_EQ(RegisterAt(31), (HlslRegister{'s', 15}));
    EXPECT_EQ(RegisterAt(32), (HlslRegister{'u', 0}));
    EXPECT_EQ(RegisterAt(95), (HlslRegister{'u', 63}));
    EXPECT_EQ(RegisterAt(96), (HlslRegister{'t', 0}));
    EXPECT_EQ(RegisterAt(223), (HlslRegister{'t', 127}));
}

TEST(RegistersTest, BasesAscendAndNameEachClassOnce) {
    EXPECT_TRUE(std::ranges::is_sorted(kRegisterBases, std::less(), &RegisterBase::binding));
    for (const char registerClass : {'b', 's', 'u', 't'})
        EXPECT_EQ(std::ranges::count(kRegisterBases, registerClass, &RegisterBase::registerClass), 1);
}

}  // namespace
}  // namespace boxcar
