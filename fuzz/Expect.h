// What must hold of all that a fuzzer is given.
#pragma once

#include <cstdlib>

namespace voxc::fuzz {

inline void expect(bool holds) {
  if (!holds)
    std::abort();
}

} // namespace voxc::fuzz
