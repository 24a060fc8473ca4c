// What fuzzers do with a volume that was found sound: it must decode to as many voxels as were counted, and
// lookups must find them.
#pragma once

#include "voxc/Volume/Volume.h"

#include <cstdlib>

namespace voxc::fuzz {

inline void decodeAll(const Volume &volume) {
  std::uint64_t found = 0;
  int cubesLeft = 20000;
  const auto visit = [&](const Cube &cube, std::uint32_t word) {
    found += std::uint64_t{1} << 3 * cube.log2Side;
    if (volume.lookup(cube.low).value != word)
      std::abort();
    return --cubesLeft > 0;
  };
  const auto decoded = decode(volume, visit);
  if (!decoded || (cubesLeft > 0 && found != volume.info().voxels))
    std::abort();
}

} // namespace voxc::fuzz
