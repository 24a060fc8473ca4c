// A tracing for each device, with the options that the command line gives to all of them.
#include "tracing/TracingDevices.h"

namespace voxc::tool {

namespace {

constexpr const char *kDevice = "--device";

/// The options among those of `tracing` that `command` was given, as given them, but for the device.
std::vector<std::string> givenOptions(const CommandLine &command, const CommandLine &tracing) {
  std::vector<std::string> arguments;
  for (const Option &option : tracing.options()) {
    const std::string name = option.name();
    const std::optional<Option> given = command.find(name);
    if (given && given->count() > 0 && name != kDevice)
      arguments.push_back(name + "=" + given->written().back());
  }
  return arguments;
}

} // namespace

void TracingDevices::declare(const CommandLine &command) {
  command_ = command;
  declared_.declare(command);
  const Option device = command.option(kDevice);
  device.lastCounts();
  device.text(device.text() + "; may be given several times");
}

Expected<void> TracingDevices::open(const CommonOptions &common) {
  std::vector<std::string> names = command_->option(kDevice).written();
  if (names.empty())
    names.emplace_back();
  for (const std::string &name : names) {
    devices_.push_back({name, std::make_unique<TraceSession>()});
    TraceSession &tracing = *devices_.back().tracing;
    const CommandLine options;
    tracing.declare(options);
    std::vector<std::string> arguments = givenOptions(*command_, options);
    if (!name.empty())
      arguments.push_back(std::string(kDevice) + "=" + name);
    VOXC_TRY(options.parse(arguments));
    VOXC_TRY(tracing.openDevice(common));
  }
  return {};
}

} // namespace voxc::tool
