// What a kernel has to know of the device that runs it.
#pragma once

#include "voxc/Support/EnumText.h"

#include <cstdint>

namespace voxc {

/// Each value is a file of shaders-runtime/memory.
enum class Addressing {
  Buffer,   ///< One storage buffer: the smallest code, up to the device's maxStorageBufferRange.
  Segments, ///< Device addresses of segments of 2^28 words each, as many as the volume has.
  Texels,   ///< A texel buffer of one word each, up to the device's maxTexelBufferElements
            ///< (docs/notes/2026-11-23-devices.md).
  Paged, ///< By a table of pages, some of which are here; a ray waits for one that is not (docs/paging.md).
};

template <>
inline constexpr std::array<std::string_view, 4> kEnumNames<Addressing> = {"buffer", "segments", "texels",
                                                                           "paged"};

/// Words in a segment of `Addressing::Segments`.
inline constexpr std::uint64_t kSegmentWords = std::uint64_t{1} << 28;

/// Whether the device runs every loop to its end.
enum class Loops {
  Whole,
  Cut, ///< It may end loops early, in silence, as Mesa's llvmpipe does: kernels leave such rays to be
       ///< resumed.
};

/// What the device's floating point is known to be.
enum class Arithmetic {
  Any, ///< As Vulkan promises: rounded one way or the other, an inverse wrong by 2.5 roundings, no doubles.
  Nearest, ///< Sums and products of float32 are rounded to nearest, where a kernel asks for it; the rest as
           ///< in `Any`.
  Ieee,    ///< As IEEE 754 has it: rounded to nearest, inverses too; doubles, which may be wrong by a few
           ///< roundings.
};

template <> inline constexpr std::array<std::string_view, 2> kEnumNames<Loops> = {"whole", "cut"};
template <>
inline constexpr std::array<std::string_view, 3> kEnumNames<Arithmetic> = {"any", "nearest", "ieee"};

} // namespace voxc
