// Rays through several volumes that stand in one world, each moved, turned and scaled by a matrix of its own.
#pragma once

#include "voxc/Support/Geometry.h"
#include "voxc/Trace/Tracer.h"

#include <glm/mat4x4.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace voxc {

/// A volume at a place in the world. Several instances may share a tracer, and tracers may be of different
/// devices.
struct Instance {
  Tracer *tracer = nullptr; ///< Of the volume; must outlive the instances' tracer.
  Int3 extent;              ///< Of its format, in voxels: `volume.format().extent()`.
  glm::mat4 toWorld{1.0f};  ///< From its voxels to the world: affine, with an inverse.
  /// The tracer takes rays with bounds. Rays then go no further in it than to the nearest hit that is known.
  bool bounded = false;
};

/// The nearest hit among all instances.
struct InstanceHit {
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  Hit hit; ///< In the voxels of its volume; its t is that of the world's ray. A miss is that of `Hit`.
  std::uint32_t instance = kNone; ///< Its place in the list; `kNone` for a miss.

  bool isHit() const { return instance != kNone; }
};

/// Traces rays of the world. A ray is taken to the voxels of an instance in float64, by the inverse of its
/// matrix, and rounded to float32 once; directions are not made unit length, so that t means the same
/// everywhere. The hit in each instance is exact for that ray. Of the instances that a ray hits, the one of
/// the least t (a float32) is taken, and of several with the same, the first.
class InstancedTracer {
public:
  /// `threads`: those that transform rays; 0: all of this processor. Errors (`Usage`): a tracer is null, or
  /// a matrix is not finite, has another last row than 0, 0, 0, 1, or has no inverse in float64.
  static Expected<InstancedTracer> create(const std::vector<Instance> &instances, unsigned threads = 0);

  /// Traces rays[i] into hits[i]; both have the same size. Bounds mean the same in the world and in every
  /// instance, as t does. `options` go to each tracer; each of its repeats traces all. Errors: as of the
  /// tracers; rays have bounds, but an instance is not `bounded` (`Usage`).
  Expected<void> trace(RaySpan rays, std::span<InstanceHit> hits, const TraceOptions &options = {});

private:
  struct Placed {
    Tracer *tracer;
    glm::dmat4 fromWorld;
    Int3 extent;
    bool bounded;
  };

  InstancedTracer(std::vector<Placed> instances, unsigned threads)
      : instances_(std::move(instances)), threads_(threads) {}
  Expected<void> traceSlice(const RaySpan &rays, std::span<InstanceHit> hits, const TraceOptions &options);
  Expected<void> checkBounds(const RaySpan &rays) const;

  std::vector<Placed> instances_;
  unsigned threads_;
};

} // namespace voxc
