#include "runtime/gpu/device.h"

#include <algorithm>
#include <cstring>
#include <string_view>

#include "compiler/base/letters.h"

namespace patina::runtime {
namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

VKAPI_ATTR VkBool32 VKAPI_CALL collect_message(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                               const VkDebugUtilsMessengerCallbackDataEXT* data, void* messages) {
    static_cast<std::vector<std::string>*>(messages)->emplace_back(data->pMessage);
    return VK_FALSE;
}

bool has_validation_layer() {
    std::uint32_t count = 0;
    vkEnumerateInstanceLayerProperties(&count, nullptr);
    std::vector<VkLayerProperties> layers(count);
    vkEnumerateInstanceLayerProperties(&count, layers.data());
    return std::any_of(layers.begin(), layers.end(),
                       [](const VkLayerProperties& layer) { return !std::strcmp(layer.layerName, kValidationLayer); });
}

Outcome<bool> create_instance(Device& device, bool validation) {
    if (validation && !has_validation_layer())
        return Failure{
            "the Khronos validation layer is not installed (on Debian: apt install vulkan-validationlayers)"};

    VkApplicationInfo application{.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO,
                                  .pNext = nullptr,
                                  .pApplicationName = "patina",
                                  .applicationVersion = 1,
                                  .pEngineName = "patina",
                                  .engineVersion = 1,
                                  .apiVersion = VK_API_VERSION_1_3};
    VkDebugUtilsMessengerCreateInfoEXT messenger{};
    messenger.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT;
    messenger.messageSeverity =
        VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    messenger.messageType =
        VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
    messenger.pfnUserCallback = collect_message;
    messenger.pUserData = &device.messages;

    VkValidationFeatureEnableEXT synchronization = VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT;
    VkValidationFeaturesEXT features{};
    features.sType = VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT;
    features.pNext = &messenger;  // so that messages about the instance itself are heard too
    features.enabledValidationFeatureCount = 1;
    features.pEnabledValidationFeatures = &synchronization;

    const char* extension = VK_EXT_DEBUG_UTILS_EXTENSION_NAME;
    VkInstanceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
    info.pApplicationInfo = &application;
    if (validation) {
        info.pNext = &features;
        info.enabledLayerCount = 1;
        info.ppEnabledLayerNames = &kValidationLayer;
        info.enabledExtensionCount = 1;
        info.ppEnabledExtensionNames = &extension;
    }
    VkResult result = vkCreateInstance(&info, nullptr, &device.instance);
    if (result == VK_ERROR_INCOMPATIBLE_DRIVER)
        return Failure{"there is no Vulkan driver (on Debian: apt install mesa-vulkan-drivers)"};
    if (result != VK_SUCCESS) return Failure{"Vulkan cannot be started: " + result_name(result)};

    if (validation) {
        auto create = PFN_vkCreateDebugUtilsMessengerEXT(
            vkGetInstanceProcAddr(device.instance, "vkCreateDebugUtilsMessengerEXT"));
        if (create) create(device.instance, &messenger, nullptr, &device.messenger);
    }
    return true;
}

struct Features {
    VkPhysicalDeviceFeatures2 core{};
    VkPhysicalDeviceVulkan11Features v11{};
    VkPhysicalDeviceVulkan12Features v12{};
    VkPhysicalDeviceVulkan13Features v13{};
    VkPhysicalDeviceDepthClipControlFeaturesEXT clip{};  // not in the chain: an extension

    Features() {
        core.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
        v11.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_FEATURES;
        v12.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
        v13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
        clip.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DEPTH_CLIP_CONTROL_FEATURES_EXT;
        core.pNext = &v11;
        v11.pNext = &v12;
        v12.pNext = &v13;
    }
    Features(const Features&) = delete;  // the chain points into this object
};

bool graphics_family(VkPhysicalDevice physical, std::uint32_t& family) {
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families.data());
    for (family = 0; family < count; family++)
        if (families[family].queueFlags & VK_QUEUE_GRAPHICS_BIT) return true;
    return false;
}

bool has_extension(VkPhysicalDevice physical, std::string_view name) {
    std::uint32_t count = 0;
    vkEnumerateDeviceExtensionProperties(physical, nullptr, &count, nullptr);
    std::vector<VkExtensionProperties> found(count);
    vkEnumerateDeviceExtensionProperties(physical, nullptr, &count, found.data());
    return std::any_of(found.begin(), found.end(),
                       [&](const VkExtensionProperties& each) { return each.extensionName == name; });
}

bool can_draw(VkPhysicalDevice physical, const VkPhysicalDeviceProperties& properties) {
    if (properties.apiVersion < VK_API_VERSION_1_3) return false;
    Features features;
    vkGetPhysicalDeviceFeatures2(physical, &features.core);
    std::uint32_t family = 0;
    return features.v13.dynamicRendering && features.v13.synchronization2 && graphics_family(physical, family);
}

Outcome<bool> choose_physical_device(Device& device, const std::string& wanted) {
    std::uint32_t count = 0;
    vkEnumeratePhysicalDevices(device.instance, &count, nullptr);
    std::vector<VkPhysicalDevice> found(count);
    vkEnumeratePhysicalDevices(device.instance, &count, found.data());

    std::string names;
    for (VkPhysicalDevice physical : found) {
        VkPhysicalDeviceProperties properties{};
        vkGetPhysicalDeviceProperties(physical, &properties);
        std::string name = properties.deviceName;
        names += (names.empty() ? "" : ", ") + name;
        if (!can_draw(physical, properties)) {
            names += " (lacks Vulkan 1.3)";
            continue;
        }
        bool is_software = properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
        bool fits = wanted.empty() ? !device.physical || is_software
                                   : small_letters(name).find(small_letters(wanted)) != name.npos;
        if (!fits) continue;
        device.physical = physical;
        device.name = name;
        device.limits = properties.limits;
        VkPhysicalDeviceMaintenance3Properties memory{};
        memory.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_3_PROPERTIES;
        VkPhysicalDeviceProperties2 more{};
        more.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
        more.pNext = &memory;
        VkPhysicalDeviceDriverProperties driver{};
        driver.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES;
        memory.pNext = &driver;
        vkGetPhysicalDeviceProperties2(physical, &more);
        device.driver = std::string(driver.driverName) + " " + driver.driverInfo;
        device.most_allocation = memory.maxMemoryAllocationSize;
        if (is_software || !wanted.empty()) break;
    }
    if (device.physical) return true;
    if (names.empty()) return Failure{"there is no Vulkan device (on Debian: apt install mesa-vulkan-drivers)"};
    return Failure{(wanted.empty() ? "no Vulkan device can be used" : "no Vulkan device is called '" + wanted + "'") +
                   "; there are: " + names};
}

Outcome<bool> create_logical_device(Device& device) {
    Features available;
    vkGetPhysicalDeviceFeatures2(device.physical, &available.core);
    Features wanted;
    wanted.v13.dynamicRendering = VK_TRUE;
    wanted.v13.synchronization2 = VK_TRUE;
    // glslang compiles HLSL's discard to it.
    wanted.v13.shaderDemoteToHelperInvocation = available.v13.shaderDemoteToHelperInvocation;
    // `half` in a material is float16 arithmetic where the device has it.
    wanted.v12.shaderFloat16 = available.v12.shaderFloat16;
    wanted.v11.storageInputOutput16 = available.v11.storageInputOutput16;
    wanted.v11.uniformAndStorageBuffer16BitAccess = available.v11.uniformAndStorageBuffer16BitAccess;
    wanted.v11.storageBuffer16BitAccess = available.v11.storageBuffer16BitAccess;
    wanted.core.features.samplerAnisotropy = available.core.features.samplerAnisotropy;
    device.anisotropy = available.core.features.samplerAnisotropy;
    wanted.core.features.independentBlend = available.core.features.independentBlend;
    device.independent_blend = available.core.features.independentBlend;
    device.symmetric_depth = has_extension(device.physical, VK_EXT_DEPTH_CLIP_CONTROL_EXTENSION_NAME);
    const char* const extension = VK_EXT_DEPTH_CLIP_CONTROL_EXTENSION_NAME;
    if (device.symmetric_depth) {
        wanted.clip.depthClipControl = VK_TRUE;
        wanted.v13.pNext = &wanted.clip;
    }

    graphics_family(device.physical, device.queue_family);
    float priority = 1;
    VkDeviceQueueCreateInfo queue{};
    queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
    queue.queueFamilyIndex = device.queue_family;
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;
    VkDeviceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
    info.pNext = &wanted.core;
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue;
    info.enabledExtensionCount = device.symmetric_depth ? 1 : 0;
    info.ppEnabledExtensionNames = &extension;
    VkResult result = vkCreateDevice(device.physical, &info, nullptr, &device.device);
    if (result != VK_SUCCESS) return Failure{"'" + device.name + "' cannot be opened: " + result_name(result)};
    vkGetDeviceQueue(device.device, device.queue_family, 0, &device.queue);
    vkGetPhysicalDeviceMemoryProperties(device.physical, &device.memory);

    VkCommandPoolCreateInfo pool{};
    pool.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
    pool.flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT;
    pool.queueFamilyIndex = device.queue_family;
    result = vkCreateCommandPool(device.device, &pool, nullptr, &device.commands);
    if (result != VK_SUCCESS) return Failure{"'" + device.name + "' has no command pool: " + result_name(result)};
    return true;
}

}  // namespace

Device::~Device() {
    if (device) {
        vkDeviceWaitIdle(device);
        vkDestroyCommandPool(device, commands, nullptr);
        vkDestroyDevice(device, nullptr);
    }
    if (messenger) {
        auto destroy =
            PFN_vkDestroyDebugUtilsMessengerEXT(vkGetInstanceProcAddr(instance, "vkDestroyDebugUtilsMessengerEXT"));
        destroy(instance, messenger, nullptr);
    }
    if (instance) vkDestroyInstance(instance, nullptr);
}

Outcome<std::unique_ptr<Device>> open_device(const DeviceOptions& options) {
    auto device = std::make_unique<Device>();
    if (auto made = create_instance(*device, options.validation); !made) return Failure{made.error};
    if (auto chosen = choose_physical_device(*device, options.device); !chosen) return Failure{chosen.error};
    if (auto made = create_logical_device(*device); !made) return Failure{made.error};
    return device;
}

std::string result_name(VkResult result) {
    // Only results that a user can meet have names here; VkResult is open-ended, with values of every extension.
    struct Name {
        VkResult result;
        const char* name;
    };
    static constexpr Name kNames[] = {
        {VK_ERROR_OUT_OF_HOST_MEMORY, "VK_ERROR_OUT_OF_HOST_MEMORY"},
        {VK_ERROR_OUT_OF_DEVICE_MEMORY, "VK_ERROR_OUT_OF_DEVICE_MEMORY"},
        {VK_ERROR_INITIALIZATION_FAILED, "VK_ERROR_INITIALIZATION_FAILED"},
        {VK_ERROR_DEVICE_LOST, "VK_ERROR_DEVICE_LOST"},
        {VK_ERROR_LAYER_NOT_PRESENT, "VK_ERROR_LAYER_NOT_PRESENT"},
        {VK_ERROR_EXTENSION_NOT_PRESENT, "VK_ERROR_EXTENSION_NOT_PRESENT"},
        {VK_ERROR_FEATURE_NOT_PRESENT, "VK_ERROR_FEATURE_NOT_PRESENT"},
        {VK_ERROR_INCOMPATIBLE_DRIVER, "VK_ERROR_INCOMPATIBLE_DRIVER"},
        {VK_ERROR_FORMAT_NOT_SUPPORTED, "VK_ERROR_FORMAT_NOT_SUPPORTED"},
    };
    for (const Name& entry : kNames)
        if (entry.result == result) return entry.name;
    return "VkResult " + std::to_string(int(result));
}

}  // namespace patina::runtime
