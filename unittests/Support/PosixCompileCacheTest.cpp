// Permissions say who may write to the folder of compiled code.
#include "voxc/Support/CompileCache.h"

#include "voxc/Support/File.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace voxc {
namespace {

namespace fs = std::filesystem;

TEST(CompileCacheFolder, CodeMustBeNobodyElses) {
  const fs::path folder = fs::path(testing::TempDir()) / "cache-of-others";
  fs::remove_all(folder);
  fs::create_directories(folder);
  fs::permissions(folder, fs::perms::all);
  const Expected<CompileCache> cache = CompileCache::open(folder.string());
  ASSERT_FALSE(cache);
  EXPECT_NE(cache.error().message.find("can be written to by others"), std::string::npos);
  ASSERT_TRUE(writeFile((folder / "file").string(), ""));
  EXPECT_FALSE(CompileCache::open((folder / "file").string()));
  fs::remove_all(folder);
}

} // namespace
} // namespace voxc
