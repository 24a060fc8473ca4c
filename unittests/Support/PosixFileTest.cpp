// Pipes and devices, which POSIX has at paths.
#include "voxc/Support/File.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <sys/stat.h>
#include <unistd.h>

namespace voxc {
namespace {

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
