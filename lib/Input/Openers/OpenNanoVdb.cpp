// Opening NanoVDB grids: colours as they are, numbers as a dense volume of samples, level sets filled.
#include "Input/Dense/ColourMap.h"
#include "Input/Dense/SampleChecks.h"
#include "Input/Dense/Samples.h"
#include "Input/NanoVdb/NanoVdbFile.h"
#include "Input/NanoVdb/NanoVdbGrid.h"
#include "Input/Openers/InputText.h"
#include "Input/Openers/Openers.h"
#include "Source/DenseSource.h"
#include "Source/GridExtent.h"
#include "voxc/Support/Stopwatch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace voxc {

namespace {

/// Which values are voxels, and what they look like.
struct Look {
  ValueMeaning meaning = ValueMeaning::Sample;
  bool isLevelSet = false;
  double threshold = 0; ///< Of a level set.
  SampleMap map;        ///< Of any other numbers.

  std::uint32_t word(double value, bool isActive) const {
    if (meaning == ValueMeaning::Colour)
      return isActive ? static_cast<std::uint32_t>(value) : 0;
    if (meaning == ValueMeaning::Flag)
      return value != 0 ? 0xffffffff : 0;
    if (isLevelSet)
      return value <= threshold ? 0xffffffff : 0;
    return map.word(value);
  }
};

/// A grid with the bytes that it lies in.
struct OpenGrid {
  StoredGrid stored;
  NanoVdbGrid grid;
};

class GridRows final : public DenseRows {
public:
  GridRows(std::shared_ptr<const OpenGrid> open, const Look &look) : open_(std::move(open)), look_(look) {}

  void read(Int3 first, std::int32_t count, std::uint32_t *words) const override {
    const auto take = [&](double value, bool isActive) { *words++ = look_.word(value, isActive); };
    for (Int3 cell = open_->grid.low() + first; count > 0;) {
      const std::int32_t run = open_->grid.readRun(cell, count, take);
      cell.x += run;
      count -= run;
    }
  }

private:
  std::shared_ptr<const OpenGrid> open_;
  Look look_;
};

Expected<Int3> extentOf(const NanoVdbGrid &grid, const InputOptions &options) {
  Int3 extent;
  for (int axis = 0; axis < 3; ++axis) {
    const std::int64_t size = std::int64_t{grid.high()[axis]} - grid.low()[axis] + 1;
    if (size < 1)
      return Error::input("its grid has no active voxel");
    extent[axis] = static_cast<std::int32_t>(std::min<std::int64_t>(size, (1 << kMaxLog2Extent) + 1));
  }
  VOXC_TRY(checkGridExtent(extent));
  const Int3 holds = options.mostExtent();
  const bool fits = extent.x <= holds.x && extent.y <= holds.y && extent.z <= holds.z;
  // What is empty is kept in a bit for each 512 cells.
  if (!fits || cellsOf(extent) > std::uint64_t{1} << 40)
    return Error::input("its grid takes " + extentText(extent) + " voxels, but the format holds " +
                        extentText(holds) + (fits ? " and at most 2^40 are read" : ""));
  return extent;
}

/// Of active values; without any, nothing but 0.
SampleRange rangeOf(const NanoVdbGrid &grid) {
  SampleRange range;
  const auto add = [&](double value, bool isActive) {
    if (!isActive || !std::isfinite(value))
      return;
    range.low = std::min(range.low, value);
    range.high = std::max(range.high, value);
  };
  grid.forEach(
      [&](Int3, const std::byte *leaf) {
        for (std::uint32_t cell = 0; cell < 512; ++cell)
          add(grid.kind().readCell(leaf, cell), isActiveInLeaf(leaf, cell));
      },
      [&](const ValueTile &tile) { add(tile.value, tile.isActive); });
  return range.low <= range.high ? range : SampleRange{0, 0};
}

/// Options that mean nothing for what the grid holds. Error: one of them is given.
Expected<void> checkOptions(const Look &look, const InputOptions &options) {
  const bool isSample = look.meaning == ValueMeaning::Sample;
  const std::string what = !isSample         ? "values that are no numbers"
                           : look.isLevelSet ? "a level set"
                                             : "numbers";
  const auto refuse = [&](const char *option) {
    return Error::usage(std::string(option) + " would do nothing for a grid of " + what + "; leave it out");
  };
  if (options.threshold && !isSample)
    return refuse("--threshold");
  if (options.window && (!isSample || look.isLevelSet))
    return refuse("--window");
  if (options.colourMap != "grey" && options.colourMap != kLabels && (!isSample || look.isLevelSet))
    return refuse("--colour-map");
  return checkThreshold(options.threshold);
}

Expected<Look> lookOf(const NanoVdbGrid &grid, const InputOptions &options, const SampleRange &range) {
  Look look;
  look.meaning = grid.kind().meaning;
  look.isLevelSet = grid.isLevelSet() && look.meaning == ValueMeaning::Sample;
  VOXC_TRY(checkOptions(look, options));
  // Nearer than half a voxel's side, as of OpenVDB's level sets.
  look.threshold = options.threshold.value_or(grid.voxelSize() / 2);
  look.map.threshold = options.threshold;
  if (options.keepsSamples) {
    look.map.kept = grid.kind().isWhole ? SampleMap::Kept::Int32 : SampleMap::Kept::Float32;
    VOXC_TRY(checkKept(look.map.kept, range));
    return look;
  }
  if (options.colourMap == kLabels) {
    look.map.labels = true;
    return look;
  }
  look.map.colours = VOXC_TRY(colourMap(options.colourMap));
  look.map.window = options.window ? SampleRange{(*options.window)[0], (*options.window)[1]} : range;
  return look;
}

/// "a, b and c", of many the first few.
std::string listed(const std::vector<std::string> &names) {
  constexpr std::size_t kMost = 8;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kMost); ++i)
    text += (i == 0 ? "" : ", ") + names[i];
  return names.size() > kMost ? text + " and " + std::to_string(names.size() - kMost) + " more" : text;
}

std::vector<InputFact> factsOf(const NanoVdbGrid &grid, const SampleRange &range, const StoredGrid &stored) {
  const bool isLevelSet = grid.isLevelSet() && grid.kind().meaning == ValueMeaning::Sample;
  const auto corner = [](Int3 cell) {
    return std::array<double, 3>{double(cell.x), double(cell.y), double(cell.z)};
  };
  std::vector<InputFact> facts{
      {"values", std::string(grid.kind().name) + (isLevelSet ? ", a level set" : ""), {}},
      boxFact("active", corner(grid.low()), corner(grid.high())),
      {"voxel size", toText(grid.voxelSize()), {grid.voxelSize()}},
      {"background", toText(grid.background()), {grid.background()}}};
  if (grid.kind().meaning == ValueMeaning::Sample)
    facts.push_back({"range", toText(range.low) + " to " + toText(range.high), {range.low, range.high}});
  if (!stored.name.empty())
    facts.push_back({"grid", stored.name, {}});
  if (!stored.others.empty()) {
    facts.push_back(countFact("other grids", stored.others.size()));
    facts.back().text += ": " + listed(stored.others);
  }
  return facts;
}

/// Marks the bricks that cells of a box reach into.
void markBox(OccupancyPyramid &occupancy, Int3 extent, Int3 low, std::int64_t side) {
  constexpr std::int64_t kBrick = 1 << OccupancyPyramid::kLog2Brick;
  Int3 first;
  Int3 last;
  for (int axis = 0; axis < 3; ++axis) {
    const std::int64_t begin = std::max<std::int64_t>(low[axis], 0);
    const std::int64_t end = std::min<std::int64_t>(low[axis] + side, extent[axis]);
    if (begin >= end)
      return;
    first[axis] = static_cast<std::int32_t>(begin & -kBrick);
    last[axis] = static_cast<std::int32_t>(end - 1);
  }
  Int3 cell;
  for (cell.z = first.z; cell.z <= last.z; cell.z += kBrick)
    for (cell.y = first.y; cell.y <= last.y; cell.y += kBrick)
      for (cell.x = first.x; cell.x <= last.x; cell.x += kBrick)
        occupancy.mark(cell);
}

/// Which bricks of the box of active cells hold a voxel.
OccupancyPyramid occupancyOf(const NanoVdbGrid &grid, const Look &look, Int3 extent) {
  OccupancyPyramid occupancy(extent);
  // A cell far outside the box may be too far for a difference in 32 bits; it is clipped before that matters.
  const auto shifted = [&](Int3 cell) {
    Int3 moved;
    for (int axis = 0; axis < 3; ++axis)
      moved[axis] = static_cast<std::int32_t>(
          std::clamp<std::int64_t>(std::int64_t{cell[axis]} - grid.low()[axis], -(1 << 24), 1 << 24));
    return moved;
  };
  grid.forEach(
      [&](Int3 low, const std::byte *leaf) {
        for (std::uint32_t cell = 0; cell < 512; ++cell)
          if (look.word(grid.kind().readCell(leaf, cell), isActiveInLeaf(leaf, cell)) != 0)
            return markBox(occupancy, extent, shifted(low), 8);
      },
      [&](const ValueTile &tile) {
        if (look.word(tile.value, tile.isActive) != 0)
          markBox(occupancy, extent, shifted(tile.low), std::int64_t{1} << tile.log2Side);
      });
  if (look.word(grid.background(), false) != 0)
    markBox(occupancy, extent, {}, std::int64_t{1} << kMaxLog2Extent);
  return occupancy;
}

/// Whole numbers of index space are the middles of voxels.
Transform voxelToModelOf(const NanoVdbGrid &grid) {
  Transform map = grid.indexToWorld();
  const Int3 low = grid.low();
  map[3] = map * glm::dvec4(low.x - 0.5, low.y - 0.5, low.z - 0.5, 1);
  return map;
}

std::string provenanceOf(const Look &look, const InputOptions &options) {
  if (look.meaning != ValueMeaning::Sample)
    return "coverage=cells" + upProvenance(options);
  std::string text = look.isLevelSet ? "coverage=inside" : "coverage=samples";
  if (options.threshold)
    text += " threshold=" + toText(*options.threshold);
  if (!look.isLevelSet)
    text += " colour-map=" + options.colourMap;
  if (!look.isLevelSet && !look.map.labels)
    text += " window=" + toText(look.map.window.low) + "," + toText(look.map.window.high);
  return text + upProvenance(options);
}

Expected<Input> makeInput(std::shared_ptr<const OpenGrid> open, const InputOptions &options) {
  const NanoVdbGrid &grid = open->grid;
  const auto stored = VOXC_TRY(extentOf(grid, options));
  const SampleRange range = grid.kind().meaning == ValueMeaning::Sample ? rangeOf(grid) : SampleRange{0, 0};
  const auto look = VOXC_TRY(lookOf(grid, options, range));
  Input input;
  if (options.describe)
    input.facts = factsOf(grid, range, open->stored);
  if (options.threshold && !look.isLevelSet)
    if (const auto complaint = complaintOf(*options.threshold, {std::min(range.low, grid.background()),
                                                                std::max(range.high, grid.background())}))
      input.warnings.push_back(*complaint);
  input.provenance = provenanceOf(look, options);
  if (!options.grid.empty())
    input.provenance += " grid=" + provenanceWord(options.grid);
  else if (!open->stored.others.empty())
    input.warnings.push_back("it holds " + std::to_string(open->stored.others.size() + 1) + " grids; '" +
                             open->stored.name + "' is taken, and left out are " +
                             listed(open->stored.others) + " (--grid NAME takes one of them)");
  OccupancyPyramid occupancy = occupancyOf(grid, look, stored);
  const Transform map = voxelToModelOf(grid);
  std::shared_ptr<const DenseRows> rows = std::make_shared<GridRows>(std::move(open), look);
  input.source = VOXC_TRY(makeUprightSource(stored, std::move(rows), std::move(occupancy), map, options.zUp,
                                            options.memory, options.progress));
  return input;
}

Expected<Input> openFile(const std::string &path, const InputOptions &options) {
  auto file = VOXC_TRY(WatchedFile::open(path, options.memory));
  constexpr std::string_view kKind = "NanoVDB file";
  auto stored = VOXC_TRY(
      usable(findNanoVdbGrid(std::move(file), options.grid, options.memory, options.progress), path, kKind));
  auto grid = VOXC_TRY(usable(NanoVdbGrid::open(stored.bytes, options.progress), path, kKind));
  auto open = std::make_shared<const OpenGrid>(OpenGrid{std::move(stored), std::move(grid)});
  return usable(makeInput(std::move(open), options), path, kKind);
}

} // namespace

Expected<Input> openNanoVdb(const std::string &path, const InputOptions &options) {
  const Stopwatch loading;
  auto input = VOXC_TRY(openFile(path, options));
  input.loadSeconds = loading.seconds();
  return input;
}

} // namespace voxc
