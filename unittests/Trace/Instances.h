// Places of instances, and what rays hit among them by tracing every one.
#pragma once

#include "testing/HardRays.h"
#include "voxc/Oracle/Oracle.h"
#include "voxc/Trace/InstancedTracer.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <gtest/gtest.h>

#include <cstring>
#include <random>
#include <vector>

namespace voxc::test {

/// The ray in an instance's voxels, as it is defined.
inline Ray rayIn(const glm::mat4 &toWorld, const Ray &ray) {
  const glm::dmat4 m = glm::inverse(glm::dmat4(toWorld));
  const glm::dvec4 o = m * glm::dvec4(ray.origin[0], ray.origin[1], ray.origin[2], 1);
  const glm::dvec4 d = m * glm::dvec4(ray.direction[0], ray.direction[1], ray.direction[2], 0);
  return makeRay(glm::vec3(glm::dvec3(o)), glm::vec3(glm::dvec3(d)));
}

inline std::size_t countDifferent(std::span<const InstanceHit> a, std::span<const InstanceHit> b) {
  std::size_t different = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    different += std::memcmp(&a[i], &b[i], sizeof a[i]) != 0;
  return different;
}

/// A place that is moved by up to `reach`, turned, scaled and mirrored.
inline glm::mat4 randomPlace(std::mt19937 &random, float reach) {
  const auto number = [&](float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random);
  };
  glm::mat4 matrix =
      glm::translate(glm::mat4(1), {number(-reach, reach), number(-reach, reach), number(-reach, reach)});
  matrix = glm::rotate(matrix, number(0, 6), glm::vec3(number(-1, 1), number(-1, 1), 1));
  return glm::scale(matrix, {number(0.2f, 2), number(-2, -0.2f), number(0.2f, 2)});
}

/// The nearest hits of the oracle among instances of its volume.
inline std::vector<InstanceHit> nearestOfOracle(const Oracle &oracle, std::span<const glm::mat4> places,
                                                std::span<const Ray> rays) {
  std::vector<InstanceHit> nearest(rays.size(), InstanceHit{{{-1, -1, -1}, 0, 0, 0}});
  for (std::uint32_t number = 0; number < places.size(); ++number)
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const Hit hit = oracle.trace(rayIn(places[number], rays[i]));
      if (hit.isHit() && (!nearest[i].isHit() || hit.t < nearest[i].hit.t))
        nearest[i] = {hit, number};
    }
  return nearest;
}

} // namespace voxc::test
