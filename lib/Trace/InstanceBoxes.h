// Where instances stand in the world: boxes that hold all that their rays can hit.
#pragma once

#include "voxc/Support/Geometry.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace voxc {

/// The voxels of an instance as a box of the world, and how much larger it has to be for rays from far away.
///
/// What a ray hits is decided in the voxels of the instance, by the ray as it is there: taken through
/// `fromWorld` in float64 and rounded to float32. That ray is a little beside the ray of the world. With
/// F = `fromWorld`, T = `toWorld`, u = 2^-24, norms of the largest row sum, and D the distance from the ray's
/// origin to the farthest corner of the box, by the largest axis:
///
/// - the origin in voxels is at most |F| D, and what the ray moves until it leaves the voxels at most 3 |F|
/// D,
///   so that a point of the ray is rounded by at most 4.1 u |F| D, unless its direction is rounded to a
///   denormal number (`leastDirection`);
/// - in the world that is |T| times as much: 4.1 u k D, where k = |T| |F|;
/// - the roundings of float64 are below 2^-48 k (D + the box's largest coordinate).
///
/// So a box that is larger by `slack` * (D + largest coordinate) at each side, with `slack` = 16 u k, holds
/// every point at which a ray can hit the instance, and leaves 11 u k of that for the roundings of whoever
/// computes with it in float32.
struct InstanceBox {
  glm::vec3 low{0}, high{0};
  float slack = 0;
  /// Of rays whose direction has no component as large as this, numbers in voxels may be denormal: the box
  /// does not hold them.
  float leastDirection = 0;
  /// There is no such box: numbers overflow, or the matrix is so near to one without an inverse that rays
  /// cannot be held to it. Every ray may hit the instance.
  bool isEverywhere = false;
};

/// The box of voxels [0, extent) at a place. `fromWorld` is about the inverse of `toWorld`; how far it is
/// from that goes into the box.
InstanceBox boxOf(const glm::dmat4 &toWorld, const glm::dmat4 &fromWorld, Int3 extent);

} // namespace voxc
