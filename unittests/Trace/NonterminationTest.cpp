// Traversals that a kernel gave up are an error, never a miss.
#include "Trace/Kernel/Nontermination.h"

#include <gtest/gtest.h>

#include <vector>

namespace voxc {
namespace {

TEST(Nontermination, HitsMissesAndUnfinishedTraversalsAreNone) {
  const std::vector<Hit> hits = {
      {{3, 4, 5}, 9, 1.5f, 0}, {{-1, -1, -1}, 0, 0, 0}, {{-2, -9, -2097153}, 0, 0, 0}};
  EXPECT_TRUE(checkEnded(hits));
  EXPECT_TRUE(checkEnded({}));
}

TEST(Nontermination, AreCountedAndTheFirstIsNamed) {
  std::vector<Hit> hits(5, Hit{{-1, -1, -1}, 0, 0, 0});
  for (const std::size_t ray : {2u, 4u})
    hits[ray].voxel[0] = hits[ray].voxel[1] = hits[ray].voxel[2] = -0x7fffffff;
  const auto ended = checkEnded(hits);
  ASSERT_FALSE(ended);
  EXPECT_EQ(ended.error().kind, ErrorKind::Input);
  EXPECT_NE(ended.error().message.find("2 rays, the first of them ray 2,"), std::string::npos)
      << ended.error().message;
}

} // namespace
} // namespace voxc
