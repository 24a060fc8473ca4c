// The visible faces of a volume: those between a voxel and an empty cell, merged to rectangles.
#pragma once

#include "voxc/Source/VoxelSource.h"
#include "voxc/Volume/Volume.h"

#include <functional>
#include <memory>
#include <span>

namespace voxc {

/// Faces of voxels of one colour that lie in one plane: `width` by `height` of them.
struct FaceRectangle {
  int axis = 0;        ///< That the plane is perpendicular to.
  bool isHigh = false; ///< The faces look along +axis, else along -axis.
  Int3 low;            ///< The first voxel.
  int width = 1;       ///< Voxels along the next axis (x after z),
  int height = 1;      ///< and along the one after that.
  std::uint32_t word = 0;
};

/// Calls `visit`, which returns false to end, for rectangles that together are all visible faces, each face
/// once. Merges within cubes of 64 cells, so that memory does not follow the volume. Errors: interrupted.
/// `words`, where it is given, gives them in place of the volume, which has the same voxels.
Expected<void> forEachFace(const Volume &volume, const std::function<bool(const FaceRectangle &)> &visit,
                           const Progress &progress = {}, std::unique_ptr<VoxelSource> words = nullptr);

/// The same for rectangles of any colours: `words` has those of the voxels, along the width first.
using VisitFaces = std::function<bool(const FaceRectangle &face, std::span<const std::uint32_t> words)>;
Expected<void> forEachFaceOfAnyColour(const Volume &volume, const VisitFaces &visit,
                                      const Progress &progress = {},
                                      std::unique_ptr<VoxelSource> words = nullptr);

} // namespace voxc
