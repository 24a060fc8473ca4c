// Rays from afar, and volumes of growing resolution.
#include "accuracy/Series.h"

#include "voxc/Construct/Constructor.h"
#include "voxc/Source/Sources.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace voxc::tool {
namespace {

constexpr int kLog10Farthest = 9;
constexpr int kLog2Least = 4;
constexpr int kLog2Most = 16;
constexpr std::size_t kStrewnVoxels = 1000;

using Point = std::array<double, 3>;

/// The same numbers for a seed on every machine.
class Random {
public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// In [0, 1).
  double share() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  int below(int end) { return static_cast<int>(share() * end); }
  Point pointIn(const Point &low, const Point &size) {
    Point point;
    for (std::size_t axis = 0; axis < 3; ++axis)
      point[axis] = low[axis] + share() * size[axis];
    return point;
  }
  /// A direction of length 1, all alike.
  Point direction() {
    for (;;) {
      Point point = pointIn({-1, -1, -1}, {2, 2, 2});
      const double length = std::hypot(point[0], point[1], point[2]);
      if (length > 1 || length < 0.01)
        continue;
      for (double &coordinate : point)
        coordinate /= length;
      return point;
    }
  }

private:
  std::mt19937_64 engine_;
};

/// From `radius` away from `centre` to `target`; the direction is that of the rounded origin.
Ray aimedRay(Random &random, const Point &centre, double radius, const Point &target) {
  const Point outward = random.direction();
  Ray ray;
  std::array<double, 3> way;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    ray.origin[axis] = static_cast<float>(centre[axis] + radius * outward[axis]);
    way[axis] = target[axis] - double(ray.origin[axis]);
  }
  const double length = std::hypot(way[0], way[1], way[2]);
  for (std::size_t axis = 0; axis < 3; ++axis)
    ray.direction[axis] = static_cast<float>(way[axis] / length);
  return ray;
}

Expected<SeriesPoint> measure(double at, std::span<const std::unique_ptr<VariantCandidate>> candidates,
                              const Oracle &oracle, const std::vector<Ray> &rays,
                              const SeriesOptions &options) {
  VOXC_TRY(traceInTurn(candidates, rays, options.rounds, options.progress));
  check(candidates, oracle, rays, rays.size());
  SeriesPoint point{at, {}};
  for (const auto &candidate : candidates)
    point.scores.push_back({mraysPerCpuSecond(*candidate), candidate->error});
  return point;
}

/// Voxels of different cells, sorted; fewer where two fell into one.
std::vector<CodedVoxel> strewnVoxels(int log2Side, std::vector<Int3> &cells) {
  Random random(static_cast<std::uint64_t>(log2Side));
  const int side = 1 << log2Side;
  std::vector<CodedVoxel> voxels;
  for (std::size_t i = 0; i < kStrewnVoxels; ++i) {
    const Int3 cell = {random.below(side), random.below(side), random.below(side)};
    cells.push_back(cell);
    voxels.push_back({mortonCode(cell), rgba(200, 120, 40)});
  }
  std::ranges::sort(voxels, {}, &CodedVoxel::code);
  const auto repeated = std::ranges::unique(voxels, {}, &CodedVoxel::code);
  voxels.erase(repeated.begin(), repeated.end());
  return voxels;
}

Format seriesFormat(int log2Side) {
  Format format = *parseFormat("R(3^3) G(" + std::to_string(log2Side - 3) + ")");
  format.levels.back().setAttribute(kDedupAttribute, "level");
  return format;
}

std::vector<Ray> raysToVoxels(int log2Side, const std::vector<Int3> &cells, std::size_t count) {
  Random random(static_cast<std::uint64_t>(100 + log2Side));
  const double half = std::ldexp(0.5, log2Side);
  std::vector<Ray> rays;
  for (std::size_t i = 0; i < count; ++i) {
    const Int3 cell = cells[i % cells.size()];
    const Point target = random.pointIn({double(cell.x), double(cell.y), double(cell.z)}, {1, 1, 1});
    rays.push_back(aimedRay(random, {half, half, half}, half * std::sqrt(3.0), target));
  }
  return rays;
}

Expected<SeriesPoint> measureResolution(int log2Side, const VariantChoice &choice, measure::Devices &devices,
                                        const SeriesOptions &options) {
  const Format format = seriesFormat(log2Side);
  std::vector<Int3> cells;
  const int side = 1 << log2Side;
  const auto source = makeSortedSource({side, side, side}, strewnVoxels(log2Side, cells));
  const auto constructor = VOXC_TRY(Constructor::compile(format));
  const auto built = VOXC_TRY(constructor.build(*source));
  const auto oracle = VOXC_TRY(Oracle::of(built.volume));
  std::vector<std::unique_ptr<VariantCandidate>> candidates;
  for (const Variant &variant : makeVariants(format, choice)) {
    auto candidate = VOXC_TRY(prepare(variant, built.volume, devices, options.threads));
    candidates.push_back(std::move(candidate));
  }
  return measure(side, candidates, oracle, raysToVoxels(log2Side, cells, options.rays), options);
}

} // namespace

Expected<std::vector<SeriesPoint>>
distanceSeries(std::span<const std::unique_ptr<VariantCandidate>> candidates, const Oracle &oracle,
               Int3 extent, const SeriesOptions &options) {
  const Point size = {double(extent.x), double(extent.y), double(extent.z)};
  const Point centre = {size[0] / 2, size[1] / 2, size[2] / 2};
  const double radius = std::hypot(centre[0], centre[1], centre[2]);
  std::vector<SeriesPoint> series;
  for (int exponent = 0; exponent <= kLog10Farthest; ++exponent) {
    const double distance = std::pow(10.0, exponent);
    Random random(static_cast<std::uint64_t>(exponent));
    std::vector<Ray> rays;
    rays.reserve(options.rays);
    for (std::size_t i = 0; i < options.rays; ++i)
      rays.push_back(aimedRay(random, centre, radius + distance, random.pointIn({}, size)));
    auto point = VOXC_TRY(measure(distance, candidates, oracle, rays, options));
    series.push_back(std::move(point));
  }
  return series;
}

Expected<std::vector<SeriesPoint>> resolutionSeries(const VariantChoice &choice, measure::Devices &devices,
                                                    const SeriesOptions &options) {
  std::vector<SeriesPoint> series;
  for (int log2Side = kLog2Least; log2Side <= kLog2Most; ++log2Side) {
    auto point = VOXC_TRY(measureResolution(log2Side, choice, devices, options));
    series.push_back(std::move(point));
  }
  return series;
}

} // namespace voxc::tool
