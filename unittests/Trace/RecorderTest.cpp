// Recorded traces on a device of the host's: the hits of the cpu, and what is refused.
#include "TestHost.h"

#include "testing/HardRays.h"
#include "testing/HardScenes.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/Construct/EditableVolume.h"
#include "voxc/Kernel/Compile.h"
#include "voxc/Kernel/CompileCpu.h"
#include "voxc/Trace/Recorder.h"

#include <gmock/gmock.h>

#include <optional>

namespace voxc {
namespace {

using testing::HasSubstr;

/// What several traces of a test have in common.
struct Model {
  Volume volume;
  std::vector<Ray> rays;
  std::vector<Hit> expected;
};

Model makeModel(const char *text, std::size_t scene, std::size_t rayCount) {
  const Format format = *parseFormat(text);
  auto built = Constructor::compile(format)->build(*test::hardScenes(format.extent())[scene].source());
  EXPECT_TRUE(built) << built.error().message;
  Model model{std::move(built->volume), {}, {}};
  model.rays = verifyRays(format.extent(), rayCount / 2, 1);
  for (const test::HardRayClass &kind : test::hardRayClasses()) {
    const auto hard = test::hardRays({format.extent()}, kind.name, rayCount / 24, 2);
    model.rays.insert(model.rays.end(), hard.begin(), hard.end());
  }
  model.expected.resize(model.rays.size());
  auto tracer = createCpuTracer(*compileCpuKernel(format, {.start = CpuStart::Fast}), model.volume);
  EXPECT_TRUE((*tracer)->trace(model.rays, model.expected));
  return model;
}

Kernel kernelFor(const Device &device, const Model &model, Addressing addressing = Addressing::Buffer) {
  auto kernel = compileKernel(
      model.volume.format(),
      {.addressing = addressing, .loops = device.info().loops, .arithmetic = device.info().arithmetic});
  EXPECT_TRUE(kernel) << kernel.error().message;
  return *kernel;
}

class RecorderTest : public testing::Test {
protected:
  void SetUp() override { openHost(false); }

  void openHost(bool plain) {
    device_.reset();
    host_ = test::Host::open(plain);
    if (!host_)
      GTEST_SKIP() << "there is no Vulkan device";
    auto device = adoptDevice(host_->device);
    ASSERT_TRUE(device) << device.error().message;
    device_.emplace(std::move(*device));
  }

  /// A model as it is on the device.
  struct Placed {
    DeviceVolume volume;
    TraceRecorder recorder;
    test::Host::Buffer rays, hits, scratch;
    std::optional<BoundTrace> trace;
  };

  /// Places a model, with scratch memory for so many rays at once.
  Placed place(const Model &model, std::uint64_t scratchRays, Addressing addressing = Addressing::Buffer) {
    const Kernel kernel = kernelFor(*device_, model, addressing);
    Placed placed{*DeviceVolume::upload(*device_, model.volume, addressing),
                  *TraceRecorder::create(*device_, kernel),
                  host_->makeBuffer(model.rays.size() * sizeof(Ray)),
                  host_->makeBuffer(model.rays.size() * sizeof(Hit)),
                  host_->makeBuffer(scratchBytes(scratchRays)),
                  {}};
    std::memcpy(placed.rays.bytes, model.rays.data(), model.rays.size() * sizeof(Ray));
    auto bound = placed.recorder.bind(placed.volume, buffersOf(placed, model, scratchRays));
    EXPECT_TRUE(bound) << bound.error().message;
    placed.trace.emplace(std::move(*bound));
    return placed;
  }

  static TraceBuffers buffersOf(const Placed &placed, const Model &model, std::uint64_t scratchRays) {
    return {.rays = {placed.rays.buffer, 0, model.rays.size() * sizeof(Ray)},
            .hits = {placed.hits.buffer, 0, model.rays.size() * sizeof(Hit)},
            .scratch = {placed.scratch.buffer, 0, scratchBytes(scratchRays)}};
  }

  static void expectHits(const Placed &placed, const Model &model) {
    std::size_t wrong = 0;
    const auto *hits = reinterpret_cast<const Hit *>(placed.hits.bytes);
    for (std::size_t i = 0; i < model.rays.size(); ++i)
      wrong += std::memcmp(&hits[i], &model.expected[i], sizeof(Hit)) != 0;
    EXPECT_EQ(wrong, 0u) << "of " << model.rays.size() << " rays through " << toString(model.volume.format());
  }

  static std::uint32_t countOf(const Model &model) { return static_cast<std::uint32_t>(model.rays.size()); }

  std::unique_ptr<test::Host> host_;
  std::optional<Device> device_; ///< Destroyed before the host.
};

TEST_F(RecorderTest, TracesTwoVolumesInOneCommandBuffer) {
  const Model tree = makeModel("R(1,1,1) G(3)", 7, 6000);
  const Model grids = makeModel("D(2,2,2,3) M(2,2,2)", 8, 3000);
  const Placed a = place(tree, tree.rays.size()), b = place(grids, grids.rays.size());
  host_->submit([&](VkCommandBuffer commands) {
    const RecordedTrace traces[] = {{&*a.trace, countOf(tree)}, {&*b.trace, countOf(grids)}};
    const auto recorded = recordTraces(commands, traces);
    ASSERT_TRUE(recorded) << recorded.error().message;
  });
  expectHits(a, tree);
  expectHits(b, grids);
}

/// The frames of a game: an edit, what brings it to the device and what traces are one command buffer.
TEST_F(RecorderTest, FollowsEditsInTheHostsCommandBuffer) {
  Model model = makeModel("R(1,1,1) G(3)", 7, 3000);
  auto edited = EditableVolume::create(model.volume);
  ASSERT_TRUE(edited) << edited.error().message;
  const std::uint64_t room = 4 * DeviceVolume::bytesFor(model.volume.words().size());
  const test::Host::Buffer words = host_->makeBuffer(room);
  std::memcpy(words.bytes, model.volume.words().data(), model.volume.words().size_bytes());
  Placed placed = place(model, model.rays.size());
  placed.volume = *DeviceVolume::withRoom({words.buffer, 0, room}, model.volume);
  placed.trace.emplace(*placed.recorder.bind(placed.volume, buffersOf(placed, model, model.rays.size())));
  for (int frame = 0; frame < 4; ++frame) {
    ASSERT_TRUE(
        edited->apply(*makeSphereChange({3 * frame, 8, 7}, 3 + frame, frame % 2 == 0 ? 0xff00ffff : 0)));
    const auto volume = edited->volume();
    const std::vector<WordRange> changes = edited->takeChanges();
    std::uint64_t changed = 0;
    for (const WordRange &range : changes)
      changed += (range.end - range.first) * sizeof(std::uint32_t);
    host_->submit([&](VkCommandBuffer commands) {
      const auto bytes = recordUpdate(*device_, commands, placed.volume, *volume, changes);
      ASSERT_TRUE(bytes) << bytes.error().message;
      EXPECT_EQ(*bytes, changed);
      ASSERT_TRUE(recordTrace(commands, {&*placed.trace, countOf(model)}));
    });
    const CpuKernel kernel = *compileCpuKernel(volume->format(), {.start = CpuStart::Fast});
    ASSERT_TRUE((*createCpuTracer(kernel, *volume))->trace(model.rays, model.expected));
    expectHits(placed, model);
  }
  const auto small = DeviceVolume::withRoom(
      {words.buffer, 0, DeviceVolume::bytesFor(model.volume.words().size())}, model.volume);
  ASSERT_TRUE(small);
  const auto failed = recordUpdate(*device_, VK_NULL_HANDLE, *small, *edited->volume(), {});
  ASSERT_FALSE(failed);
  EXPECT_THAT(failed.error().message, HasSubstr("one with more room is bound anew"));
}

TEST_F(RecorderTest, TracesRaysWithBounds) {
  Model model = makeModel("R(1,1,1) G(3)", 7, 3000);
  Format format = model.volume.format();
  format.setAttribute(kBoundsAttribute, "yes");
  std::vector<BoundedRay> rays;
  for (const Ray &ray : model.rays)
    rays.push_back(bounded(ray, {float(rays.size() % 8), 20}));
  ASSERT_TRUE((*createCpuTracer(*compileCpuKernel(format, {.start = CpuStart::Fast}), model.volume))
                  ->trace(rays, model.expected));
  const Kernel kernel = *compileKernel(format, {.loops = device_->info().loops});
  const std::uint64_t bytes = rays.size() * sizeof(BoundedRay);
  Placed placed{*DeviceVolume::upload(*device_, model.volume, Addressing::Buffer),
                *TraceRecorder::create(*device_, kernel),
                host_->makeBuffer(bytes),
                host_->makeBuffer(rays.size() * sizeof(Hit)),
                host_->makeBuffer(scratchBytes(rays.size())),
                {}};
  std::memcpy(placed.rays.bytes, rays.data(), bytes);
  TraceBuffers buffers = buffersOf(placed, model, rays.size());
  buffers.rays.bytes = bytes;
  auto bound = placed.recorder.bind(placed.volume, buffers);
  ASSERT_TRUE(bound) << bound.error().message;
  EXPECT_EQ(bound->rays(), rays.size());
  host_->submit(
      [&](VkCommandBuffer commands) { ASSERT_TRUE(recordTrace(commands, {&*bound, countOf(model)})); });
  expectHits(placed, model);
}

TEST_F(RecorderTest, TracesInPartsWhereScratchMemoryIsSmall) {
  const Model tree = makeModel("G(4)", 7, 3000), grid = makeModel("R(4,4,4)", 6, 2000);
  const Placed a = place(tree, 700), b = place(grid, 1000);
  host_->submit([&](VkCommandBuffer commands) {
    const RecordedTrace traces[] = {{&*a.trace, countOf(tree)}, {&*b.trace, countOf(grid)}};
    ASSERT_TRUE(recordTraces(commands, traces));
  });
  expectHits(a, tree);
  expectHits(b, grid);
}

TEST_F(RecorderTest, TracesSomeOfTheRaysAgainAndAgain) {
  const Model model = makeModel("S(4)", 7, 3000);
  const Placed placed = place(model, model.rays.size());
  const std::uint32_t half = countOf(model) / 2;
  host_->submit([&](VkCommandBuffer commands) {
    ASSERT_TRUE(recordTrace(commands, {&*placed.trace, half, 0}));
    ASSERT_TRUE(recordTrace(commands, {&*placed.trace, countOf(model) - half, half}));
    ASSERT_TRUE(recordTrace(commands, {&*placed.trace, half, 0}));
    ASSERT_TRUE(recordTrace(commands, {&*placed.trace, 0, half}));
  });
  expectHits(placed, model);
}

TEST_F(RecorderTest, ReadsWordsFromSegments) {
  if (!device_->info().deviceAddresses)
    GTEST_SKIP() << device_->info().name << " has no device addresses";
  const Model model = makeModel("G(4)", 7, 1000);
  const Placed placed = place(model, model.rays.size(), Addressing::Segments);
  host_->submit([&](VkCommandBuffer commands) {
    ASSERT_TRUE(recordTrace(commands, {&*placed.trace, countOf(model)}));
  });
  expectHits(placed, model);
}

TEST_F(RecorderTest, ReadsWordsThatTheHostHasBroughtThere) {
  const Model model = makeModel("G(4)", 7, 1000);
  Placed placed = place(model, model.rays.size());
  const auto words = model.volume.words();
  constexpr VkDeviceSize kOffset = 4096;
  const auto buffer = host_->makeBuffer(kOffset + DeviceVolume::bytesFor(words.size()));
  std::memcpy(buffer.bytes + kOffset, words.data(), words.size_bytes());
  const auto volume =
      DeviceVolume::in({buffer.buffer, kOffset, DeviceVolume::bytesFor(words.size())}, model.volume);
  ASSERT_TRUE(volume) << volume.error().message;
  auto bound = placed.recorder.bind(*volume, buffersOf(placed, model, model.rays.size()));
  ASSERT_TRUE(bound) << bound.error().message;
  host_->submit(
      [&](VkCommandBuffer commands) { ASSERT_TRUE(recordTrace(commands, {&*bound, countOf(model)})); });
  expectHits(placed, model);
  EXPECT_FALSE(DeviceVolume::in({buffer.buffer, 0, 16}, model.volume));
}

TEST_F(RecorderTest, AnAdoptedDeviceServesTracersToo) {
  const Model model = makeModel("R(1,1,1) G(3)", 7, 2000);
  auto tracer = createTracer(*device_, kernelFor(*device_, model), model.volume);
  ASSERT_TRUE(tracer) << tracer.error().message;
  std::vector<Hit> hits(model.rays.size());
  ASSERT_TRUE((*tracer)->trace(model.rays, hits));
  EXPECT_EQ(std::memcmp(hits.data(), model.expected.data(), hits.size() * sizeof(Hit)), 0);
}

TEST_F(RecorderTest, TracesOnADeviceThatWasOpenedWithoutFeatures) {
  openHost(true);
  EXPECT_EQ(device_->info().arithmetic, Arithmetic::Nearest); // Which needs no feature.
  EXPECT_FALSE(device_->info().deviceAddresses);
  const Model model = makeModel("R(1,1,1) G(3)", 7, 2000);
  const Placed placed = place(model, model.rays.size());
  host_->submit([&](VkCommandBuffer commands) {
    ASSERT_TRUE(recordTrace(commands, {&*placed.trace, countOf(model)}));
  });
  expectHits(placed, model);
}

TEST_F(RecorderTest, RefusesKernelsThatTheDeviceWasNotOpenedFor) {
  openHost(true);
  auto kernel = compileKernel(*parseFormat("R(8,1,1) G(3)"), {.arithmetic = Arithmetic::Ieee});
  ASSERT_TRUE(kernel);
  kernel->arithmetic = Arithmetic::Any; // Its doubles are to be refused, not what it says of itself.
  const auto recorder = TraceRecorder::create(*device_, *kernel);
  ASSERT_FALSE(recorder);
  EXPECT_THAT(recorder.error().message, HasSubstr("opened without"));
}

TEST_F(RecorderTest, RefusesWhatDoesNotFit) {
  const Model model = makeModel("G(4)", 7, 100), other = makeModel("S(4)", 7, 100);
  const Placed placed = place(model, 100), others = place(other, 100);
  const auto problem = [&](auto change) {
    TraceBuffers buffers = buffersOf(placed, model, 100);
    change(buffers);
    const auto bound = placed.recorder.bind(placed.volume, buffers);
    return bound ? std::string() : bound.error().message;
  };
  EXPECT_EQ(problem([](TraceBuffers &) {}), "");
  EXPECT_THAT(problem([](TraceBuffers &b) { b.rays.buffer = VK_NULL_HANDLE; }),
              HasSubstr("rays has no buffer"));
  EXPECT_THAT(problem([](TraceBuffers &b) { b.hits.bytes = 20; }), HasSubstr("at least 24"));
  EXPECT_THAT(problem([](TraceBuffers &b) { b.hits.offset = 3; }), HasSubstr("multiple of"));
  EXPECT_THAT(problem([](TraceBuffers &b) { b.scratch.bytes = 64; }), HasSubstr("scratch memory"));
  EXPECT_THAT(problem([](TraceBuffers &b) { b.rays.bytes = VkDeviceSize{1} << 40; }), HasSubstr("at once"));
  const auto bound = placed.recorder.bind(others.volume, buffersOf(placed, model, 100));
  ASSERT_FALSE(bound);
  EXPECT_THAT(bound.error().message, HasSubstr("S(4)"));
}

TEST_F(RecorderTest, RefusesTracesThatCannotBeRecorded) {
  const Model model = makeModel("G(4)", 7, 100);
  const Placed placed = place(model, 100);
  host_->submit([&](VkCommandBuffer commands) {
    EXPECT_FALSE(recordTrace(commands, {&*placed.trace, countOf(model), 1}));
    const RecordedTrace twice[] = {{&*placed.trace, 10, 0}, {&*placed.trace, 10, 10}};
    const auto recorded = recordTraces(commands, twice);
    ASSERT_FALSE(recorded);
    EXPECT_THAT(recorded.error().message, HasSubstr("one scratch memory"));
    EXPECT_TRUE(recordTraces(commands, {}));
  });
}

TEST(HostDevice, MustBeThere) {
  const auto device = adoptDevice({});
  ASSERT_FALSE(device);
  EXPECT_EQ(device.error().kind, ErrorKind::Usage);
  EXPECT_THAT(device.error().message, HasSubstr("instance"));
}

TEST(HostDevice, MustHaveAQueueThatComputes) {
  const auto host = test::Host::open();
  if (!host)
    GTEST_SKIP() << "there is no Vulkan device";
  HostDevice wrong = host->device;
  wrong.queueFamily = 1000;
  const auto device = adoptDevice(wrong);
  ASSERT_FALSE(device);
  EXPECT_THAT(device.error().message, HasSubstr("queue family 1000"));
}

} // namespace
} // namespace voxc
