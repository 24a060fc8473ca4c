// By how much the process has grown: what a library takes that does not tell.
#pragma once

#include <cstdint>

namespace voxc {

/// Bytes of this process that have come into memory since the object was made; 0 where the system does not
/// tell.
class ResidentGrowth {
public:
  ResidentGrowth();
  std::uint64_t bytes() const;

private:
  std::uint64_t before_;
};

} // namespace voxc
