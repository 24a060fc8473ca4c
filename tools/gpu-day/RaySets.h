// The rays that are traced of a scene, and the oracle's hits of all of them.
#pragma once

#include "voxc/Oracle/Oracle.h"
#include "voxc/Trace/Camera.h"

#include <string>
#include <vector>

namespace voxc::gpu {

/// A camera of a scene.
struct NamedCamera {
  std::string name;
  Camera camera;
};

/// Makes the sets of a scene in `folder`, each as NAME.rays and NAME.hits, 24 bytes a record: CAMERA, the
/// rays of each camera in rows; CAMERA-tiles, those of the first in tiles of 8 x 4 pixels; and from where the
/// rays of the last camera hit, `shadow`, to a sun, and `bounce`, in a direction of a diffuse surface. Sets
/// that are there are kept. Error: `Environment`, where a file cannot be written.
Expected<void> makeRaySets(const Volume &volume, const std::vector<NamedCamera> &cameras,
                           const std::string &folder);

/// Makes sets of the rays of a camera, `side` x `side` of them, that is farther and farther away from the
/// volume's middle, and in whose picture the volume is equally large: 1.5-edges and so on, in longest edges
/// of the volume, each as above. Error: `Environment`, where a file cannot be written.
Expected<void> makeDistanceSets(const Volume &volume, int side, const std::string &folder);

} // namespace voxc::gpu
