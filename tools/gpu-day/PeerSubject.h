// A tracer that somebody wrote by hand, on the same rays.
#pragma once

#include "Subject.h"

namespace voxc::gpu {

/// A kernel of `nodes`: four words (edge, levels, thirds of a, b), then the words of two buffers, a and b. It
/// binds these, six words a ray, and two a hit (a voxel of 10 bits an axis, or ~0, and a colour); its push
/// constants are columns, rows, edge and levels of a picture of rays in groups of 8 x 8.
/// Rows as of a kernel of voxc; an error is another voxel. Errors: nodes that are cut short (`Input`); those
/// of the device.
Expected<tool::Json> measurePeer(const Gpu &gpu, std::span<const std::uint32_t> spirv,
                                 std::span<const std::uint32_t> nodes, std::span<const RaysThere> sets,
                                 double seconds);

/// Columns of the picture as which a peer takes any rays; sets need room for as many more.
inline constexpr std::uint32_t kPeerColumns = 3840;

} // namespace voxc::gpu
