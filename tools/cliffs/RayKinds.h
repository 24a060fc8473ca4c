// The kinds of rays that situations have, one generator each.
#pragma once

#include "voxc/Oracle/Oracle.h"
#include "voxc/Support/Geometry.h"
#include "voxc/Trace/Ray.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace voxc::oracle {
class RandomSource;
}

namespace voxc::cliffs {

/// What rays are aimed at.
struct RayScene {
  const Oracle &oracle;
  Int3 extent;
  std::vector<Int3> voxels; ///< Some of those that are not empty, or none.

  double edge() const;
};

struct RayKind {
  std::string_view name;
  /// Makes at least `count` rays.
  std::vector<Ray> (*make)(oracle::RandomSource &random, const RayScene &scene, std::size_t count);
};

/// All of them.
std::span<const RayKind> rayKinds();

/// `count` rays of the kind of that name. The same arguments give the same rays. Precondition: there is one.
std::vector<Ray> makeRays(std::string_view kind, const RayScene &scene, std::size_t count,
                          std::uint64_t seed);

} // namespace voxc::cliffs
