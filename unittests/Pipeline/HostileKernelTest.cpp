// Whatever words pass the structure check, kernels find in every cell what lookups find there, and a device
// finds on every ray what this processor does. The validation layer's GPU-assisted checks look at every
// access of the device if VK_LAYER_ENABLES asks for them.
#include "TestLength.h"

#include "testing/HardScenes.h"
#include "testing/RandomFormat.h"
#include "testing/RandomRays.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/Kernel/Compile.h"
#include "voxc/Kernel/CompileCpu.h"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>

namespace voxc {
namespace {

using Words = std::vector<std::uint32_t>;

/// Empties a word, flips a bit, or writes what stands elsewhere.
void mutate(Words &words, std::mt19937 &random) {
  std::uint32_t &word = words[random() % words.size()];
  switch (test::pick(random, 0, 3)) {
  case 0:
    word = 0;
    break;
  case 1:
    word = words[random() % words.size()];
    break;
  default:
    word ^= 1u << random() % 32;
  }
}

/// A ray without a direction for every cell of the format: it asks for that cell alone, whatever a volume
/// says of distances.
std::vector<Ray> raysInCells(Int3 extent) {
  std::vector<Ray> rays;
  for (Int3 c; c.z < extent.z; ++c.z)
    for (c.y = 0; c.y < extent.y; ++c.y)
      for (c.x = 0; c.x < extent.x; ++c.x)
        rays.push_back({{c.x + 0.5f, c.y + 0.5f, c.z + 0.5f}, {0, 0, 0}});
  return rays;
}

/// How many cells the kernel and lookups do not agree on.
int differences(const Volume &volume, const CpuKernel &kernel, const std::vector<Ray> &rays) {
  std::vector<Hit> hits(rays.size());
  const auto tracer = createCpuTracer(kernel, volume, 1);
  EXPECT_TRUE((*tracer)->trace(rays, hits));
  int different = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Int3 cell = {static_cast<int>(rays[i].origin[0]), static_cast<int>(rays[i].origin[1]),
                       static_cast<int>(rays[i].origin[2])};
    const std::uint32_t word = volume.lookup(cell).value;
    different += (hits[i].voxel[0] >= 0) != (word != 0) || (word != 0 && hits[i].rgba != word) ? 1 : 0;
  }
  return different;
}

Volume volumeOf(const Format &format, std::uint64_t voxels, Words words) {
  VolumeInfo info;
  info.format = storageFormat(format);
  info.extent = format.extent();
  info.voxels = voxels;
  return {std::move(info), std::move(words)};
}

TEST(HostileKernel, FindsInEveryCellWhatLookupsFind) {
  std::mt19937 random(3);
  int passed = 0;
  for (int i = 0; i < test::rounds(16); ++i) {
    const Format format = test::randomFormat(random, 3);
    const auto kernel = compileCpuKernel(format, {.start = CpuStart::Fast});
    ASSERT_TRUE(kernel) << kernel.error().message;
    const auto scenes = test::hardScenes(format.extent());
    const auto built = Constructor::compile(format)->build(*scenes[random() % scenes.size()].source());
    ASSERT_TRUE(built) << built.error().message;
    const auto rays = raysInCells(format.extent());
    for (int mutation = 0; mutation < 400; ++mutation) {
      Words words(built->volume.words().begin(), built->volume.words().end());
      mutate(words, random);
      const auto voxels = checkStructure(format, words);
      if (!voxels)
        continue;
      ++passed;
      ASSERT_EQ(differences(volumeOf(format, *voxels, std::move(words)), *kernel, rays), 0)
          << printIr(format);
    }
  }
  EXPECT_GT(passed, 200);
}

/// Traces on both; the volume takes the place of the one before.
class BothTracers {
public:
  BothTracers(Device &device, const Format &format, Addressing addressing,
              std::shared_ptr<const Volume> volume)
      : volume_(std::move(volume)) {
    const auto cpu = compileCpuKernel(format, {.start = CpuStart::Fast});
    const auto kernel = compileKernel(format, {addressing, device.info().loops, device.info().arithmetic});
    tracers_[0] = std::move(*createCpuTracer(*cpu, *volume_, 1));
    tracers_[1] = std::move(*createTracer(device, *kernel, *volume_, 1));
  }

  bool agreeOn(std::shared_ptr<const Volume> volume, const std::vector<Ray> &rays) {
    std::vector<Hit> hits[2];
    for (int i = 0; i < 2; ++i) {
      EXPECT_TRUE(tracers_[i]->update(*volume_, *volume));
      hits[i].resize(rays.size());
      EXPECT_TRUE(tracers_[i]->trace(rays, hits[i]));
    }
    volume_ = std::move(volume);
    return std::memcmp(hits[0].data(), hits[1].data(), rays.size() * sizeof(Hit)) == 0;
  }

private:
  std::shared_ptr<const Volume> volume_;
  std::unique_ptr<Tracer> tracers_[2];
};

/// Flips bits of a volume, all of them or evenly spread ones, and counts those that pass the structure check.
int flipBits(Device &device, const Format &format, Addressing addressing, std::mt19937 &random) {
  const auto scenes = test::hardScenes(format.extent());
  auto built = Constructor::compile(format)->build(*scenes[random() % scenes.size()].source());
  const auto sound = std::make_shared<const Volume>(std::move(built->volume));
  const std::vector<Ray> rays = test::raysInto(format.extent(), 256, random);
  BothTracers tracers(device, format, addressing, sound);
  const std::size_t bits = sound->words().size() * 32;
  const std::size_t step = std::max<std::size_t>(1, bits / test::rounds(500));
  int passed = 0;
  for (std::size_t bit = 0; bit < bits; bit += step) {
    Words words(sound->words().begin(), sound->words().end());
    words[bit / 32] ^= 1u << bit % 32;
    const auto voxels = checkStructure(format, words);
    if (!voxels)
      continue;
    ++passed;
    EXPECT_TRUE(
        tracers.agreeOn(std::make_shared<const Volume>(volumeOf(format, *voxels, std::move(words))), rays))
        << printIr(format) << " bit " << bit;
  }
  return passed;
}

TEST(HostileKernel, HasTheHitsOfThisProcessorOnADevice) {
  auto device = Device::open();
  if (!device)
    GTEST_SKIP() << device.error().message;
  std::mt19937 random(4);
  int passed = 0;
  for (int i = 0; i < test::rounds(12); ++i)
    passed += flipBits(*device, test::randomFormat(random, 3),
                       i % 3 == 0 ? Addressing::Texels : Addressing::Buffer, random);
  EXPECT_GT(passed, 1000);
}

} // namespace
} // namespace voxc
