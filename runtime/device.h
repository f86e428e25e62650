// The device that everything else is made on.
//
//   Device -> Image, StorageBuffer, Pipeline, ComputePipeline -> CommandList records Passes -> ReadTexels, ReadBytes
//
// runtime/ is the thinnest layer over Vulkan that image-to-image chains need: one queue, one thread, dynamic
// rendering, barriers derived from what a pass says it reads and writes, bindings by the names in the HLSL. It can
// run on a device of its own or inside an engine's. It needs Vulkan 1.3 with dynamicRendering, synchronization2 and
// maintenance4, which every 1.3 driver has.
//
// Non-goals: a render graph, other APIs, windows, scenes, files.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace boxcar {

struct DeviceInfo {
    uint32_t index = 0;      // what --device takes
    std::string name;        // "llvmpipe (LLVM 15.0.6, 256 bits)"
    std::string driver;      // "llvmpipe Mesa 22.3.6"
    std::string apiVersion;  // "1.3.230"
    std::string kind;        // "discrete GPU", "integrated GPU", "virtual GPU", "CPU"
    std::string unusable;    // why it cannot be used, or empty
};

// All devices of this machine, in the loader's order. Throws Error where there is no Vulkan driver at all.
std::vector<DeviceInfo> ListDevices();

struct DeviceLimits {
    uint32_t maxSideTexels = 0;        // of an image
    uint32_t maxVolumeSideTexels = 0;  // of a volume
    uint64_t maxImageBytes = 0;        // of one image's memory
};

struct DeviceDesc {
    std::string selector;  // an index, or a part of the name in any case; empty: the first usable device
    bool validation = false;
    // Called with every warning and error of the validation layer; synchronization validation is on. Without it they
    // are printed to stderr.
    std::function<void(const std::string& message)> onValidationMessage = {};
};

// An engine's own device. It must outlive the Device made of it, be created with the three features,
// and `queue` must be a graphics queue that nobody else submits to at the same time. Pixel shaders that write
// storage need fragmentStoresAndAtomics as well.
struct AdoptedDevice {
    VkInstance instance = VK_NULL_HANDLE;
    VkPhysicalDevice physicalDevice = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    VkQueue queue = VK_NULL_HANDLE;
    uint32_t queueFamily = 0;
    // Vulkan cannot be asked what the engine enabled, so it says so here.
    bool hasDebugUtils = false;         // VK_EXT_debug_utils, of the instance: names and labels for debuggers
    bool hasSamplerAnisotropy = false;  // the feature, of the device; without it anisotropic samplers are linear
};

// Not thread-safe, and neither is anything made on it. Must outlive all that is made on it.
class Device {
public:
    // Throws Error: no driver; no device matches the selector (the message lists them); the device lacks a feature;
    // the validation layer is asked for and not installed.
    explicit Device(const DeviceDesc& desc = {});

    // Destroys nothing of the engine's.
    explicit Device(const AdoptedDevice& adopted);

    ~Device();
    Device(Device&&) = delete;

    const DeviceInfo& Info() const;
    const DeviceLimits& Limits() const;

    // Bytes of device memory held by what was made on this device, now and at the most.
    uint64_t MemoryBytes() const;
    uint64_t PeakMemoryBytes() const;

    // For use beside an engine's own Vulkan code; in this form another Device can adopt it.
    AdoptedDevice Handles() const;

    struct Impl;
    Impl& impl() const { return *m_impl; }

private:
    std::unique_ptr<Impl> m_impl;
};

}  // namespace boxcar
