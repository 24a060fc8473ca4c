// Where the camera will be, if it goes on as it did.
#pragma once

#include "view/ViewCamera.h"

#include <optional>

namespace voxc::view {

/// How a camera moves.
enum class Course {
  Rests,
  Turns,  ///< It begins to move, or moves otherwise than before.
  GoesOn, ///< As before: it can be told where it will be.
};

/// Pure bookkeeping: it looks at no clock.
class CameraPrediction {
public:
  /// The camera stands at `camera`, so many seconds after it was told the last time. One that does not move
  /// for a moment has not come to rest yet: what a mouse does comes in pieces.
  Course saw(const ViewCamera &camera, double seconds);
  /// Where it will be in so many seconds, after a `saw` that told that it goes on.
  ViewCamera in(double seconds) const;
  /// The next camera has nothing to do with those before.
  void forget() { *this = {}; }

private:
  std::optional<ViewCamera> last_;
  std::optional<CameraMotion> motion_; ///< In a second, if it moves.
  double still_ = 0;                   ///< Seconds since it was seen to move, or began to.
  Course course_ = Course::Rests;
};

} // namespace voxc::view
