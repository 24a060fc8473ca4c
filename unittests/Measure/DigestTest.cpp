// Digests.
#include "voxc/Measure/Digest.h"

#include "voxc/Support/File.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace voxc::measure {
namespace {

TEST(Digest, tellsPartsApart) {
  EXPECT_EQ(Digest().add("ab").add("c").hex(), Digest().add("ab").add("c").hex());
  EXPECT_NE(Digest().add("ab").add("c").hex(), Digest().add("a").add("bc").hex());
  EXPECT_EQ(Digest().add("ab").hex().size(), 16u);
}

TEST(Digest, takesTheContentOfAFile) {
  const std::string path = testing::TempDir() + "voxc-digest";
  ASSERT_TRUE(writeFile(path, "ab"));
  Digest digest;
  ASSERT_TRUE(digest.addFile(path));
  EXPECT_EQ(digest.hex(), Digest().add("ab").hex());
  std::filesystem::remove(path);
  EXPECT_FALSE(digest.addFile(path));
}

} // namespace
} // namespace voxc::measure
