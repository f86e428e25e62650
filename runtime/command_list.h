// Records passes and the barriers between them.
#pragma once

#include <memory>
#include <vector>

#include "runtime/pass.h"
#include "runtime/timing.h"

namespace boxcar {

// Move-only. Keep what a pass names alive until the work is done.
class CommandList {
public:
    enum class Timing { Off, On };

    explicit CommandList(Device& device, Timing timing = Timing::Off);

    // Records into an engine's command buffer, which is being recorded and outside of rendering. The engine ends and
    // submits it; this object must live until that work is done.
    CommandList(Device& device, VkCommandBuffer wrapped);

    ~CommandList();
    CommandList(CommandList&&) noexcept;
    CommandList& operator=(CommandList&&) noexcept;

    // Throws Error: a texture of the shaders is not among pass.reads, or is a volume or a cube map where they read
    // another kind; an image is read and written at once; the targets and the depth image differ in extent, are not
    // of the pipeline's formats or are volumes; the constants have another size than the shaders'; a mesh or a depth
    // image is missing, or given to a pipeline that has no use for it. The message names the pass.
    void Draw(const Pass& pass);

    // Puts an image into the state for a use outside of Draw, with the barrier that it needs.
    void Use(const Image& image, ImageUse use);

    // Copies an image of one layer and level into a part of `target`, of the same format and of that part's extent.
    void Copy(const Image& source, const Image& target, uint32_t layer = 0, uint32_t level = 0);

    // Sets every texel. `rgba` is converted to the image's format, which is not Depth32F: a pass clears that.
    void Clear(const Image& image, const float (&rgba)[4]);

    // Ends the list, runs it and waits for it. Only for a list of one's own, once. Throws Error when the device is
    // lost.
    void SubmitAndWait();

    // After SubmitAndWait() of a list with timing: one entry a Draw, in order. Empty where the device has no timer.
    std::vector<PassTime> PassTimes() const;

    // For Vulkan commands of one's own between passes.
    VkCommandBuffer Handle() const;

    struct Impl;
    Impl& impl() const { return *m_impl; }

private:
    std::unique_ptr<Impl> m_impl;
};

}  // namespace boxcar
