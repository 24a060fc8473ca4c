// A camera that flies through the cameras of a file.
#pragma once

#include "CameraFile.h"

namespace voxc::tool {

class Flight {
public:
  /// Through all cameras of a file, in its order. Errors: those of `readCameras`; `Input` if there are fewer
  /// than two.
  static Expected<Flight> through(const std::string &path);

  /// The camera of a frame of so many: the first frame is the first camera, the last frame the last, and all
  /// cameras are equally far apart in time. Between two of them each number goes smoothly from the one to the
  /// other, and never beyond either. A flight of one frame stays at the first camera.
  FileCamera at(unsigned frame, unsigned frames) const;

private:
  std::vector<FileCamera> stops_;
};

} // namespace voxc::tool
