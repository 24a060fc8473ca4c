// Ray files and hit files, of both versions: docs/command-line.md, Rays and hits.
#pragma once

#include "voxc/Support/Error.h"
#include "voxc/Trace/BoundedRay.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace voxc::tool {

/// The rays of a file. Those of version 1 have no bounds, those of version 2 have.
class RayFile {
public:
  RayFile() = default;
  explicit RayFile(std::vector<Ray> rays) : rays_(std::move(rays)) {}
  explicit RayFile(std::vector<BoundedRay> rays) : version_(2), boundedRays_(std::move(rays)) {}

  int version() const { return version_; }
  RaySpan rays() const { return version_ == 2 ? RaySpan(boundedRays_) : RaySpan(rays_); }
  /// The rays of a file of version 1, handed over.
  std::vector<Ray> takeRays() && { return std::move(rays_); }

private:
  int version_ = 1;
  std::vector<Ray> rays_;
  std::vector<BoundedRay> boundedRays_;
};

/// Reads the bytes of either version; `name` names them in errors. Error (`Input`): they are no whole number
/// of records, of a version that is not known, or more or fewer than the header says. Memory follows the
/// bytes.
Expected<RayFile> parseRayFile(std::span<const std::byte> bytes, const std::string &name);

/// A hit as files of version 2 have it.
struct HitRecord {
  std::int32_t voxel[3]; ///< Of a miss -1, -1, -1, and the rest 0.
  std::uint32_t rgba;
  float t;
  std::uint32_t face;  ///< As `Hit::steps` has it (voxc/Trace/Face.h).
  float normal[3];     ///< Of that face.
  std::uint32_t steps; ///< Lookups, if they were counted; else 0.
};

static_assert(sizeof(HitRecord) == 40);

/// The bytes of a ray file of version 2.
std::string rayFileText(std::span<const BoundedRay> rays);

/// The bytes of a hit file of version 2: of hits with their faces, and steps[i] lookups of hit i; none, if
/// there are no steps.
std::string hitFileText(std::span<const Hit> hits, std::span<const std::uint32_t> steps = {});

} // namespace voxc::tool
