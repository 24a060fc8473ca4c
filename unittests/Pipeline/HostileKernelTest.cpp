// Whatever words pass the structure check, kernels find in every cell what lookups find there.
#include "TestLength.h"

#include "testing/HardScenes.h"
#include "testing/RandomFormat.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/Kernel/CompileCpu.h"

#include <gtest/gtest.h>

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

TEST(HostileKernel, FindsInEveryCellWhatLookupsFind) {
  std::mt19937 random(3);
  int passed = 0;
  for (int i = 0; i < test::rounds(16); ++i) {
    const Format format = test::randomFormat(random, 3);
    const auto kernel = compileCpuKernel(format);
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
      VolumeInfo info;
      info.format = storageFormat(format);
      info.extent = format.extent();
      info.voxels = *voxels;
      ASSERT_EQ(differences(Volume(std::move(info), std::move(words)), *kernel, rays), 0) << printIr(format);
    }
  }
  EXPECT_GT(passed, 200);
}

} // namespace
} // namespace voxc
