// How slices lie in scans.
#include "Source/Export/SliceAxes.h"

#include <gtest/gtest.h>

namespace voxc {
namespace {

constexpr SliceAxis kX{0}, kY{1}, kZ{2};

SliceAxis back(SliceAxis axis) { return {axis.axis, true}; }

TEST(SliceAxes, OfVoxelsAreTheirOwn) {
  const Transform turned({0, 0, 5}, {0, -1, 0}, {1, 0, 0}, {});
  EXPECT_EQ(sliceAxes(SlicePlane::Z, turned), (SliceAxes{kX, kY, kZ}));
  EXPECT_EQ(sliceAxes(SlicePlane::Y, turned), (SliceAxes{kX, kZ, kY}));
  EXPECT_EQ(sliceAxes(SlicePlane::X, turned), (SliceAxes{kZ, kY, kX}));
}

TEST(SliceAxes, OfAScanAreThoseOfItsModel) {
  // As files have them: x, y and z of the scan are those of the voxels. Up is up.
  const Transform straight({1, 0, 0}, {0, 1, 0}, {0, 0, 3}, {});
  EXPECT_EQ(sliceAxes(SlicePlane::Axial, straight), (SliceAxes{kX, back(kY), kZ}));
  EXPECT_EQ(sliceAxes(SlicePlane::Coronal, straight), (SliceAxes{kX, back(kZ), kY}));
  EXPECT_EQ(sliceAxes(SlicePlane::Sagittal, straight), (SliceAxes{kY, back(kZ), kX}));
  // Turned upright, as readers of scans do: y of the voxels is z of the scan, and z is -y.
  const Transform upright({1, 0, 0}, {0, 0, 3}, {0, -1, 0}, {});
  EXPECT_EQ(sliceAxes(SlicePlane::Axial, upright), (SliceAxes{kX, kZ, kY}));
  EXPECT_EQ(sliceAxes(SlicePlane::Coronal, upright), (SliceAxes{kX, back(kY), back(kZ)}));
  EXPECT_EQ(sliceAxes(SlicePlane::Sagittal, upright), (SliceAxes{back(kZ), back(kY), kX}));
}

TEST(SliceAxes, OfAnObliqueScanAreTheNearest) {
  // Tilted by 40 degrees about x, and x of the voxels runs to the left.
  const double c = 0.766, s = 0.643;
  const Transform tilted({-1, 0, 0}, {0, c, s}, {0, -s, c}, {});
  EXPECT_EQ(sliceAxes(SlicePlane::Axial, tilted), (SliceAxes{back(kX), back(kY), kZ}));
  // No axis is taken twice, whatever the map.
  const SliceAxes flat = sliceAxes(SlicePlane::Axial, Transform({1, 1, 1}, {1, 1, 1}, {0, 0, 0}, {}));
  EXPECT_EQ(flat.right.axis + flat.down.axis + flat.through.axis, 3);
}

} // namespace
} // namespace voxc
