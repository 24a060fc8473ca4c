// voxc devices: what this machine can trace on.
#include "common/Statistics.h"
#include "options/Figures.h"
#include "program/Subcommand.h"
#include "voxc/Trace/CpuKernel.h"

#include <cstdio>

namespace voxc::tool {

namespace {

Json describe(const DeviceInfo &device) {
  return {{"name", device.name},
          {"uuid", device.uuid},
          {"kind", device.kind},
          {"driver", device.driver},
          {"vulkan", device.apiVersion},
          {"memory_bytes", device.memoryBytes},
          {"max_storage_buffer_bytes", device.maxStorageBufferBytes},
          {"max_allocation_bytes", device.maxAllocationBytes},
          {"usable", device.usable},
          {"device_addresses", device.deviceAddresses}};
}

/// `number`: what --device takes for it beside its name.
void print(const DeviceInfo &device, const std::string &number) {
  std::printf("%s%s (%s)\n", number.c_str(), device.name.c_str(), device.kind.c_str());
  if (device.apiVersion.empty()) {
    std::printf("  %s, without Vulkan; %.1f GiB of memory\n", device.driver.c_str(),
                double(device.memoryBytes) / (1 << 30));
    return;
  }
  std::printf("  driver %s, Vulkan %s\n", device.driver.c_str(), device.apiVersion.c_str());
  std::printf("  %.1f GiB of memory; one storage buffer holds %.1f MiB; device addresses: %s\n",
              double(device.memoryBytes) / (1 << 30), double(device.maxStorageBufferBytes) / (1 << 20),
              device.deviceAddresses ? "yes" : "no");
  if (!device.uuid.empty())
    std::printf("  UUID %s\n", device.uuid.c_str());
  if (!device.usable)
    std::printf("  not usable: voxc needs Vulkan 1.2 and a compute queue\n");
}

class DevicesCommand final : public Subcommand {
public:
  void declare(const CommandLine &command) override { addCommonOptions(command, common_); }

  Expected<void> run() override {
    std::vector<DeviceInfo> devices = listDevices();
    if (devices.empty() && !common_.quiet)
      printNote("there is no Vulkan device; a driver, such as Debian's mesa-vulkan-drivers, brings one");
    devices.push_back(cpuDeviceInfo());
    Json figures{{"devices", Json::array()}};
    std::size_t number = 0;
    for (const DeviceInfo &device : devices) {
      figures["devices"].push_back(describe(device));
      if (tellsOnStdout(common_))
        print(device, device.apiVersion.empty() ? "" : std::to_string(number) + ": ");
      ++number;
    }
    return writeStatistics(common_.stats, figures);
  }

private:
  CommonOptions common_;
};

} // namespace

std::unique_ptr<Subcommand> makeDevicesCommand() { return std::make_unique<DevicesCommand>(); }

} // namespace voxc::tool
