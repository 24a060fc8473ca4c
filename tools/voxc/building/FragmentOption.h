// The option --fragment I/N of the commands that write one fragment of a volume.
#pragma once

#include "common/CommandLine.h"

#include <cstdint>
#include <optional>
#include <string>

namespace voxc::tool {

/// One of several fragments.
struct FragmentChoice {
  std::uint64_t index = 0; ///< From 0 to count - 1.
  std::uint64_t count = 1;
};

class FragmentOption {
public:
  /// Adds --fragment to a command.
  void declare(const CommandLine &command, const std::string &summary);
  /// What was chosen, if anything was.
  std::optional<FragmentChoice> choice() const;

private:
  std::string text_;
};

} // namespace voxc::tool
