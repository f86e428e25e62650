// The structs that C++ and HLSL share have the same members, offsets and sizes in both. Shaders name such a struct g
// in their block of constants.
#include <gtest/gtest.h>

#include <algorithm>

#include "effects_shaders.h"
#include "passes_shaders.h"
#include "precision_shaders.h"
#include "scenes_shaders.h"
#include "tests/support/shared_structs.h"

namespace boxcar {
namespace {

struct Block {
    std::string shader;
    LayoutResource constants;
};

// The blocks of constants of every shader. A new set of shaders gets its line here.
const std::vector<Block>& Blocks() {
    static const std::vector<Block> kBlocks = [] {
        std::vector<Block> blocks;
        for (const auto& shaders :
             {passes_shaders::All(), scenes_shaders::All(), effects_shaders::All(), precision_shaders::All()})
            for (const EmbeddedShader& shader : shaders)
                for (LayoutResource& resource : ShaderLayoutFromJson(shader.layoutJson).resources)
                    if (resource.kind == ResourceKind::PushConstants)
                        blocks.push_back({std::string(shader.name), std::move(resource)});
        return blocks;
    }();
    return kBlocks;
}

bool Match(const SharedStruct& shared, const Block& block) {
    return shared.sizeBytes == block.constants.sizeBytes && shared.members == block.constants.members;
}

TEST(SharedConstants, EveryStructIsTheBlockOfAShader) {
    for (const SharedStruct& shared : kSharedStructs)
        EXPECT_TRUE(std::ranges::any_of(Blocks(), [&](const Block& block) { return Match(shared, block); }))
            << shared.name << ": no shader has a block of these members, offsets and sizes";
}

TEST(SharedConstants, EveryBlockOfAShaderIsAStruct) {
    ASSERT_FALSE(Blocks().empty());
    for (const Block& block : Blocks())
        EXPECT_TRUE(std::ranges::any_of(kSharedStructs, [&](const SharedStruct& s) { return Match(s, block); }))
            << block.shader << ": no struct of hlsl/constants has the members, offsets and sizes of its block";
}

}  // namespace
}  // namespace boxcar
