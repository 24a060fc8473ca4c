// The exact traversal against brute force in rational arithmetic, on every class of hard rays.
#include "testing/HardRays.h"

#include "../../lib/Oracle/ExactTraversal.h"
#include "BruteForce.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace voxc::test {
namespace {

struct Scene {
  const char *name;
  Int3 extent;
  std::size_t voxels; // At most; scattered, the low and high corner of the extent among them.
  std::size_t rays;   // Of each class.
};

constexpr Scene kScenes[] = {
    {"one", {1, 1, 1}, 1, 200},         {"two", {2, 2, 2}, 3, 400},
    {"four", {4, 4, 4}, 16, 400},       {"eight", {8, 8, 8}, 100, 100},
    {"flat", {16, 1, 4}, 20, 200},      {"sparse", {64, 64, 64}, 40, 200},
    {"wide", {4096, 2, 1024}, 40, 150}, {"largest", {1 << 21, 1 << 21, 1 << 21}, 30, 200},
};

std::vector<Voxel> scatter(const Scene &scene) {
  std::mt19937 random(7);
  const auto below = [&](int bound) { return static_cast<int>(random() % static_cast<unsigned>(bound)); };
  std::vector<Voxel> voxels{{{0, 0, 0}, 1}, {scene.extent - Int3{1, 1, 1}, 2}};
  while (voxels.size() < scene.voxels) {
    const Int3 cell{below(scene.extent.x), below(scene.extent.y), below(scene.extent.z)};
    voxels.push_back({cell, static_cast<std::uint32_t>(voxels.size() + 1)});
  }
  const auto code = [](const Voxel &voxel) { return mortonCode(voxel.cell); };
  std::ranges::stable_sort(voxels, {}, code);
  const auto repeated = std::ranges::unique(voxels, {}, code);
  voxels.erase(repeated.begin(), repeated.end());
  return voxels;
}

VoxelRuns runsOf(const std::vector<Voxel> &voxels, Int3 extent) {
  VoxelRuns runs(extent);
  for (const Voxel &voxel : voxels)
    runs.add({voxel.cell, 0}, voxel.word);
  runs.finish();
  return runs;
}

std::string describe(const Hit &hit) {
  std::ostringstream text;
  text << std::hexfloat << hit.voxel[0] << ' ' << hit.voxel[1] << ' ' << hit.voxel[2] << " t " << hit.t;
  return text.str();
}

std::string describe(const Ray &ray) {
  std::ostringstream text;
  text << std::hexfloat;
  for (float component : ray.origin)
    text << component << ' ';
  for (float component : ray.direction)
    text << component << ' ';
  return text.str();
}

bool operator==(const Hit &a, const Hit &b) {
  return std::ranges::equal(a.voxel, b.voxel) && a.rgba == b.rgba &&
         std::bit_cast<std::uint32_t>(a.t) == std::bit_cast<std::uint32_t>(b.t);
}

class ExactTraversal : public testing::TestWithParam<Scene> {};

TEST_P(ExactTraversal, AgreesWithBruteForceOnHardRays) {
  const Scene &scene = GetParam();
  const std::vector<Voxel> voxels = scatter(scene);
  const VoxelRuns runs = runsOf(voxels, scene.extent);
  std::size_t hits = 0, rays = 0;
  for (const test::HardRayClass &row : test::hardRayClasses()) {
    for (const Ray &ray : test::hardRays(scene.extent, row.name, scene.rays, 42)) {
      const Hit expected = bruteForce(voxels, ray);
      const Hit hit = traceExactly(runs, ray);
      ASSERT_TRUE(hit == expected) << row.name << " ray " << describe(ray) << ": " << describe(hit)
                                   << " instead of " << describe(expected);
      hits += hit.isHit();
      ++rays;
    }
  }
  EXPECT_GT(hits, std::size_t{0});
  EXPECT_LT(hits, rays);
}

INSTANTIATE_TEST_SUITE_P(Scenes, ExactTraversal, testing::ValuesIn(kScenes),
                         [](const auto &parameter) { return std::string(parameter.param.name); });

// Tiny grids reach every relation of boundaries when origin and direction are small whole numbers and halves.
TEST(ExactTraversalLattice, AgreesWithBruteForceOnEverySmallRay) {
  const Int3 extent{2, 2, 2};
  std::size_t traced = 0;
  for (unsigned filled : {0x81u, 0x42u, 0x24u, 0x18u, 0x16u, 0xfeu}) {
    std::vector<Voxel> voxels;
    for (unsigned code = 0; code < 8; ++code)
      if (filled >> code & 1)
        voxels.push_back({mortonCell(code), code + 1});
    const VoxelRuns runs = runsOf(voxels, extent);
    for (int origin = 0; origin < 7 * 7 * 7; ++origin)
      for (int direction = 0; direction < 27; ++direction) {
        const float half = 0.5f;
        const Ray ray{{half * static_cast<float>(origin % 7 - 1),
                       half * static_cast<float>(origin / 7 % 7 - 1),
                       half * static_cast<float>(origin / 49 - 1)},
                      {static_cast<float>(direction % 3 - 1), static_cast<float>(direction / 3 % 3 - 1),
                       static_cast<float>(direction / 9 - 1)}};
        ASSERT_TRUE(traceExactly(runs, ray) == bruteForce(voxels, ray)) << describe(ray);
        ++traced;
      }
  }
  EXPECT_EQ(traced, std::size_t{6 * 343 * 27});
}

} // namespace
} // namespace voxc::test
