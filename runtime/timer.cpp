#include <algorithm>

#include "runtime/vulkan.h"

namespace boxcar {
namespace {

constexpr uint32_t kPassesPerPool = 256;
constexpr uint32_t kQueriesPerPool = 2 * kPassesPerPool;
constexpr auto kAllWorkBefore = vk::PipelineStageFlagBits2::eAllCommands;

}  // namespace

void PassTimer::Begin(vk::CommandBuffer commands, const std::string& pass) {
    const auto& dispatch = *m_device->device.getDispatcher();
    const auto index = static_cast<uint32_t>(m_names.size() % kPassesPerPool);
    if (index == 0) {
        m_pools.emplace_back(m_device->device,
                             vk::QueryPoolCreateInfo({}, vk::QueryType::eTimestamp, kQueriesPerPool));
        m_device->Name(m_pools.back(), "boxcar timer");
        commands.resetQueryPool(*m_pools.back(), 0, kQueriesPerPool, dispatch);
    }
    commands.writeTimestamp2(kAllWorkBefore, *m_pools.back(), 2 * index, dispatch);
    m_names.push_back(pass);
}

void PassTimer::End(vk::CommandBuffer commands) const {
    const auto index = static_cast<uint32_t>((m_names.size() - 1) % kPassesPerPool);
    commands.writeTimestamp2(kAllWorkBefore, *m_pools.back(), 2 * index + 1, *m_device->device.getDispatcher());
}

std::vector<PassTime> PassTimer::Times() const {
    std::vector<PassTime> times;
    for (const auto& pool : m_pools) {
        const auto passes = std::min(kPassesPerPool, static_cast<uint32_t>(m_names.size() - times.size()));
        const auto [result, ticks] = pool.getResults<uint64_t>(0, 2 * passes, 2 * passes * sizeof(uint64_t),
                                                               sizeof(uint64_t), vk::QueryResultFlagBits::e64);
        if (result != vk::Result::eSuccess) return {};
        for (uint32_t i = 0; i < passes; i++) {
            const auto elapsed = static_cast<double>(ticks[2 * i + 1] - ticks[2 * i]);
            times.push_back({m_names[times.size()], elapsed * m_device->nanosecondsPerTick * 1e-6});
        }
    }
    return times;
}

}  // namespace boxcar
