// The resident size as the system tells it.
#include "Support/ResidentGrowth.h"

#include <fstream>
#include <unistd.h>

namespace voxc {

namespace {

std::uint64_t residentBytes() {
  std::uint64_t size = 0;
  std::uint64_t resident = 0;
  std::ifstream("/proc/self/statm") >> size >> resident;
  return resident * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

} // namespace

ResidentGrowth::ResidentGrowth() : before_(residentBytes()) {}

std::uint64_t ResidentGrowth::bytes() const {
  const std::uint64_t now = residentBytes();
  return now > before_ ? now - before_ : 0;
}

} // namespace voxc
