// A dense volume of samples, as a reader of its file describes it.
#pragma once

#include "Input/Dense/Samples.h"
#include "Support/WatchedFile.h"
#include "voxc/Input/Input.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace voxc {

/// Samples in memory or in a mapped file, by default x fastest, then y, then z.
struct DenseVolume {
  Int3 extent;
  SampleLayout layout;
  double slope = 1;
  double intercept = 0;
  const std::byte *samples = nullptr;  ///< The sample of cell (0, 0, 0).
  std::shared_ptr<const void> storage; ///< What `samples` points into.
  /// Bytes from a sample to the next along each axis, which may be negative; all 0: as the default has it.
  std::array<std::int64_t, 3> steps{};
  /// 3 or 4: a cell is not a sample but a colour of so many, each `channelStep` bytes behind the one before.
  /// Without alpha, black is empty.
  int channels = 1;
  std::int64_t channelStep = 0;
  double fullColour = 0;   ///< Of colours: the number of a channel that is 255, as `makeInput` finds it,
  double fullAlpha = 0;    ///< and of alpha.
  bool areLabels = false;  ///< The file says that its samples are numbers of things.
  double unit = 0;         ///< Metres of a step of length 1 in the model; 0: not known.
  Transform sampleToModel; ///< Of points in voxels: sample i fills [i, i + 1).
  std::vector<std::string> warnings;
  std::vector<std::string> notes;
  std::vector<std::string> files; ///< As in `Input`.
};

/// `volume.steps`, or those of samples without gaps.
std::array<std::int64_t, 3> stepsOf(const DenseVolume &volume);

/// The bytes of all samples of a possible extent. Error: more than 2^63, so that no file has them.
Expected<std::uint64_t> sampleBytes(Int3 extent, SampleLayout layout);

/// The affine map of which column i is the step from one sample to the next along axis i; the centre of the
/// first sample lies at `origin`.
Transform mapOfSteps(const std::array<std::array<double, 3>, 3> &steps, const std::array<double, 3> &origin);

/// The input that the options make of it: threshold, colours and the turn.
Expected<Input> makeInput(DenseVolume volume, const InputOptions &options);

} // namespace voxc
