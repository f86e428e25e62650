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
                           OFFSET(SceneConstants, scale),         OFFSET(SceneConstants, albedo),
                           OFFSET(SceneConstants, turnCosine),    OFFSET(SceneConstants, eyeWorld),
                           OFFSET(SceneConstants, turnSine)};
    const Offsets backdrop = {OFFSET(BackdropConstants, rightWorld),   OFFSET(BackdropConstants, unused0),
                              OFFSET(BackdropConstants, upWorld),      OFFSET(BackdropConstants, unused1),
                              OFFSET(BackdropConstants, forwardWorld), OFFSET(BackdropConstants, unused2)};
    const Offsets face = {OFFSET(DPFaceConstants, face), OFFSET(DPFaceConstants, sideTexels),
                          OFFSET(DPFaceConstants, codeScale), OFFSET(DPFaceConstants, largestLight)};
    const Offsets encode = {OFFSET(SATEncodeConstants, scale), OFFSET(SATEncodeConstants, largest)};
    const Offsets lensMips = {OFFSET(LensMipsConstants, focusDisparity), OFFSET(LensMipsConstants, apertureTexels),
                              OFFSET(LensMipsConstants, noiseLevels)};
    EXPECT_EQ(OffsetsIn(scenes_shaders::Find("shaders/scene.vs")), scene);
    EXPECT_EQ(OffsetsIn(scenes_shaders::Find("shaders/environment.ps")), backdrop);
    EXPECT_EQ(OffsetsIn(effects_shaders::Find("shaders/lens_mips.ps")), lensMips);
    EXPECT_EQ(OffsetsIn(passes_shaders::Find("shaders/dp_encode.ps.FINE=0")), face);
    EXPECT_EQ(OffsetsIn(passes_shaders::Find("shaders/sat_encode.ps.WORDS=2")), encode);
}

// The members of `scene`, as they lie in a block that begins with it, and those of the block's own.
Offsets OfObject(Offsets own) {
    own.merge(Offsets{OFFSET(MattConstants, scene.clipFromWorld), OFFSET(MattConstants, scene.offsetWorld),
                      OFFSET(MattConstants, scene.scale), OFFSET(MattConstants, scene.albedo),
                      OFFSET(MattConstants, scene.turnCosine), OFFSET(MattConstants, scene.eyeWorld),
                      OFFSET(MattConstants, scene.turnSine)});
    return own;
}

TEST(EffectConstants, BlocksOfObjectsBeginWithTheScenes) {
    const std::pair<EmbeddedShader, Offsets> blocks[] = {
        {scenes_shaders::Find("shaders/scene.ps"), {OFFSET(MattConstants, checkWorld)}},
        {effects_shaders::Find("shaders/glossy.ps.LOBE=STACK"),
         {OFFSET(GlossyConstants, widthTexels), OFFSET(GlossyConstants, codeScale),
          OFFSET(GlossyConstants, largestTexels)}},
        {effects_shaders::Find("shaders/phong.ps"),
         {OFFSET(PhongConstants, exponent), OFFSET(PhongConstants, shine), OFFSET(PhongConstants, boxes),
          OFFSET(PhongConstants, codeScale)}},
        {effects_shaders::Find("shaders/dp_scene.vs"),
         {OFFSET(DPSceneConstants, checkWorld), OFFSET(DPSceneConstants, face), OFFSET(DPSceneConstants, farWorld)}},
        {effects_shaders::Find("shaders/planar_floor.ps.WORDS=1"),
         {OFFSET(PlanarFloorConstants, checkWorld), OFFSET(PlanarFloorConstants, coneTexels),
          OFFSET(PlanarFloorConstants, codeScale), OFFSET(PlanarFloorConstants, mirrorShare)}},
        {effects_shaders::Find("shaders/glass.ps.WORDS=2"),
         {OFFSET(GlassConstants, blurTexels), OFFSET(GlassConstants, bendTexels), OFFSET(GlassConstants, codeScale)}},
        {effects_shaders::Find("shaders/texture_table.ps"), {OFFSET(TexturedConstants, repeats)}},
        {effects_shaders::Find("shaders/shadow_depth.ps"),
         {OFFSET(ShadowDepthConstants, nearWorld), OFFSET(ShadowDepthConstants, reachWorld)}},
        {effects_shaders::Find("shaders/lens_scene.ps.HIDDEN=0"), {OFFSET(LensSceneConstants, brightness)}}};
    for (const auto& [shader, own] : blocks)
        EXPECT_EQ(OffsetsIn(shader), OfObject(own)) << shader.name;
}

}  // namespace
}  // namespace boxcar
