// Fans over loops, from the mean of their corners.
#include "Mesh/Solid/HoleCaps.h"

#include "Mesh/Solid/RimLoops.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>

namespace voxc {

namespace {

/// The mean of the corners of a loop; within their box, whatever rounding does.
glm::dvec3 middleOf(std::span<const LoopEdge> loop) {
  glm::dvec3 sum{};
  glm::dvec3 low = loop.front().from;
  glm::dvec3 high = low;
  for (const LoopEdge &edge : loop) {
    sum += edge.from;
    low = glm::min(low, edge.from);
    high = glm::max(high, edge.from);
  }
  return glm::clamp(sum / static_cast<double>(loop.size()), low, high);
}

} // namespace

HoleCaps HoleCaps::of(std::span<const RimEdge> rims, bool isEither, const MeshModel &model) {
  HoleCaps caps;
  const ModelFrame &frame = model.grid.frame();
  const auto isOpen = [&](const RimEdge &rim) { return !isEither || rim.times % 2 != 0; };
  const auto loops = loopsOf(rims, isEither);
  if (loops.empty() && std::ranges::any_of(rims, isOpen))
    caps.area = std::numeric_limits<double>::infinity();
  for (const std::vector<LoopEdge> &loop : loops) {
    const glm::dvec3 middle = middleOf(loop);
    const glm::dvec3 top = frame.toVoxels(middle);
    for (const LoopEdge &edge : loop) {
      // The edge is passed back as often as passed.
      for (const glm::dvec3 &corner : {edge.to, edge.from, middle})
        caps.corners.push_back({corner.x, corner.y, corner.z});
      caps.area +=
          glm::length(glm::cross(frame.toVoxels(edge.from) - top, frame.toVoxels(edge.to) - top)) / 2;
    }
    ++caps.holes;
  }
  return caps;
}

} // namespace voxc
