// Cells as sorted codes, and batches of them against all triangles.
#include "Mesh/Solid/InsideCells.h"

#include <algorithm>
#include <vector>

namespace voxc {

namespace {

constexpr std::uint64_t kFewCodes = 1 << 20; ///< Fewer are not worth sorting.
constexpr std::uint64_t kCellsAtOnce = 1 << 21;
constexpr std::uint64_t kBetweenLooks = 64;

Expected<void> sortOut(ScratchArray<std::uint64_t> &codes) {
  std::ranges::sort(codes.span());
  return codes.resize(codes.size() - std::ranges::unique(codes.span()).size());
}

/// The cell at a place of a brick in Morton order.
void addCell(Slices &cells, std::uint64_t place) {
  const Int3 at = mortonCell(place);
  cells[static_cast<std::size_t>(at.z)] |= std::uint64_t{1} << (at.x + 8 * at.y);
}

Expected<ScratchArray<BrickCells>> bricksOf(const ScratchArray<std::uint64_t> &codes,
                                            const std::shared_ptr<WorkingMemory> &memory) {
  ScratchArray<BrickCells> bricks(memory);
  for (const std::uint64_t code : codes.span()) {
    const Int3 low = mortonCell(code >> 9 << 9);
    if (bricks.empty() || bricks[bricks.size() - 1].low != low)
      VOXC_TRY(bricks.push({low, {}}));
    addCell(bricks[bricks.size() - 1].cells, code & 511);
  }
  return bricks;
}

/// Adds the cells of a brick, and takes them out of it.
Expected<void> moveCells(BrickCells &brick, ScratchArray<CellCrossings> &cells) {
  for (std::size_t z = 0; z < 8; ++z)
    for (std::uint64_t bits = std::exchange(brick.cells[z], 0); bits != 0; bits &= bits - 1) {
      const int bit = std::countr_zero(bits);
      VOXC_TRY(cells.push({brick.low + Int3{bit & 7, bit >> 3, static_cast<int>(z)}}));
    }
  return {};
}

} // namespace

Expected<ScratchArray<BrickCells>> voxelsOfCaps(const ClosedMesh &mesh, const VoxelRule &rule,
                                                const std::shared_ptr<WorkingMemory> &memory,
                                                const Progress &progress) {
  ScratchArray<std::uint64_t> codes(memory);
  std::uint64_t sorted = 0;
  std::vector<CellMask> masks;
  TriangleCursor cursor(*mesh.scene, mesh.model.numbers);
  for (std::uint64_t number = mesh.caps; number < mesh.model.numbers.size(); ++number) {
    if (number % kBetweenLooks == 0) {
      VOXC_TRY(progress.check());
      memory->relieve();
    }
    cursor.moveTo(number);
    rule.cover(mesh.model.snapped(cursor), {}, {{}, mesh.model.extent()}, masks);
    Expected<void> added;
    for (const CellMask &mask : masks)
      forEachCell(mask, [&](Int3 cell) {
        if (added)
          added = codes.push(mortonCode(cell));
      });
    if (added && codes.size() > std::max(kFewCodes, 2 * sorted)) {
      added = sortOut(codes);
      sorted = codes.size();
    }
    if (!added)
      return added.error();
  }
  VOXC_TRY(sortOut(codes));
  return bricksOf(codes, memory);
}

Expected<void> keepInside(ScratchArray<BrickCells> &bricks, const ClosedMesh &mesh,
                          const std::shared_ptr<WorkingMemory> &memory, const Progress &progress) {
  ScratchArray<CellCrossings> cells(memory);
  for (std::uint64_t end = 0; end < bricks.size();) {
    const std::uint64_t begin = end;
    VOXC_TRY(cells.resize(0));
    for (; end < bricks.size() && cells.size() < kCellsAtOnce; ++end)
      VOXC_TRY(moveCells(bricks[end], cells));
    if (auto counted = countCrossings(*mesh.scene, mesh.model, cells, *memory, progress, mesh.roles());
        !counted)
      return counted;
    const std::span<BrickCells> batch = bricks.span().subspan(begin, end - begin);
    for (const CellCrossings &cell : cells.span()) {
      if (!mesh.isInside(cell))
        continue;
      const std::uint64_t code = mortonCode(cell.cell);
      const auto brick = std::ranges::lower_bound(batch, code >> 9, {},
                                                  [](const BrickCells &b) { return mortonCode(b.low) >> 9; });
      addCell(brick->cells, code & 511);
    }
  }
  return {};
}

} // namespace voxc
