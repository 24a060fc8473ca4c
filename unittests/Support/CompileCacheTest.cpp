// The folder of compiled code: found again, never another's, never half, bounded.
#include "voxc/Support/CompileCache.h"

#include "voxc/Support/File.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <thread>
#include <vector>

namespace voxc {
namespace {

namespace fs = std::filesystem;

class CompileCacheTest : public testing::Test {
protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) /
              ("cache-" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  CompileCache open(std::uint64_t mostBytes = CompileCache::kDefaultBytes) {
    Expected<CompileCache> cache = CompileCache::open(folder_.string(), mostBytes);
    EXPECT_TRUE(cache);
    return std::move(*cache);
  }
  fs::path onlyFile() const { return fs::directory_iterator(folder_)->path(); }

  fs::path folder_;
};

using Parts = std::vector<std::string_view>;

TEST_F(CompileCacheTest, FindsWhatWasStored) {
  const CompileCache cache = open();
  EXPECT_FALSE(cache.find("object", Parts{"text", "-O3"}));
  cache.store("object", Parts{"text", "-O3"}, std::string("code\0more", 9));
  EXPECT_EQ(cache.find("object", Parts{"text", "-O3"}), std::string("code\0more", 9));
  EXPECT_EQ(open().find("object", Parts{"text", "-O3"}), std::string("code\0more", 9));
}

TEST_F(CompileCacheTest, TellsPartsApart) {
  const CompileCache cache = open();
  cache.store("object", Parts{"text", "-O3"}, "code");
  EXPECT_FALSE(cache.find("spirv", Parts{"text", "-O3"}));
  EXPECT_FALSE(cache.find("object", Parts{"text-O3"}));
  EXPECT_FALSE(cache.find("object", Parts{"text-", "O3"}));
  EXPECT_FALSE(cache.find("object", Parts{"text", "-O3", ""}));
}

TEST_F(CompileCacheTest, DamagedEntriesAreGivenUp) {
  const CompileCache cache = open();
  cache.store("object", Parts{"text"}, "some code");
  const fs::path file = onlyFile();
  Expected<std::string> bytes = readTextFile(file.string());
  ASSERT_TRUE(bytes);
  for (std::size_t i = 0; i < bytes->size(); ++i) {
    std::string damaged = *bytes;
    damaged[i] ^= 4;
    ASSERT_TRUE(writeFile(file.string(), damaged));
    EXPECT_FALSE(cache.find("object", Parts{"text"})) << i;
    EXPECT_FALSE(fs::exists(file)) << i;
  }
  for (std::size_t size = 0; size < bytes->size(); ++size) {
    ASSERT_TRUE(writeFile(file.string(), bytes->substr(0, size)));
    EXPECT_FALSE(cache.find("object", Parts{"text"})) << size;
  }
}

TEST_F(CompileCacheTest, GivesUpWhatWasLongestWithoutUse) {
  const CompileCache cache = open(1000);
  const auto used = [&](std::string_view name, int secondsAgo) {
    cache.store("object", Parts{name}, std::string(200, 'x'));
    for (const fs::directory_entry &entry : fs::directory_iterator(folder_))
      if (entry.last_write_time() > fs::file_time_type::clock::now() - std::chrono::seconds(1))
        fs::last_write_time(entry.path(),
                            fs::file_time_type::clock::now() - std::chrono::seconds(secondsAgo));
  };
  used("a", 50);
  used("b", 40);
  used("c", 30);
  EXPECT_TRUE(cache.find("object", Parts{"a"})); // Used now.
  used("d", 20);
  cache.store("object", Parts{"e"}, std::string(200, 'x'));
  EXPECT_LE(cache.usage().bytes, 1000u);
  EXPECT_FALSE(cache.find("object", Parts{"b"}));
  EXPECT_TRUE(cache.find("object", Parts{"e"}));
  cache.store("object", Parts{"f"}, std::string(2000, 'x'));
  EXPECT_FALSE(cache.find("object", Parts{"f"}));
}

TEST_F(CompileCacheTest, ManyMayUseItAtOnce) {
  std::vector<std::jthread> threads;
  for (int thread = 0; thread < 4; ++thread)
    threads.emplace_back([&, thread] {
      const CompileCache cache = open(3000);
      for (int i = 0; i < 200; ++i) {
        const std::string name = std::to_string((i * 7 + thread) % 20);
        if (const auto found = cache.find("object", Parts{name}))
          EXPECT_EQ(*found, std::string(150, name[0]));
        else
          cache.store("object", Parts{name}, std::string(150, name[0]));
      }
    });
}

TEST_F(CompileCacheTest, MustBeAFolder) {
  fs::create_directories(folder_);
  ASSERT_TRUE(writeFile((folder_ / "file").string(), ""));
  EXPECT_FALSE(CompileCache::open((folder_ / "file").string()));
}

TEST_F(CompileCacheTest, CanBeCleared) {
  const CompileCache cache = open();
  cache.store("object", Parts{"a"}, "code");
  cache.store("object", Parts{"b"}, "code");
  EXPECT_EQ(cache.usage().entries, 2u);
  ASSERT_TRUE(cache.clear());
  EXPECT_EQ(cache.usage().entries, 0u);
}

} // namespace
} // namespace voxc
