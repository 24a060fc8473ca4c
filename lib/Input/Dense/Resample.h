// A scan in cubes of another size: each axis has its own, and the samples between are made of those around.
#pragma once

#include "Input/Dense/DenseVolume.h"
#include "Source/DenseSource.h"

#include <memory>

namespace voxc {

struct Resampled {
  Int3 extent;
  std::shared_ptr<const DenseRows> rows;
  Transform voxelToModel;
};

/// The cells of a volume as cubes of a `side` in units of the model, along the volume's own axes. Samples
/// that are parted by a threshold are first made anew: the mean of those that a larger cube covers, or, in a
/// smaller one, what lies between the nearest; that of others, and colours, is the sample at the middle of
/// the cube. Planes between cubes go through `options.align`, or through the low corner. Errors: steps of no
/// length; more cubes than the format holds.
Expected<Resampled> resample(DenseVolume volume, const SampleMap &map, double side,
                             const InputOptions &options);

/// The steps of a volume's axes in units of the model.
std::array<double, 3> stepLengths(const Transform &sampleToModel);

} // namespace voxc
