// Filling a mesh: its empty cells fall into parts, and one cell of each tells whether it lies inside.
#include "voxc/Mesh/SolidMesh.h"

#include "Mesh/Solid/EdgeBalance.h"
#include "Mesh/Solid/RowCrossings.h"
#include "Source/Interior/FloodTree.h"
#include "Source/Interior/PaintedSource.h"
#include "voxc/Source/Interior.h"

#include <utility>

namespace voxc {

namespace {

/// The scene without colours: nothing of it is cut out, and voxels are made faster.
std::shared_ptr<const TriangleScene> shapeOf(const TriangleScene &scene) {
  auto shape = std::make_shared<TriangleScene>(scene);
  shape->materials = {Material{}};
  shape->textures.clear();
  for (MeshPart &part : shape->parts) {
    part.uvs = {};
    part.emissionUvs = {};
    part.colours = {};
    part.material = 0;
  }
  return shape;
}

bool isInside(const CellCrossings &cell, SolidRule rule) {
  return rule == SolidRule::Winding ? cell.winding != 0 : cell.crossings % 2 != 0;
}

Expected<FloodTree::Chosen> insideOf(const TriangleScene &scene, const MeshModel &model, SolidRule rule,
                                     const VoxelizeOptions &options, const InteriorOptions &means) {
  const std::shared_ptr<WorkingMemory> &memory = means.memory;
  auto shape = makeMeshSource(shapeOf(scene), options, memory);
  if (!shape)
    return shape.error();
  // What lies beyond the volume is no way from one part to another.
  auto tree = FloodTree::read(**shape, {Step::Face, Beyond::Solid}, means);
  if (!tree)
    return tree.error();
  const auto parts = tree->floodEveryPart();
  if (!parts)
    return parts.error();
  ScratchArray<CellCrossings> cells(memory);
  for (const Int3 &part : parts->span())
    if (auto added = cells.push({part}); !added)
      return added.error();
  if (auto counted = countCrossings(scene, model, cells, *memory, means.progress); !counted)
    return counted.error();
  tree->drain();
  for (const CellCrossings &cell : cells.span())
    if (isInside(cell, rule))
      if (auto flooded = tree->floodFrom(cell.cell); !flooded)
        return flooded.error();
  return tree->choose(Choice::Reached);
}

} // namespace

Expected<SolidMesh> fillMesh(const TriangleScene &scene, const VoxelizeOptions &options,
                             std::unique_ptr<VoxelSource> surface, std::uint32_t word,
                             const InteriorOptions &means) {
  const auto model = MeshModel::open(scene, options, means.memory.get());
  if (!model)
    return model.error();
  const auto balance = EdgeBalance::of(scene, *model, means.memory, means.progress);
  if (!balance)
    return balance.error();
  if (balance->rule == SolidRule::Enclosure) {
    auto filled = fillInterior(std::move(surface), word, means);
    if (!filled)
      return filled.error();
    return SolidMesh{std::move(filled->source), filled->voxels, balance->rule, balance->open};
  }
  auto inside = insideOf(scene, *model, balance->rule, options, means);
  if (!inside)
    return inside.error();
  return SolidMesh{paint(std::move(surface), std::move(inside->cells), word), inside->count, balance->rule,
                   balance->open};
}

} // namespace voxc
