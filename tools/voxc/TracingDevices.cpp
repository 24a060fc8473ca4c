// A tracing for each device, with the options that the command line gives to all of them.
#include "TracingDevices.h"

#include <CLI/CLI.hpp>

namespace voxc::tool {

namespace {

constexpr const char *kDevice = "--device";

/// The options among those of `tracing` that `command` was given, as it was given them, but for the device.
std::vector<std::string> givenOptions(const CLI::App &command, const CLI::App &tracing) {
  std::vector<std::string> arguments;
  for (const CLI::Option *option : tracing.get_options()) {
    const std::string name = option->get_name();
    const CLI::Option *given = command.get_option_no_throw(name);
    if (given && given->count() > 0 && name != kDevice)
      arguments.push_back(name + "=" + given->results().back());
  }
  return arguments;
}

} // namespace

void TracingDevices::declare(CLI::App &app) {
  app_ = &app;
  declared_.declare(app);
  CLI::Option *device = app.get_option(kDevice);
  device->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  device->description(device->get_description() + "; may be given several times");
}

Expected<void> TracingDevices::open(const CommonOptions &common) {
  std::vector<std::string> names = app_->get_option(kDevice)->results();
  if (names.empty())
    names.emplace_back();
  for (const std::string &name : names) {
    devices_.push_back({name, std::make_unique<Tracing>()});
    Tracing &tracing = *devices_.back().tracing;
    CLI::App options;
    tracing.declare(options);
    std::vector<std::string> arguments = givenOptions(*app_, options);
    if (!name.empty())
      arguments.push_back(std::string(kDevice) + "=" + name);
    options.parse(std::move(arguments));
    if (Expected<void> opened = tracing.openDevice(common); !opened)
      return opened;
  }
  return {};
}

} // namespace voxc::tool
