// Voxelization of triangles, decided in exact arithmetic.
#pragma once

#include "voxc/Mesh/TriangleScene.h"
#include "voxc/Source/VoxelSource.h"

#include <array>
#include <memory>
#include <optional>
#include <string_view>

namespace voxc {

/// Which voxels a triangle takes.
enum class Coverage {
  Conservative, ///< Every closed voxel cube that the closed triangle touches.
  Thin,         ///< Those in which it meets one of the three axis-parallel segments through the centre, from
                ///< face to face: no path over faces crosses a watertight surface (6-separating).
  Inner,  ///< As thin, and as separating, but what lies exactly between two voxels takes one of them: in
          ///< a closed mesh whose triangles turn alike that on the inner side, else that with the higher
          ///< coordinate, or the last of the volume. Segments that a triangle is parallel to do not count.
  Centre, ///< Of a solid, all whose centre lies in it: see `centreMesh`. Before it, as conservative.
};

/// What the rules are called, in their order.
inline constexpr std::array<std::string_view, 4> kCoverageNames{"conservative", "thin", "inner", "centre"};

/// The rule of a name, or nothing.
constexpr std::optional<Coverage> coverageOf(std::string_view name) {
  for (std::size_t i = 0; i < kCoverageNames.size(); ++i)
    if (kCoverageNames[i] == name)
      return static_cast<Coverage>(i);
  return std::nullopt;
}

/// Which colour a texture gives to a voxel.
enum class ColourRule {
  Mean, ///< Where texels are finer than voxels, their mean over the part of the surface that is as long and
        ///< wide as a voxel, by area and alpha, in linear light; else the nearest texel.
  Nearest, ///< The texel at the point that is nearest to the voxel's centre.
};

struct VoxelizeOptions {
  int resolution = 512;                        ///< Voxels on the longest axis of the bounds; 0: what fits.
  Int3 maxExtent{1 << 21, 1 << 21, 1 << 21};   ///< Error if the bounds need more than this on an axis.
  std::optional<std::array<double, 6>> bounds; ///< Crops, before the turn; default: the triangles' box.
  bool zUp = false;                            ///< Turns +z to +y (a rotation about x).
  Coverage coverage = Coverage::Conservative;
  /// Only voxels in boxes [box[0], box[1]) of these will be asked for, unless there is none: all others may
  /// look empty.
  std::vector<std::array<Int3, 2>> regions;
  Progress progress;
  ColourRule colour = ColourRule::Mean; ///< Changes no shape: the nearest texel says what is cut out.
  double voxelSize = 0;                 ///< The side of a voxel in model units, in place of a resolution.
  std::optional<std::array<double, 3>>
      align; ///< A point that planes between voxels go through; before the turn.
};

/// Voxelizes a scene as it is asked for, one chunk of voxels at a time. Corners are snapped to a fixed-point
/// grid (`makeMeshSource` of docs/construction.md says which) and the overlap is then decided without any
/// rounding: it depends on nothing but triangle and voxel. A voxel takes the colour of the triangle
/// nearest to its centre, then of the lowest number, at the point nearest to the centre; where a material is
/// cut out, the triangle leaves no voxel. Errors: bounds that do not fit, a vertex too far away, no memory.
Expected<std::unique_ptr<VoxelSource>> makeMeshSource(std::shared_ptr<const TriangleScene> scene,
                                                      const VoxelizeOptions &options,
                                                      const std::shared_ptr<WorkingMemory> &memory);

/// The same voxels by an independent, simple and slow way, to check the other: every voxel of every
/// triangle's box is tested by the definition, and the result is one sorted list in memory.
Expected<std::unique_ptr<VoxelSource>> makeReferenceMeshSource(const TriangleScene &scene,
                                                               const VoxelizeOptions &options);

} // namespace voxc
