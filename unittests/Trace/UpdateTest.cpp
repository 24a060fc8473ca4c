// A tracer that takes an edited volume has the hits of one that was made with it.
#include "TestLength.h"

#include "testing/RandomFormat.h"
#include "testing/RandomRays.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/Kernel/Compile.h"
#include "voxc/Kernel/CompileCpu.h"
#include "voxc/Kernel/OpenTracer.h"
#include "voxc/Source/Sources.h"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <random>
#include <vector>

namespace voxc {
namespace {

using SharedVolume = std::shared_ptr<const Volume>;
using OwnedTracer = std::unique_ptr<Tracer>;

constexpr int kSide = 32;

SharedVolume build(const Format &format, const char *scene, int side) {
  const auto constructor = Constructor::compile(format);
  EXPECT_TRUE(constructor) << constructor.error().message;
  const auto source = makeBuiltinSource(scene, side);
  auto built = constructor->build(**source);
  return built ? std::make_shared<const Volume>(std::move(built->volume)) : nullptr;
}

/// Null: the format's payload keeps fewer colours.
SharedVolume edit(const Constructor &constructor, const SharedVolume &volume,
                  const std::vector<VoxelEdit> &edits) {
  auto edited = constructor.edit(volume, edits);
  return edited ? std::make_shared<const Volume>(std::move(edited->volume)) : nullptr;
}

VoxelEdit randomBox(std::mt19937 &random) {
  constexpr std::uint32_t kWords[] = {0, 0xff0000ff, 0x7f102030};
  const auto pick = [&](int least, int most) { return test::pick(random, least, most); };
  const Int3 low{pick(0, kSide - 1), pick(0, kSide - 1), pick(0, kSide - 1)};
  return {low, {pick(1, kSide - low.x), pick(1, kSide - low.y), pick(1, kSide - low.z)}, kWords[pick(0, 2)]};
}

std::vector<Hit> hitsOf(Tracer &tracer, std::span<const Ray> rays) {
  std::vector<Hit> hits(rays.size());
  const auto report = tracer.trace(rays, hits);
  EXPECT_TRUE(report) << report.error().message;
  return hits;
}

bool areEqual(const std::vector<Hit> &a, const std::vector<Hit> &b) {
  return std::memcmp(a.data(), b.data(), a.size() * sizeof(Hit)) == 0;
}

/// A way to make tracers.
class BackEnd {
public:
  virtual ~BackEnd() = default;
  virtual Expected<OwnedTracer> make(const Volume &volume) const = 0;
};

class Cpu final : public BackEnd {
public:
  explicit Cpu(const Format &format) : kernel_(*compileCpuKernel(format, {.start = CpuStart::Fast})) {}
  Expected<OwnedTracer> make(const Volume &volume) const override {
    return createCpuTracer(kernel_, volume, 2);
  }

private:
  CpuKernel kernel_;
};

class OnDevice final : public BackEnd {
public:
  OnDevice(Device &device, const Format &format, Addressing addressing)
      : device_(&device),
        kernel_(*compileKernel(format, {addressing, device.info().loops, device.info().arithmetic})) {}
  Expected<OwnedTracer> make(const Volume &volume) const override {
    return createTracer(*device_, kernel_, volume, 1);
  }

private:
  Device *device_;
  Kernel kernel_;
};

/// Edits a volume again and again, and looks after each edit at what the updated tracer sees.
void expectHitsOfANewTracer(const BackEnd &backEnd, const Format &format, std::mt19937 &random) {
  const auto constructor = Constructor::compile(format);
  SharedVolume volume = build(format, "empty", kSide);
  ASSERT_TRUE(volume);
  auto tracer = backEnd.make(*volume);
  ASSERT_TRUE(tracer) << tracer.error().message;
  const std::vector<Ray> rays = test::raysInto({kSide, kSide, kSide}, 500, random);
  std::vector<Hit> before = hitsOf(**tracer, rays);
  for (int i = 0; i < 6; ++i) {
    const SharedVolume edited = edit(*constructor, volume,
                                     i == 0 ? std::vector{VoxelEdit{{0, 0, 0}, {3, 5, kSide}, 0xff00ff00}}
                                            : std::vector{randomBox(random), randomBox(random)});
    if (!edited)
      return;
    const auto updated = (*tracer)->update(*volume, *edited);
    ASSERT_TRUE(updated) << updated.error().message;
    volume = edited;
    const auto fresh = backEnd.make(*volume);
    ASSERT_TRUE(fresh);
    const std::vector<Hit> hits = hitsOf(**tracer, rays);
    EXPECT_TRUE(areEqual(hits, hitsOf(**fresh, rays))) << printIr(format) << " edit " << i;
    EXPECT_FALSE(i == 0 && areEqual(hits, before)); // The edits are seen at all.
  }
}

/// A random format that holds kSide voxels on each axis: the edits ask for all of them.
Format randomCube(std::mt19937 &random) {
  for (;;) {
    const Format format = test::randomFormat(random, 5);
    if (format.extent() == Int3{kSide, kSide, kSide})
      return format;
  }
}

std::vector<Format> formats(std::mt19937 &random) {
  std::vector<Format> all;
  for (const char *text : {"R(5^3)", "R(2^3) G(3)", "M(2^3) M(2^3) M(1^3)"})
    all.push_back(*parseFormat(text));
  for (int i = 0; i < test::rounds(4); ++i)
    all.push_back(randomCube(random));
  return all;
}

TEST(Update, GivesTheHitsOfANewTracerOnTheCpu) {
  std::mt19937 random(5);
  for (const Format &format : formats(random))
    expectHitsOfANewTracer(Cpu(format), format, random);
}

TEST(Update, GivesTheHitsOfANewTracerOnADevice) {
  auto device = Device::open();
  if (!device)
    GTEST_SKIP() << device.error().message;
  // A device compiles its kernel for each new tracer: each format is addressed in one way, and the way
  // changes from format to format.
  constexpr Addressing kAddressings[] = {Addressing::Buffer, Addressing::Segments, Addressing::Texels};
  std::mt19937 random(6);
  std::size_t next = 0;
  for (const Format &format : formats(random))
    expectHitsOfANewTracer(OnDevice(*device, format, kAddressings[next++ % std::size(kAddressings)]), format,
                           random);
}

TEST(Update, CopiesTheBlocksThatDiffer) {
  auto device = Device::open();
  if (!device)
    GTEST_SKIP() << device.error().message;
  const Format format = *parseFormat("R(6^3)");
  const auto constructor = Constructor::compile(format);
  const SharedVolume volume = build(format, "terrain", 64);
  const OnDevice backEnd(*device, format, Addressing::Buffer);
  auto tracer = backEnd.make(*volume);
  ASSERT_TRUE(tracer);
  const SharedVolume edited = edit(*constructor, volume, {{{63, 63, 63}, {1, 1, 1}, 0xff0000ff}});
  const auto one = (*tracer)->update(*volume, *edited);
  ASSERT_TRUE(one);
  EXPECT_GT(one->copiedBytes, 0u);
  EXPECT_LE(one->copiedBytes, 65536u);
  const auto none =
      (*tracer)->update(*edited, *edit(*constructor, edited, {{{63, 63, 63}, {1, 1, 1}, 0xff0000ff}}));
  ASSERT_TRUE(none);
  EXPECT_EQ(none->copiedBytes, 0u);
  const auto most =
      (*tracer)->update(*edited, *edit(*constructor, edited, {{{0, 0, 0}, {64, 64, 64}, 0xff112233}}));
  ASSERT_TRUE(most);
  EXPECT_GT(most->copiedBytes, volume->words().size_bytes() / 2);
}

TEST(Update, RefusesOtherVolumesAndStaysAsItWas) {
  const Format format = *parseFormat("R(2^3) G(3)");
  const SharedVolume volume = build(format, "terrain", kSide), other = build(format, "shell", kSide);
  const SharedVolume foreign = build(*parseFormat("G(5)"), "terrain", kSide);
  std::mt19937 random(7);
  const std::vector<Ray> rays = test::raysInto({kSide, kSide, kSide}, 500, random);
  std::vector<std::unique_ptr<BackEnd>> backEnds;
  backEnds.push_back(std::make_unique<Cpu>(format));
  auto device = Device::open();
  if (device)
    backEnds.push_back(std::make_unique<OnDevice>(*device, format, Addressing::Buffer));
  for (const auto &backEnd : backEnds) {
    auto tracer = backEnd->make(*volume);
    ASSERT_TRUE(tracer);
    const std::vector<Hit> hits = hitsOf(**tracer, rays);
    const auto wrongFormat = (*tracer)->update(*volume, *foreign);
    ASSERT_FALSE(wrongFormat);
    EXPECT_EQ(wrongFormat.error().kind, ErrorKind::Input);
    const auto wrongVolume = (*tracer)->update(*other, *volume);
    ASSERT_FALSE(wrongVolume);
    EXPECT_EQ(wrongVolume.error().kind, ErrorKind::Usage);
    EXPECT_TRUE(areEqual(hits, hitsOf(**tracer, rays)));
  }
}

TEST(Update, GoesThroughATracerThatOwnsItsDevice) {
  const Format format = *parseFormat("G(5)");
  const auto constructor = Constructor::compile(format);
  const SharedVolume volume = build(format, "terrain", kSide);
  const SharedVolume edited = edit(*constructor, volume, {{{0, 0, 0}, {32, 32, 32}, 0}});
  auto tracer = openTracer(*volume);
  ASSERT_TRUE(tracer) << tracer.error().message;
  ASSERT_TRUE((*tracer)->update(*volume, *edited));
  const Ray ray{{16.5f, 40, 16.5f}, {0, -1, 0}};
  EXPECT_FALSE(hitsOf(**tracer, {&ray, 1})[0].isHit());
  const WordRange all{0, volume->words().size()};
  ASSERT_TRUE((*tracer)->follow(*volume, {&all, 1}));
  EXPECT_TRUE(hitsOf(**tracer, {&ray, 1})[0].isHit());
}

} // namespace
} // namespace voxc
