// Grids whose slots are numbers: what kernels read of them lies within the words.
#include "voxc/Volume/Volume.h"

#include <gtest/gtest.h>

namespace voxc {
namespace {

TEST(IndexedGrid, FieldsAreReadByTwoWords) {
  const auto format = parseFormat(
      "format payload=occupancy { level 1: masked(1, 1, 1) level 2: masked(2, 2, 2) pointers=16 }");
  ASSERT_TRUE(format);
  // Root and array; numbers 0, which is none, and 1, of one voxel; a node of one child, that number.
  std::vector<std::uint32_t> words = {6, 2, 0, 0, 1, 0, 1, 1};
  EXPECT_FALSE(checkStructure(*format, words)) << "the word behind the number is outside";
  words.push_back(0);
  const auto voxels = checkStructure(*format, words);
  ASSERT_TRUE(voxels);
  EXPECT_EQ(*voxels, 1u);
}

} // namespace
} // namespace voxc
