// Whole files: what was there stays until it is replaced, whatever its name is.
#include "voxc/Support/File.h"
#include "Support/ParallelFor.h"
#include "Support/PathEnding.h"
#include "Support/Platform/Path.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>

namespace voxc {
namespace {

TEST(OutputFile, LeavesWhatWasThereUnlessCommitted) {
  const auto folder = std::filesystem::temp_directory_path() / "voxc-output-file-test";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directory(folder);
  const std::string path = (folder / "file").string();
  ASSERT_TRUE(writeFile(path, "old"));
  {
    auto output = OutputFile::create(path);
    ASSERT_TRUE(output);
    ASSERT_TRUE(output->write("new", 3));
  }
  EXPECT_EQ(*readTextFile(path), "old");
  ASSERT_TRUE(writeFile(path, "new"));
  EXPECT_EQ(*readTextFile(path), "new");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1) << "no temporary file is left";
  EXPECT_FALSE(OutputFile::create(folder.string()));
  EXPECT_FALSE(OutputFile::create((folder / "none" / "file").string()));
  EXPECT_FALSE(MappedFile::open(folder.string()));
  std::filesystem::remove_all(folder);
}

TEST(OutputFile, OfSeveralThreadsAtOnceIsOneOfThem) {
  const auto folder = std::filesystem::temp_directory_path() / "voxc-output-race-test";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directory(folder);
  const std::string path = (folder / "file").string();
  parallelFor(8, 8, [&](std::uint64_t thread) {
    for (int i = 0; i < 50; ++i)
      EXPECT_TRUE(writeFile(path, std::string(10000, static_cast<char>('a' + thread))));
  });
  const std::string text = *readTextFile(path);
  EXPECT_EQ(text, std::string(10000, text.front()));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1) << "no second name is left";
  std::filesystem::remove_all(folder);
}

TEST(OutputFile, NamesAreUtf8) {
  const auto folder = std::filesystem::temp_directory_path() / u8"voxc-\u00e4\u65e5-test";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directory(folder);
  const std::string path = platform::utf8From(folder / u8"\u00fc\u8a9e.hvx");
  EXPECT_TRUE(path.ends_with("\xc3\xbc\xe8\xaa\x9e.hvx"));
  EXPECT_EQ(platform::pathFrom(path), folder / u8"\u00fc\u8a9e.hvx");
  EXPECT_EQ(pathEnding(path), ".hvx");
  ASSERT_TRUE(writeFile(path, "text"));
  ASSERT_TRUE(writeFile(path, "other"));
  EXPECT_TRUE(std::filesystem::exists(folder / u8"\u00fc\u8a9e.hvx"));
  EXPECT_EQ(*readTextFile(path), "other");
  std::filesystem::remove_all(folder);
}

TEST(OutputFile, WritesOverWhatItWroteBefore) {
  const std::string path = platform::utf8From(std::filesystem::temp_directory_path() / "voxc-rewrite-test");
  auto output = OutputFile::create(path);
  ASSERT_TRUE(output);
  ASSERT_TRUE(output->write("one two\r\n\n", 10));
  ASSERT_TRUE(output->rewrite(4, "six", 3));
  ASSERT_TRUE(output->write("!", 1));
  ASSERT_TRUE(output->commit());
  EXPECT_EQ(*readTextFile(path), "one six\r\n\n!");
  std::filesystem::remove(platform::pathFrom(path));
}

TEST(MappedFile, IsWrittenOverInMemoryAlone) {
  const std::string path = platform::utf8From(std::filesystem::temp_directory_path() / "voxc-mapped-test");
  ASSERT_TRUE(writeFile(path, std::string(100000, 'a')));
  {
    const auto file = MappedFile::open(path), other = MappedFile::open(path);
    ASSERT_TRUE(file && other);
    ASSERT_TRUE(writeOver(file->bytes().subspan(70000, 2), std::as_bytes(std::span("bc", 2))));
    EXPECT_EQ(std::memcmp(file->bytes().data() + 69999, "abca", 4), 0);
    EXPECT_EQ(std::memcmp(other->bytes().data() + 69999, "aaaa", 4), 0);
    other->letGo();
    EXPECT_EQ(other->bytes()[5], std::byte{'a'});
  }
  EXPECT_EQ(*readTextFile(path), std::string(100000, 'a'));
  std::filesystem::remove(platform::pathFrom(path));
}

} // namespace
} // namespace voxc
