// All voxels of a volume as a list, in C.
#include "C/Handles.h"

using namespace voxc;
using namespace voxc::c;

voxc_error *voxc_volume_list(const voxc_volume *volume, int32_t *places, uint32_t *words) {
  return guarded([&] {
    std::uint64_t count = 0;
    const std::uint64_t most = volume->volume->info().voxels;
    const auto list = [&](const Cube &cube, std::uint32_t word) {
      const std::uint64_t cells = word == 0 ? 0 : std::uint64_t{1} << (3 * cube.log2Side);
      if (cells >
          most - count) // Only a file that was trusted unseen has more than it says; `decode` tells it.
        return true;
      for (std::uint64_t i = 0; places && i < cells; ++i) {
        const Int3 place = cube.low + mortonCell(i);
        std::copy_n(&place.x, 3, places + 3 * (count + i));
      }
      if (words)
        std::fill_n(words + count, cells, word);
      count += cells;
      return true;
    };
    return decode(*volume->volume, list);
  });
}
