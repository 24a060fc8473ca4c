// Grids of OpenVDB files as dense grids that know where they are empty. OpenVDB throws; nothing of that
// leaves this file.
#include "voxc/OpenVdb/OpenVdb.h"

#include "Input/Dense/ColourMap.h"
#include "Input/Dense/Samples.h"
#include "Input/Openers/InputText.h"
#include "Source/DenseSource.h"
#include "Source/GridExtent.h"
#include "voxc/Support/Stopwatch.h"

#include <openvdb/openvdb.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

namespace voxc {

namespace {

using Grid = openvdb::FloatGrid;
using Tree = openvdb::FloatTree;

/// Which values are voxels, and what they look like.
struct Look {
  bool isLevelSet = false;
  double threshold = 0; ///< Of a level set.
  SampleMap map;        ///< Of any other grid.

  std::uint32_t word(float value) const {
    if (!isLevelSet)
      return map.word(value);
    return value <= threshold ? 0xffffffff : 0;
  }
};

class VdbRows final : public DenseRows {
public:
  VdbRows(Grid::ConstPtr grid, openvdb::Coord low, Look look)
      : grid_(std::move(grid)), low_(low), look_(look) {}

  void read(Int3 first, std::int32_t count, std::uint32_t *words) const override {
    // One that the tree does not keep book of, so that threads need not wait for each other.
    const openvdb::tree::ValueAccessor<const Tree, false> accessor(grid_->constTree());
    openvdb::Coord at = low_ + openvdb::Coord(first.x, first.y, first.z);
    for (std::int32_t i = 0; i < count; ++i, ++at.x())
      words[i] = look_.word(accessor.getValue(at));
  }

private:
  Grid::ConstPtr grid_;
  openvdb::Coord low_;
  Look look_;
};

/// Marks the bricks that leaves and tiles of voxels reach into.
class Marker {
public:
  Marker(const openvdb::CoordBBox &box, const Look &look, OccupancyPyramid &occupancy)
      : box_(box), look_(look), occupancy_(occupancy) {}

  void mark(const Tree &tree) const {
    for (auto leaf = tree.cbeginLeaf(); leaf; ++leaf)
      if (std::any_of(leaf->buffer().data(), leaf->buffer().data() + Tree::LeafNodeType::SIZE,
                      [&](float value) { return look_.word(value) != 0; }))
        markBox(leaf->getNodeBoundingBox());
    auto tile = tree.cbeginValueAll();
    tile.setMaxDepth(Tree::ValueAllCIter::LEAF_DEPTH - 1);
    for (; tile; ++tile)
      if (look_.word(*tile) != 0)
        markBox(tile.getBoundingBox());
    // The background fills what no node covers.
    if (look_.word(tree.background()) != 0)
      markBox(box_);
  }

private:
  void markBox(openvdb::CoordBBox box) const {
    box.intersect(box_);
    if (box.empty())
      return;
    const openvdb::Coord low = box.min() - box_.min();
    const openvdb::Coord high = box.max() - box_.min();
    constexpr std::int32_t kBrick = 1 << OccupancyPyramid::kLog2Brick;
    Int3 cell;
    for (cell.z = low.z() & -kBrick; cell.z <= high.z(); cell.z += kBrick)
      for (cell.y = low.y() & -kBrick; cell.y <= high.y(); cell.y += kBrick)
        for (cell.x = low.x() & -kBrick; cell.x <= high.x(); cell.x += kBrick)
          occupancy_.mark(cell);
  }

  openvdb::CoordBBox box_;
  const Look &look_;
  OccupancyPyramid &occupancy_;
};

/// A grid of floats, and the others of its file.
struct Found {
  Grid::ConstPtr grid; ///< Null if there is none.
  std::string name;
  std::string others; ///< "Cd (vec3s), heat (float)".
};

/// The grid of a name, or the first one of floats.
Found readGrid(const std::string &path, const std::string &wanted) {
  openvdb::initialize();
  openvdb::io::File file(path);
  file.open(false);
  Found found;
  for (auto name = file.beginName(); name != file.endName(); ++name) {
    const auto metadata = file.readGridMetadata(name.gridName());
    const bool isWanted = wanted.empty() || name.gridName() == wanted;
    if (!found.grid && isWanted && metadata->isType<Grid>()) {
      found.grid = openvdb::gridConstPtrCast<Grid>(file.readGrid(name.gridName()));
      found.name = name.gridName();
    } else {
      found.others +=
          (found.others.empty() ? "" : ", ") + name.gridName() + " (" + metadata->valueType() + ")";
    }
  }
  return found;
}

Expected<Look> lookOf(const Grid &grid, const InputOptions &options) {
  Look look;
  look.isLevelSet = grid.getGridClass() == openvdb::GRID_LEVEL_SET;
  // Nearer than half a voxel's side: the sheets of an open mesh have hardly any value that is not positive.
  look.threshold = options.threshold.value_or(grid.voxelSize()[0] / 2);
  look.map.threshold = options.threshold;
  look.map.colours = VOXC_TRY(colourMap(options.colourMap));
  if (options.window) {
    look.map.window = {(*options.window)[0], (*options.window)[1]};
    return look;
  }
  for (auto value = grid.cbeginValueOn(); value; ++value) {
    if (!std::isfinite(*value))
      continue;
    look.map.window.low = std::min<double>(look.map.window.low, *value);
    look.map.window.high = std::max<double>(look.map.window.high, *value);
  }
  return look;
}

Expected<Int3> extentOf(const openvdb::CoordBBox &box, const InputOptions &options) {
  if (box.empty())
    return Error::input("its grid has no active voxel");
  Int3 extent;
  for (int axis = 0; axis < 3; ++axis) {
    const std::int64_t size = std::int64_t{box.max()[axis]} - box.min()[axis] + 1;
    extent[axis] = static_cast<std::int32_t>(std::min<std::int64_t>(size, (1 << kMaxLog2Extent) + 1));
  }
  VOXC_TRY(checkGridExtent(extent));
  const Int3 holds = options.mostExtent();
  const bool fits = extent.x <= holds.x && extent.y <= holds.y && extent.z <= holds.z;
  // What is empty is kept in a bit for each 512 cells.
  if (!fits || cellsOf(extent) > std::uint64_t{1} << 42)
    return Error::input("its grid takes " + extentText(extent) + " voxels, but the format holds " +
                        extentText(holds) + (fits ? " and at most 2^42 are read" : ""));
  return extent;
}

Transform mapOf(const Grid &grid, const openvdb::Coord &low) {
  const auto at = [&](double x, double y, double z) {
    // OpenVDB's coordinates are of the middles of voxels.
    return grid.indexToWorld(openvdb::Vec3d(low.x() + x - 0.5, low.y() + y - 0.5, low.z() + z - 0.5));
  };
  const openvdb::Vec3d origin = at(0, 0, 0);
  const std::array<openvdb::Vec3d, 3> steps{at(1, 0, 0) - origin, at(0, 1, 0) - origin, at(0, 0, 1) - origin};
  Transform map;
  for (int row = 0; row < 3; ++row) {
    for (int axis = 0; axis < 3; ++axis)
      map[axis][row] = steps[static_cast<std::size_t>(axis)][row];
    map[3][row] = origin[row];
  }
  return map;
}

std::string provenanceOf(const Look &look, const InputOptions &options) {
  std::string text = look.isLevelSet ? "coverage=inside" : "coverage=samples";
  if (options.threshold)
    text += " threshold=" + toText(*options.threshold);
  if (!look.isLevelSet)
    text += " colour-map=" + options.colourMap + " window=" + toText(look.map.window.low) + "," +
            toText(look.map.window.high);
  return text + upProvenance(options);
}

Expected<Input> makeInput(const Grid::ConstPtr &grid, const InputOptions &options) {
  const openvdb::CoordBBox box = grid->evalActiveVoxelBoundingBox();
  const auto stored = VOXC_TRY(extentOf(box, options));
  const auto look = VOXC_TRY(lookOf(*grid, options));
  OccupancyPyramid occupancy(stored);
  Marker(box, look, occupancy).mark(grid->constTree());
  Input input;
  input.loaderPeakBytes = grid->memUsage();
  input.provenance = provenanceOf(look, options);
  auto rows = std::make_shared<VdbRows>(grid, box.min(), look);
  const Transform map = mapOf(*grid, box.min());
  input.source = VOXC_TRY(makeUprightSource(stored, std::move(rows), std::move(occupancy), map, options.zUp,
                                            options.memory, options.progress));
  return input;
}

Expected<Input> openVdb(const std::string &path, const InputOptions &options) {
  const Stopwatch loading;
  const auto broken = [&](const std::string &problem) {
    return Error::input("'" + path + "' is not a usable OpenVDB file: " + problem);
  };
  try {
    const Found found = readGrid(path, options.grid);
    if (!found.grid)
      return broken("it has no grid of 32-bit floats" +
                    (options.grid.empty() ? std::string() : " of the name '" + options.grid + "'") +
                    (found.others.empty() ? "" : "; there are " + found.others));
    auto input = makeInput(found.grid, options);
    if (input && !options.grid.empty())
      input->provenance += " grid=" + provenanceWord(options.grid);
    else if (input && !found.others.empty())
      input->warnings.push_back("the grid '" + found.name + "' is taken, and left out are " + found.others +
                                " (--grid NAME takes one of them)");
    if (!input && input.error().kind == ErrorKind::Input)
      return broken(input.error().message);
    if (input)
      input->loadSeconds = loading.seconds();
    return input;
  } catch (const std::bad_alloc &) {
    return Error::environment("out of memory for '" + path + "'");
  } catch (const std::exception &problem) {
    return broken(problem.what());
  }
}

} // namespace

InputKind openVdbKind() { return {".vdb", openVdb}; }

} // namespace voxc
