// Rays through the instances of a world, round by round.
#include "InstanceRounds.h"

#include "Support/ParallelFor.h"

#include <algorithm>
#include <cmath>

namespace voxc {
namespace {

/// Rays that a thread looks at together: enough to be worth taking, few enough that threads end together.
constexpr std::size_t kChunkRays = 4096;

/// Instances that are tried for a ray at once, at most. A round tries twice as many as the one before it, so
/// that few rays which graze many boxes do not take as many rounds.
constexpr unsigned kMostAtOnce = 8;

bool isFinite(const Ray &ray) {
  for (int axis = 0; axis < 3; ++axis)
    if (!std::isfinite(ray.origin[axis]) || !std::isfinite(ray.direction[axis]))
      return false;
  return true;
}

/// False if a ray surely comes to no voxel of [0, extent) between its bounds, which are some. Sure is what a
/// slab test in float64 says of a box and of bounds that are larger by far more than it rounds, but by little
/// beside what float32 has rounded of a ray from far away.
bool mayHit(const Ray &ray, Int3 extent, const RayBounds &bounds) {
  constexpr double kMargin = 0x1p-44;
  double low = std::max(0.0, double(bounds.tmin) * (1 - kMargin));
  double high = double(bounds.tmax) * (1 + kMargin);
  for (int axis = 0; axis < 3; ++axis) {
    const double origin = ray.origin[axis], direction = ray.direction[axis];
    const double room = kMargin * (1 + extent[axis] + std::abs(origin));
    if (direction == 0) {
      if (origin < -room || origin > extent[axis] + room)
        return false;
      continue;
    }
    const double inverse = 1 / direction;
    const double first = (-room - origin) * inverse, last = (extent[axis] + room - origin) * inverse;
    low = std::max(low, std::min(first, last));
    high = std::min(high, std::max(first, last));
  }
  return !(low > high * (1 + kMargin));
}

/// Where a ray is still to be looked at, of which it is known what it has hit so far. A voxel that is entered
/// a little later may have the same t, rounded.
RayBounds boundsLeft(RayBounds bounds, const InstanceHit &nearest) {
  if (nearest.isHit())
    bounds.tmax =
        std::min(bounds.tmax, std::nextafter(nearest.hit.t, std::numeric_limits<float>::infinity()));
  return bounds;
}

bool isNearer(const Hit &hit, std::uint32_t instance, const InstanceHit &nearest) {
  return !nearest.isHit() || hit.t < nearest.hit.t || (hit.t == nearest.hit.t && instance < nearest.instance);
}

/// The nearest instances that a ray may hit, in their order.
class NearestInstances {
public:
  struct Entry {
    InstanceKey key;
    Ray ray; ///< In the voxels of the instance.
  };

  NearestInstances(const PlacedInstances &world, const Ray &ray, const RayBounds &bounds, unsigned most)
      : world_(world), ray_(ray), bounds_(bounds), most_(most) {}

  void operator()(const InstanceKey &key, float &limit) {
    if (count_ == most_ && key > entries_[count_ - 1].key)
      return;
    const PlacedInstance &instance = world_.instances[key.number];
    const Ray there = rayThere(instance.fromWorld, ray_);
    if (!mayHit(there, instance.extent, bounds_))
      return;
    unsigned place = count_ < most_ ? count_++ : count_ - 1;
    for (; place > 0 && key < entries_[place - 1].key; --place)
      entries_[place] = entries_[place - 1];
    entries_[place] = {key, there};
    if (count_ == most_)
      limit = entries_[count_ - 1].key.moment;
  }

  std::span<const Entry> entries() const { return {entries_.data(), count_}; }

private:
  const PlacedInstances &world_;
  const Ray &ray_;
  const RayBounds &bounds_;
  unsigned most_;
  unsigned count_ = 0;
  std::array<Entry, kMostAtOnce> entries_;
};

} // namespace

Ray rayThere(const glm::dmat4 &fromWorld, const Ray &ray) {
  const auto apply = [&](const float(&v)[3], double w) {
    const glm::dvec3 x = glm::dvec3(fromWorld[0]) * double(v[0]), y = glm::dvec3(fromWorld[1]) * double(v[1]),
                     z = glm::dvec3(fromWorld[2]) * double(v[2]), moved = glm::dvec3(fromWorld[3]) * w;
    return glm::vec3((x + y) + (z + moved));
  };
  return makeRay(apply(ray.origin, 1), apply(ray.direction, 0));
}

void InstanceRounds::Candidates::clear() {
  rays.clear();
  boundedRays.clear();
  numbers.clear();
  instances.clear();
}

void InstanceRounds::Candidates::add(const Ray &ray, const RayBounds &bounds, bool isBounded,
                                     std::uint32_t number, std::uint32_t instance) {
  if (isBounded)
    boundedRays.push_back(bounded(ray, bounds));
  else
    rays.push_back(ray);
  numbers.push_back(number);
  instances.push_back(instance);
}

void InstanceRounds::begin(const RaySpan &rays) {
  chunks_.resize((rays.size() + kChunkRays - 1) / kChunkRays);
  parallelFor(chunks_.size(), threads_, [&](std::uint64_t index) {
    Chunk &chunk = chunks_[index];
    chunk.candidates.resize(world_.groups.size());
    chunk.first.resize(world_.groups.size());
    chunk.numbers.clear();
    const std::size_t end = std::min((index + 1) * kChunkRays, rays.size());
    for (std::size_t number = index * kChunkRays; number < end; ++number)
      if (isFinite(rays[number]))
        chunk.numbers.push_back(static_cast<std::uint32_t>(number));
    chunk.last.assign(chunk.numbers.size(), InstanceKey{});
  });
}

void InstanceRounds::select(Chunk &chunk, const RaySpan &rays, std::span<const InstanceHit> hits,
                            unsigned most) const {
  for (Candidates &candidates : chunk.candidates)
    candidates.clear();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < chunk.numbers.size(); ++i) {
    const std::uint32_t number = chunk.numbers[i];
    const Ray ray = rays[number];
    const RayBounds bounds = boundsLeft(rays.bounds(number), hits[number]);
    const BoxRay boxRay(ray, world_.tree);
    const float moment = chunk.last[i].moment;
    if (moment - moment * kMomentRounding > boxRay.momentOf(bounds.tmax))
      continue;
    NearestInstances nearest(world_, ray, bounds, most);
    world_.tree.traverse(boxRay, bounds, chunk.last[i], std::numeric_limits<float>::infinity(), nearest);
    for (const NearestInstances::Entry &entry : nearest.entries()) {
      const std::uint32_t group = world_.instances[entry.key.number].group;
      chunk.candidates[group].add(entry.ray, bounds, world_.groups[group].bounded, number, entry.key.number);
    }
    if (nearest.entries().size() < most)
      continue; // There are no others.
    chunk.numbers[kept] = number;
    chunk.last[kept++] = nearest.entries().back().key;
  }
  chunk.numbers.resize(kept);
  chunk.last.resize(kept);
}

template <typename AnyRay>
RaySpan InstanceRounds::gather(std::uint32_t group, std::vector<AnyRay> Candidates::*rays,
                               std::vector<AnyRay> &all) const {
  all.resize(found_.size());
  parallelFor(chunks_.size(), threads_, [&](std::uint64_t index) {
    const Chunk &chunk = chunks_[index];
    std::ranges::copy(chunk.candidates[group].*rays,
                      all.begin() + static_cast<std::ptrdiff_t>(chunk.first[group]));
  });
  return std::span<const AnyRay>(all);
}

Expected<void> InstanceRounds::traceGroup(std::uint32_t group, std::span<InstanceHit> hits,
                                          const TraceOptions &options) {
  std::size_t count = 0;
  for (Chunk &chunk : chunks_) {
    chunk.first[group] = count;
    count += chunk.candidates[group].numbers.size();
  }
  if (count == 0)
    return {};
  found_.resize(count);
  const auto [tracer, isBounded] = world_.groups[group];
  const RaySpan rays = isBounded ? gather(group, &Candidates::boundedRays, boundedRays_)
                                 : gather(group, &Candidates::rays, rays_);
  VOXC_TRY(tracer->trace(rays, found_, options));
  parallelFor(chunks_.size(), threads_, [&](std::uint64_t index) {
    const Candidates &candidates = chunks_[index].candidates[group];
    for (std::size_t i = 0; i < candidates.numbers.size(); ++i) {
      const Hit &hit = found_[chunks_[index].first[group] + i];
      InstanceHit &nearest = hits[candidates.numbers[i]];
      if (hit.isHit() && isNearer(hit, candidates.instances[i], nearest))
        nearest = {hit, candidates.instances[i]};
    }
  });
  return {};
}

Expected<void> InstanceRounds::trace(const RaySpan &rays, std::span<InstanceHit> hits,
                                     const TraceOptions &options) {
  std::ranges::fill(hits, InstanceHit{{{-1, -1, -1}, 0, 0, 0}});
  begin(rays);
  const auto isDone = [](const Chunk &chunk) { return chunk.numbers.empty(); };
  for (unsigned most = 1; !std::ranges::all_of(chunks_, isDone); most = std::min(2 * most, kMostAtOnce)) {
    if (options.progress.stopped())
      return Error::interrupted();
    parallelFor(chunks_.size(), threads_,
                [&](std::uint64_t index) { select(chunks_[index], rays, hits, most); });
    for (std::uint32_t group = 0; group < world_.groups.size(); ++group)
      VOXC_TRY(traceGroup(group, hits, options));
  }
  return {};
}

} // namespace voxc
