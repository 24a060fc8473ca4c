// From simulated rays to nanoseconds of a call.
#include "Expectation.h"

#include "voxc/Layout/SlotKind.h"
#include "voxc/Plan/Plan.h"
#include "voxc/Search/RayCostModel.h"
#include "voxc/Search/SampleRays.h"
#include "voxc/Trace/SampleIndex.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace voxc::cliffs {
namespace {

/// Nanoseconds, guessed: to take a ray to an instance and its hit back; to begin with a ray of a world; of
/// another thread. They are not told by the model, and only what is far above them is told as a cliff.
constexpr double kVisit = 80;
constexpr double kWorldRay = 100;
constexpr double kThread = 60000;
/// Rays through pages look each word's page up (docs/paging.md).
constexpr double kPaged = 1.6;
/// Rays that a register holds at the least.
constexpr std::size_t kLanes = 8;

/// Rays that begin where their bounds do.
std::vector<Ray> movedToBounds(const StagedRays &rays) {
  std::vector<Ray> moved = rays.plain;
  for (std::size_t i = 0; i < rays.bounded.size(); ++i)
    if (const float tmin = rays.bounded[i].tmin; tmin > 0 && std::isfinite(tmin))
      for (int axis = 0; axis < 3; ++axis)
        moved[i].origin[axis] += tmin * moved[i].direction[axis];
  return moved;
}

/// How much of their way, from tmin to their hits or out of the box, rays have to go.
double shareOfWay(const Stage &stage, const StagedRays &rays, const std::vector<Ray> &moved) {
  if (rays.bounded.empty())
    return 1;
  double whole = 0, asked = 0;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    const Passage passage = passageOf(moved[i], stage.place.extent);
    if (passage.isEmpty())
      continue;
    const Hit hit = stage.oracle.trace(moved[i]);
    const double way = std::max((hit.isHit() ? double{hit.t} : passage.to) - passage.from, 0.0);
    const double bound = double{rays.bounded[i].tmax} - std::max(double{rays.bounded[i].tmin}, 0.0);
    const double length = way > 0 ? 1 / way : 0;
    whole += 1;
    asked += std::clamp((std::min(bound, passage.from + way) - passage.from) * length, 0.0, 1.0);
  }
  return whole > 0 ? asked / whole : 1;
}

/// Whole packets, for what is left over is not simulated.
std::vector<Ray> filledUp(std::vector<Ray> rays) {
  while (!rays.empty() && rays.size() % kSimulatedPacket != 0)
    rays.push_back(rays.back());
  return rays;
}

class Simulated {
public:
  Simulated(const Machine &machine, const Stage &stage, const Plan &plan)
      : model_(defaultSpeedModel(machine.isCpu()                        ? "cpu"
                                 : machine.device->info().kind == "cpu" ? "llvmpipe"
                                                                        : "")),
        stage_(stage), plan_(plan) {}

  RayCost cost(const std::vector<Ray> &rays) const {
    if (!stage_.shape.isEmpty())
      return modelRayCost(stage_.shape, filledUp(rays), plan_);
    RayCost none; // Of a volume without voxels a kernel looks at no word but the first.
    none.levels = static_cast<double>(plan_.layout.strata.size());
    return none;
  }

  /// Nanoseconds of a ray that goes only this share of its way.
  double nanoseconds(const RayCost &cost, double share) const {
    RayCost none;
    none.levels = cost.levels;
    none.binned = cost.binned;
    const std::uint64_t bytes = 4 * stage_.volume.words().size();
    const double fixed = model_.predict(speedTerms(none, bytes));
    const double all = model_.predict(speedTerms(cost, bytes));
    return (fixed + share * (all - fixed)) * lookUpFactor(plan_.layout.strata);
  }

private:
  const SpeedModel &model_;
  const Stage &stage_;
  const Plan &plan_;
};

/// The rays of a world, as they should be taken to instances: to those that begin before their hit.
std::vector<Ray> raysInInstances(const Stage &stage, const Subject &subject, const StagedRays &all,
                                 std::size_t most) {
  std::vector<Ray> there;
  std::vector<glm::dmat4> inverses;
  for (const glm::mat4 &placement : subject.placements())
    inverses.push_back(glm::inverse(glm::dmat4(placement)));
  const std::size_t count = std::min(all.plain.size(), most);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t number = sampleIndex(i, count, all.plain.size());
    const Ray &ray = all.plain[number];
    const InstanceHit &hit = subject.instanceHits()[number];
    for (const glm::dmat4 &inverse : inverses) {
      const glm::dvec3 from(inverse * glm::dvec4(ray.origin[0], ray.origin[1], ray.origin[2], 1));
      const glm::dvec3 step(inverse * glm::dvec4(ray.direction[0], ray.direction[1], ray.direction[2], 0));
      const Ray moved = makeRay(from, step);
      const Passage passage = passageOf(moved, stage.place.format.extent());
      if (!passage.isEmpty() && (!hit.isHit() || passage.from <= double{hit.hit.t}))
        there.push_back(moved);
    }
  }
  return there;
}

} // namespace

StagedRays someOf(const StagedRays &rays, std::size_t count) {
  if (rays.plain.size() <= count)
    return rays;
  StagedRays some;
  const std::size_t packets = count / kSimulatedPacket;
  for (std::size_t packet = 0; packet < packets; ++packet) {
    const std::size_t first = packet * (rays.plain.size() - kSimulatedPacket) / packets;
    for (std::size_t i = first; i < first + kSimulatedPacket; ++i) {
      some.plain.push_back(rays.plain[i]);
      if (!rays.bounded.empty())
        some.bounded.push_back(rays.bounded[i]);
    }
  }
  return some;
}

Expected<Expectation> expect(const Machine &machine, const Calibration &calibration, const Stage &stage,
                             const Situation &situation, const Subject &subject, const StagedRays &all,
                             const StagedRays &some) {
  const auto plan = VOXC_TRY(makePlan(askedFormat(stage.place, situation), kCpuPlan));
  const Simulated simulated(machine, stage, plan);
  Expectation expected;
  const std::size_t packets = (all.plain.size() + kLanes - 1) / kLanes;
  const auto lanes = static_cast<double>(packets * kLanes);
  const auto count = static_cast<double>(all.plain.size());
  double ray = 0;
  if (situation.instances > 0) {
    constexpr std::size_t kFew = 512;
    const std::vector<Ray> there = raysInInstances(stage, subject, all, kFew);
    expected.visits =
        static_cast<double>(there.size()) / static_cast<double>(std::min(all.plain.size(), kFew));
    const double once = there.empty() ? 0 : simulated.nanoseconds(simulated.cost(there), 1) + kVisit;
    ray = expected.visits * once + kWorldRay;
  } else {
    const std::vector<Ray> moved = movedToBounds(some);
    RayCost cost = simulated.cost(moved);
    const double share =
        isOfPoints(situation.query) ? 1 / std::max(cost.turns, 1.0) : shareOfWay(stage, some, moved);
    expected.lookups = share * cost.lookups + (share < 1 ? 1 : 0);
    ray = simulated.nanoseconds(cost, share);
    // Scattered rays may be sorted first, as is faster.
    const Int3 extent = stage.place.extent;
    const int edge = std::max({extent.x, extent.y, extent.z});
    if (areScattered(all.plain, edge)) {
      const RaySet binned = samplePackets("", all.plain, moved.size(), edge, RayOrder::Binned);
      cost = simulated.cost(binned.rays);
      cost.binned = 1;
      ray = std::min(ray, simulated.nanoseconds(cost, share));
    }
  }
  expected.nanoseconds =
      calibration.perCall + (situation.threads - 1) * kThread +
      (situation.isPaged ? kPaged : 1) * calibration.scale * ray * (count < 4 * kLanes ? lanes : count);
  return expected;
}

} // namespace voxc::cliffs
