// Turning and moving the viewer's camera.
#include "view/ViewCamera.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace voxc::view {
namespace {

/// The least angle between the view and the upright: at none, right and left have no meaning.
constexpr double kLeastTilt = glm::radians(1.0);

/// Nearer than this, in voxels, there is nothing left to orbit around.
constexpr double kLeastDistance = 1e-3;

constexpr glm::dvec3 kUpwards{0, 1, 0};

/// The unit vector at `angle` from `upright`, on the side of `direction`.
glm::dvec3 tilted(const glm::dvec3 &direction, const glm::dvec3 &upright, double angle) {
  const glm::dvec3 level = glm::normalize(direction - upright * glm::dot(direction, upright));
  return upright * std::cos(angle) + level * std::sin(angle);
}

double angleTo(const glm::dvec3 &upright, const glm::dvec3 &direction) {
  return std::acos(std::clamp(glm::dot(upright, direction), -1.0, 1.0));
}

double clampTilt(double angle) { return std::clamp(angle, kLeastTilt, glm::radians(180.0) - kLeastTilt); }

/// What stays upright: +y, unless `up` leans to the right or left of it, or is upside down.
glm::dvec3 uprightOf(const glm::dvec3 &forward, const glm::dvec3 &up) {
  const glm::dvec3 sideways = glm::cross(forward, kUpwards);
  const bool isUpsideDown = glm::dot(up, kUpwards) < -1e-9;
  const bool leans = std::abs(glm::dot(up, sideways)) > 1e-6 * glm::length(up);
  return leans || isUpsideDown ? glm::normalize(up) : kUpwards;
}

} // namespace

ViewCamera::ViewCamera(const Camera &camera)
    : eye_(camera.eye * camera.spacing),
      forward_(glm::normalize((camera.look - camera.eye) * camera.spacing)),
      distance_(std::max(lookDistance(camera), kLeastDistance)), verticalFov_(camera.verticalFov),
      orthographicHeight_(camera.orthographicHeight), spacing_(camera.spacing) {
  const glm::dvec3 up = camera.up * spacing_;
  upright_ = uprightOf(forward_, up);
  const double angle = angleTo(upright_, forward_);
  if (angle == clampTilt(angle))
    return;
  // Straight up or down: the picture's way up says which way is on.
  const bool looksDown = glm::dot(forward_, upright_) < 0;
  const glm::dvec3 on = looksDown ? up : -up;
  const bool isTold = glm::length(glm::cross(on, upright_)) > 1e-9 * glm::length(on);
  const glm::dvec3 look = camera.look * spacing_;
  forward_ = tilted(isTold ? on : glm::dvec3(0.6, 0.5, -0.8), upright_, clampTilt(angle));
  eye_ = look - forward_ * distance_;
}

Camera ViewCamera::camera(int width, int height) const {
  return {.eye = eye_ / spacing_,
          .look = look() / spacing_,
          .up = upright_ / spacing_,
          .verticalFov = verticalFov_,
          .width = width,
          .height = height,
          .spacing = spacing_,
          .orthographicHeight = orthographicHeight_};
}

/// Forwards, but neither up nor down.
glm::dvec3 ViewCamera::level() const { return tilted(forward_, upright_, glm::radians(90.0)); }

void ViewCamera::turn(double right, double up) {
  const glm::dvec3 at = look();
  const glm::dvec3 side = glm::cross(level(), upright_);
  const glm::dvec3 turned = level() * std::cos(right) + side * std::sin(right);
  forward_ = tilted(turned, upright_, clampTilt(angleTo(upright_, forward_) - up));
  if (turning_ == Turning::Orbit)
    eye_ = at - forward_ * distance_;
}

void ViewCamera::move(double right, double up, double forward) {
  const glm::dvec3 side = glm::normalize(glm::cross(forward_, upright_));
  eye_ += side * right + upright_ * up + forward_ * forward;
}

void ViewCamera::approach(double factor) {
  if (isOrthographic()) {
    orthographicHeight_ = std::max(orthographicHeight_ / factor, kLeastDistance);
    return;
  }
  const glm::dvec3 at = look();
  distance_ = std::max(distance_ / factor, kLeastDistance);
  eye_ = at - forward_ * distance_;
}

void ViewCamera::setOrthographic(bool isOrthographic) {
  const Camera camera = projected(this->camera(1, 1), isOrthographic);
  eye_ = camera.eye * spacing_;
  distance_ = std::max(lookDistance(camera), kLeastDistance);
  orthographicHeight_ = camera.orthographicHeight;
}

CameraMotion ViewCamera::since(const ViewCamera &before) const {
  CameraMotion motion;
  const glm::dvec3 sideBefore = glm::cross(before.level(), upright_);
  const double tilt = angleTo(upright_, forward_);
  motion.turn = {std::atan2(glm::dot(level(), sideBefore), glm::dot(level(), before.level())),
                 angleTo(upright_, before.forward_) - tilt};
  motion.approach = std::log(before.reach() / reach());
  // Turning leaves the look in orbit and the eye in flight; approaching leaves the look.
  const glm::dvec3 by = turning_ == Turning::Orbit
                            ? look() - before.look()
                            : eye_ - before.eye_ - forward_ * (before.distance_ - distance_);
  // Forward may rise, so it is no right angle to the way up.
  const double forward = glm::dot(by, level()) / std::sin(tilt);
  motion.move = {glm::dot(by, glm::cross(level(), upright_)),
                 glm::dot(by, upright_) - forward * std::cos(tilt), forward};
  return motion;
}

void ViewCamera::apply(const CameraMotion &motion, double times) {
  turn(motion.turn.x * times, motion.turn.y * times);
  move(motion.move.x * times, motion.move.y * times, motion.move.z * times);
  approach(std::exp(motion.approach * times));
}

void ViewCamera::lookAt(const glm::dvec3 &place) {
  const glm::dvec3 point = place * spacing_;
  const double distance = glm::distance(point, eye_);
  if (distance < kLeastDistance)
    return;
  const glm::dvec3 direction = (point - eye_) / distance;
  const double angle = angleTo(upright_, direction);
  forward_ = angle == clampTilt(angle) ? direction : tilted(forward_, upright_, clampTilt(angle));
  distance_ = distance;
}

} // namespace voxc::view
