// Counting what is left.
#include "jobs/Jobs.h"

namespace voxc::tool {

std::uint64_t countOf(const Jobs::Missing &missing) {
  std::uint64_t count = 0;
  for (const auto &level : missing)
    count += level.size();
  return count;
}

} // namespace voxc::tool
