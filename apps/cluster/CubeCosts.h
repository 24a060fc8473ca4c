// The counting pass of a build plan: what each cube of an input is predicted to cost.
#pragma once

#include "voxc/Input/Input.h"
#include "voxc/Source/VoxelSource.h"

#include <cstdint>
#include <string>
#include <vector>

namespace voxc::tool::cluster {

/// Costs of aligned cubes of one size, in Morton order.
struct CubeCosts {
  int log2Side = 0; ///< Of a cube, in voxels.
  std::vector<std::uint64_t> costs;
  std::uint64_t voxels = 0;  ///< Of all cubes, as they were estimated or counted,
  std::uint64_t records = 0; ///< and the triangles in all of them.
};

/// Predicts what it costs to build the cubes of 2^log2Side voxels a side of an opened input, or larger ones
/// where these would be more than 2^21: by its voxels, and by the triangles that are gone through to make
/// them. The voxels of a mesh are estimated from an eighth of its resolution, at which `name` is opened again
/// with `options`; those of other inputs are counted. Errors: those of opening and reading.
Expected<CubeCosts> predictCosts(const Input &input, const std::string &name, const InputOptions &options,
                                 int log2Side);

} // namespace voxc::tool::cluster
