// Solid voxels of closed meshes.
#pragma once

#include "voxc/Mesh/MeshSource.h"
#include "voxc/Source/Interior.h"

#include <array>
#include <cstdint>
#include <memory>

namespace voxc {

/// By which rule the inside of a mesh was told from its outside.
enum class SolidRule : std::uint8_t {
  Winding, ///< The mesh is closed and its triangles turn alike: inside, the winding number is not 0.
  Parity,  ///< It is closed, but some triangles face the other way: inside, a ray crosses it an odd number of
           ///< times.
  Enclosure, ///< It is not closed: inside is what no path over faces of empty voxels leads out of.
};

/// Edges without a counterpart: in a closed mesh whose triangles turn alike each edge is passed as often one
/// way as the other.
struct OpenEdges {
  std::uint64_t count = 0;
  bool isAll = true;            ///< False: there are so many that only some were counted.
  std::array<double, 3> from{}; ///< The ends of one of them, in model units.
  std::array<double, 3> to{};
};

struct SolidMesh {
  std::unique_ptr<VoxelSource> source;
  std::uint64_t voxels = 0; ///< That were added.
  SolidRule rule = SolidRule::Winding;
  OpenEdges open; ///< Of the rule `Parity` or `Enclosure`.
};

/// The voxels of `surface`, which is `scene` voxelized with `options`, and one with the word `word` (not 0)
/// in every empty cell inside the mesh.
///
/// The winding number of a cell's centre is the number of triangles that the row from it towards -x leaves
/// through, less those that it enters by; corners are those that are voxelized, snapped to the grid, and all
/// is decided in integers. A row that meets an edge or a corner is taken to lie a step of e towards +y and of
/// e^2 towards +z beside it, with e beyond every number (Edelsbrunner and Muecke, "Simulation of Simplicity",
/// ACM Transactions on Graphics 9, 1990): each edge belongs to one of its triangles. As no path over faces of
/// empty voxels crosses a closed mesh, one cell of each part of them is looked at. Triangles outside the
/// volume count, and so do those that a texture cuts out. Errors: those of `makeMeshSource` and of sources
/// that fail, interrupted, no memory.
Expected<SolidMesh> fillMesh(const TriangleScene &scene, const VoxelizeOptions &options,
                             std::unique_ptr<VoxelSource> surface, std::uint32_t word,
                             const InteriorOptions &means = {});

} // namespace voxc
