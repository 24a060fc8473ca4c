// Solids of meshes with small holes, and of double-sided ones.
#include "SceneTesting.h"
#include "SolidTesting.h"
#include "TestLength.h"

#include <algorithm>
#include <random>

namespace voxc::test {
namespace {

constexpr std::array<Coverage, 3> kCoverages{Coverage::Conservative, Coverage::Thin, Coverage::Inner};

struct ClosedSolid {
  Cells surface;
  Cells cells;
  SolidMesh told; ///< Without its source.
};

ClosedSolid closedSolid(const Soup &soup, const VoxelizeOptions &options) {
  const auto memory = WorkingMemory::create(std::uint64_t{1} << 26);
  const auto scene = soupOf(soup);
  auto surface = makeMeshSource(scene, options, memory);
  EXPECT_TRUE(surface) << surface.error().message;
  ClosedSolid solid;
  solid.surface = cellsOf(**surface);
  auto filled = fillMesh(*scene, options, std::move(*surface), kFill, {memory});
  EXPECT_TRUE(filled) << filled.error().message;
  solid.cells = cellsOf(*filled->source);
  EXPECT_EQ(filled->voxels, solid.cells.size() - solid.surface.size());
  filled->source.reset();
  solid.told = std::move(*filled);
  return solid;
}

/// The voxels of the surface, and all cells whose centres lie in the whole mesh.
Cells expectedOf(const Cells &surface, const Soup &whole, int resolution) {
  Cells cells = surface;
  for (Int3 cell; cell.z < resolution; ++cell.z)
    for (cell.y = 0; cell.y < resolution; ++cell.y)
      for (cell.x = 0; cell.x < resolution; ++cell.x)
        if (windingAt(whole, glm::dvec3(cell.x + 0.5, cell.y + 0.5, cell.z + 0.5) / double(resolution)) != 0)
          cells.insert(mortonCode(cell));
  return cells;
}

Soup without(Soup soup, std::size_t triangle) {
  const auto first = soup.begin() + static_cast<std::ptrdiff_t>(3 * triangle);
  soup.erase(first, first + 3);
  return soup;
}

TEST(NearlyClosed, SmallHolesAreClosed) {
  const Soup whole = sphere(0.4);
  // Three triangles apart from each other; a fan over a triangle is the triangle.
  const Soup open = without(without(without(whole, 500), 400), 200);
  for (const int resolution : {6, 16, 30}) {
    const Cells inside = expectedOf({}, whole, resolution);
    for (const Coverage coverage : kCoverages)
      for (const bool isFlipped : {false, true}) {
        const ClosedSolid solid =
            closedSolid(isFlipped ? flipped(open) : open, optionsAt(resolution, coverage));
        Cells expected = solid.surface;
        expected.insert(inside.begin(), inside.end());
        EXPECT_EQ(solid.cells, expected) << resolution;
        EXPECT_EQ(solid.told.rule, SolidRule::Winding);
        EXPECT_EQ(solid.told.holes, 3u);
        EXPECT_EQ(solid.told.open.count, 9u);
        EXPECT_TRUE(solid.told.open.isAll);
        EXPECT_FALSE(solid.told.isDoubleSided);
        EXPECT_GT(solid.told.holeShare, 0.001);
        EXPECT_LT(solid.told.holeShare, 0.01);
      }
  }
}

TEST(NearlyClosed, AWideHoleIsCutOffByItsFan) {
  // A sphere without its cap of 25 degrees: flat above y = 0.5 + 0.4 cos(25.7 degrees).
  Soup bowl;
  const Soup whole = sphere(0.4);
  for (std::size_t i = 0; i < whole.size(); i += 3)
    if (whole[i][1] + whole[i + 1][1] + whole[i + 2][1] < 3 * 0.859f)
      bowl.insert(bowl.end(), whole.begin() + static_cast<std::ptrdiff_t>(i),
                  whole.begin() + static_cast<std::ptrdiff_t>(i + 3));
  const ClosedSolid solid = closedSolid(bowl, optionsAt(24));
  EXPECT_EQ(solid.told.holes, 1u);
  Cells expected = solid.surface;
  for (const std::uint64_t code : expectedOf({}, whole, 24))
    if ((mortonCell(code).y + 0.5) / 24 < 0.8604)
      expected.insert(code);
  EXPECT_EQ(solid.cells, expected);
}

/// A box of which one side is cut in the middle of an edge that its neighbour has in one piece; the middle
/// lies so far beside the edge.
Soup cracked(float beside) {
  Soup soup = cube(0.2f, 0.8f);
  const std::array<Corner, 3> side{soup[0], soup[1], soup[2]};
  Corner middle;
  for (std::size_t axis = 0; axis < 3; ++axis)
    middle[axis] = (side[0][axis] + side[1][axis]) / 2 + beside;
  soup.erase(soup.begin(), soup.begin() + 3);
  return joined(std::move(soup), {side[0], middle, side[2], middle, side[1], side[2]});
}

TEST(NearlyClosed, CornersOnEdgesMakeNoHoles) {
  const ClosedSolid solid = closedSolid(cracked(0), optionsAt(20));
  EXPECT_EQ(solid.told.rule, SolidRule::Winding);
  EXPECT_EQ(solid.told.open.count, 0u);
  EXPECT_EQ(solid.told.holes, 0u);
  EXPECT_EQ(solid.cells, closedSolid(cube(0.2f, 0.8f), optionsAt(20)).cells);
  const ClosedSolid beside = closedSolid(cracked(0.001f), optionsAt(20));
  EXPECT_EQ(beside.told.rule, SolidRule::Winding);
  EXPECT_EQ(beside.told.open.count, 3u);
  EXPECT_EQ(beside.told.holes, 1u);
  EXPECT_LT(beside.told.holeShare, 1e-3);
  EXPECT_EQ(beside.cells, expectedOf(beside.surface, cube(0.2f, 0.8f), 20));
}

/// Two boxes of 8, 4 and 4 units that touch, each side cut into strips of its own: all edges are parted
/// elsewhere.
TEST(NearlyClosed, MergedFacesOfVoxelsAreClosed) {
  std::mt19937 random(4);
  for (int round = 0; round < rounds(10); ++round) {
    Soup soup;
    const auto strips = [&](Corner low, Corner high, std::size_t axis, bool isHigh) {
      const std::size_t u = (axis + 1 + random() % 2) % 3;
      Corner from = low;
      (isHigh ? from : high)[axis] = (isHigh ? high : low)[axis];
      // Along u, in units of an eighth.
      while (from[u] < high[u]) {
        Corner to = high;
        to[u] = std::min(high[u], from[u] + static_cast<float>(1 + random() % 3) / 8);
        const std::size_t v = 3 - axis - u;
        std::array<Corner, 4> square{from, from, to, to};
        square[1][v] = to[v];
        square[3][v] = from[v];
        const bool turnsLeft = (v == (axis + 1) % 3) == isHigh;
        const Soup strip{square[0], square[1], square[2], square[0], square[2], square[3]};
        soup = joined(std::move(soup), turnsLeft ? strip : flipped(strip));
        from[u] = to[u];
      }
    };
    for (const auto &[low, high] :
         {std::pair<Corner, Corner>{{0, 0, 0}, {1, 0.5f, 0.5f}}, {{0, 0.5f, 0.5f}, {0.5f, 1, 1}}})
      for (std::size_t axis = 0; axis < 3; ++axis)
        for (const bool isHigh : {false, true})
          strips(low, high, axis, isHigh);
    const ClosedSolid solid = closedSolid(soup, optionsAt(8, Coverage::Inner));
    EXPECT_EQ(solid.told.rule, SolidRule::Winding);
    EXPECT_EQ(solid.told.open.count, 0u);
    EXPECT_EQ(solid.cells.size(), 8u * 4 * 4 + 4 * 4 * 4);
  }
}

TEST(NearlyClosed, HolesAmongFlippedTriangles) {
  const Soup whole = joined(sphere(0.45), flipped(sphere(0.2)));
  for (const std::size_t step : {21u, 300u}) {
    Soup mixed = whole;
    for (std::size_t i = 0; i < mixed.size(); i += step)
      std::swap(mixed[i + 1], mixed[i + 2]);
    const ClosedSolid solid = closedSolid(without(mixed, 390), optionsAt(20));
    // Few of them are taken for holes that are closed twice.
    EXPECT_EQ(solid.told.rule, step == 21 ? SolidRule::Parity : SolidRule::Winding);
    EXPECT_GT(solid.told.holes, 0u);
    EXPECT_EQ(solid.cells, expectedOf(solid.surface, whole, 20));
  }
}

/// Each triangle twice, the second time from behind and somewhere else in the list.
Soup doubled(const Soup &soup, std::mt19937 &random) {
  std::vector<std::array<Corner, 3>> triangles;
  for (std::size_t i = 0; i < soup.size(); i += 3)
    for (const bool isBehind : {false, true}) {
      std::array<Corner, 3> triangle{soup[i], soup[i + 1], soup[i + 2]};
      if (isBehind)
        std::swap(triangle[0], triangle[1]);
      std::rotate(triangle.begin(), triangle.begin() + random() % 3, triangle.end());
      triangles.push_back(triangle);
    }
  std::shuffle(triangles.begin(), triangles.end(), random);
  Soup both;
  for (const auto &triangle : triangles)
    both.insert(both.end(), triangle.begin(), triangle.end());
  return both;
}

TEST(NearlyClosed, DoubleSidedMeshesAreSolid) {
  std::mt19937 random(1);
  for (const Soup &whole :
       {sphere(0.4), torus(0.3, 0.12), cube(0.25f, 0.75f), joined(sphere(0.45), flipped(sphere(0.25)))})
    for (const Coverage coverage : kCoverages) {
      const ClosedSolid solid = closedSolid(doubled(whole, random), optionsAt(24, coverage));
      EXPECT_TRUE(solid.told.isDoubleSided);
      EXPECT_EQ(solid.told.open.count, 0u);
      // Which way it faces is not known, and the cube lies on faces of voxels.
      const bool isOther = coverage == Coverage::Inner && whole.size() == 36;
      EXPECT_EQ(solid.cells == closedSolid(whole, optionsAt(24, coverage)).cells, !isOther);
    }
}

/// Two triangles each are a quad, which is there again from behind, cut along the other diagonal.
Soup doubledOtherwise(const Soup &soup, std::mt19937 &random) {
  std::vector<std::array<Corner, 3>> triangles;
  for (std::size_t i = 0; i < soup.size(); i += 6) {
    const Corner a = soup[i], b = soup[i + 1], c = soup[i + 2], d = soup[i + 5];
    for (std::array<Corner, 3> triangle : {std::array{a, b, c}, {a, c, d}, {d, b, a}, {d, c, b}}) {
      std::rotate(triangle.begin(), triangle.begin() + random() % 3, triangle.end());
      triangles.push_back(triangle);
    }
  }
  std::shuffle(triangles.begin(), triangles.end(), random);
  Soup both;
  for (const auto &triangle : triangles)
    both.insert(both.end(), triangle.begin(), triangle.end());
  return both;
}

TEST(NearlyClosed, DoubleSidedMeshesMayBeCutInTwoWays) {
  std::mt19937 random(4);
  const Soup shell = joined(sphere(0.45), sphere(0.25));
  for (const auto &[sides, whole] :
       {std::pair(sphere(0.4), sphere(0.4)), std::pair(torus(0.3, 0.12), torus(0.3, 0.12)),
        std::pair(shell, joined(sphere(0.45), flipped(sphere(0.25))))}) {
    const ClosedSolid solid = closedSolid(doubledOtherwise(sides, random), optionsAt(24));
    EXPECT_TRUE(solid.told.isDoubleSided);
    EXPECT_EQ(solid.told.open.count, 0u);
    EXPECT_EQ(solid.cells, expectedOf(solid.surface, whole, 24));
  }
  // A pane of one quad closes nothing.
  const Soup pane{{0.2f, 0.2f, 0.5f}, {0.8f, 0.2f, 0.5f}, {0.8f, 0.8f, 0.5f},
                  {0.2f, 0.2f, 0.5f}, {0.8f, 0.8f, 0.5f}, {0.2f, 0.8f, 0.5f}};
  EXPECT_FALSE(closedSolid(doubledOtherwise(pane, random), optionsAt(24)).told.isDoubleSided);
}

TEST(NearlyClosed, DoubleSidedMeshesMayHaveHoles) {
  std::mt19937 random(2);
  const Soup whole = sphere(0.4);
  const ClosedSolid solid = closedSolid(doubled(without(without(whole, 500), 300), random), optionsAt(24));
  EXPECT_TRUE(solid.told.isDoubleSided);
  EXPECT_EQ(solid.told.holes, 2u);
  EXPECT_EQ(solid.told.open.count, 6u);
  EXPECT_EQ(solid.cells, expectedOf(solid.surface, whole, 24));
}

TEST(NearlyClosed, PartsOfBothKindsAreSolid) {
  std::mt19937 random(3);
  const Soup one = sphere(0.2, {0.25f, 0.25f, 0.25f});
  const Soup other = sphere(0.2, {0.7f, 0.7f, 0.7f});
  EXPECT_EQ(closedSolid(joined(one, doubled(other, random)), optionsAt(30)).cells,
            closedSolid(joined(one, other), optionsAt(30)).cells);
  // A pane in a closed mesh, and the wall between two bodies that share one, change nothing.
  const Soup pane{{0.3f, 0.3f, 0.3f}, {0.7f, 0.3f, 0.3f}, {0.3f, 0.7f, 0.3f}};
  const ClosedSolid glazed = closedSolid(joined(sphere(0.4), doubled(pane, random)), optionsAt(24));
  EXPECT_FALSE(glazed.told.isDoubleSided);
  EXPECT_EQ(glazed.cells, closedSolid(sphere(0.4), optionsAt(24)).cells);
  const Soup boxes =
      joined(box({0.1f, 0.2f, 0.2f}, {0.5f, 0.8f, 0.8f}), box({0.5f, 0.2f, 0.2f}, {0.9f, 0.8f, 0.8f}));
  const ClosedSolid touching = closedSolid(boxes, optionsAt(20));
  EXPECT_FALSE(touching.told.isDoubleSided);
  EXPECT_EQ(touching.cells, expectedOf(touching.surface, boxes, 20));
}

} // namespace
} // namespace voxc::test
