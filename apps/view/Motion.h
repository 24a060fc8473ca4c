// Keys that are held down, and how they move the camera.
#pragma once

#include "view/Keys.h"
#include "view/ViewCamera.h"

#include <map>

namespace voxc::view {

class Motion {
public:
  /// A key went down or up. Keys that are not held are left.
  void press(Action action);
  void release(Action action);
  /// The window does not hear keys any more.
  void releaseAll();

  bool isMoving() const { return !held_.empty(); }
  /// Moves the camera by what is held, for so many seconds; true if there was something. A key acts for the
  /// time that it is down, and for `kTap` seconds at least, which it does at once: a tap is always the same
  /// step. `stride`: voxels a second.
  bool advance(ViewCamera &camera, double seconds, double stride);

  static constexpr double kTap = 0.06;

private:
  struct Held {
    double seconds = 0; ///< For which it acted.
    double down = 0;    ///< For which it was down.
    bool isDown = true;
  };

  std::map<Action, Held> held_;
};

} // namespace voxc::view
