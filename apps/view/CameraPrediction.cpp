// Comparing motions.
#include "view/CameraPrediction.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace voxc::view {
namespace {

/// Seconds without motion that are a rest.
constexpr double kRest = 0.15;

/// The cosine between motions that are alike: about 35 degrees.
constexpr double kAlike = 0.8;

/// Shorter times tell no speed.
constexpr double kLeastSeconds = 1e-3;

/// A motion in voxels by which things at the point looked at move, or seem to: so its parts can be compared.
using Way = std::array<double, 6>;

Way wayOf(const CameraMotion &motion, double distance) {
  return {motion.turn.x * distance,  motion.turn.y * distance, motion.move.x, motion.move.y, motion.move.z,
          motion.approach * distance};
}

double dot(const Way &a, const Way &b) { return std::inner_product(a.begin(), a.end(), b.begin(), 0.0); }

/// A millionth of the distance is what rounding does.
bool isMoving(const Way &way, double distance) { return dot(way, way) > 1e-12 * distance * distance; }

bool areAlike(const Way &a, const Way &b) {
  return dot(a, b) > 0 && dot(a, b) * dot(a, b) > kAlike * kAlike * dot(a, a) * dot(b, b);
}

/// In a second, if it took so many.
CameraMotion perSecond(const CameraMotion &motion, double seconds) {
  const double times = 1 / std::max(seconds, kLeastSeconds);
  return {motion.turn * times, motion.move * times, motion.approach * times};
}

CameraMotion mean(const CameraMotion &a, const CameraMotion &b) {
  return {0.5 * (a.turn + b.turn), 0.5 * (a.move + b.move), 0.5 * (a.approach + b.approach)};
}

} // namespace

Course CameraPrediction::saw(const ViewCamera &camera, double seconds) {
  const CameraMotion moved = last_ ? camera.since(*last_) : CameraMotion{};
  last_ = camera;
  const double distance = camera.distance();
  still_ += seconds;
  if (!isMoving(wayOf(moved, distance), distance)) {
    if (still_ < kRest)
      return course_;
    motion_.reset();
    still_ = 0;
    return course_ = Course::Rests;
  }
  const CameraMotion now = perSecond(moved, motion_ ? still_ : seconds);
  still_ = 0;
  const bool goesOn = motion_ && areAlike(wayOf(*motion_, distance), wayOf(now, distance));
  motion_ = goesOn ? mean(*motion_, now) : now;
  return course_ = goesOn ? Course::GoesOn : Course::Turns;
}

ViewCamera CameraPrediction::in(double seconds) const {
  ViewCamera camera = *last_;
  camera.apply(*motion_, seconds);
  return camera;
}

} // namespace voxc::view
