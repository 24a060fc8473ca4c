// Thin voxels of closed meshes let nothing through.
#include "SceneTesting.h"
#include "Source/SourceTesting.h"
#include "TestLength.h"

#include <cmath>
#include <random>
#include <set>

namespace voxc {
namespace {

using Corner = std::array<float, 3>;

constexpr int kSide = 40;

/// A closed surface that every ray from the centre of the unit cube meets once: an octahedron, whose faces
/// are split and whose corners are moved in and out.
class StarShape {
public:
  explicit StarShape(unsigned seed) : seed_(seed) {}

  std::vector<Corner> triangles() const {
    std::vector<Corner> corners;
    for (int octant = 0; octant < 8; ++octant) {
      const int x = octant & 1 ? 1 : -1;
      const int y = octant & 2 ? 1 : -1;
      const int z = octant & 4 ? 1 : -1;
      split({x * kParts, 0, 0}, {0, y * kParts, 0}, {0, 0, z * kParts}, corners);
    }
    return corners;
  }

private:
  static constexpr int kParts = 8;

  /// Points of the octahedron |x| + |y| + |z| = kParts, so that neighbours agree on them exactly.
  void split(const std::array<int, 3> &a, const std::array<int, 3> &b, const std::array<int, 3> &c,
             std::vector<Corner> &corners) const {
    const auto at = [&](int i, int j) {
      std::array<int, 3> p;
      for (std::size_t k = 0; k < 3; ++k)
        p[k] = (a[k] * (kParts - i - j) + b[k] * i + c[k] * j) / kParts;
      return moved(p);
    };
    for (int i = 0; i < kParts; ++i)
      for (int j = 0; i + j < kParts; ++j) {
        corners.insert(corners.end(), {at(i, j), at(i + 1, j), at(i, j + 1)});
        if (i + j + 1 < kParts)
          corners.insert(corners.end(), {at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
      }
  }

  Corner moved(const std::array<int, 3> &p) const {
    std::seed_seq seeds{seed_, static_cast<unsigned>(p[0] + 9), static_cast<unsigned>(p[1] + 9),
                        static_cast<unsigned>(p[2] + 9)};
    std::mt19937 random(seeds);
    const double length = std::hypot(p[0], p[1], p[2]);
    const double radius = 0.25 + 0.2 * static_cast<double>(random() % 1000) / 1000;
    Corner corner;
    for (std::size_t k = 0; k < 3; ++k)
      corner[k] = static_cast<float>(0.5 + radius * p[k] / length);
    return corner;
  }

  unsigned seed_;
};

/// The empty voxels that paths over faces reach from the corner of the volume.
std::set<std::uint64_t> outside(const Voxels &voxels) {
  std::set<std::uint64_t> reached{0};
  std::vector<Int3> front{{}};
  while (!front.empty()) {
    const Int3 cell = front.back();
    front.pop_back();
    for (int direction = 0; direction < 6; ++direction) {
      Int3 next = cell;
      next[direction / 2] += direction % 2 == 0 ? 1 : -1;
      if (contains({kSide, kSide, kSide}, next) && !voxels.contains(mortonCode(next)) &&
          reached.insert(mortonCode(next)).second)
        front.push_back(next);
    }
  }
  return reached;
}

Voxels voxelized(const std::vector<Corner> &corners, Coverage coverage) {
  VoxelizeOptions options;
  options.resolution = kSide;
  options.bounds = {{0, 0, 0, 1, 1, 1}};
  options.coverage = coverage;
  auto source = makeMeshSource(test::soupOf(corners), options, WorkingMemory::createDefault());
  EXPECT_TRUE(source) << source.error().message;
  return source ? voxelsOf(**source) : Voxels{};
}

TEST(Watertight, ThinAndInnerLeakNowhereAndArePartOfConservative) {
  for (int i = 0; i < test::rounds(12); ++i) {
    const auto corners = StarShape(static_cast<unsigned>(i / 2)).triangles();
    const Voxels thin = voxelized(corners, i % 2 == 0 ? Coverage::Thin : Coverage::Inner);
    const auto reached = outside(thin);
    EXPECT_FALSE(reached.contains(mortonCode({kSide / 2, kSide / 2, kSide / 2})));
    for (const std::uint64_t code : reached) {
      const Int3 cell = mortonCell(code);
      const double radius = std::hypot(cell.x + 0.5 - 20, cell.y + 0.5 - 20, cell.z + 0.5 - 20) / kSide;
      ASSERT_GT(radius, 0.2) << "this deep is inside";
    }
    const Voxels conservative = voxelized(corners, Coverage::Conservative);
    EXPECT_GT(conservative.size(), thin.size());
    for (const auto &[code, word] : thin)
      ASSERT_TRUE(conservative.contains(code));
  }
}

TEST(Watertight, SurfacesOnFacesOfVoxelsDoNotLeakEither) {
  // A cube whose faces lie on those of voxels, and one whose faces go through their centres.
  for (const float low : {10.0f / kSide, 10.5f / kSide}) {
    std::vector<Corner> corners;
    const float high = 1 - low;
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const float at : {low, high}) {
        std::array<Corner, 4> square;
        for (std::size_t i = 0; i < 4; ++i) {
          square[i][axis] = at;
          square[i][(axis + 1) % 3] = i % 2 == 0 ? low : high;
          square[i][(axis + 2) % 3] = i / 2 == 0 ? low : high;
        }
        corners.insert(corners.end(), {square[0], square[1], square[2], square[1], square[3], square[2]});
      }
    for (const Coverage coverage : {Coverage::Thin, Coverage::Inner}) {
      const auto reached = outside(voxelized(corners, coverage));
      EXPECT_GT(reached.size(), 1000u);
      EXPECT_FALSE(reached.contains(mortonCode({kSide / 2, kSide / 2, kSide / 2})));
    }
  }
}

} // namespace
} // namespace voxc
