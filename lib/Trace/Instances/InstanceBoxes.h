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
/// F = `fromWorld`, T = the inverse of F, u = 2^-24, lengths and norms of Euclid, D the distance from the
/// ray's origin to the farthest corner of the box, and C the largest coordinate of the box:
///
/// - the first voxel's corner is one of the box, so that the origin in voxels is no longer than |F| D,
///   and the ray moves at most as far until it leaves the voxels. Each of both is rounded by u of itself:
///   a point of the ray by less than 2.05 u |F| D, unless its direction is rounded to a denormal number
///   (`leastDirection`);
/// - in the world that is |T| times as much: 2.05 u k D, where k = |T| |F|, which is 1 where an instance is
///   turned and scaled alike along its axes;
/// - the roundings of float64 are below 2^-48 k (D + C), and so, as k is below 2^16, below 0.01 u (k D + C).
///
/// So a box that is larger by `slack` * D at each side, with `slack` = 2.25 u k, holds every point at which a
/// ray can hit the instance, but for 0.01 u C. That is part of what whoever computes with it in float32 adds
/// for his own roundings.
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
