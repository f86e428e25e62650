// The structs that C++ and HLSL share have the same offsets in both.
#include <gtest/gtest.h>

#include "hlsl/constants/effect_constants.h"
#include "hlsl/constants/sat_constants.h"
#include "passes_shaders.h"
#include "tests/support/offsets.h"

namespace boxcar {
namespace {

TEST(PassesConstants, OffsetsInCppEqualThoseInTheShaders) {
    const Offsets pass = {OFFSET(SATPassConstants, strideUv), OFFSET(SATPassConstants, strideTexels),
                          OFFSET(SATPassConstants, originTexels)};
    const Offsets mean = {OFFSET(MeanConstants, extentTexels), OFFSET(MeanConstants, divisor)};
    const Offsets extend = {OFFSET(SATExtendConstants, extentTexels), OFFSET(SATExtendConstants, paddingTexels),
                            OFFSET(SATExtendConstants, isMirrored)};
    const Offsets filter = {OFFSET(SATFilterConstants, extentTexels),  OFFSET(SATFilterConstants, originTexels),
                            OFFSET(SATFilterConstants, paddingTexels), OFFSET(SATFilterConstants, widthMapTexels),
                            OFFSET(SATFilterConstants, minTexels),     OFFSET(SATFilterConstants, maxTexels),
                            OFFSET(SATFilterConstants, boxes),         OFFSET(SATFilterConstants, sides),
                            OFFSET(SATFilterConstants, codeScale),     OFFSET(SATFilterConstants, largestMass),
                            OFFSET(SATFilterConstants, isSigned),      OFFSET(SATFilterConstants, isWholeX),
                            OFFSET(SATFilterConstants, isWholeY)};
    const Offsets lens = {OFFSET(LensConstants, focusDisparity), OFFSET(LensConstants, apertureTexels),
                          OFFSET(LensConstants, largestTexels)};
    const Offsets lensLayer = {
        OFFSET(LensLayerConstants, focusDisparity), OFFSET(LensLayerConstants, apertureTexels),
        OFFSET(LensLayerConstants, behindKnot),     OFFSET(LensLayerConstants, knot),
        OFFSET(LensLayerConstants, beforeKnot),     OFFSET(LensLayerConstants, secondBeforeKnot),
        OFFSET(LensLayerConstants, thirdBeforeKnot)};
    const Offsets lensOver = {OFFSET(LensOverConstants, diameterTexels), OFFSET(LensOverConstants, boxes),
                              OFFSET(LensOverConstants, sides),          OFFSET(LensOverConstants, codeScale),
                              OFFSET(LensOverConstants, opacity),        OFFSET(LensOverConstants, isLast)};
    EXPECT_EQ(OffsetsIn(passes_shaders::Find("shaders/lens_width.ps")), lens);
    EXPECT_EQ(OffsetsIn(passes_shaders::Find("shaders/lens_layer.ps")), lensLayer);
    EXPECT_EQ(OffsetsIn(passes_shaders::Find("shaders/lens_over.ps.WORDS=2")), lensOver);
    EXPECT_EQ(OffsetsIn(passes_shaders::Find("shaders/sat_pass.vs.TAPS=16")), pass);
    EXPECT_EQ(OffsetsIn(passes_shaders::Find("shaders/sat_pass_load.ps.TAPS=2")), pass);
    EXPECT_EQ(OffsetsIn(passes_shaders::Find("shaders/sat_pass_exact.ps.TAPS=2.WORDS=2")), pass);
    EXPECT_EQ(OffsetsIn(passes_shaders::Find("shaders/mean.ps")), mean);
    EXPECT_EQ(OffsetsIn(passes_shaders::Find("shaders/sat_extend.ps.WORDS=1")), extend);
    EXPECT_EQ(OffsetsIn(passes_shaders::Find("shaders/sat_filter.ps.EDGE=SAT_EDGE_CLIP")), filter);
    EXPECT_EQ(
        OffsetsIn(passes_shaders::Find("shaders/sat_filter_exact.ps.ORDER=2.WHOLE=0.WORDS=2.EDGE=SAT_EDGE_CLIP")),
        filter);
    EXPECT_EQ(OffsetsIn(passes_shaders::Find("shaders/sat_blur_verbatim.ps")), filter);
}

}  // namespace
}  // namespace boxcar
