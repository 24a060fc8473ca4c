// The file by which perf knows names of code that no file on disk holds. No LLVM type appears here.
#pragma once

#include "voxc/Support/Error.h"

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

namespace voxc {

/// /tmp/perf-PID.map, where perf looks for it. A line for each function: its address, its size, its name.
class PerfMap {
public:
  /// That of this process, if VOXC_PERF asks for it: it is set, and neither empty nor "0". Else null.
  static PerfMap *asked();

  /// Adds a function. The file is made with the first.
  void add(std::uint64_t address, std::uint64_t size, std::string_view name);

  /// Why functions could not be added.
  std::optional<Error> problem() const;

private:
  std::optional<Error> open();

  mutable std::mutex mutex_;
  int file_ = -1;
  std::optional<Error> problem_;
};

} // namespace voxc
