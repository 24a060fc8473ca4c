// Which instances of a scene reach into a region of its voxels.
#pragma once

#include "Mesh/Voxelize/MeshModel.h"

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace voxc {

/// The triangles [first, second) of the instances whose boxes reach into the voxels [region[0], region[1]),
/// in order; all triangles without a region. More than that may be given, never less.
std::vector<std::pair<std::uint64_t, std::uint64_t>>
trianglesNear(const std::optional<std::array<Int3, 2>> &region, const TriangleScene &scene,
              const MeshModel &model);

} // namespace voxc
