#include "runtime/command_list.h"

#include <limits>

#include "runtime/vulkan.h"
#include "tools/base/error.h"

namespace boxcar {
namespace {

// Command buffers are kept and recorded anew: freed ones are a race in the validation layer (1.3.239), whose own
// thread forgets the labels of the old buffer while the next one, often of the same address, is being labeled.
vk::raii::CommandBuffer TakeCommands(Device::Impl& device) {
    if (device.idleCommands.empty()) {
        auto commands = std::move(
            device.device.allocateCommandBuffers({**device.commandPool, vk::CommandBufferLevel::ePrimary, 1})[0]);
        device.Name(commands, "boxcar commands");
        return commands;
    }
    auto commands = std::move(device.idleCommands.back());
    device.idleCommands.pop_back();
    commands.reset();
    return commands;
}

}  // namespace

CommandList::CommandList(Device& device, Timing timing) : m_impl(new Impl) {
    Impl& c = *m_impl;
    c.device = &device.impl();
    c.own = TakeCommands(*c.device);
    c.commands = *c.own;
    c.own.begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    if (timing == Timing::On && c.device->nanosecondsPerTick > 0) c.timer.emplace(*c.device);
}

CommandList::CommandList(Device& device, VkCommandBuffer wrapped) : m_impl(new Impl) {
    m_impl->device = &device.impl();
    m_impl->commands = wrapped;
}

CommandList::Impl::~Impl() {
    if (*own && !isPending) device->idleCommands.push_back(std::move(own));
}

CommandList::~CommandList() = default;
CommandList::CommandList(CommandList&&) noexcept = default;
CommandList& CommandList::operator=(CommandList&&) noexcept = default;

void CommandList::Impl::BeginPass(std::string_view name) {
    const std::string label(name);
    if (device->hasDebugUtils)
        commands.beginDebugUtilsLabelEXT(vk::DebugUtilsLabelEXT(label.c_str()), *device->device.getDispatcher());
    if (timer) timer->Begin(commands, label);
}

void CommandList::Impl::EndPass() {
    if (timer) timer->End(commands);
    if (device->hasDebugUtils) commands.endDebugUtilsLabelEXT(*device->device.getDispatcher());
}

void CommandList::Use(const Image& image, ImageUse use) {
    m_impl->Barrier(image, use);
}

void CommandList::Copy(const Image& source, const Image& target, uint32_t layer, uint32_t level) {
    Impl& c = *m_impl;
    const ImageDesc &from = source.Desc(), &to = target.Desc();
    BOXCAR_ASSERT(!from.IsVolume() && !to.IsVolume());
    BOXCAR_ASSERT(from.layers == 1 && from.levels == 1 && from.format == to.format && layer < to.layers &&
                  level < to.levels && from.extent == LevelExtent(to.extent, level) && &source != &target);
    c.Barrier(source, ImageUse::TransferSource);
    c.Barrier(target, ImageUse::TransferTarget);
    const auto aspect = AspectOf(from.format);
    const vk::ImageCopy region({aspect, 0, 0, 1}, {}, {aspect, level, layer, 1}, {},
                               {from.extent.widthTexels, from.extent.heightTexels, 1});
    c.commands.copyImage(source.Handle(), source.impl().state.layout, target.Handle(), target.impl().state.layout,
                         region, *c.device->device.getDispatcher());
}

void CommandList::Clear(const Image& image, const float (&rgba)[4]) {
    Impl& c = *m_impl;
    BOXCAR_ASSERT(image.Desc().format != Format::Depth32F);
    c.Barrier(image, ImageUse::TransferTarget);
    const vk::ClearColorValue value = ClearValue({rgba[0], rgba[1], rgba[2], rgba[3]}, image.Desc().format);
    c.commands.clearColorImage(
        image.Handle(), image.impl().state.layout, value,
        vk::ImageSubresourceRange(vk::ImageAspectFlagBits::eColor, 0, image.Desc().levels, 0, image.Desc().layers),
        *c.device->device.getDispatcher());
}

void CommandList::SubmitAndWait() {
    Impl& c = *m_impl;
    BOXCAR_ASSERT(*c.own);
    c.own.end();
    const vk::raii::Fence fence(c.device->device, vk::FenceCreateInfo());
    c.device->Name(fence, "boxcar submit");
    const vk::CommandBuffer commands = *c.own;
    c.isPending = true;
    c.device->queue.submit(vk::SubmitInfo({}, {}, commands), *fence);
    if (c.device->device.waitForFences(*fence, true, std::numeric_limits<uint64_t>::max()) != vk::Result::eSuccess)
        throw Error("the device '{}' did not finish", c.device->info.name);
    c.isPending = false;
    if (c.timer) c.times = c.timer->Times();
}

std::vector<PassTime> CommandList::PassTimes() const {
    return m_impl->times;
}
VkCommandBuffer CommandList::Handle() const {
    return m_impl->commands;
}

}  // namespace boxcar
