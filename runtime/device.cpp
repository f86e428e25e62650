#include "runtime/device.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstring>
#include <span>

#include "runtime/vulkan.h"
#include "tools/base/error.h"

namespace boxcar {
namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";
constexpr uint32_t kApiVersion = VK_API_VERSION_1_3;

VKAPI_ATTR VkBool32 VKAPI_CALL OnMessage(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                         const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
    std::string message = data->pMessage;
    // Layers from 1.4 on leave the names of objects out of their text.
    for (const auto& object : std::span(data->pObjects, data->objectCount))
        if (object.pObjectName && message.find(object.pObjectName) == std::string::npos)
            message += fmt::format(" ['{}']", object.pObjectName);
    static_cast<Device::Impl*>(user)->onValidationMessage(message);
    return VK_FALSE;
}

bool HasExtension(const std::vector<vk::ExtensionProperties>& extensions, const char* name) {
    return std::ranges::any_of(extensions, [&](const auto& e) { return std::strcmp(e.extensionName, name) == 0; });
}

vk::raii::Context LoadVulkan() {
    try {
        return vk::raii::Context();
    } catch (const std::exception&) {
        throw Error(
            "no Vulkan loader (libvulkan.so.1): install libvulkan1 and a driver, such as mesa-vulkan-drivers");
    }
}

vk::raii::Instance CreateInstance(const vk::raii::Context& context, bool validation) {
    std::vector<const char*> layers;
    if (validation) {
        const auto available = context.enumerateInstanceLayerProperties();
        if (std::ranges::none_of(available, [](const auto& l) { return !strcmp(l.layerName, kValidationLayer); }))
            throw Error("validation layer {} not found: install vulkan-validationlayers", kValidationLayer);
        layers.push_back(kValidationLayer);
    }
    std::vector<const char*> extensions;
    if (validation || HasExtension(context.enumerateInstanceExtensionProperties(), VK_EXT_DEBUG_UTILS_EXTENSION_NAME))
        extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);

    const vk::ApplicationInfo application("boxcar", 1, "boxcar", 1, kApiVersion);
    vk::InstanceCreateInfo info({}, &application, layers, extensions);
    const vk::ValidationFeatureEnableEXT synchronization = vk::ValidationFeatureEnableEXT::eSynchronizationValidation;
    const vk::ValidationFeaturesEXT features(1, &synchronization);
    if (validation) info.pNext = &features;
    try {
        return vk::raii::Instance(context, info);
    } catch (const vk::IncompatibleDriverError&) {
        throw Error(
            "no Vulkan driver: install one, such as mesa-vulkan-drivers, and see that VK_ICD_FILENAMES, if it "
            "is set, names it");
    }
}

std::string VersionText(uint32_t version) {
    return fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(version), VK_API_VERSION_MINOR(version),
                       VK_API_VERSION_PATCH(version));
}

std::optional<uint32_t> GraphicsQueueFamily(const vk::raii::PhysicalDevice& device) {
    const auto families = device.getQueueFamilyProperties();
    for (uint32_t i = 0; i < families.size(); i++)
        if (families[i].queueFlags & vk::QueueFlagBits::eGraphics) return i;
    return {};
}

std::string WhyUnusable(const vk::raii::PhysicalDevice& device) {
    const uint32_t version = device.getProperties().apiVersion;
    if (version < kApiVersion) return fmt::format("has Vulkan {}, 1.3 is needed", VersionText(version));
    const auto features = device.getFeatures2<vk::PhysicalDeviceFeatures2, vk::PhysicalDeviceVulkan13Features>();
    const auto& vulkan13 = features.get<vk::PhysicalDeviceVulkan13Features>();
    if (!vulkan13.dynamicRendering) return "lacks dynamicRendering";
    if (!vulkan13.synchronization2) return "lacks synchronization2";
    if (!vulkan13.maintenance4) return "lacks maintenance4";
    if (!GraphicsQueueFamily(device)) return "has no graphics queue";
    return "";
}

DeviceInfo Describe(const vk::raii::PhysicalDevice& device, uint32_t index) {
    DeviceInfo info;
    info.index = index;
    const auto properties = device.getProperties();
    info.name = properties.deviceName.data();
    info.apiVersion = VersionText(properties.apiVersion);
    switch (properties.deviceType) {
        case vk::PhysicalDeviceType::eDiscreteGpu: info.kind = "discrete GPU"; break;
        case vk::PhysicalDeviceType::eIntegratedGpu: info.kind = "integrated GPU"; break;
        case vk::PhysicalDeviceType::eVirtualGpu: info.kind = "virtual GPU"; break;
        case vk::PhysicalDeviceType::eCpu: info.kind = "CPU"; break;
        default: info.kind = "other"; break;
    }
    if (properties.apiVersion >= VK_API_VERSION_1_2) {
        const auto chain = device.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceDriverProperties>();
        const auto& driver = chain.get<vk::PhysicalDeviceDriverProperties>();
        info.driver = fmt::format("{} {}", driver.driverName.data(), driver.driverInfo.data());
    }
    info.unusable = WhyUnusable(device);
    return info;
}

std::vector<DeviceInfo> DescribeAll(const std::vector<vk::raii::PhysicalDevice>& devices) {
    std::vector<DeviceInfo> infos;
    for (uint32_t i = 0; i < devices.size(); i++)
        infos.push_back(Describe(devices[i], i));
    if (infos.empty()) throw Error("no Vulkan device: install a driver, such as mesa-vulkan-drivers");
    return infos;
}

std::string Lower(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

bool Matches(const DeviceInfo& info, const std::string& selector) {
    if (selector.empty()) return info.unusable.empty();
    if (std::ranges::all_of(selector, [](unsigned char c) { return std::isdigit(c); }))
        return std::to_string(info.index) == selector;
    return Lower(info.name).find(Lower(selector)) != std::string::npos;
}

const DeviceInfo& Choose(const std::vector<DeviceInfo>& infos, const std::string& selector) {
    std::string known;
    for (const DeviceInfo& info : infos) {
        known += fmt::format("{}{}: {}", known.empty() ? "" : "; ", info.index, info.name);
        if (!info.unusable.empty()) known += fmt::format(" ({})", info.unusable);
    }
    const auto found = std::ranges::find_if(infos, [&](const auto& info) { return Matches(info, selector); });
    if (found == infos.end() && selector.empty()) throw Error("no Vulkan device can be used; there is {}", known);
    if (found == infos.end()) throw Error("no Vulkan device matches '{}'; there is {}", selector, known);
    if (!found->unusable.empty()) throw Error("the device '{}' {}", found->name, found->unusable);
    return *found;
}

template <typename Dispatcher>
Dispatcher& Mutable(const Dispatcher* dispatcher) {
    return *const_cast<Dispatcher*>(dispatcher);
}

}  // namespace

std::vector<DeviceInfo> ListDevices() {
    const vk::raii::Context context = LoadVulkan();
    const vk::raii::Instance instance = CreateInstance(context, false);
    return DescribeAll(instance.enumeratePhysicalDevices());
}

Device::Device(const DeviceDesc& desc) : m_impl(new Impl(LoadVulkan())) {
    Impl& d = *m_impl;
    d.instance = CreateInstance(d.context, desc.validation);
    d.onValidationMessage = desc.onValidationMessage;
    if (!d.onValidationMessage)
        d.onValidationMessage = [](const std::string& message) { fmt::print(stderr, "{}\n", message); };
    d.hasDebugUtils =
        HasExtension(d.context.enumerateInstanceExtensionProperties(), VK_EXT_DEBUG_UTILS_EXTENSION_NAME) ||
        desc.validation;
    if (desc.validation) {
        using Severity = vk::DebugUtilsMessageSeverityFlagBitsEXT;
        using Type = vk::DebugUtilsMessageTypeFlagBitsEXT;
        vk::DebugUtilsMessengerCreateInfoEXT info;
        info.messageSeverity = Severity::eWarning | Severity::eError;
        info.messageType = Type::eValidation | Type::ePerformance;
        // vulkan.hpp's own type of it changed between 1.3 and 1.4; by way of void* either will do.
        info.pfnUserCallback = reinterpret_cast<decltype(info.pfnUserCallback)>(reinterpret_cast<void*>(&OnMessage));
        info.pUserData = &d;
        d.messenger = vk::raii::DebugUtilsMessengerEXT(d.instance, info);
    }

    auto devices = d.instance.enumeratePhysicalDevices();
    d.info = Choose(DescribeAll(devices), desc.selector);
    d.physicalDevice = std::move(devices[d.info.index]);
    d.queueFamily = *GraphicsQueueFamily(d.physicalDevice);

    const float priority = 1.0f;
    const vk::DeviceQueueCreateInfo queueInfo({}, d.queueFamily, 1, &priority);
    vk::PhysicalDeviceVulkan13Features vulkan13;
    // maintenance4: a pixel shader need not read all that quad.vs writes.
    vulkan13.dynamicRendering = vulkan13.synchronization2 = vulkan13.maintenance4 = true;
    vk::DeviceCreateInfo deviceInfo({}, queueInfo);
    deviceInfo.pNext = &vulkan13;
    vk::PhysicalDeviceFeatures features;
    const vk::PhysicalDeviceFeatures available = d.physicalDevice.getFeatures();
    features.samplerAnisotropy = available.samplerAnisotropy;
    features.fragmentStoresAndAtomics = available.fragmentStoresAndAtomics;
    deviceInfo.pEnabledFeatures = &features;
    d.device = vk::raii::Device(d.physicalDevice, deviceInfo);
    d.queue = d.device.getQueue(d.queueFamily, 0);
    d.hasSamplerAnisotropy = features.samplerAnisotropy;
    d.Finish();
}

Device::Device(const AdoptedDevice& adopted) : m_impl(new Impl(LoadVulkan())) {
    Impl& d = *m_impl;
    d.instance = vk::raii::Instance(d.context, adopted.instance);
    d.physicalDevice = vk::raii::PhysicalDevice(d.instance, adopted.physicalDevice);
    d.device = vk::raii::Device(d.physicalDevice, adopted.device);
    d.queue = vk::raii::Queue(d.device, adopted.queue);
    d.queueFamily = adopted.queueFamily;
    d.hasDebugUtils = adopted.hasDebugUtils;
    d.hasSamplerAnisotropy = adopted.hasSamplerAnisotropy;
    // The wrappers would destroy the engine's handles: leave them nothing to destroy with.
    Mutable(d.instance.getDispatcher()).vkDestroyInstance = [](VkInstance, const VkAllocationCallbacks*) {};
    Mutable(d.device.getDispatcher()).vkDestroyDevice = [](VkDevice, const VkAllocationCallbacks*) {};
    d.info = Describe(d.physicalDevice, 0);
    d.Finish();
}

Device::~Device() = default;

const DeviceInfo& Device::Info() const {
    return m_impl->info;
}
const DeviceLimits& Device::Limits() const {
    return m_impl->limits;
}
uint64_t Device::MemoryBytes() const {
    return m_impl->memoryBytes;
}
uint64_t Device::PeakMemoryBytes() const {
    return m_impl->peakMemoryBytes;
}

AdoptedDevice Device::Handles() const {
    const Impl& d = *m_impl;
    return {*d.instance,     *d.physicalDevice,     *d.device, *d.queue, d.queueFamily,
            d.hasDebugUtils, d.hasSamplerAnisotropy};
}

void Device::Impl::Finish() {
    const auto properties =
        physicalDevice.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceMaintenance3Properties>();
    const auto& base = properties.get<vk::PhysicalDeviceProperties2>().properties;
    limits.maxSideTexels = base.limits.maxImageDimension2D;
    limits.maxVolumeSideTexels = base.limits.maxImageDimension3D;
    limits.maxImageBytes = properties.get<vk::PhysicalDeviceMaintenance3Properties>().maxMemoryAllocationSize;
    maxStorageBytes = base.limits.maxStorageBufferRange;
    maxThreadGroups = base.limits.maxComputeWorkGroupCount;
    if (hasSamplerAnisotropy) maxAnisotropy = base.limits.maxSamplerAnisotropy;
    memory = physicalDevice.getMemoryProperties();
    if (physicalDevice.getQueueFamilyProperties()[queueFamily].timestampValidBits > 0)
        nanosecondsPerTick = base.limits.timestampPeriod;
    commandPool.emplace(device,
                        vk::CommandPoolCreateInfo(vk::CommandPoolCreateFlagBits::eResetCommandBuffer, queueFamily));
    Name(*commandPool, "boxcar commands");
}

std::optional<uint32_t> Device::Impl::MemoryType(uint32_t typeBits, vk::MemoryPropertyFlags flags) const {
    for (uint32_t i = 0; i < memory.memoryTypeCount; i++)
        if ((typeBits >> i & 1) && (memory.memoryTypes[i].propertyFlags & flags) == flags) return i;
    return {};
}

void Device::Impl::CountMemory(int64_t bytes) {
    memoryBytes += static_cast<uint64_t>(bytes);
    peakMemoryBytes = std::max(peakMemoryBytes, memoryBytes);
}

}  // namespace boxcar
