// Reading within bounds.
#include "voxc/Layout/WordReader.h"

namespace voxc {

bool WordReader::require(std::uint64_t offset, std::uint64_t count, const char *what) {
  if (offset <= size() && count <= size() - offset)
    return true;
  fail(std::string(what) + " at word " + std::to_string(offset) + " needs " + std::to_string(count) +
       " words, but the volume has " + std::to_string(size()));
  return false;
}

} // namespace voxc
