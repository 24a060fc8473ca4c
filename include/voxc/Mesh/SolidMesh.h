// Solid voxels of closed meshes.
#pragma once

#include "voxc/Mesh/MeshSource.h"
#include "voxc/Source/Interior.h"

#include <array>
#include <cstdint>
#include <memory>

namespace voxc {

/// By which rule the inside of a mesh was distinguished from its outside.
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

/// Holes are closed if the fans that do it have no more than this share of the mesh's area.
inline constexpr double kMostHoles = 0.1;

struct SolidMesh {
  std::unique_ptr<VoxelSource> source;
  std::uint64_t voxels = 0; ///< That were added where no triangle is.
  SolidRule rule = SolidRule::Winding;
  /// Triangles that lie on others, which face the other way, are closed for themselves: inside is also where
  /// a ray crosses them an odd number of times. The rule `Enclosure` then means that nothing else is closed.
  bool isDoubleSided = false;
  OpenEdges open;          ///< Of the rule `Parity` or `Enclosure`, or of a mesh with holes.
  std::uint64_t holes = 0; ///< That were closed, each by a fan from the middle of its rim.
  double holeShare = 0;    ///< Of the area, at most `kMostHoles`.
};

/// The voxels of `surface`, which is `scene` voxelized with `options`, and one with the word `word` (not 0)
/// in every empty cell inside the mesh.
///
/// A mesh with small holes (`kMostHoles`) is closed by fans, and each cell that one of them touches is looked
/// at. Of triangles that have the same corners, as many one way as the other, those of one way count for
/// themselves: of a double-sided mesh the winding number is 0 everywhere.
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

/// The solid that `scene` bounds, by the centres of cells: those inside by the rule of `fillMesh` are voxels,
/// with the word of `surface`, which is `scene` voxelized with `options`, or where that has none with `word`.
/// A centre on the surface is taken to lie a step of e towards +x, of e^2 towards +y and of e^3 towards +z
/// beside it. Error besides those of `fillMesh`: the mesh is not closed, and has more holes than may be
/// closed.
Expected<SolidMesh> centreMesh(const TriangleScene &scene, const VoxelizeOptions &options,
                               std::unique_ptr<VoxelSource> surface, std::uint32_t word,
                               const InteriorOptions &means = {});

} // namespace voxc
