// How much memory the machine has, and how much of this process is in it.
#pragma once

#include <cstdint>

namespace voxc::platform {

/// Bytes of memory of this machine.
std::uint64_t physicalMemory();

/// Bytes of this process that are in memory now; 0 where the system does not tell.
class ResidentSize {
public:
  ResidentSize();
  ~ResidentSize();
  ResidentSize(const ResidentSize &) = delete;
  ResidentSize &operator=(const ResidentSize &) = delete;

  std::uint64_t now() const;

private:
  int file_ = -1; ///< Where the system tells by a file.
};

} // namespace voxc::platform
