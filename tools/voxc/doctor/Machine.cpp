// What the processor and the devices are.
#include "doctor/Checks.h"

#include "common/Command.h"
#include "voxc/Measure/Machine.h"
#include "voxc/Trace/CpuKernel.h"
#include "voxc/Trace/Tracer.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <dlfcn.h>
#include <fstream>
#include <sstream>

namespace voxc::tool {
namespace {

constexpr double kGibibyte = 1024.0 * 1024 * 1024;
/// Formats of large scenes are built in more, or with --memory in less.
constexpr double kLittleMemory = 2;

std::string oneDigit(double value) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.1f", value);
  return text.data();
}

/// Of the extensions that code for vectors is made with, those that this processor has, the widest last.
std::string vectorExtensions() {
  constexpr std::string_view kKnown[] = {"sse4_2", "avx", "avx2", "fma", "avx512f", "asimd", "sve"};
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("flags") && !line.starts_with("Features"))
      continue;
    std::istringstream words(line);
    std::vector<std::string> has;
    for (std::string word; words >> word;)
      has.push_back(word);
    std::string text;
    for (const std::string_view known : kKnown)
      if (std::ranges::find(has, known) != has.end())
        text += (text.empty() ? "" : " ") + std::string(known);
    return text;
  }
  return {};
}

Check checkLoader() {
  void *const loader = ::dlopen("libvulkan.so.1", RTLD_NOW | RTLD_LOCAL);
  if (!loader)
    return {"Vulkan", Check::State::Missing, "no loader (libvulkan.so.1); the cpu device does without",
            "install the loader and a driver, such as Debian's libvulkan1 and mesa-vulkan-drivers"};
  ::dlclose(loader);
  return {"Vulkan", Check::State::Good, "the loader is there (libvulkan.so.1)", ""};
}

Check checkDevice(const DeviceInfo &device) {
  const std::string name = device.name + " (" + device.kind + "), driver " + device.driver;
  if (!device.usable)
    return {"device", Check::State::Missing, name + ", is not usable",
            "voxc needs Vulkan 1.2 and a compute queue: a newer driver may bring them"};
  return {"device", Check::State::Good,
          name + ", Vulkan " + device.apiVersion + ", " +
              oneDigit(static_cast<double>(device.memoryBytes) / kGibibyte) + " GiB",
          ""};
}

} // namespace

std::vector<Check> checkProcessor() {
  const measure::MadeByPart machine = measure::madeBy("");
  const std::string extensions = vectorExtensions();
  const double memory = static_cast<double>(measure::machineMemory()) / kGibibyte;
  const bool isLittle = memory < kLittleMemory;
  return {{"processor", Check::State::Good,
           machine.processor + ", " + std::to_string(machine.cores.value_or(1)) + " threads" +
               (extensions.empty() ? "" : "; " + extensions),
           ""},
          {"memory", isLittle ? Check::State::Missing : Check::State::Good, oneDigit(memory) + " GiB",
           isLittle ? "--memory keeps builds of large scenes within less, with scratch files" : ""}};
}

std::vector<Check> checkDevices() {
  std::vector<Check> checks = {checkLoader()};
  const std::vector<DeviceInfo> devices = listDevices();
  if (devices.empty() && checks.front().state == Check::State::Good)
    checks.push_back({"device", Check::State::Missing, "Vulkan has no device",
                      "install a driver, such as Debian's mesa-vulkan-drivers; VK_ICD_FILENAMES, if it is "
                      "set, has to name one"});
  for (const DeviceInfo &device : devices)
    checks.push_back(checkDevice(device));
  checks.push_back({"device", Check::State::Good, "cpu, " + cpuDeviceInfo().driver, ""});
  return checks;
}

} // namespace voxc::tool
