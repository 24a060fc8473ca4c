// The voxels of a cube in one traversal, from level to level, where lookups would go down once for each.
#include "Decode.h"

#include "voxc/Layout/SubVolume.h"
#include "voxc/Layout/Values.h"

#include <algorithm>

namespace voxc {
namespace {

class CubeTraversal {
public:
  CubeTraversal(const WordReader &words, const Layout &layout, CubeVisit visit)
      : words_(words), layout_(layout), visit_(visit) {}

  /// The part of the cube that lies in the sub-volume of a level at `ref`, whose first voxel has a rank:
  /// `window`, in voxels from that one; and the place of the window's first voxel in the cube.
  void subVolume(std::size_t level, Ref ref, const Cube &window, std::uint64_t place,
                 std::uint64_t rank) const {
    const Stratum &stratum = layout_.strata[level];
    const int log2Cell = stratum.log2Cell;
    const Cube cells{window.low >> log2Cell, std::max(window.log2Side - log2Cell, 0)};
    // The window is whole cells, or lies in one of them.
    const Cube part{window.log2Side >= log2Cell ? Int3{} : window.low - cells.low * (1 << log2Cell),
                    std::min(window.log2Side, log2Cell)};
    visitWindow(words_, stratum, words_.wordOf(ref), cells,
                [&](const Cube &cube, std::uint32_t value, std::uint64_t before, std::uint64_t each) {
                  const std::uint64_t first = place + (mortonCode(cube.low - cells.low) << 3 * log2Cell);
                  const std::uint64_t count = std::uint64_t{1} << 3 * cube.log2Side;
                  if (layout_.holdsVoxels(level))
                    return visit_(first, count, value, rank + before);
                  for (std::uint64_t cell = 0; cell < count; ++cell)
                    subVolume(level + 1, value, part, first + (cell << 3 * log2Cell),
                              rank + before + cell * each);
                });
  }

private:
  const WordReader &words_;
  const Layout &layout_;
  CubeVisit visit_;
};

} // namespace

void visitCube(const WordReader &words, const Layout &layout, const Cube &cube, CubeVisit visit) {
  const Int3 log2 = layout.log2Extent();
  const auto last = static_cast<std::int32_t>(cube.side() - 1);
  const Int3 extent{1 << log2.x, 1 << log2.y, 1 << log2.z};
  if (contains(extent, cube.low) && contains(extent, cube.low + Int3{last, last, last})) {
    if (const std::uint32_t root = words[0])
      CubeTraversal(words, layout, visit).subVolume(0, root, cube, 0, 0);
    return;
  }
  // The format is smaller than the cube along an axis.
  for (std::uint64_t place = 0; place < std::uint64_t{1} << 3 * cube.log2Side; ++place)
    if (const Lookup found = lookUpShape(words, layout, cube.low + mortonCell(place)); found.value != 0)
      visit(place, 1, found.value, found.rank);
}

void readCube(const Volume &volume, const Cube &cube, std::uint32_t *out) {
  const Layout &layout = volume.layout();
  const WordReader words = layout.reader(volume.words());
  std::fill_n(out, std::uint64_t{1} << 3 * cube.log2Side, 0u);
  visitCube(words, layout, cube,
            [&](std::uint64_t first, std::uint64_t count, std::uint32_t value, std::uint64_t rank) {
              if (layout.ranksVoxels())
                for (std::uint64_t i = 0; i < count; ++i)
                  out[first + i] = valueOfVoxel(words, layout, value, rank + i);
              else
                std::fill_n(out + first, count, valueOfVoxel(words, layout, value, rank));
            });
}

} // namespace voxc
