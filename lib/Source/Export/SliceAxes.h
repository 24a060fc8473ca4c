// How slices lie in a volume.
#pragma once

#include "voxc/Source/Export.h"
#include "voxc/Support/Geometry.h"
#include "voxc/Support/Transform.h"

namespace voxc {

/// An axis of voxels that something goes along, forwards or backwards.
struct SliceAxis {
  int axis = 0;
  bool isBackward = false;

  bool operator==(const SliceAxis &) const = default;
};

/// Along which axes of voxels the pixels of slices and the slices lie.
struct SliceAxes {
  SliceAxis right, down, through;

  bool operator==(const SliceAxes &) const = default;
};

/// Those of a plane in a volume whose units are the model's by `voxelToModel`. Of the planes of a scan each
/// axis of the model gets the axis of voxels that lies nearest to it, of which none is taken twice.
SliceAxes sliceAxes(SlicePlane plane, const Transform &voxelToModel);

} // namespace voxc
