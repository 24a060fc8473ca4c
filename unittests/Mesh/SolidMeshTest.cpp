// Solid voxels of meshes, held against winding numbers by solid angles.
#include "Mesh/Solid/RowCrossings.h"
#include "SceneTesting.h"
#include "SolidTesting.h"
#include "TestLength.h"

#include <atomic>
#include <limits>
#include <numbers>
#include <random>

namespace voxc::test {
namespace {

struct Solid {
  Voxels surface;
  Voxels voxels;
  std::uint64_t added = 0;
  SolidRule rule = SolidRule::Winding;
  OpenEdges open;
  bool isDoubleSided = false;
};

Solid solidOf(const std::shared_ptr<TriangleScene> &scene, const VoxelizeOptions &options,
              unsigned threads = 1) {
  const auto memory = WorkingMemory::create(std::uint64_t{1} << 26);
  auto surface = makeMeshSource(scene, options, memory);
  EXPECT_TRUE(surface) << surface.error().message;
  Solid solid;
  solid.surface = voxelsOf(**surface);
  auto filled = fillMesh(*scene, options, std::move(*surface), kFill, {memory, threads, options.progress});
  EXPECT_TRUE(filled) << filled.error().message;
  solid.voxels = voxelsOf(*filled->source);
  solid.added = filled->voxels;
  solid.rule = filled->rule;
  solid.open = filled->open;
  solid.isDoubleSided = filled->isDoubleSided;
  return solid;
}

Solid solidOf(const Soup &soup, const VoxelizeOptions &options) { return solidOf(soupOf(soup), options); }

/// Every cell's row is right, though only one of each part is asked: they meet edges and corners in every
/// way.
void expectWindings(const Soup &soup, const VoxelizeOptions &options,
                    const std::map<std::uint64_t, int> &windings) {
  const auto memory = WorkingMemory::create(std::uint64_t{1} << 26);
  const auto scene = soupOf(soup);
  const auto model = MeshModel::open(*scene, options, memory.get());
  ASSERT_TRUE(model);
  ScratchArray<CellCrossings> cells(memory);
  for (const auto &[code, winding] : windings)
    ASSERT_TRUE(cells.push({mortonCell(code)}));
  ASSERT_TRUE(countCrossings(*scene, *model, cells, *memory, {}));
  for (const CellCrossings &cell : cells.span())
    ASSERT_EQ(cell.winding, windings.at(mortonCode(cell.cell)))
        << cell.cell.x << " " << cell.cell.y << " " << cell.cell.z;
}

/// The surface's voxels as they are, and of the other cells those whose centres the mesh winds about.
void expectSolid(const Soup &soup, int resolution, Coverage coverage) {
  const VoxelizeOptions options = optionsAt(resolution, coverage);
  const Solid solid = solidOf(soup, options);
  EXPECT_EQ(solid.rule, SolidRule::Winding);
  EXPECT_EQ(solid.open.count, 0u);
  // Surfaces drawn at random may lie on each other, one facing the other way: winding numbers miss them.
  if (solid.isDoubleSided)
    return;
  Voxels expected = solid.surface;
  std::uint64_t added = 0;
  std::map<std::uint64_t, int> windings;
  for (Int3 cell; cell.z < resolution; ++cell.z)
    for (cell.y = 0; cell.y < resolution; ++cell.y)
      for (cell.x = 0; cell.x < resolution; ++cell.x) {
        if (expected.contains(mortonCode(cell)))
          continue;
        const glm::dvec3 centre = glm::dvec3(cell.x + 0.5, cell.y + 0.5, cell.z + 0.5) / double(resolution);
        const int winding = windings[mortonCode(cell)] = windingAt(soup, centre);
        if (winding == 0)
          continue;
        expected[mortonCode(cell)] = kFill;
        ++added;
      }
  EXPECT_EQ(solid.added, added);
  ASSERT_EQ(solid.voxels, expected);
  expectWindings(soup, options, windings);
}

void expectSolids(const Soup &soup, int resolution) {
  for (const Coverage coverage : {Coverage::Conservative, Coverage::Thin, Coverage::Inner})
    expectSolid(soup, resolution, coverage);
}

TEST(SolidMesh, IsWhatTheMeshWindsAbout) {
  expectSolids(sphere(0.4), 24);
  expectSolids(flipped(sphere(0.4)), 24);
  expectSolids(torus(0.3, 0.12), 24);
}

TEST(SolidMesh, OnTheGridsOwnPlanes) {
  // Faces on those of voxels, and through their centres: rows meet diagonals, edges and corners.
  for (const float low : {4.0f / 16, 4.5f / 16})
    expectSolids(cube(low, 1 - low), 16);
  // An octahedron with corners at centres, so that rows meet edges from the side too.
  const auto at = [](double x, double y, double z) {
    return Corner{static_cast<float>((8.5 + x) / 16), static_cast<float>((8.5 + y) / 16),
                  static_cast<float>((8.5 + z) / 16)};
  };
  Soup octahedron;
  for (int octant = 0; octant < 8; ++octant) {
    const int x = octant & 1 ? 6 : -6;
    const int y = octant & 2 ? 6 : -6;
    const int z = octant & 4 ? 6 : -6;
    const Soup face{at(x, 0, 0), at(0, y, 0), at(0, 0, z)};
    octahedron = joined(std::move(octahedron), x * y * z > 0 ? face : flipped(face));
  }
  expectSolids(octahedron, 16);
}

TEST(SolidMesh, OfNestedAndTouchingShells) {
  const Soup outer = cube(0.1f, 0.9f);
  // A hollow stays one if its shell faces inwards.
  expectSolids(joined(outer, flipped(cube(0.3f, 0.7f))), 20);
  expectSolids(joined(outer, cube(0.3f, 0.7f)), 20);
  expectSolids(joined(sphere(0.45), flipped(sphere(0.25))), 24);
  // Two that share a face, and two of which one reaches into the other.
  expectSolids(
      joined(box({0.1f, 0.2f, 0.2f}, {0.5f, 0.8f, 0.8f}), box({0.5f, 0.2f, 0.2f}, {0.9f, 0.8f, 0.8f})), 20);
  expectSolids(joined(cube(0.1f, 0.6f), cube(0.4f, 0.9f)), 20);
}

/// Closed surfaces whose corners are anywhere, often on the same planes, and which pass through themselves.
TEST(SolidMesh, OfRandomClosedSurfaces) {
  std::mt19937 random(1);
  for (int round = 0; round < rounds(12); ++round) {
    const bool isCoarse = round % 2 == 0;
    std::vector<Corner> points(6);
    for (Corner &point : points)
      for (float &coordinate : point)
        coordinate =
            isCoarse ? static_cast<float>(random() % 9) / 8 : static_cast<float>(random() % 1000) / 1000;
    Soup soup;
    // Surfaces of tetrahedra: any sum of closed surfaces is closed.
    for (int i = 0; i < 4; ++i) {
      std::array<Corner, 4> t;
      for (Corner &corner : t)
        corner = points[random() % points.size()];
      soup =
          joined(std::move(soup), {t[0], t[1], t[2], t[0], t[3], t[1], t[1], t[3], t[2], t[2], t[3], t[0]});
    }
    SCOPED_TRACE(round);
    expectSolids(soup, 16);
  }
}

TEST(SolidMesh, IsCutWhereTheVolumeEnds) {
  // The volume sees a part of the mesh, which begins far outside; the cut is filled.
  const auto moved = [](Soup soup, float by) {
    for (Corner &corner : soup)
      corner[0] -= by;
    return soup;
  };
  expectSolids(moved(sphere(0.4), 0.5f), 20);
  expectSolids(moved(cube(0.2f, 1.8f), 1), 20);
  // The volume lies in a ball of a radius of 2^20 voxels: all is inside.
  const Solid solid = solidOf(sphere(double(1 << 16)), optionsAt(16));
  EXPECT_EQ(solid.rule, SolidRule::Winding);
  EXPECT_EQ(solid.added, 16u * 16 * 16);
}

TEST(SolidMesh, HasTheVolumeOfTheBody) {
  const double radius = 0.4;
  const double ball = 4.0 / 3 * std::numbers::pi * radius * radius * radius;
  const double area = 4 * std::numbers::pi * radius * radius;
  const Soup soup = sphere(radius, {0.5f, 0.5f, 0.5f}, 64);
  double before = 1;
  for (const int resolution : {16, 32, 64, 128}) {
    const double cell = 1.0 / resolution;
    const double volume = double(solidOf(soup, optionsAt(resolution)).voxels.size()) * cell * cell * cell;
    const double excess = volume - ball;
    EXPECT_GT(excess, 0) << resolution;
    // Conservative voxels reach less than a diagonal out of the body.
    EXPECT_LT(excess, area * std::sqrt(3.0) * cell) << resolution;
    EXPECT_LT(excess, 0.6 * before) << resolution;
    before = excess;
  }
}

TEST(SolidMesh, OfAMeshWithALargeHoleIsWhatItsVoxelsEnclose) {
  // A box without a side is open, whatever its voxels.
  Soup bin = cube(0.2f, 0.8f);
  bin.resize(30);
  const Solid leaking = solidOf(bin, optionsAt(16));
  EXPECT_EQ(leaking.rule, SolidRule::Enclosure);
  EXPECT_EQ(leaking.added, 0u);
  EXPECT_EQ(leaking.voxels, leaking.surface);
  // A lid that lies on it closes it, though it has no edge in common with it.
  const Solid closed = solidOf(joined(bin, box({0.1f, 0.1f, 0.8f}, {0.9f, 0.9f, 0.9f})), optionsAt(16));
  EXPECT_EQ(closed.rule, SolidRule::Enclosure);
  EXPECT_GT(closed.added, 400u);
}

TEST(SolidMesh, WithFlippedTrianglesIsToldByParity) {
  const Soup whole = joined(sphere(0.45), flipped(sphere(0.2)));
  Soup mixed = whole;
  for (std::size_t i = 0; i < mixed.size(); i += 21)
    std::swap(mixed[i + 1], mixed[i + 2]);
  const Solid solid = solidOf(mixed, optionsAt(20));
  EXPECT_EQ(solid.rule, SolidRule::Parity);
  EXPECT_GT(solid.open.count, 100u);
  EXPECT_EQ(solid.added, solidOf(whole, optionsAt(20)).added);
}

TEST(SolidMesh, OnSeveralThreadsIsTheSame) {
  const auto scene = soupOf(joined(torus(0.3, 0.15), flipped(sphere(0.2))));
  const Solid one = solidOf(scene, optionsAt(150));
  EXPECT_EQ(solidOf(scene, optionsAt(150), 3).voxels, one.voxels);
  EXPECT_GT(one.added, 100000u);
}

TEST(SolidMesh, TakesNoNoticeOfLinesAndPoints) {
  const Soup whole = sphere(0.4);
  const Corner a{0.5f, 0.5f, 0.5f};
  const Corner b{0.3f, 0.6f, 0.4f};
  const Solid solid = solidOf(joined(whole, {a, a, a, a, b, b, a, a, b}), optionsAt(20));
  EXPECT_EQ(solid.rule, SolidRule::Winding);
  EXPECT_EQ(solid.voxels.size(), solidOf(whole, optionsAt(20)).voxels.size());
}

TEST(SolidMesh, IsFilledBehindWhatIsCutOut) {
  // The surface is all holes: nothing of it is a voxel, but it holds the inside.
  HandPart part;
  part.positions = cube(0.2f, 0.8f);
  part.uvs.resize(part.positions.size());
  part.material = 0;
  Material holes;
  holes.texture.texture = 0;
  auto scene = sceneOf({part}, {holes});
  scene->textures.push_back(textureOf(1, 1, {0x00ffffff}));
  const Solid solid = solidOf(scene, optionsAt(16));
  EXPECT_TRUE(solid.surface.empty());
  EXPECT_EQ(solid.added, solidOf(cube(0.2f, 0.8f), optionsAt(16)).added);
}

TEST(SolidMesh, PassesErrorsOn) {
  const auto memory = WorkingMemory::createDefault();
  const auto fill = [&](const std::shared_ptr<TriangleScene> &scene, const VoxelizeOptions &options) {
    auto surface = makeMeshSource(soupOf(cube(0.1f, 0.9f)), optionsAt(8), memory);
    return fillMesh(*scene, options, std::move(*surface), kFill, {memory, 1, options.progress});
  };
  Soup broken = cube(0.2f, 0.8f);
  broken[4][1] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(fill(soupOf(broken), optionsAt(8)));
  broken[4][1] = std::numeric_limits<float>::infinity();
  EXPECT_FALSE(fill(soupOf(broken), optionsAt(8)));
  broken[4][1] = 1e30f;
  EXPECT_FALSE(fill(soupOf(broken), optionsAt(8)));
  EXPECT_FALSE(fill(soupOf({}), optionsAt(8)));
  std::atomic<bool> stop = true;
  VoxelizeOptions stopped = optionsAt(8);
  stopped.progress.stop = &stop;
  const auto result = fill(soupOf(cube(0.2f, 0.8f)), stopped);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, ErrorKind::Interrupted);
}

} // namespace
} // namespace voxc::test
