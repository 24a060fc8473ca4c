// The oracle between two moments: by rationals, voxel by voxel.
#include "BruteForce.h"

#include "testing/HardRays.h"
#include "testing/HardScenes.h"
#include "voxc/Oracle/VerifyRays.h"

#include <gtest/gtest.h>

#include <cstring>

namespace voxc::test {
namespace {

constexpr Int3 kExtent{6, 5, 7};

std::vector<Voxel> voxelsOf(const HardScene &scene) {
  std::vector<Voxel> voxels;
  for (Int3 cell; cell.z < kExtent.z; ++cell.z)
    for (cell.y = 0; cell.y < kExtent.y; ++cell.y)
      for (cell.x = 0; cell.x < kExtent.x; ++cell.x)
        if (const std::uint32_t word = scene.voxel(cell); word != 0)
          voxels.push_back({cell, word});
  return voxels;
}

TEST(OracleBounds, AreThoseOfRationals) {
  int within = 0, beyond = 0;
  std::uint64_t seed = 1;
  for (const HardScene &scene : hardScenes(kExtent)) {
    const Oracle oracle = *Oracle::of(*scene.source());
    const std::vector<Voxel> voxels = voxelsOf(scene);
    for (const HardRayClass &row : hardRayClasses()) {
      const auto aimed = oracle.sampleVoxels(16);
      const auto rays = hardRays({kExtent, aimed}, row.name, 8, ++seed);
      for (const BoundedRay &ray : withHardBounds(oracle, rays, seed)) {
        const Hit expected = bruteForce(voxels, ray.ray(), ray.bounds());
        const Hit hit = oracle.trace(ray.ray(), ray.bounds());
        ASSERT_EQ(std::memcmp(&hit, &expected, sizeof hit), 0)
            << scene.name << ", " << row.name << std::hexfloat << " from " << ray.tmin << " to " << ray.tmax
            << ": t = " << hit.t << ", and not " << expected.t;
        const Hit closest = oracle.trace(ray.ray());
        within += hit.isHit() && std::memcmp(&hit, &closest, sizeof hit) != 0;
        beyond += !hit.isHit() && closest.isHit();
      }
    }
  }
  EXPECT_GT(within, 300); // The bounds leave some rays another voxel,
  EXPECT_GT(beyond, 300); // and others none.
}

TEST(OracleBounds, OfManyRaysAreTheirOwn) {
  const HardScene scene = hardScenes(kExtent)[1];
  const Oracle oracle = *Oracle::of(*scene.source());
  const std::vector<BoundedRay> rays = {{{-1, 1, 1}, 0, {1, 0, 0}, 9}, {{-1, 1, 1}, 1.5f, {1, 0, 0}, 9}};
  const auto hits = oracle.trace(rays);
  ASSERT_TRUE(hits);
  EXPECT_EQ((*hits)[0].voxel[0], 0);
  EXPECT_EQ((*hits)[1].voxel[0], 1);
  EXPECT_EQ(oracle.explain(rays[1].ray(), 3, rays[1].bounds()).face, (Face{0, -1}));
  EXPECT_TRUE(compare(oracle, rays, *hits).clean());
}

} // namespace
} // namespace voxc::test
