// Rays that stand for those that will be asked of a scene.
#include "voxc/Search/SampleRays.h"

#include "RayPosition.h"
#include "ScenePath.h"

#include "voxc/Search/RayCostModel.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <numeric>
#include <optional>
#include <random>
#include <span>
#include <utility>

namespace voxc {
namespace {

/// The last empty voxel before the first one that a ray hits; none if it misses, or begins in one.
std::optional<Int3> beforeHit(const SceneDag &dag, const Ray &ray) {
  RayPosition at(ray, 1 << dag.log2Side());
  ScenePath path(dag, dag.log2Side());
  std::optional<Int3> before;
  for (int turns = 3 << dag.log2Side(); at.isInside() && turns > 0; --turns) {
    const int empty = path.find(at.voxel());
    if (empty < 0)
      return before;
    before = at.voxel();
    // By single voxels near what is there, so that the last empty one is its neighbour.
    at.leave({empty > 2 ? empty - 2 : 0, 1});
  }
  return std::nullopt;
}

/// Empty cubes of the scene's graph, each as large as it can be, and the voxel that is hit.
int cubesCrossed(const SceneDag &dag, const Ray &ray) {
  RayPosition at(ray, 1 << dag.log2Side());
  ScenePath path(dag, dag.log2Side());
  int cubes = 0;
  for (const int most = 3 << dag.log2Side(); at.isInside() && cubes < most;) {
    ++cubes;
    const int empty = path.find(at.voxel());
    if (empty < 0)
      break;
    at.leave({empty, 1});
  }
  return cubes;
}

/// A number that has nothing in common with the widths of pictures.
constexpr std::size_t kSpread = 40503;

/// Any direction, all alike. By integers, so that a seed means the same everywhere.
glm::vec3 anyDirection(std::mt19937 &random) {
  for (;;) {
    glm::vec3 point;
    for (int axis = 0; axis < 3; ++axis)
      point[axis] = static_cast<float>(static_cast<int>(random() % 2001) - 1000) / 1000.0F;
    const float square = glm::dot(point, point);
    if (square > 0.01F && square <= 1)
      return point;
  }
}

} // namespace

std::vector<Ray> sampleCamera(const Camera &camera, std::size_t count) {
  const std::vector<Ray> all = cameraRays(camera);
  constexpr std::size_t kPacket = kSimulatedPacket;
  const std::size_t packets = std::min(count, all.size()) / kPacket;
  std::vector<Ray> rays;
  for (std::size_t packet = 0; packet < packets; ++packet) {
    // One in each of as many runs of pixels, not at the same place of each: runs may be whole rows.
    const std::size_t run = all.size() / packets;
    const std::size_t within = packet * kSpread % run;
    const std::size_t first = std::min((run * packet + within) / kPacket * kPacket, all.size() - kPacket);
    rays.insert(rays.end(), all.begin() + static_cast<std::ptrdiff_t>(first),
                all.begin() + static_cast<std::ptrdiff_t>(first + kPacket));
  }
  return rays;
}

std::vector<Ray> sampleBounces(const SceneDag &dag, const std::vector<Ray> &rays, std::size_t count,
                               std::uint32_t seed) {
  std::vector<Int3> places;
  for (const Ray &ray : rays)
    if (const auto place = beforeHit(dag, ray))
      places.push_back(*place);
  std::vector<Ray> bounces;
  std::mt19937 random(seed);
  for (std::size_t i = 0; i < count && !places.empty(); ++i) {
    const Int3 place = places[i % places.size()];
    const glm::vec3 origin = glm::vec3(place.x, place.y, place.z) + 0.5F;
    bounces.push_back(makeRay(origin, anyDirection(random)));
  }
  return bounces;
}

RaySet samplePackets(std::string name, std::vector<Ray> rays, std::size_t count, int edge, RayOrder order) {
  RaySet set{std::move(name), {}};
  set.isBinned = order == RayOrder::Binned || (order == RayOrder::Auto && areScattered(RaySpan(rays), edge));
  std::vector<std::uint32_t> places(rays.size());
  std::iota(places.begin(), places.end(), 0U);
  if (set.isBinned)
    places = binnedOrder(RaySpan(rays), edge, 1);
  const std::size_t packets = std::min(rays.size(), count) / kSimulatedPacket;
  for (std::size_t packet = 0; packet < packets; ++packet)
    for (std::size_t i = 0; i < kSimulatedPacket; ++i)
      set.rays.push_back(rays[places[rays.size() / packets * packet + i]]);
  return set;
}

RaySet typicalPackets(const SceneDag &dag, const RaySet &set, std::size_t count) {
  const std::size_t packets = set.rays.size() / kSimulatedPacket, wanted = count / kSimulatedPacket;
  if (packets <= wanted)
    return set;
  const auto raysOf = [&](std::size_t packet) {
    return std::span(set.rays).subspan(packet * kSimulatedPacket, kSimulatedPacket);
  };
  std::vector<std::pair<int, std::size_t>> order; // Cubes that are crossed, and the packet.
  for (std::size_t packet = 0; packet < packets; ++packet) {
    int cubes = 0;
    for (const Ray &ray : raysOf(packet))
      cubes += cubesCrossed(dag, ray);
    order.emplace_back(cubes, packet);
  }
  std::ranges::sort(order);
  RaySet typical{set.name, {}, set.isBinned};
  for (std::size_t i = 0; i < wanted; ++i) {
    const auto rays =
        raysOf(order[(2 * i + 1) * packets / (2 * wanted)].second); // Amid as many that are alike.
    typical.rays.insert(typical.rays.end(), rays.begin(), rays.end());
  }
  return typical;
}

} // namespace voxc
