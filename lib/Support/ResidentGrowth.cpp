// The resident size as the system tells it.
#include "Support/ResidentGrowth.h"

#include "Support/Platform/Memory.h"

namespace voxc {

ResidentGrowth::ResidentGrowth() : before_(platform::ResidentSize().now()) {}

std::uint64_t ResidentGrowth::bytes() const {
  const std::uint64_t now = platform::ResidentSize().now();
  return now > before_ ? now - before_ : 0;
}

} // namespace voxc
