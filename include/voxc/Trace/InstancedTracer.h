// Rays through several volumes that stand in one world, each moved, turned and scaled by a matrix of its own.
#pragma once

#include "voxc/Support/Geometry.h"
#include "voxc/Trace/Tracer.h"

#include <glm/mat4x4.hpp>

#include <cstdint>
#include <memory>
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

static_assert(sizeof(InstanceHit) == 28);

/// Traces rays of the world. A ray is taken to the voxels of an instance in float64, by the inverse of its
/// matrix, and rounded to float32 once; directions are not made unit length, so that t means the same
/// everywhere. The hit in each instance is exact for that ray. Of the instances that a ray hits, the one of
/// the least t (a float32) is taken, and of several with the same, the first.
///
/// Which instances a ray is traced through is looked up in a bounding-volume hierarchy over their boxes,
/// which leaves out none that the ray hits, under any matrix that is taken: docs/tracers.md says what a ray
/// costs among many.
class InstancedTracer {
public:
  /// `threads`: those that transform rays; 0: all of this processor. Errors (`Usage`): a tracer is null, or
  /// a matrix is not finite, has another last row than 0, 0, 0, 1, or has no inverse in float64; there are
  /// 2^31 instances or more.
  static Expected<InstancedTracer> create(const std::vector<Instance> &instances, unsigned threads = 0);
  ~InstancedTracer();
  InstancedTracer(InstancedTracer &&) noexcept;
  InstancedTracer &operator=(InstancedTracer &&) noexcept;

  /// Traces rays[i] into hits[i]; both have the same size. Bounds mean the same in the world and in every
  /// instance, as t does. `options` go to each tracer; each of its repeats traces all. Errors: as of the
  /// tracers; rays have bounds, but an instance is not `bounded` (`Usage`).
  Expected<void> trace(RaySpan rays, std::span<InstanceHit> hits, const TraceOptions &options = {});

private:
  struct State;
  explicit InstancedTracer(std::unique_ptr<State> state);

  std::unique_ptr<State> state_;
};

} // namespace voxc
