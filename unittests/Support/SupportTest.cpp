// Diagnostics, Morton codes and files.
#include "Support/ParallelFor.h"
#include "voxc/Support/Diagnostic.h"
#include "voxc/Support/File.h"
#include "voxc/Support/Geometry.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <sys/stat.h>
#include <unistd.h>

namespace voxc {
namespace {

TEST(Diagnostics, PutCaretsUnderTheWholeRange) {
  Diagnostics diagnostics;
  diagnostics.error({7, 10}, "bad");
  EXPECT_EQ(render(diagnostics, "one\n\ttwo three\n", "name"),
            "name:2:4: error: bad\n  \ttwo three\n  \t  ^^^\n");
}

TEST(Diagnostics, ShowWhatIsAroundTheRangeOfALongLine) {
  Diagnostics diagnostics;
  diagnostics.error({100000, 100003}, "wrong");
  const std::string text = std::string(100000, 'a') + "bad" + std::string(100000, 'b');
  const std::string shown = std::string(200, 'a') + "bad" + std::string(197, 'b');
  EXPECT_EQ(render(diagnostics, text, "name"),
            "name:1:100001: error: wrong\n  " + shown + "\n  " + std::string(200, ' ') + "^^^\n");
}

/// A text of a stranger may be wrong a million times, each time in the same long line.
TEST(Diagnostics, KeepFiftyAndSayThatThereAreMore) {
  Diagnostics diagnostics;
  for (std::size_t i = 0; i < 1000000; ++i)
    diagnostics.error({i, i + 1}, "wrong");
  ASSERT_EQ(diagnostics.all().size(), 51u);
  EXPECT_EQ(diagnostics.all().back().message, "there are more errors from here on");
  EXPECT_LT(render(diagnostics, std::string(1000000, 'a'), "name").size(), 51u * 1000u);
}

TEST(Diagnostics, ShowTheEnd) {
  Diagnostics diagnostics;
  diagnostics.error({3, 3}, "missing");
  EXPECT_EQ(render(diagnostics, "abc", "name"), "name:1:4: error: missing\n  abc\n     ^\n");
}

TEST(Morton, IsItsOwnInverse) {
  const Int3 cells[] = {{0, 0, 0}, {1, 0, 0},     {0, 1, 0},
                        {0, 0, 1}, {5, 1999, 77}, {0x1fffff, 0x155555, 0x0aaaaa}};
  for (const Int3 cell : cells)
    EXPECT_EQ(mortonCell(mortonCode(cell)), cell);
  EXPECT_EQ(mortonCode({1, 0, 0}), 1u);
  EXPECT_EQ(mortonCode({0, 1, 0}), 2u);
  EXPECT_EQ(mortonCode({0, 0, 1}), 4u);
  EXPECT_EQ(mortonCode({0b011, 0b101, 0b110}), 0b110'101'011u) << "z, y, x of bit 2, then 1, then 0";
}

TEST(OutputFile, LeavesWhatWasThereUnlessCommitted) {
  const auto folder = std::filesystem::temp_directory_path() / "voxc-output-file-test";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directory(folder);
  const std::string path = folder / "file";
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
  EXPECT_FALSE(OutputFile::create(folder));
  EXPECT_FALSE(OutputFile::create(folder / "none" / "file"));
  EXPECT_FALSE(MappedFile::open(folder));
  std::filesystem::remove_all(folder);
}

TEST(OutputFile, OfSeveralThreadsAtOnceIsOneOfThem) {
  const auto folder = std::filesystem::temp_directory_path() / "voxc-output-race-test";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directory(folder);
  const std::string path = folder / "file";
  parallelFor(8, 8, [&](std::uint64_t thread) {
    for (int i = 0; i < 50; ++i)
      EXPECT_TRUE(writeFile(path, std::string(10000, static_cast<char>('a' + thread))));
  });
  const std::string text = *readTextFile(path);
  EXPECT_EQ(text, std::string(10000, text.front()));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1) << "no second name is left";
  std::filesystem::remove_all(folder);
}

TEST(MappedFile, DoesNotWaitForAPipe) {
  const std::string pipe =
      std::filesystem::temp_directory_path() / ("voxc-pipe-" + std::to_string(::getpid()));
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  ::alarm(60); // Ends the test if it does wait.
  const auto file = MappedFile::open(pipe);
  ::alarm(0);
  std::filesystem::remove(pipe);
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().message, "'" + pipe + "' is not a regular file");
}

TEST(OutputFile, WritesToDevicesWithoutReplacingThem) {
  ASSERT_TRUE(writeFile("/dev/null", "text"));
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
  const auto full = writeFile("/dev/full", "text");
  ASSERT_FALSE(full);
  EXPECT_EQ(full.error().kind, ErrorKind::Environment);
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

} // namespace
} // namespace voxc
