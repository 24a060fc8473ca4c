// The formats that hard rays are traced in: given, listed in a file, or random.
#pragma once

#include "common/CommandLine.h"
#include "frontend/AttributeOptions.h"
#include "frontend/PassOptions.h"
#include "voxc/IR/Format.h"
#include "voxc/Support/Error.h"

#include <cstdint>
#include <string>
#include <vector>

namespace voxc::tool {

class HardRayFormats {
public:
  /// Adds --format, --formats, --random, --precision and the passes to a command.
  void declare(const CommandLine &command);

  /// All of them at the precision asked for, the passes run on those that are not random. Without any, two
  /// that hold every kind of level. Errors: an unreadable file, a bad format, a pass that does not apply.
  Expected<std::vector<Format>> read(std::uint64_t seed) const;

private:
  Expected<std::vector<std::string>> texts() const;

  std::vector<std::string> formats_;
  std::string file_;
  std::uint32_t random_ = 0;
  AttributeOptions attributes_;
  PassOptions passes_;
};

/// The format with all its attributes on one line, as FORMAT takes it.
std::string oneLine(const Format &format);

} // namespace voxc::tool
