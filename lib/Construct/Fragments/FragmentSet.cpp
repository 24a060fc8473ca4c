// Completeness and order of fragments.
#include "FragmentSet.h"

#include "Construct/Parts/PartBuilder.h"

#include "Source/CubeTools.h"

#include <algorithm>
#include <iterator>

namespace voxc {
namespace {

bool belongTogether(const FragmentInfo &a, const FragmentInfo &b) {
  return a.share.count == b.share.count && a.log2Side == b.log2Side && a.volume.format == b.volume.format &&
         a.volume.extent == b.volume.extent && a.volume.voxelToModel == b.volume.voxelToModel &&
         a.volume.provenance == b.volume.provenance;
}

/// Does the share of one fragment begin where that of the one before it ends?
Expected<void> checkFollows(const FragmentReader &before, const FragmentReader &reader) {
  const std::uint64_t end = before.info().share.end;
  const std::uint64_t begin = reader.info().share.begin;
  if (begin == end)
    return {};
  return Error::input("'" + before.path() + "' ends at cube " + std::to_string(end) +
                      " of the volume, and '" + reader.path() + "' begins at " + std::to_string(begin) +
                      ": " + (begin > end ? "there is a gap between them" : "they overlap"));
}

/// Files in the order of their indices: are they `begin`, `begin` + 1, ... of one volume?
Expected<void> checkRun(const std::vector<FragmentReader> &readers, std::uint64_t begin) {
  const FragmentReader &first = readers.front();
  const std::string of = " of " + std::to_string(first.info().share.count);
  for (std::size_t i = 0; i < readers.size(); ++i) {
    const FragmentReader &reader = readers[i];
    if (!belongTogether(reader.info(), first.info()))
      return Error::input("'" + reader.path() + "' and '" + first.path() +
                          "' are fragments of different volumes");
    if (i > 0 && reader.info().share.index == readers[i - 1].info().share.index)
      return Error::input("'" + reader.path() + "' and '" + readers[i - 1].path() +
                          "' are the same fragment, " + std::to_string(reader.info().share.index) + of);
    if (reader.info().share.index != begin + i)
      return Error::input("fragment " + std::to_string(begin + i) + of + " is missing");
    if (i > 0)
      VOXC_TRY(checkFollows(readers[i - 1], reader));
  }
  return {};
}

/// True if a fragment may have such a part: an aligned cube of a size that its layout allows, in its share.
bool isPart(const Cube &cube, const FragmentInfo &info, const Layout &layout) {
  if (cube.log2Side < info.log2Side || cube.log2Side > kMaxLog2Extent ||
      layout.partSide(cube.log2Side) != cube.log2Side)
    return false;
  const int mask = (1 << cube.log2Side) - 1;
  const std::uint64_t first = mortonCode(cube.low >> info.log2Side);
  return contains(info.volume.extent, cube.low) && ((cube.low.x | cube.low.y | cube.low.z) & mask) == 0 &&
         first >= info.share.begin && first + cellCount(cube.log2Side - info.log2Side) <= info.share.end;
}

/// True if the cells are some of those that the part covers in the grid of its level; a tree has none.
bool coversCells(const Fragment &fragment, const Layout &layout) {
  const int log2Side = fragment.cube.log2Side;
  const Stratum &stratum = layout.strata[layout.stratumOfPart(log2Side)];
  const int log2Cell = stratum.log2Cell;
  const Int3 size = stratum.log2Size();
  if (!stratum.isGrid())
    return fragment.cells.empty();
  const auto isInside = [&](const construct::PlacedCell &placed) {
    const Int3 cell = {placed.cell.x, placed.cell.y, placed.cell.z};
    for (int axis = 0; axis < 3; ++axis) {
      const int mask = (1 << size[axis]) - 1;
      const int first = fragment.cube.low[axis] >> log2Cell & mask;
      if (cell[axis] < first || cell[axis] > std::min(first + (1 << (log2Side - log2Cell)) - 1, mask))
        return false;
    }
    return true;
  };
  return std::ranges::all_of(fragment.cells, isInside);
}

/// True if the node or the cells say of their voxels what the values do, where those stand apart; a grid of
/// voxels has its values in its cells.
bool countsValues(const Fragment &fragment, const Layout &layout) {
  const std::size_t index = layout.stratumOfPart(fragment.cube.log2Side);
  // Other nodes have something else there, or nothing.
  std::uint64_t voxels = layout.ranksVoxels() ? fragment.node.voxels : 0;
  for (const construct::PlacedCell &cell : fragment.cells)
    voxels += cell.voxels;
  const bool hasValues =
      layout.ranksVoxels() && !(layout.strata[index].isGrid() && layout.holdsVoxels(index));
  return fragment.values.size() == voxels && voxels == (hasValues ? fragment.voxels : 0);
}

} // namespace

Expected<FragmentSet> FragmentSet::openRun(const std::vector<std::string> &paths,
                                           const std::shared_ptr<WorkingMemory> &memory) {
  std::vector<FragmentReader> readers;
  for (const std::string &path : paths) {
    auto reader = VOXC_TRY(FragmentReader::open(path));
    memory->watch(reader.bytes());
    readers.push_back(std::move(reader));
  }
  if (readers.empty())
    return Error::input("there is no fragment to merge");
  std::ranges::sort(readers, {}, [](const FragmentReader &reader) { return reader.info().share.index; });
  FragmentSet set(std::move(readers), memory);
  VOXC_TRY(checkRun(set.readers_, set.info().share.index));
  set.sumBytes();
  return set;
}

Expected<FragmentSet> FragmentSet::open(const std::vector<std::string> &paths,
                                        const std::shared_ptr<WorkingMemory> &memory) {
  auto set = VOXC_TRY(openRun(paths, memory));
  const FragmentInfo &first = set.info();
  const std::uint64_t missing = first.share.index > 0 ? 0 : set.readers_.size();
  if (missing < first.share.count)
    return Error::input("fragment " + std::to_string(missing) + " of " + std::to_string(first.share.count) +
                        " is missing");
  const std::uint64_t all = PartGrid::of(first.volume.extent, set.layout(), first.log2Side).count();
  if (set.cubes() != std::pair(std::uint64_t{0}, all))
    return Error::input("the fragments have the cubes " + std::to_string(set.cubes().first) + " to " +
                        std::to_string(set.cubes().second) + " of a volume of " + std::to_string(all));
  return set;
}

std::uint64_t FragmentSet::voxels() const {
  std::uint64_t sum = 0;
  for (const FragmentReader &reader : readers_)
    sum += reader.info().volume.voxels;
  return sum;
}

void FragmentSet::sumBytes() {
  std::uint64_t sum = 0;
  for (const FragmentReader &reader : readers_)
    for (const PartPlace &place : reader.places()) {
      sums_.emplace_back(mortonCode(place.cube.low), sum += place.bytes);
      memory_->relieve();
    }
}

std::uint64_t FragmentSet::bytesIn(const Cube &cube) const {
  const auto before = [&](std::uint64_t code) {
    const auto at =
        std::ranges::lower_bound(sums_, code, {}, &std::pair<std::uint64_t, std::uint64_t>::first);
    return at == sums_.begin() ? 0 : std::prev(at)->second;
  };
  const std::uint64_t code = mortonCode(cube.low);
  return before(code + cellCount(cube.log2Side)) - before(code);
}

FragmentSet::~FragmentSet() {
  for (const FragmentReader &reader : readers_)
    memory_->unwatch(reader.bytes());
}

Next<Cube> FragmentSet::next() {
  for (; current_ < readers_.size(); ++current_)
    if (auto cube = readers_[current_].next(); !cube.isEnd())
      return cube;
  return End{};
}

Expected<void> FragmentSet::checkPart(const Fragment &fragment) const {
  if (!isPart(fragment.cube, readers_[current_].info(), layout()) ||
      mortonCode(fragment.cube.low) < endOfLast_)
    return Error::input("'" + readers_[current_].path() + "' is broken: its parts are not in order");
  if (!coversCells(fragment, layout()))
    return Error::input("'" + readers_[current_].path() + "' is broken: a part has cells outside itself");
  const bool hasColour = layout().hasOneColour() && fragment.voxels > 0;
  if (hasColour != (fragment.colour != 0))
    return Error::input("'" + readers_[current_].path() +
                        "' is broken: a part has a colour too much, or none");
  if (!countsValues(fragment, layout()))
    return Error::input("'" + readers_[current_].path() + "' is broken: a part has no value for each voxel");
  return {};
}

Expected<Fragment> FragmentSet::take() {
  auto fragment = VOXC_TRY(readers_[current_].take());
  VOXC_TRY(checkPart(fragment));
  endOfLast_ = mortonCode(fragment.cube.low) + cellCount(fragment.cube.log2Side);
  return fragment;
}

} // namespace voxc
