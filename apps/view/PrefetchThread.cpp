// Going ahead.
#include "view/PrefetchThread.h"

#include <sched.h>

#include <algorithm>
#include <vector>

namespace voxc::view {
namespace {

/// Seconds ahead of the camera: soon at first, as that is asked for first.
constexpr double kAhead[] = {0.1, 0.2, 0.4};

/// Pixels of its pictures at most, from left to right.
constexpr int kWidth = 320;

/// This thread runs from now on when no other has work, where the system can do that.
void giveWay() {
#ifdef SCHED_IDLE
  const sched_param none{};
  ::sched_setscheduler(0, SCHED_IDLE, &none); // Of Linux: of this thread. If it is refused, all goes on.
#endif
}

} // namespace

Expected<void> prefetch(const Shot &shot, const std::atomic<bool> &stop) {
  Shot ahead = shot;
  const int divisor = std::max((shot.camera.width + kWidth - 1) / kWidth, 1);
  ahead.camera.width = std::max(shot.camera.width / divisor, 1);
  ahead.camera.height = std::max(shot.camera.height / divisor, 1);
  ahead.look.coarse /= divisor; // In the pixels of what is seen.
  const Expected<Picture> picture = paint(ahead, {}, {.stop = &stop});
  return picture ? Expected<void>() : picture.error();
}

void PrefetchThread::follow(const Shot &shot, const ViewCamera &camera, double seconds) {
  if (shot.scene != scene_ || shot.look != look_) {
    prediction_.forget();
    scene_ = shot.scene;
    look_ = shot.look;
  }
  if (!shot.scene->prefetch)
    return;
  if (prediction_.saw(camera, seconds) != Course::GoesOn) {
    if (isBusy())
      thread_.post([](const std::atomic<bool> &) {}); // Which ends the one at hand.
    return;
  }
  if (isBusy())
    return;
  std::vector<Shot> shots;
  for (const double ahead : kAhead)
    shots.push_back({shot.scene->prefetch,
                     prediction_.in(ahead).camera(shot.camera.width, shot.camera.height), shot.look});
  thread_.post([shots = std::move(shots)](const std::atomic<bool> &stop) {
    giveWay();
    for (const Shot &ahead : shots)
      if (!prefetch(ahead, stop))
        return; // Whatever is wrong is told when somebody looks there.
  });
}

} // namespace voxc::view
