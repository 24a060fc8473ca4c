// The header of a NIfTI file, of version 1 or 2.
#pragma once

#include "Input/Dense/Samples.h"
#include "voxc/Support/Geometry.h"
#include "voxc/Support/Transform.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace voxc {

struct NiftiHeader {
  /// Bytes of the longer version, with those that say whether extensions follow.
  static constexpr std::size_t kMaxBytes = 544;

  Int3 extent;
  std::uint64_t volumes = 1; ///< Of this extent, one after the other.
  SampleLayout layout;
  /// 3 or 4 samples are a colour: side by side, or, with `arePlanes`, all of a channel before those of the
  /// next.
  int channels = 1;
  bool arePlanes = false;
  double slope = 1;
  double intercept = 0;
  bool isPair = false;          ///< The samples are in another file,
  std::uint64_t dataOffset = 0; ///< where they begin at this byte, as they do in the same file.
  bool isAnalyze = false;       ///< The older format, which says of no axis where it goes.
  bool hasOrientation = false;  ///< It is said how the axes lie: +x is right, +y front, +z up.
  bool areLabels = false;
  std::vector<std::string> warnings;
  double unit = 0; ///< Metres of a step of length 1; 0: not said.
  Transform sampleToModel;

  /// Bytes of one volume. Error: as `voxc::sampleBytes`.
  Expected<std::uint64_t> volumeBytes() const;
};

/// Reads the header at the front of `bytes`; `allowsAnalyze`: the name of the file says that it may be one
/// without the marks of NIfTI. Errors: not a NIfTI file; numbers that make no sense; a type of samples that
/// is neither a number nor a colour.
Expected<NiftiHeader> readNiftiHeader(std::span<const std::byte> bytes, bool allowsAnalyze = false);

} // namespace voxc
