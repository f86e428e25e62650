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

    // Both order what they do after all that was recorded before on the same images and buffers.
    //
    // Both throw Error: a texture of the shaders is not among pass.reads, or is a volume or a cube map where they
    // read another kind; a writable texture or a buffer is not among pass.storage, is the other of the two or is an
    // image that cannot be it; an image is read and written at once, or written by two names; the constants have
    // another size than the shaders'. The message names the pass.
    //
    // Draw also: the targets and the depth image differ in extent, are not of the pipeline's formats or are volumes;
    // a mesh or a depth image is missing, or given to a pipeline that has no use for it. Dispatch also: a count of
    // groups is 0 or more than the device runs.
    void Draw(const Pass& pass);
    void Dispatch(const ComputePass& pass);

    // Puts an image into the state for a use outside of Draw, with the barrier that it needs.
    void Use(const Image& image, ImageUse use);

    // Copies an image of one layer and level into a part of `target`, of the same format and of that part's extent.
    void Copy(const Image& source, const Image& target, uint32_t layer = 0, uint32_t level = 0);

    // Sets every texel. `rgba` is converted to the image's format, which is not Depth32F: a pass clears that.
    void Clear(const Image& image, const float (&rgba)[4]);

    // Ends the list, runs it and waits for it. Only for a list of one's own, once. Throws Error when the device is
    // lost.
    void SubmitAndWait();

    // After SubmitAndWait() of a list with timing: one entry a Draw or Dispatch, in order. Empty where the device has
    // no timer.
    std::vector<PassTime> PassTimes() const;

    // For Vulkan commands of one's own between passes.
    VkCommandBuffer Handle() const;

    struct Impl;
    Impl& impl() const { return *m_impl; }

private:
    std::unique_ptr<Impl> m_impl;
};

}  // namespace boxcar
