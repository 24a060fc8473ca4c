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

TEST(Diagnostics, ShowTheEnd) {
  Diagnostics diagnostics;
  diagnostics.error({3, 3}, "missing");
  EXPECT_EQ(render(diagnostics, "abc", "name"), "name:1:4: error: missing\n  abc\n     ^\n");
}

TEST(Diagnostics, CutLongLines) {
  Diagnostics diagnostics;
  const std::string text = std::string(1000, 'a') + "\u00e9wrong" + std::string(1000, 'b');
  diagnostics.error({1002, 1007}, "bad");
  const std::string shown = std::string(58, 'a') + "\u00e9wrong";
  EXPECT_EQ(render(diagnostics, text, "name"), "name:1:1003: error: bad\n  ..." + shown +
                                                   std::string(135, 'b') + "...\n  " +
                                                   std::string(3 + 60, ' ') + "^^^^^\n");
}

/// A line with an error at each character would be rendered as often as it is long.
TEST(Diagnostics, AreAFewHoweverMuchIsWrong) {
  Diagnostics diagnostics;
  EXPECT_FALSE(diagnostics.hasErrors());
  for (std::size_t i = 0; i < 1000; ++i)
    diagnostics.note({i, i + 1}, "odd");
  EXPECT_FALSE(diagnostics.hasErrors());
  diagnostics.error({0, 1}, "bad");
  EXPECT_TRUE(diagnostics.hasErrors());
  EXPECT_EQ(diagnostics.all().size(), 21u);
  const std::string text = render(diagnostics, std::string(1000, 'a'), "name");
  EXPECT_LT(text.size(), 10000u);
  EXPECT_NE(text.find("name:1:21: error: there is more from here on, which is not told\n"),
            std::string::npos);
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
