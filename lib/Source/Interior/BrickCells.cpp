// A tree of bricks, from the leaves up.
#include "Source/Interior/BrickCells.h"

#include <algorithm>
#include <optional>

namespace voxc {

namespace {

class Builder {
public:
  explicit Builder(const std::shared_ptr<WorkingMemory> &memory)
      : cells_(std::make_shared<CellSet>(memory)) {}

  Expected<std::shared_ptr<const CellSet>> build(std::span<const BrickCells> bricks, int height) {
    cells_->finish(child(bricks, height), height);
    if (error_)
      return *error_;
    return std::shared_ptr<const CellSet>(std::move(cells_));
  }

private:
  /// What the bricks of a cube of 8^height cells a side are to its parent.
  std::uint32_t child(std::span<const BrickCells> bricks, int height) {
    if (bricks.empty() || error_)
      return CellSet::kNone;
    if (height == 1) {
      const std::uint64_t bits = countBits(bricks.front().cells);
      if (bits == 0 || bits == 512)
        return bits == 0 ? CellSet::kNone : CellSet::kAll;
      return take(cells_->add(toMorton(bricks.front().cells)));
    }
    CellSet::Node children;
    children.fill(CellSet::kNone);
    const auto placeOf = [height](const BrickCells &brick) {
      return mortonCode(brick.low >> 3 * (height - 1)) & 511;
    };
    while (!bricks.empty()) {
      const std::uint64_t place = placeOf(bricks.front());
      const auto end =
          std::ranges::find_if(bricks, [&](const auto &brick) { return placeOf(brick) != place; });
      const auto count = static_cast<std::size_t>(end - bricks.begin());
      children[place] = child(bricks.first(count), height - 1);
      bricks = bricks.subspan(count);
    }
    for (const std::uint32_t whole : {CellSet::kNone, CellSet::kAll})
      if (std::ranges::all_of(children, [whole](std::uint32_t one) { return one == whole; }))
        return whole;
    return take(cells_->add(children));
  }

  std::uint32_t take(const Expected<std::uint32_t> &added) {
    if (added)
      return *added;
    error_ = added.error();
    return CellSet::kNone;
  }

  std::shared_ptr<CellSet> cells_;
  std::optional<Error> error_;
};

} // namespace

Expected<std::shared_ptr<const CellSet>> setOf(std::span<const BrickCells> bricks, Int3 extent,
                                               const std::shared_ptr<WorkingMemory> &memory) {
  int height = 1;
  while (1 << 3 * height < std::max({extent.x, extent.y, extent.z}))
    ++height;
  return Builder(memory).build(bricks, height);
}

} // namespace voxc
