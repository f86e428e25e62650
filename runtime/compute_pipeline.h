// A compute shader, ready to be dispatched. Bindings, constants and samplers come from its reflected layout, as those
// of a Pipeline do (runtime/pipeline.h).
#pragma once

#include <cstdint>
#include <memory>

#include "runtime/device.h"
#include "tools/layout/shader_layout.h"

namespace boxcar {

// How many groups of threads run along each axis.
struct ThreadGroups {
    uint32_t x = 1;
    uint32_t y = 1;
    uint32_t z = 1;

    bool operator==(const ThreadGroups&) const = default;
};

// Move-only.
class ComputePipeline {
public:
    // Throws Error: not a compute shader; groups of more threads than the device runs; a resource of a kind or a
    // sampler of a name that the runtime does not know; constants over 128 bytes. The message names the shader and
    // the resource.
    ComputePipeline(Device& device, const EmbeddedShader& shader);

    ~ComputePipeline();
    ComputePipeline(ComputePipeline&&) noexcept;
    ComputePipeline& operator=(ComputePipeline&&) noexcept;

    // The fewest groups that have at least so many threads along each axis. The shader leaves out those beyond.
    ThreadGroups GroupsOver(uint32_t xThreads, uint32_t yThreads = 1, uint32_t zThreads = 1) const;

    struct Impl;
    Impl& impl() const { return *m_impl; }

private:
    std::unique_ptr<Impl> m_impl;
};

}  // namespace boxcar
