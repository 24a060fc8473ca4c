// How long random tests run: VOXC_TEST_FACTOR in the environment multiplies their rounds (./check --full sets
// it).
#pragma once

#include <cstdlib>

namespace voxc::test {

/// `quick` rounds, times VOXC_TEST_FACTOR if that is a positive number.
inline int rounds(int quick) {
  const char *text = std::getenv("VOXC_TEST_FACTOR");
  const int factor = text ? std::atoi(text) : 1;
  return factor > 0 ? quick * factor : quick;
}

} // namespace voxc::test
