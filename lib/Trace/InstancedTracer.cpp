// Rays through several volumes that stand in one world.
#include "voxc/Trace/InstancedTracer.h"

#include "Support/ParallelFor.h"

#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace voxc {
namespace {

/// Rays are taken so many at a time: more would take memory, and are not traced faster.
constexpr std::size_t kSliceRays = std::size_t{1} << 20;

/// What a thread transforms at a time.
constexpr std::size_t kChunkRays = std::size_t{1} << 14;

bool isFinite(const glm::dmat4 &matrix) {
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      if (!std::isfinite(matrix[column][row]))
        return false;
  return true;
}

bool isAffine(const glm::dmat4 &matrix) {
  return matrix[0][3] == 0 && matrix[1][3] == 0 && matrix[2][3] == 0 && matrix[3][3] == 1;
}

Ray transformed(const glm::dmat4 &matrix, const Ray &ray) {
  const auto apply = [&](const float(&v)[3], double w) {
    return glm::vec3(glm::dvec3(matrix * glm::dvec4(v[0], v[1], v[2], w)));
  };
  return makeRay(apply(ray.origin, 1), apply(ray.direction, 0));
}

/// False if a ray surely comes to no voxel of [0, extent) between its bounds, which are some. Sure is what a
/// slab test in float64 says of a box and of bounds that are larger by far more than it rounds.
bool mayHit(const Ray &ray, Int3 extent, const RayBounds &bounds) {
  constexpr double kMargin = 1e-6;
  double low = std::max(0.0, double(bounds.tmin) * (1 - kMargin));
  double high = double(bounds.tmax) * (1 + kMargin);
  for (int axis = 0; axis < 3; ++axis) {
    const double origin = ray.origin[axis], direction = ray.direction[axis];
    const double room = kMargin * (1 + extent[axis] + std::abs(origin));
    const double first = (-room - origin) / direction, last = (extent[axis] + room - origin) / direction;
    if (direction == 0) {
      if (origin < -room || origin > extent[axis] + room)
        return false;
      continue;
    }
    low = std::max(low, std::min(first, last));
    high = std::min(high, std::max(first, last));
  }
  return !(low > high * (1 + kMargin));
}

/// The rays that may hit an instance, with bounds or without, and their numbers.
struct Candidates {
  std::vector<Ray> rays;
  std::vector<BoundedRay> boundedRays;
  std::vector<std::uint32_t> numbers;

  void append(const Candidates &others) {
    rays.insert(rays.end(), others.rays.begin(), others.rays.end());
    boundedRays.insert(boundedRays.end(), others.boundedRays.begin(), others.boundedRays.end());
    numbers.insert(numbers.end(), others.numbers.begin(), others.numbers.end());
  }
};

/// Where a ray is still to be looked at, of which it is known what it has hit so far.
RayBounds boundsLeft(RayBounds bounds, const InstanceHit &nearest) {
  if (nearest.isHit() && nearest.hit.t < bounds.tmax)
    bounds.tmax = nearest.hit.t;
  return bounds;
}

/// Those of the rays, of which `hits` says what they have hit so far.
Candidates candidates(const RaySpan &rays, std::span<const InstanceHit> hits, const glm::dmat4 &matrix,
                      Int3 extent, bool withBounds, unsigned threads) {
  const std::size_t chunks = (rays.size() + kChunkRays - 1) / kChunkRays;
  std::vector<Candidates> parts(chunks);
  parallelFor(chunks, threads, [&](std::uint64_t chunk) {
    const std::size_t end = std::min((chunk + 1) * kChunkRays, rays.size());
    for (std::size_t i = chunk * kChunkRays; i < end; ++i) {
      const Ray ray = transformed(matrix, rays[i]);
      const RayBounds bounds = boundsLeft(rays.bounds(i), hits[i]);
      if (!mayHit(ray, extent, bounds))
        continue;
      if (withBounds)
        parts[chunk].boundedRays.push_back(bounded(ray, bounds));
      else
        parts[chunk].rays.push_back(ray);
      parts[chunk].numbers.push_back(static_cast<std::uint32_t>(i));
    }
  });
  Candidates all;
  for (const Candidates &part : parts)
    all.append(part);
  return all;
}

} // namespace

Expected<InstancedTracer> InstancedTracer::create(const std::vector<Instance> &instances, unsigned threads) {
  std::vector<Placed> placed;
  for (const Instance &instance : instances) {
    const auto wrong = [&](const char *problem) {
      return Error::usage("instance " + std::to_string(placed.size()) + " " + problem);
    };
    if (!instance.tracer)
      return wrong("has no tracer");
    const glm::dmat4 toWorld(instance.toWorld);
    if (!isFinite(toWorld) || !isAffine(toWorld))
      return wrong("has a matrix that is not affine: its last row must be 0, 0, 0, 1, and all of it finite");
    const glm::dmat4 fromWorld = glm::inverse(toWorld);
    if (!isFinite(fromWorld))
      return wrong("has a matrix without an inverse");
    placed.push_back({instance.tracer, fromWorld, instance.extent, instance.bounded});
  }
  return InstancedTracer(std::move(placed), threads);
}

Expected<void> InstancedTracer::checkBounds(const RaySpan &rays) const {
  const auto takesNone = [](const Placed &instance) { return !instance.bounded; };
  const auto found = std::ranges::find_if(instances_, takesNone);
  if (!rays.isBounded() || found == instances_.end())
    return {};
  return Error::usage("the rays have bounds, but instance " + std::to_string(found - instances_.begin()) +
                      " is not said to take such: make its tracer with bounds=yes and set `bounded`");
}

Expected<void> InstancedTracer::trace(RaySpan rays, std::span<InstanceHit> hits,
                                      const TraceOptions &options) {
  if (rays.size() != hits.size())
    return Error::usage("there are " + std::to_string(rays.size()) + " rays, but room for " +
                        std::to_string(hits.size()) + " hits");
  if (auto checked = checkBounds(rays); !checked)
    return checked;
  for (std::size_t first = 0; first < rays.size(); first += kSliceRays) {
    const std::size_t count = std::min(kSliceRays, rays.size() - first);
    const auto traced = traceSlice(rays.subspan(first, count), hits.subspan(first, count), options);
    if (!traced)
      return traced;
  }
  return {};
}

Expected<void> InstancedTracer::traceSlice(const RaySpan &rays, std::span<InstanceHit> hits,
                                           const TraceOptions &options) {
  std::ranges::fill(hits, InstanceHit{{{-1, -1, -1}, 0, 0, 0}});
  std::vector<Hit> found;
  for (std::size_t number = 0; number < instances_.size(); ++number) {
    const Placed &instance = instances_[number];
    const auto some = candidates(rays, hits, instance.fromWorld, instance.extent, instance.bounded, threads_);
    found.resize(some.numbers.size());
    const RaySpan left = instance.bounded ? RaySpan(some.boundedRays) : RaySpan(some.rays);
    if (auto traced = instance.tracer->trace(left, found, options); !traced)
      return traced.error();
    for (std::size_t i = 0; i < found.size(); ++i) {
      InstanceHit &nearest = hits[some.numbers[i]];
      if (found[i].isHit() && (!nearest.isHit() || found[i].t < nearest.hit.t))
        nearest = {found[i], static_cast<std::uint32_t>(number)};
    }
  }
  return {};
}

} // namespace voxc
