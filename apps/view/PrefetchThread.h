// The thread that goes ahead of the camera: what it looks at the tracer of the scene then has at hand.
#pragma once

#include "view/CameraPrediction.h"
#include "view/JobThread.h"
#include "view/Painting.h"

namespace voxc::view {

/// Paints what nobody sees: the scene's prefetch, from where the camera will be. It takes only time that the
/// machine has left, and nothing of the tracer that paints what is seen.
class PrefetchThread {
public:
  /// `shot` is shown, from `camera`, so many seconds after the last call. While the camera goes on as it did,
  /// the prefetch paints its next places; when it rests or turns otherwise, or another scene or look is
  /// shown, the prefetch stops. Nothing is done for a scene without a prefetch.
  void follow(const Shot &shot, const ViewCamera &camera, double seconds);
  /// Whether it paints.
  bool isBusy() const { return thread_.isBusy(); }

private:
  std::shared_ptr<const Scene> scene_; ///< That it saw last.
  Look look_;
  CameraPrediction prediction_;
  JobThread thread_; // The last: it uses what others hold.
};

/// Paints `shot` as a prefetch, so that its pages are there for another tracer: with few rays, as few show
/// what will be looked at. Errors: those of `paint`.
Expected<void> prefetch(const Shot &shot, const std::atomic<bool> &stop);

} // namespace voxc::view
