// The structs that C++ and HLSL share have the same offsets in both.
#include <gtest/gtest.h>

#include <cstddef>
#include <map>

#include "hlsl/constants/sat_constants.h"
#include "passes_shaders.h"
#include "tools/layout/shader_layout.h"

namespace boxcar {
namespace {

using Offsets = std::map<std::string, uint32_t>;

// The members that a shader uses: the optimiser may leave the rest out.
Offsets OffsetsIn(std::string_view shader) {
    const ShaderLayout layout = ShaderLayoutFromJson(passes_shaders::Find(shader).layoutJson);
    Offsets offsets;
    for (const LayoutResource& resource : layout.resources)
        if (resource.kind == ResourceKind::PushConstants)
            for (const LayoutMember& member : resource.members)
                offsets[member.name] = member.offsetBytes;
    return offsets;
}

#define OFFSET(Struct, member) \
    { "g." #member, offsetof(Struct, member) }

TEST(PassesConstants, OffsetsInCppEqualThoseInTheShaders) {
    const Offsets pass = {OFFSET(SATPassConstants, strideUv), OFFSET(SATPassConstants, strideTexels)};
    const Offsets bias = {OFFSET(SATBiasConstants, bias)};
    const Offsets filter = {OFFSET(SATFilterConstants, extentTexels), OFFSET(SATFilterConstants, sizeTexels),
                            OFFSET(SATFilterConstants, bias)};
    EXPECT_EQ(OffsetsIn("shaders/sat_pass.vs.TAPS=16"), pass);
    EXPECT_EQ(OffsetsIn("shaders/sat_pass_load.ps.TAPS=2"), pass);
    EXPECT_EQ(OffsetsIn("shaders/sat_bias.ps"), bias);
    EXPECT_EQ(OffsetsIn("shaders/sat_filter.ps.EDGE_ZERO=0"), filter);
    EXPECT_EQ(OffsetsIn("shaders/sat_blur_verbatim.ps"), filter);
}

}  // namespace
}  // namespace boxcar
