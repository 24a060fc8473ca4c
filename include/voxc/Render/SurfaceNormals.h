// The directions of surfaces at the voxels that rays hit.
#pragma once

#include "voxc/Support/Error.h"
#include "voxc/Support/Progress.h"
#include "voxc/Trace/Ray.h"
#include "voxc/Volume/ShapeReader.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <memory>
#include <span>
#include <unordered_map>

namespace voxc {

/// The direction of a surface, of either sign, and how far along it and against it there is room above the
/// steps of its voxels, from where the way to the light is not hidden by them: 0 where there is none.
struct SurfaceNormal {
  glm::vec3 direction{}; ///< Zero where the voxels around give none.
  float roomAlong = 0;
  float roomAgainst = 0;
};

/// Finds the normals of a smooth surface once a voxel, on threads, and keeps them: several pictures of a
/// volume may share them, one at a time. The volume must outlive it.
class SurfaceNormals {
public:
  SurfaceNormals(const Volume &volume, unsigned threads) : volume_(&volume), threads_(threads) {}
  /// The same of a page file, of which it reads the pages around the voxels hit: from `shelf`, or from the
  /// file, and then they lie there. Each thread holds 32 pages more at most.
  SurfaceNormals(const PagedVolume &volume, std::shared_ptr<PageShelf> shelf, unsigned threads)
      : pages_(&volume), shelf_(std::move(shelf)), threads_(threads) {}

  /// Finds those of all voxels hit that are not known yet. Errors: interrupted, by `progress`; a page that is
  /// not what was stored (`Input`). What was found until then is kept.
  Expected<void> learn(std::span<const Hit> hits, const Progress &progress = {});
  /// That of a voxel; one that was not learned has no direction.
  SurfaceNormal at(const Hit &hit) const;

  /// Pages that came from the file so far.
  std::uint64_t pagesRead() const { return pagesRead_; }

private:
  ShapeReader reader() const;

  const Volume *volume_ = nullptr;     ///< Or
  const PagedVolume *pages_ = nullptr; ///< these.
  std::shared_ptr<PageShelf> shelf_;
  unsigned threads_;
  std::uint64_t pagesRead_ = 0;
  std::unordered_map<std::uint64_t, SurfaceNormal> normals_; ///< By the Morton code of the voxel.
};

} // namespace voxc
