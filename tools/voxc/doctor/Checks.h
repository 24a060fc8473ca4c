// What voxc finds on a machine, and how what is missing is mended.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace voxc::tool {

/// One thing that was looked at.
struct Check {
  enum class State {
    Good,
    Missing, ///< Something that most commands do without.
    Bad,     ///< Something that must be mended before voxc can be used.
  };
  std::string subject; ///< "device", "compiled code".
  State state = State::Good;
  std::string found;  ///< What there is: words without a full stop.
  std::string remedy; ///< How it is mended; "" if it is good.
};

/// What was built in: versions, and the parts that a build may lack.
std::vector<Check> checkBuild();
/// The processor, and what its code may use; memory.
std::vector<Check> checkProcessor();
/// The loader of Vulkan, and each device.
std::vector<Check> checkDevices();
/// The caches, and where scratch files go.
std::vector<Check> checkFolders();
/// The viewer, and the module for Python.
std::vector<Check> checkPrograms();

/// "ok", "note", "bad".
std::string_view wordOf(Check::State state);

} // namespace voxc::tool
