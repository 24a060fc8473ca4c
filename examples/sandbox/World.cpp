#include "World.h"

#include <voxc/Kernel/OpenTracer.h>
#include <voxc/Source/Sources.h>

#include <chrono>
#include <cstring>
#include <span>
#include <utility>

namespace {

// Seconds that a piece of work takes, added to a sum.
class Timed {
public:
  explicit Timed(double &sum) : sum_(sum) {}
  ~Timed() { sum_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count(); }
  Timed(const Timed &) = delete;
  Timed &operator=(const Timed &) = delete;

private:
  double &sum_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

} // namespace

voxc::Expected<World> World::create(const std::string &device) {
  // A grid at the top, whose cells change where they are; equal nodes of the trees below are one.
  voxc::Expected<voxc::Format> format = voxc::parseFormat("R(3^3) G(5)");
  auto hills = format ? voxc::makeBuiltinSource("terrain", 256) : format.error();
  if (!hills)
    return hills.error();
  auto constructor = voxc::Constructor::compile(*format);
  if (!constructor)
    return constructor.error();
  const auto built = constructor->build(**hills);
  if (!built)
    return built.error();
  auto volume = voxc::EditableVolume::create(built->volume);
  if (!volume)
    return volume.error();
  auto tracer = voxc::openTracer(*volume->volume(), {.device = device});
  if (!tracer)
    return tracer.error();
  World world(std::move(*volume), std::move(*tracer), device);
  world.shown_ = world.volume_.volume();
  return world;
}

voxc::Expected<void> World::follow() {
  const Timed timed(costs_.followSeconds);
  const auto now = volume_.volume();
  auto followed = tracer_->follow(*now, volume_.takeChanges());
  if (!followed)
    return followed.error();
  costs_.copiedBytes += followed->copiedBytes;
  shown_ = now;
  return {};
}

std::optional<voxc::Hit> World::shoot(const voxc::Ray &ray) {
  voxc::Hit hit;
  if (!follow() || !tracer_->trace(std::span(&ray, 1), std::span(&hit, 1)) || !hit.isHit())
    return std::nullopt;
  return hit;
}

voxc::Expected<void> World::edit(voxc::VoxelChange &change) {
  const Timed timed(costs_.editSeconds);
  ++costs_.edits;
  auto applied = volume_.apply(change);
  return applied ? voxc::Expected<void>() : applied.error();
}

voxc::Expected<voxc::Picture> World::show(const voxc::Camera &camera) {
  if (auto followed = follow(); !followed)
    return followed.error();
  const Timed timed(costs_.traceSeconds);
  const auto trace = [&](std::span<const voxc::Ray> rays, std::span<voxc::Hit> hits,
                         const voxc::TraceOptions &options) -> voxc::Expected<void> {
    auto traced = tracer_->trace(rays, hits, options);
    return traced ? voxc::Expected<void>() : traced.error();
  };
  auto picture = voxc::render(*shown_, camera, {trace, trace}, {});
  if (!picture)
    return picture.error();
  return std::move(picture->picture);
}

FrameCosts World::takeCosts() { return std::exchange(costs_, {}); }

voxc::Expected<int> World::wrongHits(const std::vector<voxc::Ray> &rays) {
  const auto built = volume_.compact();
  if (!built)
    return built.error();
  auto tracer = voxc::openTracer(built->volume, {.device = device_});
  if (!tracer)
    return tracer.error();
  std::vector<voxc::Hit> own(rays.size()), expected(rays.size());
  if (auto followed = follow(); !followed)
    return followed.error();
  if (auto traced = tracer_->trace(rays, own); !traced)
    return traced.error();
  if (auto traced = (*tracer)->trace(rays, expected); !traced)
    return traced.error();
  int wrong = 0;
  for (std::size_t i = 0; i < rays.size(); ++i)
    wrong += std::memcmp(&own[i], &expected[i], sizeof(voxc::Hit)) != 0 ? 1 : 0;
  return wrong;
}
