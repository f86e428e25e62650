#include "runtime/passes/mip_chain.h"

#include "runtime/passes/quad_shaders.h"

namespace boxcar {

MipChain::MipChain(Device& device, Extent2D extent) : MipChain(device, extent, QuadShaders("half.ps")) {}

MipChain::MipChain(Device& device, Extent2D extent, const PipelineDesc& halve)
    : m_halve(device, halve), m_all(device, {.extent = extent, .name = "mip levels", .levels = MipLevels(extent)}) {
    for (uint32_t level = 1; level < MipLevels(extent); level++)
        m_levels.emplace_back(device, ImageDesc{.extent = LevelExtent(extent, level), .name = "mip level"});
}

const Image& MipChain::Record(CommandList& commands, const Image& source) {
    commands.Copy(source, m_all);
    const Image* finer = &source;
    for (uint32_t level = 1; const Image& image : m_levels) {
        commands.Draw({.name = "mip level", .pipeline = m_halve, .reads = {{"finer", finer}}, .writes = {&image}});
        commands.Copy(image, m_all, 0, level++);
        finer = &image;
    }
    return m_all;
}

}  // namespace boxcar
