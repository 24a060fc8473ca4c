// The camera of the viewer: what keys and the mouse do to it.
#pragma once

#include "voxc/Trace/Camera.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace voxc::view {

/// What turning turns about.
enum class Turning {
  Orbit, ///< The point looked at, which stays where it is.
  Fly,   ///< The eye.
};

/// What leads from one camera to another, as the functions of `ViewCamera` take it.
struct CameraMotion {
  glm::dvec2 turn{};   ///< Right and up, in radians.
  glm::dvec3 move{};   ///< Right, up and forward, in spaced space.
  double approach = 0; ///< The logarithm of the factor.
};

/// It moves in spaced space (`Camera::spacing`), where distances and angles are those that are seen.
class ViewCamera {
public:
  /// Begins where `camera` stands. It keeps what is up there: +y, unless the camera is rolled.
  explicit ViewCamera(const Camera &camera);

  /// The camera for a picture of this size.
  Camera camera(int width, int height) const;

  Turning turning() const { return turning_; }
  void setTurning(Turning turning) { turning_ = turning; }

  /// Turns the view by angles in radians: `right` moves what is seen to the left, `up` moves it down. It
  /// stops short of looking straight up or down.
  void turn(double right, double up);
  /// Moves the eye and the point looked at by so much of spaced space, as the camera sees these directions;
  /// the way up is the upright one, whatever the view is tilted.
  void move(double right, double up, double forward);
  /// Brings the eye nearer to the point looked at: to 1 / `factor` of its distance (above 0). An orthographic
  /// camera stays, and shows so much less.
  void approach(double factor);
  /// By parallel rays, or by those of a pinhole: what lies around the point looked at looks the same.
  void setOrthographic(bool isOrthographic);
  bool isOrthographic() const { return orthographicHeight_ > 0; }
  /// Looks at `place`, which is in voxels, from where the eye is, and orbits around it from now on. A place
  /// at the eye is left.
  void lookAt(const glm::dvec3 &place);
  /// What has led from `before` to here, as if all was done at once. Both have the same way up.
  CameraMotion since(const ViewCamera &before) const;
  /// Does such a motion so many times.
  void apply(const CameraMotion &motion, double times);
  /// From the eye to the point looked at, in spaced space.
  double distance() const { return distance_; }

private:
  glm::dvec3 look() const { return eye_ + forward_ * distance_; }
  double reach() const { return isOrthographic() ? orthographicHeight_ : distance_; }
  glm::dvec3 level() const;

  glm::dvec3 eye_;     ///< In spaced space.
  glm::dvec3 forward_; ///< Unit length, and at least `kLeastTilt` from the upright.
  glm::dvec3 upright_; ///< Unit length.
  double distance_;
  double verticalFov_;
  double orthographicHeight_; ///< 0: it is a pinhole.
  glm::dvec3 spacing_;
  Turning turning_ = Turning::Orbit;
};

} // namespace voxc::view
