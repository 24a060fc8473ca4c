// One voxel where a face lies between two: meshes of voxels come back as the same voxels.
#include "Mesh/Voxelize/MeshVoxels.h"
#include "SceneTesting.h"
#include "SolidTesting.h"
#include "TestLength.h"

#include <random>

namespace voxc::test {
namespace {

constexpr int kSide = 12;

/// The faces of voxels towards empty cells, turned outwards; each is cut by either diagonal.
Soup facesOf(const Cells &voxels, std::mt19937 &random) {
  Soup soup;
  for (const std::uint64_t code : voxels) {
    const Int3 voxel = mortonCell(code);
    for (int axis = 0; axis < 3; ++axis)
      for (const int up : {0, 1}) {
        Int3 next = voxel;
        next[axis] += up == 1 ? 1 : -1;
        if (next[axis] >= 0 && voxels.contains(mortonCode(next)))
          continue;
        std::array<Corner, 4> square;
        for (int i = 0; i < 4; ++i) {
          // Around the square, to the left as seen from the high side.
          Int3 corner = voxel;
          corner[axis] += up;
          corner[(axis + 1) % 3] += i == 1 || i == 2;
          corner[(axis + 2) % 3] += i >= 2;
          square[static_cast<std::size_t>(i)] = {float(corner.x), float(corner.y), float(corner.z)};
        }
        const std::size_t first = random() % 2;
        const Soup face{square[first], square[first + 1], square[first + 2],
                        square[first], square[first + 2], square[(first + 3) % 4]};
        soup = joined(std::move(soup), up == 1 ? face : flipped(face));
      }
  }
  return soup;
}

/// Voxels of which no empty neighbour is seen are not on the surface.
Cells shellOf(const Cells &voxels) {
  Cells shell;
  for (const std::uint64_t code : voxels) {
    int covered = 0;
    for (int side = 0; side < 6; ++side) {
      Int3 next = mortonCell(code);
      next[side / 2] += side % 2 == 0 ? 1 : -1;
      covered += next[side / 2] >= 0 && voxels.contains(mortonCode(next));
    }
    if (covered < 6)
      shell.insert(code);
  }
  return shell;
}

VoxelizeOptions onTheGrid() {
  VoxelizeOptions options;
  options.resolution = kSide;
  options.bounds = {{0, 0, 0, kSide, kSide, kSide}};
  options.coverage = Coverage::Inner;
  return options;
}

/// The voxels of a scene, alone and filled; both voxelizers agree.
std::array<Cells, 2> voxelized(const std::shared_ptr<TriangleScene> &scene, const VoxelizeOptions &options) {
  const auto memory = WorkingMemory::createDefault();
  auto surface = makeMeshSource(scene, options, memory);
  EXPECT_TRUE(surface);
  auto reference = makeReferenceMeshSource(*scene, options);
  EXPECT_TRUE(reference);
  EXPECT_EQ(voxelsOf(**surface), voxelsOf(**reference));
  const Cells shell = cellsOf(**surface);
  auto solid = fillMesh(*scene, options, std::move(*surface), kFill, {memory});
  EXPECT_TRUE(solid);
  return {shell, cellsOf(*solid->source)};
}

Cells randomVoxels(std::mt19937 &random) {
  Cells voxels;
  // Boxes and single voxels, so that there are insides, hollows, and voxels that meet at edges and corners.
  for (int i = 0; i < 3; ++i) {
    Int3 low;
    Int3 high;
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = static_cast<int>(random() % kSide);
      high[axis] = std::min(kSide, low[axis] + 1 + static_cast<int>(random() % 7));
    }
    for (Int3 cell = low; cell.z < high.z; ++cell.z)
      for (cell.y = low.y; cell.y < high.y; ++cell.y)
        for (cell.x = low.x; cell.x < high.x; ++cell.x)
          voxels.insert(mortonCode(cell));
  }
  for (int i = 0; i < 60; ++i) {
    const Int3 cell{static_cast<int>(random() % kSide), static_cast<int>(random() % kSide),
                    static_cast<int>(random() % kSide)};
    if (random() % 2 == 0)
      voxels.insert(mortonCode(cell));
    else
      voxels.erase(mortonCode(cell));
  }
  return voxels;
}

TEST(InnerCoverage, AMeshOfVoxelsComesBackAsTheSameVoxels) {
  std::mt19937 random(1);
  for (int round = 0; round < rounds(12); ++round) {
    const Cells voxels = randomVoxels(random);
    const Soup soup = facesOf(voxels, random);
    for (const bool isInwards : {false, true}) {
      const auto [shell, solid] = voxelized(soupOf(isInwards ? flipped(soup) : soup), onTheGrid());
      ASSERT_EQ(shell, shellOf(voxels)) << round;
      ASSERT_EQ(solid, voxels) << round;
    }
  }
}

TEST(InnerCoverage, OfAMirroredInstanceIsTheMirroredOne) {
  std::mt19937 random(2);
  const Cells voxels = randomVoxels(random);
  const auto scene = soupOf(facesOf(voxels, random));
  scene->instances[0].toModel = transformOfRows({-1, 0, 0, kSide, 0, 1, 0, 0, 0, 0, 1, 0});
  Cells mirrored;
  for (const std::uint64_t code : voxels) {
    const Int3 cell = mortonCell(code);
    mirrored.insert(mortonCode({kSide - 1 - cell.x, cell.y, cell.z}));
  }
  EXPECT_EQ(voxelized(scene, onTheGrid())[1], mirrored);
}

TEST(InnerCoverage, HalfAMeshAndItsMirrorImageAreOne) {
  // Two halves of a cube, one of them mirrored: only together they are closed, and only as mirrored.
  Soup half = box({6, 2, 2}, {10, 10, 10});
  half.erase(half.begin(), half.begin() + 6);
  const auto scene = soupOf(half);
  scene->instances.push_back({0, transformOfRows({-1, 0, 0, kSide, 0, 1, 0, 0, 0, 0, 1, 0})});
  const auto [shell, solid] = voxelized(scene, onTheGrid());
  EXPECT_EQ(shell.size(), 512u - 216u);
  EXPECT_EQ(solid.size(), 512u);
}

TEST(InnerCoverage, OpenSurfacesTakeTheHigherVoxelAndTheLastOne) {
  const auto square = [](float at) {
    return Soup{{at, 2, 2}, {at, 5, 2}, {at, 5, 5}, {at, 2, 2}, {at, 5, 5}, {at, 2, 5}};
  };
  for (const auto &[at, x] : {std::pair{0.0f, 0}, {4.0f, 4}, {4.5f, 4}, {float(kSide), kSide - 1}})
    for (const bool isFlipped : {false, true}) {
      const Soup soup = isFlipped ? flipped(square(at)) : square(at);
      Cells expected;
      for (int i = 0; i < 9; ++i)
        expected.insert(mortonCode({x, 2 + i % 3, 2 + i / 3}));
      EXPECT_EQ(voxelized(soupOf(soup), onTheGrid())[0], expected) << at;
    }
}

/// They have no inside: each takes the voxels that it touches, as by every rule.
TEST(InnerCoverage, LinesAndPointsAreNoSurfaces) {
  const auto thin = [](const Soup &corners, PrimitiveMode mode) {
    const auto scene = soupOf(corners);
    scene->parts[0].mode = mode;
    auto source = makeMeshSource(scene, onTheGrid(), WorkingMemory::createDefault());
    EXPECT_TRUE(source) << source.error().message;
    return cellsOf(**source);
  };
  const Corner from{2, 4.5f, 4.5f}, point{4, 4.5f, 4.5f};
  EXPECT_EQ(thin({point}, PrimitiveMode::Points), (Cells{mortonCode({3, 4, 4}), mortonCode({4, 4, 4})}));
  EXPECT_EQ(thin({from, point}, PrimitiveMode::Lines), (Cells{mortonCode({1, 4, 4}), mortonCode({2, 4, 4}),
                                                              mortonCode({3, 4, 4}), mortonCode({4, 4, 4})}));
}

TEST(InnerCoverage, OfOtherSurfacesIsAsThinBetweenFaces) {
  // Where no corner and no crossing lies on a face between voxels, nothing is to be decided.
  const Soup soup = sphere(0.4);
  VoxelizeOptions options;
  options.resolution = 40;
  options.bounds = {{0.013, 0.017, 0.011, 0.993, 0.987, 0.991}};
  options.coverage = Coverage::Thin;
  auto thin = makeMeshSource(soupOf(soup), options, WorkingMemory::createDefault());
  options.coverage = Coverage::Inner;
  auto inner = makeMeshSource(soupOf(soup), options, WorkingMemory::createDefault());
  EXPECT_EQ(voxelsOf(**inner), voxelsOf(**thin));
}

} // namespace
} // namespace voxc::test
