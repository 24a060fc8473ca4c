// Bounds of rays that are chosen to hurt: at the moments when voxels are entered, and right beside them.
#pragma once

#include "voxc/Oracle/Oracle.h"
#include "voxc/Trace/BoundedRay.h"

#include <cstdint>
#include <span>
#include <vector>

namespace voxc::test {

/// Each ray with bounds of its own: the moments, rounded to float32, at which it enters one of the first
/// voxels on it, float32 neighbours of such, moments in between, and numbers that are no moments at all. The
/// same arguments give the same bounds.
std::vector<BoundedRay> withHardBounds(const Oracle &oracle, std::span<const Ray> rays, std::uint64_t seed);

} // namespace voxc::test
