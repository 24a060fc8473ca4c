// A dense volume of samples, as a reader of its file describes it.
#pragma once

#include "Input/Dense/Samples.h"
#include "Support/WatchedFile.h"
#include "voxc/Input/Input.h"

#include <memory>
#include <string>
#include <vector>

namespace voxc {

/// Samples in memory or in a mapped file, x fastest, then y, then z.
struct DenseVolume {
  Int3 extent;
  SampleLayout layout;
  double slope = 1;
  double intercept = 0;
  const std::byte *samples = nullptr;
  std::shared_ptr<const void> storage; ///< What `samples` points into.
  Transform sampleToModel;             ///< Of points in voxels: sample i fills [i, i + 1).
  std::vector<std::string> warnings;
  std::vector<std::string> notes;
};

/// The bytes of all samples of a possible extent. Error: more than 2^63, so that no file has them.
Expected<std::uint64_t> sampleBytes(Int3 extent, SampleLayout layout);

/// The affine map of which column i is the step from one sample to the next along axis i; the centre of the
/// first sample lies at `origin`.
Transform mapOfSteps(const std::array<std::array<double, 3>, 3> &steps, const std::array<double, 3> &origin);

/// The input that the options make of it: threshold, colours and the turn.
Expected<Input> makeInput(DenseVolume volume, const InputOptions &options);

} // namespace voxc
