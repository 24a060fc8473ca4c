// Rays through several volumes that stand in one world.
#include "voxc/Trace/InstancedTracer.h"

#include "InstancePlaces.h"
#include "InstanceRounds.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace voxc {
namespace {

/// Rays are taken so many at a time: more would take memory, and are not traced faster.
constexpr std::size_t kSliceRays = std::size_t{1} << 18;

/// Puts instances together that one tracer takes in one call.
class Groups {
public:
  std::uint32_t of(const Instance &instance) {
    const auto number = static_cast<std::uint32_t>(groups.size());
    const auto [found, isNew] = numbers_.try_emplace({instance.tracer, instance.bounded}, number);
    if (isNew)
      groups.push_back({instance.tracer, instance.bounded});
    return found->second;
  }

  std::vector<InstanceGroup> groups;

private:
  std::map<std::pair<Tracer *, bool>, std::uint32_t> numbers_;
};

} // namespace

struct InstancedTracer::State {
  PlacedInstances world;
  InstanceRounds rounds;

  State(PlacedInstances placed, unsigned threads) : world(std::move(placed)), rounds(world, threads) {}
};

InstancedTracer::InstancedTracer(std::unique_ptr<State> state) : state_(std::move(state)) {}
InstancedTracer::~InstancedTracer() = default;
InstancedTracer::InstancedTracer(InstancedTracer &&) noexcept = default;
InstancedTracer &InstancedTracer::operator=(InstancedTracer &&) noexcept = default;

Expected<InstancedTracer> InstancedTracer::create(const std::vector<Instance> &instances, unsigned threads) {
  if (instances.size() >= InstanceTree::kLeaf)
    return Error::usage("there are " + std::to_string(instances.size()) + " instances; at most " +
                        std::to_string(InstanceTree::kLeaf - 1) + " are traced together");
  std::vector<PlacedInstance> placed;
  Groups groups;
  std::vector<InstanceBox> boxes;
  for (const Instance &instance : instances) {
    if (!instance.tracer)
      return wrongInstance(placed.size(), "has no tracer");
    const auto fromWorld = VOXC_TRY(fromWorldOf(instance.toWorld, placed.size()));
    placed.push_back({fromWorld, instance.extent, groups.of(instance)});
    boxes.push_back(boxOf(glm::dmat4(instance.toWorld), fromWorld, instance.extent));
  }
  PlacedInstances world{std::move(placed), std::move(groups.groups), InstanceTree(boxes)};
  return InstancedTracer(std::make_unique<State>(std::move(world), threads));
}

Expected<void> InstancedTracer::trace(RaySpan rays, std::span<InstanceHit> hits,
                                      const TraceOptions &options) {
  if (rays.size() != hits.size())
    return Error::usage("there are " + std::to_string(rays.size()) + " rays, but room for " +
                        std::to_string(hits.size()) + " hits");
  const auto &[instances, groups, tree] = state_->world;
  const auto takesNone = [&](const PlacedInstance &instance) { return !groups[instance.group].bounded; };
  const auto found = std::ranges::find_if(instances, takesNone);
  if (rays.isBounded() && found != instances.end())
    return Error::usage("the rays have bounds, but instance " + std::to_string(found - instances.begin()) +
                        " is not said to take such: make its tracer with bounds=yes and set `bounded`");
  for (std::size_t first = 0; first < rays.size(); first += kSliceRays) {
    const std::size_t count = std::min(kSliceRays, rays.size() - first);
    VOXC_TRY(state_->rounds.trace(rays.subspan(first, count), hits.subspan(first, count), options));
  }
  return {};
}

} // namespace voxc
