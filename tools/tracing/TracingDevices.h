// Tracing on several devices with the same options.
#pragma once

#include "tracing/TraceSession.h"

#include <memory>
#include <string>
#include <vector>

namespace voxc::tool {

class TracingDevices {
public:
  struct Device {
    std::string name; ///< As it was asked for; "" is the best there is.
    std::unique_ptr<TraceSession> tracing;
  };

  /// Adds the options of `TraceSession` to a command, of which --device may be given several times.
  void declare(const CommandLine &command);
  /// Opens every device that was asked for. Errors: as `TraceSession::openDevice`.
  Expected<void> open(const CommonOptions &common);

  std::vector<Device> &all() { return devices_; }
  /// What --threads says; 0: nothing.
  unsigned threads() const { return declared_.threads(); }

private:
  std::optional<CommandLine> command_;
  TraceSession declared_; // Holds the options; each device has a tracing of its own.
  std::vector<Device> devices_;
};

} // namespace voxc::tool
