// The structs that C++ and HLSL share have the same offsets in both.
#include <gtest/gtest.h>

#include "effects_shaders.h"
#include "hlsl/constants/dp_constants.h"
#include "hlsl/constants/effect_constants.h"
#include "hlsl/constants/sat_constants.h"
#include "hlsl/constants/scene_constants.h"
#include "passes_shaders.h"
#include "scenes_shaders.h"
#include "tests/support/offsets.h"

namespace boxcar {
namespace {

TEST(EffectConstants, OffsetsInCppEqualThoseInTheShaders) {
    const Offsets scene = {OFFSET(SceneConstants, clipFromWorld), OFFSET(SceneConstants, offsetWorld),
                           OFFSET(SceneConstants, scale),         OFFSET(SceneConstants, turn),
                           OFFSET(SceneConstants, checkWorld),    OFFSET(SceneConstants, optionA),
                           OFFSET(SceneConstants, albedo),        OFFSET(SceneConstants, optionB),
                           OFFSET(SceneConstants, eyeWorld),      OFFSET(SceneConstants, optionC)};
    const Offsets backdrop = {OFFSET(BackdropConstants, rightWorld),   OFFSET(BackdropConstants, unused0),
                              OFFSET(BackdropConstants, upWorld),      OFFSET(BackdropConstants, unused1),
                              OFFSET(BackdropConstants, forwardWorld), OFFSET(BackdropConstants, unused2)};
    const Offsets face = {OFFSET(DPFaceConstants, face), OFFSET(DPFaceConstants, sideTexels),
                          OFFSET(DPFaceConstants, codeScale), OFFSET(DPFaceConstants, largestLight)};
    const Offsets encode = {OFFSET(SATEncodeConstants, scale), OFFSET(SATEncodeConstants, largest)};
    const Offsets lensMips = {OFFSET(LensMipsConstants, focusDisparity), OFFSET(LensMipsConstants, apertureTexels),
                              OFFSET(LensMipsConstants, noiseLevels)};
    EXPECT_EQ(OffsetsIn(effects_shaders::Find("shaders/planar_floor.ps.WORDS=1")), scene);
    EXPECT_EQ(OffsetsIn(scenes_shaders::Find("shaders/scene.vs")), scene);
    EXPECT_EQ(OffsetsIn(scenes_shaders::Find("shaders/environment.ps")), backdrop);
    EXPECT_EQ(OffsetsIn(effects_shaders::Find("shaders/lens_mips.ps")), lensMips);
    EXPECT_EQ(OffsetsIn(passes_shaders::Find("shaders/dp_encode.ps.FINE=0")), face);
    EXPECT_EQ(OffsetsIn(passes_shaders::Find("shaders/sat_encode.ps.WORDS=2")), encode);
}

}  // namespace
}  // namespace boxcar
