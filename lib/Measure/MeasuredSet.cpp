// Sets of rays, and samples of them.
#include "voxc/Measure/MeasuredSet.h"

#include "voxc/Trace/SampleIndex.h"

#include <algorithm>

namespace voxc::measure {
namespace {

/// What a record says of an order; of the default, nothing.
std::optional<std::string> nameOf(RayOrder order) {
  switch (order) {
  case RayOrder::Given:
    return "given";
  case RayOrder::Binned:
    return "binned";
  case RayOrder::Auto:
    break;
  }
  return std::nullopt;
}

} // namespace

RayOrder MeasuredSet::order() const { return rayOrderFrom(part.order.value_or("auto")); }

RaysPart cameraPart(const std::string &name, std::array<int, 2> size, Digest digest) {
  const std::array<std::uint64_t, 2> pixels{std::uint64_t(size[0]), std::uint64_t(size[1])};
  digest.add(std::to_string(size[0])).add(std::to_string(size[1]));
  return {name, "camera", pixels[0] * pixels[1], pixels, digest.hex(), {}};
}

RaysPart overviewPart(std::array<int, 2> size) {
  constexpr const char *kName = "overview";
  return cameraPart(kName, size, Digest().add(kName));
}

RaysPart listPart(const std::string &name, std::span<const Ray> rays) {
  const auto bytes = std::as_bytes(rays);
  return {name,
          "file",
          rays.size(),
          {},
          Digest().add({reinterpret_cast<const char *>(bytes.data()), bytes.size()}).hex(),
          {}};
}

MeasuredSet overviewSet(Int3 extent, std::array<int, 2> size) {
  const Camera camera = frameExtent(extent, size[0], size[1]);
  return {overviewPart(size), cameraRays(camera), camera};
}

MeasuredSet listSet(const std::string &name, std::vector<Ray> rays, RayOrder order) {
  MeasuredSet set{listPart(name, rays), std::move(rays), {}};
  set.part.order = nameOf(order);
  return set;
}

std::vector<Hit> SampledRays::sampleOf(std::span<const Hit> hits) const {
  std::vector<Hit> sampled(sample.size());
  for (std::size_t i = 0; i < sampled.size(); ++i)
    sampled[i] = hits[sampleIndex(i, sampled.size(), rays.size())];
  return sampled;
}

SampledRays sampleRays(std::vector<Ray> rays, std::size_t count) {
  SampledRays result{.rays = std::move(rays), .sample = {}, .exact = {}};
  const std::size_t sample = std::min(count, result.rays.size());
  for (std::size_t i = 0; i < sample; ++i)
    result.sample.push_back(result.rays[sampleIndex(i, sample, result.rays.size())]);
  return result;
}

} // namespace voxc::measure
