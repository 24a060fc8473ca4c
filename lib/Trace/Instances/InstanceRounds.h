// Rays through the instances of a world, round by round: of each ray the next instances that it may hit, all
// of one tracer at once.
#pragma once

#include "InstanceTree.h"

#include "voxc/Trace/InstancedTracer.h"

#include <span>
#include <vector>

namespace voxc {

/// An instance as rays are taken to it.
struct PlacedInstance {
  glm::dmat4 fromWorld;
  Int3 extent;
  std::uint32_t group; ///< Of the instances that are traced together.
};

/// Instances whose rays one tracer takes in one call.
struct InstanceGroup {
  Tracer *tracer;
  bool bounded;
};

struct PlacedInstances {
  std::vector<PlacedInstance> instances;
  std::vector<InstanceGroup> groups;
  InstanceTree tree;
};

/// The ray in the voxels of an instance: by float64 in this order of products and sums, each of which is
/// rounded, and then to float32.
Ray rayThere(const glm::dmat4 &fromWorld, const Ray &ray);

/// Traces rays through instances; keeps its memory for the next slice of them.
class InstanceRounds {
public:
  InstanceRounds(const PlacedInstances &world, unsigned threads) : world_(world), threads_(threads) {}

  /// Errors: those of the tracers, and that it was asked to stop.
  Expected<void> trace(const RaySpan &rays, std::span<InstanceHit> hits, const TraceOptions &options);

private:
  /// Rays in the voxels of instances, of one group.
  struct Candidates {
    std::vector<Ray> rays;
    std::vector<BoundedRay> boundedRays; ///< In place of those, where the group is bounded.
    std::vector<std::uint32_t> numbers;  ///< Of the rays in the slice.
    std::vector<std::uint32_t> instances;

    void clear();
    void add(const Ray &ray, const RayBounds &bounds, bool isBounded, std::uint32_t number,
             std::uint32_t instance);
  };

  /// Neighbouring rays that are not done.
  struct Chunk {
    std::vector<std::uint32_t> numbers;
    std::vector<InstanceKey> last;      ///< The last instance that was tried, of each.
    std::vector<Candidates> candidates; ///< By group.
    std::vector<std::size_t> first;     ///< Where they begin among those of all chunks.
  };

  void begin(const RaySpan &rays);
  void select(Chunk &chunk, const RaySpan &rays, std::span<const InstanceHit> hits, unsigned most) const;
  Expected<void> traceGroup(std::uint32_t group, std::span<InstanceHit> hits, const TraceOptions &options);
  template <typename AnyRay>
  RaySpan gather(std::uint32_t group, std::vector<AnyRay> Candidates::*rays, std::vector<AnyRay> &all) const;

  const PlacedInstances &world_;
  unsigned threads_;
  std::vector<Chunk> chunks_;
  std::vector<Ray> rays_; ///< Of a group; those with bounds in the other.
  std::vector<BoundedRay> boundedRays_;
  std::vector<Hit> found_;
};

} // namespace voxc
