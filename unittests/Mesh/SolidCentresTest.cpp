// Solids by the centres of their cells, held against winding numbers by solid angles.
#include "SceneTesting.h"
#include "SolidTesting.h"
#include "TestLength.h"

#include <numbers>
#include <random>

namespace voxc::test {
namespace {

VoxelizeOptions centresAt(int resolution) { return optionsAt(resolution, Coverage::Centre); }

Expected<SolidMesh> centred(const std::shared_ptr<TriangleScene> &scene, const VoxelizeOptions &options,
                            unsigned threads = 1) {
  const auto memory = WorkingMemory::create(std::uint64_t{1} << 26);
  auto surface = makeMeshSource(scene, options, memory);
  EXPECT_TRUE(surface) << surface.error().message;
  return centreMesh(*scene, options, std::move(*surface), kFill, {memory, threads, options.progress});
}

Voxels centresOf(const Soup &soup, const VoxelizeOptions &options, bool *isDoubleSided = nullptr) {
  auto solid = centred(soupOf(soup), options);
  EXPECT_TRUE(solid) << solid.error().message;
  if (isDoubleSided)
    *isDoubleSided = solid && solid->isDoubleSided;
  return solid ? voxelsOf(*solid->source) : Voxels{};
}

/// Every cell whose centre, moved by `step` as the rule says, the mesh winds about: white where a triangle
/// touches it.
void expectCentres(const Soup &soup, int resolution, double step = 1e-6) {
  VoxelizeOptions options = centresAt(resolution);
  bool isDoubleSided = false;
  const Voxels solid = centresOf(soup, options, &isDoubleSided);
  // Surfaces drawn at random may lie on each other, one facing the other way: winding numbers miss them.
  if (isDoubleSided)
    return;
  options.coverage = Coverage::Conservative;
  const Voxels touched =
      voxelsOf(**makeMeshSource(soupOf(soup), options, WorkingMemory::create(std::uint64_t{1} << 26)));
  Voxels expected;
  for (Int3 cell; cell.z < resolution; ++cell.z)
    for (cell.y = 0; cell.y < resolution; ++cell.y)
      for (cell.x = 0; cell.x < resolution; ++cell.x) {
        const glm::dvec3 centre(cell.x + 0.5 + step, cell.y + 0.5 + step * step,
                                cell.z + 0.5 + step * step * step);
        if (windingAt(soup, centre / double(resolution)) == 0)
          continue;
        const auto there = touched.find(mortonCode(cell));
        expected[mortonCode(cell)] = there == touched.end() ? kFill : there->second;
      }
  ASSERT_EQ(solid, expected);
}

TEST(SolidCentres, AreThoseThatTheMeshWindsAbout) {
  expectCentres(sphere(0.4), 24);
  expectCentres(flipped(sphere(0.4)), 24);
  expectCentres(torus(0.3, 0.12), 24);
  expectCentres(joined(sphere(0.45), flipped(sphere(0.25))), 24);
  // Thinner than a voxel: some centres are in it, all the same.
  expectCentres(box({0.1f, 0.1f, 0.51f}, {0.9f, 0.9f, 0.54f}), 16);
}

TEST(SolidCentres, OnTheSurfaceAreDecidedByTheSameRuleEverywhere) {
  // Faces through centres: those at the low ends belong to the box, those at the high ends do not.
  for (const float low : {4.0f / 16, 4.5f / 16})
    expectCentres(cube(low, low + 0.5f), 16, 1e-3);
  EXPECT_EQ(centresOf(cube(4.5f / 16, 12.5f / 16), centresAt(16)).size(), 512u);
  // Boxes that share such faces share no cell, and leave none out.
  const Soup whole = cube(4.5f / 16, 12.5f / 16);
  const Soup parts = joined(box({4.5f / 16, 4.5f / 16, 4.5f / 16}, {8.5f / 16, 12.5f / 16, 12.5f / 16}),
                            box({8.5f / 16, 4.5f / 16, 4.5f / 16}, {12.5f / 16, 12.5f / 16, 12.5f / 16}));
  EXPECT_EQ(centresOf(parts, centresAt(16)).size(), centresOf(whole, centresAt(16)).size());
}

TEST(SolidCentres, OfRandomClosedSurfaces) {
  std::mt19937 random(1);
  for (int round = 0; round < rounds(12); ++round) {
    std::vector<Corner> points(6);
    // Every other time all corners are at centres of cells, so that rows meet them in every way; else on the
    // steps that corners snap to.
    for (Corner &point : points)
      for (float &coordinate : point)
        coordinate = round % 2 == 0 ? (static_cast<float>(random() % 16) + 0.5f) / 16
                                    : static_cast<float>(random() % 0x10001) / 0x10000;
    Soup soup;
    for (int i = 0; i < 4; ++i) {
      std::array<Corner, 4> t;
      for (Corner &corner : t)
        corner = points[random() % points.size()];
      soup =
          joined(std::move(soup), {t[0], t[1], t[2], t[0], t[3], t[1], t[1], t[3], t[2], t[2], t[3], t[0]});
    }
    SCOPED_TRACE(round);
    // Planes through centres pass by others at a 500th of a voxel or more.
    expectCentres(soup, 16, round % 2 == 0 ? 1e-3 : 1e-6);
  }
}

/// Whatever is the matter with a mesh, as long as it can be closed: a cell that no voxel of its surface fills
/// is filled if and only if its centre is inside. So no rule lets an inside and an outside be one part.
TEST(SolidCentres, AreWhatIsFilledBesideTheSurface) {
  std::mt19937 random(5);
  int closed = 0;
  for (int round = 0; round < rounds(120); ++round) {
    std::vector<Corner> points(7);
    for (Corner &point : points)
      for (float &coordinate : point)
        coordinate = round % 3 == 0 ? static_cast<float>(random() % 1000) / 1000
                                    : static_cast<float>(random() % 33) / 32;
    Soup soup;
    for (int i = 0; i < 5; ++i) {
      std::array<Corner, 4> t;
      for (Corner &corner : t)
        corner = points[random() % points.size()];
      Soup body{t[0], t[1], t[2], t[0], t[3], t[1], t[1], t[3], t[2], t[2], t[3], t[0]};
      if (random() % 4 == 0)
        body = joined(body, flipped(body));
      // A side in two parts, the corner between them on an edge or beside it; a side that is turned, or
      // missing.
      if (random() % 3 == 0) {
        const Corner middle{(t[0][0] + t[1][0]) / 2 + static_cast<float>(random() % 2) / 256,
                            (t[0][1] + t[1][1]) / 2, (t[0][2] + t[1][2]) / 2};
        body = joined({body.begin() + 3, body.end()}, {t[0], middle, t[2], middle, t[1], t[2]});
      }
      if (random() % 6 == 0)
        std::swap(body[0], body[1]);
      if (random() % 6 == 0)
        body.erase(body.begin(), body.begin() + 3);
      soup = joined(std::move(soup), body);
    }
    const auto scene = soupOf(soup);
    auto options = centresAt(16);
    auto solid = centred(scene, options);
    if (!solid)
      continue;
    ++closed;
    const Voxels centres = voxelsOf(*solid->source);
    for (const Coverage coverage : {Coverage::Conservative, Coverage::Thin, Coverage::Inner}) {
      options.coverage = coverage;
      const auto memory = WorkingMemory::create(std::uint64_t{1} << 26);
      auto surface = makeMeshSource(scene, options, memory);
      Voxels expected = voxelsOf(**surface);
      for (const auto &[code, word] : centres)
        expected.emplace(code, kFill);
      const auto filled = fillMesh(*scene, options, std::move(*surface), kFill, {memory});
      ASSERT_TRUE(filled);
      ASSERT_EQ(voxelsOf(*filled->source), expected) << round << " " << static_cast<int>(coverage);
    }
  }
  EXPECT_GT(closed, rounds(120) / 4);
}

TEST(SolidCentres, HaveTheVolumeOfTheBody) {
  const double radius = 0.4;
  const double ball = 4.0 / 3 * std::numbers::pi * radius * radius * radius;
  const Soup soup = sphere(radius, {0.5f, 0.5f, 0.5f}, 64);
  for (const int resolution : {32, 64, 128}) {
    const auto voxels = static_cast<double>(centresOf(soup, centresAt(resolution)).size());
    EXPECT_NEAR(voxels / std::pow(resolution, 3) / ball, 1, 0.006) << resolution;
  }
}

TEST(SolidCentres, OnSeveralThreadsAndOfMoreCellsThanABatchAreTheSame) {
  const auto scene = soupOf(sphere(0.45));
  auto options = centresAt(100);
  EXPECT_EQ(voxelsOf(*centred(scene, options, 3)->source), voxelsOf(*centred(scene, options)->source));
  // Three million cells that triangles touch.
  options = centresAt(700);
  auto solid = centred(soupOf(cube(10.5f / 700, 689.5f / 700)), options);
  ASSERT_TRUE(solid);
  EXPECT_EQ(solid->voxels, 678u * 678 * 678);
  Int3 cell{10, 350, 350};
  std::uint32_t word = 0;
  // The low face lies through centres, the high one too.
  for (const auto &[x, expected] :
       {std::pair{9, 0u}, {10, 0xffffffffu}, {11, kFill}, {688, kFill}, {689, 0u}}) {
    cell.x = x;
    ASSERT_TRUE(solid->source->read({cell, 0}, &word));
    EXPECT_EQ(word, expected) << x;
  }
}

TEST(SolidCentres, OfWhatIsNotClosedAreAnError) {
  Soup bin = cube(0.2f, 0.8f);
  bin.resize(30);
  const auto solid = centred(soupOf(bin), centresAt(8));
  ASSERT_FALSE(solid);
  EXPECT_EQ(solid.error().kind, ErrorKind::Input);
  EXPECT_EQ(solid.error().message.find("the mesh is not closed, so that no centre lies inside it: 4 edges"),
            0u);
  // A small hole is closed.
  Soup open = sphere(0.4);
  open.erase(open.begin() + 1200, open.begin() + 1203);
  EXPECT_EQ(centresOf(open, centresAt(30)).size(), centresOf(sphere(0.4), centresAt(30)).size());
}

} // namespace
} // namespace voxc::test
