// Camera files: named cameras as JSON, for volumes scaled to [0, 100]^3.
#pragma once

#include "voxc/Support/Error.h"
#include "voxc/Trace/Camera.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace voxc::tool {

/// The largest width or height of a picture in pixels.
inline constexpr int kMaxPictureSide = 32768;

/// A camera of a file, as it stands there.
struct FileCamera {
  glm::dvec3 position{}; ///< In a volume scaled to [0, 100]^3 by its longest axis.
  double pitch = 0;      ///< Degrees.
  double yaw = 0;        ///< Degrees.
  double fov = 90;       ///< Vertical, in degrees.
  double height = 0;     ///< Of an orthographic camera, in units of `position`; 0: a pinhole.
  std::optional<std::array<int, 2>> size; ///< Of the pictures, in pixels.
};

/// Reads the camera `name`. A file is an object {"size": [width, height], "cameras": {NAME: {"position": [x,
/// y, z], "pitch": degrees, "yaw": degrees, "fov": degrees, "height": number}}}; `size`, `fov` and `height`
/// may be left out, other keys are ignored. A camera with a height, above 0, is orthographic. No number is
/// beyond 10^12. Errors: `Input` if the file is unreadable or broken, or has no such camera, naming those it
/// has.
Expected<FileCamera> readCamera(const std::string &path, const std::string &name);

/// All cameras of a file, in its order. Errors: `Input` if it is unreadable or broken.
Expected<std::vector<FileCamera>> readCameras(const std::string &path);

/// The names of all cameras of a file, in its order. Errors: `Input` if it is unreadable or broken.
Expected<std::vector<std::string>> cameraNames(const std::string &path);

} // namespace voxc::tool
