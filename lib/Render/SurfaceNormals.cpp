// The directions of surfaces at the voxels that rays hit.
#include "voxc/Render/SurfaceNormals.h"

#include "PlaneFit.h"

#include "Support/ParallelFor.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>
#include <vector>

namespace voxc {

namespace {

/// Normals that are kept before all are forgotten: 200 MiB or so.
constexpr std::size_t kMostNormals = std::size_t{1} << 22;

/// Voxels that a thread takes at once; near each other, as their codes are.
constexpr std::size_t kChunk = 1024;

std::uint64_t codeOf(const Hit &hit) { return mortonCode({hit.voxel[0], hit.voxel[1], hit.voxel[2]}); }

/// Above a smooth surface of voxels, so many voxels, their steps hide nothing of it any more; or at least
/// less.
constexpr float kAboveSteps[] = {2, 1};

/// The first of these heights at which a point above the middle voxel is free.
float roomAbove(const Neighbourhood &voxels, const glm::vec3 &normal) {
  const auto isFree = [&](float height) {
    const glm::vec3 place = normal * height;
    return isEmpty(voxels, {int(std::lround(place.x)), int(std::lround(place.y)), int(std::lround(place.z))});
  };
  for (const float height : kAboveSteps)
    if (isFree(height) && isFree(height + 0.5f))
      return height;
  return 0;
}

SurfaceNormal normalOf(const Neighbourhood &voxels) {
  const glm::vec3 direction = planeNormal(voxels);
  if (direction == glm::vec3(0))
    return {};
  return {direction, roomAbove(voxels, direction), roomAbove(voxels, -direction)};
}

} // namespace

Expected<void> SurfaceNormals::learn(std::span<const Hit> hits, const Progress &progress) {
  if (normals_.size() > kMostNormals)
    normals_.clear();
  std::vector<std::uint64_t> codes;
  for (const Hit &hit : hits)
    if (hit.isHit() && !normals_.contains(codeOf(hit)))
      codes.push_back(codeOf(hit));
  std::ranges::sort(codes);
  codes.erase(std::ranges::unique(codes).begin(), codes.end());
  VOXC_TRY(progress.check());
  std::vector<std::optional<SurfaceNormal>> found(codes.size());
  std::atomic<std::uint64_t> pagesRead = 0;
  const auto learnChunk = [&](Occupancy &occupancy, std::size_t first) -> Expected<void> {
    for (std::size_t i = first; i < std::min(first + kChunk, codes.size()); ++i) {
      VOXC_TRY(progress.check());
      const SurfaceNormal normal = normalOf(occupancy.around(mortonCell(codes[i])));
      if (const auto &problem = occupancy.reader().problem())
        return *problem;
      found[i] = normal;
    }
    return {};
  };
  const auto learned =
      parallelTry((codes.size() + kChunk - 1) / kChunk, threads_, [&](std::uint64_t chunk) -> Expected<void> {
        Occupancy occupancy(reader());
        auto done = learnChunk(occupancy, std::size_t(chunk) * kChunk);
        pagesRead += occupancy.reader().pagesRead();
        return done;
      });
  pagesRead_ += pagesRead;
  for (std::size_t i = 0; i < codes.size(); ++i)
    if (found[i])
      normals_.emplace(codes[i], *found[i]);
  return learned;
}

ShapeReader SurfaceNormals::reader() const {
  return volume_ ? ShapeReader(*volume_) : ShapeReader(*pages_, shelf_);
}

SurfaceNormal SurfaceNormals::at(const Hit &hit) const {
  const auto found = normals_.find(codeOf(hit));
  return found == normals_.end() ? SurfaceNormal{} : found->second;
}

} // namespace voxc
