// The header of a NIfTI file, of version 1 or 2.
#pragma once

#include "Input/Dense/Samples.h"
#include "voxc/Support/Geometry.h"
#include "voxc/Support/Transform.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace voxc {

struct NiftiHeader {
  /// Bytes of the longer version.
  static constexpr std::size_t kMaxBytes = 540;

  Int3 extent;
  std::uint64_t volumes = 1; ///< Of this extent, one after the other.
  SampleLayout layout;
  double slope = 1;
  double intercept = 0;
  std::uint64_t dataOffset = 0;
  Transform sampleToModel;
};

/// Reads the header at the front of `bytes`. Errors: not a NIfTI file; samples in another file; numbers that
/// make no sense; a type of samples that is no number.
Expected<NiftiHeader> readNiftiHeader(std::span<const std::byte> bytes);

} // namespace voxc
