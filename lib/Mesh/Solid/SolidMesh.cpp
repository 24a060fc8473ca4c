// Filling a mesh: its empty cells fall into parts, and one cell of each tells whether it lies inside.
#include "voxc/Mesh/SolidMesh.h"

#include "Mesh/Solid/CentreSource.h"
#include "Mesh/Solid/ClosedMesh.h"
#include "Mesh/Solid/Facing.h"
#include "Mesh/Solid/InsideCells.h"
#include "Mesh/Voxelize/MeshVoxels.h"
#include "Source/Interior/FloodTree.h"
#include "Source/Interior/PaintedSource.h"

#include <string>
#include <utility>

namespace voxc {

namespace {

/// What both ways to make a solid begin with.
struct Prepared {
  ClosedMesh mesh;
  Facing facing; ///< Of the scene before its holes were closed: its voxels shall stay what they are.

  static Expected<Prepared> of(const TriangleScene &scene, const VoxelizeOptions &options,
                               const InteriorOptions &means) {
    const auto model = VOXC_TRY(MeshModel::open(scene, options, means.memory.get()));
    Facing facing = Facing::Unknown;
    if (options.coverage == Coverage::Inner)
      facing = VOXC_TRY(facingOf(scene, model, means.memory, means.progress));
    auto mesh = VOXC_TRY(ClosedMesh::of(scene, model, means.memory, means.progress));
    return Prepared{std::move(mesh), facing};
  }

  /// The solid, with what was found out of the mesh.
  SolidMesh solid(std::unique_ptr<VoxelSource> source, std::uint64_t voxels) const {
    return {std::move(source), voxels, mesh.rule, mesh.hasTwins, mesh.open, mesh.holes, mesh.holeShare};
  }
};

/// The voxels of the closed mesh as a tree, and the empty cells inside.
struct Inside {
  FloodTree tree;
  FloodTree::Chosen cells;
};

Expected<Inside> insideOf(const Prepared &prepared, const VoxelizeOptions &options,
                          const InteriorOptions &means) {
  const ClosedMesh &mesh = prepared.mesh;
  MeshTuning tuning;
  tuning.facing = prepared.facing;
  auto shape = VOXC_TRY(makeMeshSource(mesh.scene, options, means.memory, tuning));
  // What lies beyond the volume is no way from one part to another.
  auto tree = VOXC_TRY(FloodTree::read(*shape, {Step::Face, Outside::Solid}, means));
  const auto parts = VOXC_TRY(tree.floodEveryPart());
  ScratchArray<CellCrossings> cells(means.memory);
  for (const Int3 &part : parts.span())
    VOXC_TRY(cells.push({part}));
  if (auto counted =
          countCrossings(*mesh.scene, mesh.model, cells, *means.memory, means.progress, mesh.roles());
      !counted)
    return counted.error();
  tree.clearReached();
  for (const CellCrossings &cell : cells.span())
    if (mesh.isInside(cell))
      VOXC_TRY(tree.floodFrom(cell.cell));
  auto chosen = VOXC_TRY(tree.choose(Choice::Reached));
  return Inside{std::move(tree), std::move(chosen)};
}

/// Takes the cells where a source has voxels out of the bricks, and counts those that are left.
Expected<std::uint64_t> leaveEmpty(ScratchArray<BrickCells> &bricks, VoxelSource &source) {
  std::uint64_t count = 0;
  std::array<std::uint32_t, 512> words;
  for (BrickCells &brick : bricks.span()) {
    VOXC_TRY(source.read({brick.low, 3}, words.data()));
    const Slices voxels = toSlices(bitsOf(words.data()));
    for (std::size_t z = 0; z < brick.cells.size(); ++z)
      brick.cells[z] &= ~voxels[z];
    count += countBits(brick.cells);
  }
  return count;
}

/// Paints the cells inside that triangles which close holes touch: no part of the empty cells has them.
Expected<std::uint64_t> fillCaps(const Prepared &prepared, const VoxelizeOptions &options, std::uint32_t word,
                                 std::unique_ptr<VoxelSource> &source, const InteriorOptions &means) {
  const ClosedMesh &mesh = prepared.mesh;
  const VoxelRule rule(options.coverage, mesh.model.grid.bits(), prepared.facing, mesh.model.extent());
  auto bricks = VOXC_TRY(voxelsOfCaps(mesh, rule, means.memory, means.progress));
  VOXC_TRY(keepInside(bricks, mesh, means.memory, means.progress));
  const auto count = VOXC_TRY(leaveEmpty(bricks, *source));
  auto cells = VOXC_TRY(setOf(bricks.span(), mesh.model.extent(), means.memory));
  source = paint(std::move(source), std::move(cells), word);
  return count;
}

} // namespace

Expected<SolidMesh> fillMesh(const TriangleScene &scene, const VoxelizeOptions &options,
                             std::unique_ptr<VoxelSource> surface, std::uint32_t word,
                             const InteriorOptions &means) {
  const auto prepared = VOXC_TRY(Prepared::of(scene, options, means));
  if (!prepared.mesh.isClosed()) {
    auto filled = VOXC_TRY(fillInterior(std::move(surface), word, means));
    return prepared.solid(std::move(filled.source), filled.voxels);
  }
  auto inside = VOXC_TRY(insideOf(prepared, options, means));
  std::unique_ptr<VoxelSource> source = paint(std::move(surface), std::move(inside.cells.cells), word);
  std::uint64_t count = inside.cells.count;
  if (prepared.mesh.holes != 0) {
    const auto added = VOXC_TRY(fillCaps(prepared, options, word, source, means));
    count += added;
  }
  return prepared.solid(std::move(source), count);
}

Expected<SolidMesh> centreMesh(const TriangleScene &scene, const VoxelizeOptions &options,
                               std::unique_ptr<VoxelSource> surface, std::uint32_t word,
                               const InteriorOptions &means) {
  const auto prepared = VOXC_TRY(Prepared::of(scene, options, means));
  const ClosedMesh &mesh = prepared.mesh;
  if (!mesh.isClosed())
    return Error::input(
        "the mesh is not closed, so that no centre lies inside it: " + std::to_string(mesh.open.count) +
        " edges lack a counterpart; close it, or take the coverage conservative, thin or inner");
  auto inside = VOXC_TRY(insideOf(prepared, options, means));
  auto bricks = VOXC_TRY(inside.tree.voxels());
  VOXC_TRY(keepInside(bricks, mesh, means.memory, means.progress));
  auto cells = VOXC_TRY(setOf(bricks.span(), mesh.model.extent(), means.memory));
  const std::uint64_t count = inside.cells.count;
  return prepared.solid(
      makeCentreSource(std::move(surface), {std::move(inside.cells.cells), std::move(cells)}, word), count);
}

} // namespace voxc
