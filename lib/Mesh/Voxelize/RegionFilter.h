// Which instances of a scene reach into regions of its voxels.
#pragma once

#include "Mesh/Voxelize/MeshModel.h"

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace voxc {

/// The triangles [first, second) of the instances whose boxes reach into voxels [region[0], region[1]) of one
/// of the regions, in order; all triangles without a region. More than that may be given, never less.
std::vector<std::pair<std::uint64_t, std::uint64_t>>
trianglesNear(std::span<const std::array<Int3, 2>> regions, const TriangleScene &scene,
              const MeshModel &model);

} // namespace voxc
