// Recorded traces among instances: the hits of an instanced tracer, bit by bit, and what is refused.
#include "voxc/Trace/InstancedRecorder.h"

#include "Instances.h"
#include "TestHost.h"

#include "TestLength.h"
#include "testing/HardScenes.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/Kernel/Compile.h"
#include "voxc/Kernel/OpenTracer.h"

#include <gmock/gmock.h>

#include <optional>

namespace voxc {
namespace {

using testing::HasSubstr;

constexpr Int3 kVolumeExtent{16, 16, 16};

/// A volume, with bounds or without, on the device and on the processor.
struct Model {
  Volume volume;
  std::unique_ptr<Tracer> tracer;
  DeviceVolume words;
  TraceRecorder recorder;
  bool bounded;
};

class InstancedRecorderTest : public testing::Test {
protected:
  void SetUp() override {
    host_ = test::Host::open();
    if (!host_)
      GTEST_SKIP() << "there is no Vulkan device";
    auto device = adoptDevice(host_->device);
    ASSERT_TRUE(device) << device.error().message;
    device_.emplace(std::move(*device));
    models_.push_back(makeModel("G(4)", 7, true));
    models_.push_back(makeModel("R(2,2,2) M(2,2,2)", 8, false));
  }

  Model makeModel(const char *text, std::size_t scene, bool bounded) {
    Format format = *parseFormat(text);
    if (bounded)
      format.setAttribute(kBoundsAttribute, "yes");
    auto built = Constructor::compile(format)->build(*test::hardScenes(kVolumeExtent)[scene].source());
    EXPECT_TRUE(built) << built.error().message;
    auto tracer = openTracer(built->volume, {.device = "cpu", .format = format});
    auto kernel =
        compileKernel(format, {.loops = device_->info().loops, .arithmetic = device_->info().arithmetic});
    EXPECT_TRUE(kernel) << kernel.error().message;
    auto words = DeviceVolume::upload(*device_, built->volume, Addressing::Buffer);
    return {std::move(built->volume), std::move(*tracer), std::move(*words),
            *TraceRecorder::create(*device_, *kernel), bounded};
  }

  /// Places of the first model, and in turn of the second one too.
  void place(int count, float reach, bool both) {
    std::mt19937 random(21);
    for (int i = 0; i < count; ++i) {
      const std::uint32_t volume = both ? i % 2 : 0;
      placed_.push_back({volume, kVolumeExtent, test::randomPlace(random, reach)});
      instances_.push_back(
          {models_[volume].tracer.get(), kVolumeExtent, placed_.back().toWorld, models_[volume].bounded});
    }
  }

  std::vector<Ray> raysAmong(std::size_t count) const {
    std::vector<Ray> rays;
    std::mt19937 random(22);
    for (const Ray &ray : hardRaysOf(count)) {
      const glm::mat4 &at = placed_[random() % placed_.size()].toWorld;
      const glm::vec3 origin(at * glm::vec4(ray.origin[0], ray.origin[1], ray.origin[2], 1));
      const glm::vec3 direction(at * glm::vec4(ray.direction[0], ray.direction[1], ray.direction[2], 0));
      rays.push_back(makeRay(origin, direction));
    }
    return rays;
  }

  /// Rays as of cameras, and some of every hard class.
  static std::vector<Ray> hardRaysOf(std::size_t count) {
    std::vector<Ray> rays = verifyRays(kVolumeExtent, count, 23);
    for (const test::HardRayClass &kind : test::hardRayClasses()) {
      const auto hard = test::hardRays({kVolumeExtent}, kind.name, count / 40, 24);
      rays.insert(rays.end(), hard.begin(), hard.end());
    }
    return rays;
  }

  Expected<InstancedRecorder> recorder(const InstancedRecorderOptions &options = {}) const {
    std::vector<RecordedVolume> volumes;
    for (const Model &model : models_)
      volumes.push_back({&model.recorder, &model.words});
    return InstancedRecorder::create(const_cast<Device &>(*device_), volumes, placed_, options);
  }

  template <typename AnyRay>
  std::vector<InstanceHit> recorded(const std::vector<AnyRay> &rays, std::uint64_t scratchRays,
                                    const InstancedRecorderOptions &options = {}) {
    const auto made = recorder(options);
    EXPECT_TRUE(made) << made.error().message;
    const std::uint64_t bytes = rays.size() * sizeof(AnyRay), hitBytes = rays.size() * sizeof(InstanceHit),
                        scratchBytes = made->scratchBytes(scratchRays);
    const auto rayBuffer = host_->makeBuffer(bytes), hitBuffer = host_->makeBuffer(hitBytes),
               scratch = host_->makeBuffer(scratchBytes);
    std::memcpy(rayBuffer.bytes, rays.data(), bytes);
    const auto bound = made->bind(
        {{rayBuffer.buffer, 0, bytes}, {hitBuffer.buffer, 0, hitBytes}, {scratch.buffer, 0, scratchBytes}});
    EXPECT_TRUE(bound) << bound.error().message;
    EXPECT_EQ(bound->rays(), rays.size());
    EXPECT_FALSE(recordInstancedTrace(VK_NULL_HANDLE, *bound, bound->rays(), 1));
    host_->submit([&](VkCommandBuffer commands) {
      ASSERT_TRUE(recordInstancedTrace(commands, *bound, static_cast<std::uint32_t>(rays.size())));
    });
    const auto *hits = reinterpret_cast<const InstanceHit *>(hitBuffer.bytes);
    return {hits, hits + rays.size()};
  }

  std::vector<InstanceHit> traced(const RaySpan &rays) const {
    std::vector<InstanceHit> hits(rays.size());
    EXPECT_TRUE(InstancedTracer::create(instances_)->trace(rays, hits));
    return hits;
  }

  std::unique_ptr<test::Host> host_;
  std::optional<Device> device_; ///< Destroyed before the host, and after what is on it.
  std::vector<Model> models_;
  std::vector<RecordedInstance> placed_;
  std::vector<Instance> instances_;
};

TEST_F(InstancedRecorderTest, FindsTheNearestOfManyInstancesOfTwoVolumes) {
  place(300, 60, true);
  const std::vector<Ray> rays = raysAmong(4000 * static_cast<std::size_t>(test::rounds(1)));
  const auto expected = traced(rays);
  // Some hard rays have to be traced through all: their directions are next to 0, or they begin too far away.
  const InstancedRecorderOptions options{.rounds = 45};
  EXPECT_EQ(
      test::countDifferent(recorded(rays, std::min<std::size_t>(rays.size(), 200000), options), expected),
      0u);
  EXPECT_EQ(test::countDifferent(recorded(rays, rays.size() / 6, options), expected), 0u) << "in parts";
  EXPECT_GT(static_cast<std::size_t>(std::ranges::count_if(expected, &InstanceHit::isHit)), rays.size() / 3);
}

TEST_F(InstancedRecorderTest, KeepsTheBoundsOfRays) {
  place(100, 30, false);
  models_.pop_back(); // Which takes none.
  std::vector<BoundedRay> rays;
  for (const Ray &ray : raysAmong(3000))
    rays.push_back(bounded(ray, {float(rays.size() % 7), float(9 + rays.size() % 50)}));
  const auto expected = traced(rays);
  EXPECT_EQ(test::countDifferent(recorded(rays, rays.size(), {.boundedRays = true, .rounds = 20}), expected),
            0u);
  EXPECT_GT(std::ranges::count_if(expected, &InstanceHit::isHit), 500);
}

TEST_F(InstancedRecorderTest, SaysWhatIsUnfinished) {
  place(300, 150, false);
  const std::vector<Ray> rays = raysAmong(3000);
  const auto expected = traced(rays), hits = recorded(rays, rays.size(), {.rounds = 2});
  std::size_t unfinished = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (hits[i].hit.voxel[0] < -1)
      ++unfinished;
    else
      EXPECT_EQ(test::countDifferent({&hits[i], 1}, {&expected[i], 1}), 0u) << i;
  }
  EXPECT_GT(unfinished, 100u);
  EXPECT_LT(unfinished, 2900u);
}

TEST_F(InstancedRecorderTest, TakesRaysThatAreNoNumbersOrHardlyAny) {
  place(20, 20, true);
  std::vector<Ray> rays = raysAmong(500);
  const float nan = std::numeric_limits<float>::quiet_NaN(),
              infinity = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < rays.size(); ++i) {
    float &some = i % 2 ? rays[i].direction[i / 2 % 3] : rays[i].origin[i / 2 % 3];
    const float values[] = {nan, infinity, 0, 1e-44f, 1e38f, -3e-39f, 5};
    some = values[i % 7];
    if (i % 5 == 0)
      rays[i] = {{rays[i].origin[0], rays[i].origin[1], rays[i].origin[2]}, {1e-40f, -2e-41f, 1e-39f}};
  }
  EXPECT_EQ(test::countDifferent(recorded(rays, rays.size()), traced(rays)), 0u);
}

TEST_F(InstancedRecorderTest, OfNoInstancesHasNoHits) {
  place(1, 1, false);
  const std::vector<Ray> rays = raysAmong(100);
  placed_.clear();
  for (const InstanceHit &hit : recorded(rays, rays.size()))
    EXPECT_FALSE(hit.isHit() || hit.hit.isHit());
}

TEST_F(InstancedRecorderTest, RefusesWhatDoesNotFit) {
  const auto problem = [&](const RecordedInstance &instance, const InstancedRecorderOptions &options = {}) {
    placed_ = {{}, instance};
    const auto made = recorder(options);
    return made ? std::string() : made.error().message;
  };
  EXPECT_EQ(problem({1, kVolumeExtent}), "");
  EXPECT_THAT(problem({2, kVolumeExtent}), HasSubstr("instance 1 is of a volume that is not in the list"));
  EXPECT_THAT(problem({0, kVolumeExtent, glm::mat4(0)}),
              HasSubstr("instance 1 has a matrix that is not affine"));
  EXPECT_THAT(problem({0, kVolumeExtent}, {.boundedRays = true}),
              HasSubstr("volume 1 has a kernel without bounds"));
  const auto made = recorder();
  const auto buffer = host_->makeBuffer(1 << 16);
  const auto bound =
      made->bind({{buffer.buffer, 0, 1024}, {buffer.buffer, 0, 1024}, {buffer.buffer, 0, 4096}});
  ASSERT_FALSE(bound);
  EXPECT_THAT(bound.error().message, HasSubstr("scratch memory has 4096 bytes, but at least"));
}

} // namespace
} // namespace voxc
