// Pipes, devices, links and permissions, which POSIX has at paths.
#include "NewFolder.h"
#include "voxc/Support/File.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <filesystem>
#include <grp.h>
#include <sys/stat.h>
#include <sys/wait.h>
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

class LinkedFile : public ::testing::Test {
protected:
  void SetUp() override { folder_ = test::newFolder("voxc-linked-file"); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string pathOf(const char *name) const { return (folder_ / name).string(); }
  /// Made of a text in the folder.
  std::string link(const char *name, const std::string &text) const {
    std::filesystem::create_symlink(text, folder_ / name);
    return pathOf(name);
  }
  std::ptrdiff_t files() const { return std::distance(std::filesystem::directory_iterator(folder_), {}); }

  std::filesystem::path folder_;
};

TEST_F(LinkedFile, IsMadeWhereTheLinksLead) {
  std::filesystem::create_directory(folder_ / "disk");
  ASSERT_TRUE(writeFile(pathOf("disk/file"), "old"));
  const std::string near = link("near", "disk/file"), far = link("far", pathOf("near"));
  {
    auto output = OutputFile::create(far);
    ASSERT_TRUE(output);
    ASSERT_TRUE(output->isRegular());
    ASSERT_TRUE(output->write("half", 4));
  }
  EXPECT_EQ(*readTextFile(pathOf("disk/file")), "old");
  ASSERT_TRUE(writeFile(far, "new"));
  EXPECT_EQ(*readTextFile(pathOf("disk/file")), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(near) && std::filesystem::is_symlink(far));
  EXPECT_EQ(files(), 3) << "nothing else beside the links";
}

TEST_F(LinkedFile, IsMadeWhereNothingIsYet) {
  const std::string path = link("link", "file");
  ASSERT_TRUE(writeFile(path, "text"));
  EXPECT_TRUE(std::filesystem::is_symlink(path));
  EXPECT_FALSE(std::filesystem::is_symlink(pathOf("file")));
  EXPECT_EQ(*readTextFile(pathOf("file")), "text");
}

TEST_F(LinkedFile, LinksInACircleAreAnError) {
  const std::string path = link("one", "other");
  link("other", "one");
  const auto written = writeFile(path, "text");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().kind, ErrorKind::Environment);
  EXPECT_TRUE(std::filesystem::is_symlink(path));
  const auto isRegular = OutputFile::isRegularAt(path);
  ASSERT_FALSE(isRegular);
  EXPECT_EQ(isRegular.error().message, written.error().message);
}

/// As a shell that sends output to a file has it: /dev/stdout is such a link.
TEST_F(LinkedFile, WhatIsOpenIsWrittenTo) {
  const int file = ::open(pathOf("file").c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  ASSERT_GE(file, 0);
  ASSERT_EQ(::write(file, "before, ", 8), 8);
  const std::string own = "/proc/self/fd/" + std::to_string(file), path = link("link", own);
  EXPECT_FALSE(*OutputFile::isRegularAt(own));
  EXPECT_FALSE(*OutputFile::isRegularAt(path));
  EXPECT_TRUE(writeFile(own, "text"));
  EXPECT_TRUE(writeFile(path, " and more"));
  ::close(file);
  EXPECT_TRUE(std::filesystem::is_symlink(path));
  EXPECT_EQ(*readTextFile(pathOf("file")), "before, text and more");
  EXPECT_EQ(files(), 2);
}

/// The machine lacks a permission then; nothing is wrong with the file.
TEST_F(LinkedFile, ThatMayNotBeReadIsNoWrongInput) {
  const std::string path = pathOf("file");
  ASSERT_TRUE(writeFile(path, "text"));
  ASSERT_EQ(::chmod(path.c_str(), 0), 0);
  ASSERT_EQ(::chmod(folder_.c_str(), 0755), 0);
  constexpr int kLacks = 0, kWrong = 1, kMay = 2;
  const pid_t child = ::fork();
  if (child == 0) {
    // Root may read everything.
    const bool mayNot = ::geteuid() != 0 || ::setuid(2000) == 0;
    if (!mayNot || ::access(folder_.c_str(), X_OK) != 0)
      ::_exit(kMay);
    const auto file = MappedFile::open(path);
    ::_exit(!file && file.error().kind == ErrorKind::Environment ? kLacks : kWrong);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  if (WEXITSTATUS(status) == kMay)
    GTEST_SKIP() << "this process cannot become another that sees the folder";
  EXPECT_EQ(WEXITSTATUS(status), kLacks);
}

TEST(MappedFile, ThatIsNotThereIsAWrongInput) {
  const auto file = MappedFile::open("/none/such");
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().kind, ErrorKind::Input);
}

TEST_F(LinkedFile, KeepsPermissions) {
  const std::string path = pathOf("file");
  ASSERT_TRUE(writeFile(path, "old"));
  ASSERT_EQ(::chmod(path.c_str(), 0600), 0);
  ASSERT_TRUE(writeFile(path, "new"));
  struct stat status{};
  ASSERT_EQ(::stat(path.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0600U);
}

/// Root alone may give a file to somebody else.
TEST_F(LinkedFile, KeepsItsOwner) {
  if (::geteuid() != 0)
    GTEST_SKIP() << "this process may not give files away";
  const std::string path = pathOf("file");
  ASSERT_TRUE(writeFile(path, "old"));
  ASSERT_EQ(::chown(path.c_str(), 2000, 3000), 0);
  ASSERT_EQ(::chmod(path.c_str(), 0640), 0);
  ASSERT_TRUE(writeFile(path, "new"));
  struct stat status{};
  ASSERT_EQ(::stat(path.c_str(), &status), 0);
  EXPECT_EQ(status.st_uid, 2000U);
  EXPECT_EQ(status.st_gid, 3000U);
  EXPECT_EQ(status.st_mode & 0777U, 0640U);
}

/// Who may not keep the group of a file gives its own group no more than all others have.
TEST_F(LinkedFile, AnotherGroupHasWhatOthersHave) {
  if (::geteuid() != 0)
    GTEST_SKIP() << "this process cannot become another";
  const std::string path = pathOf("file");
  ASSERT_TRUE(writeFile(path, "old"));
  ASSERT_EQ(::chown(path.c_str(), 2000, 3000), 0);
  ASSERT_EQ(::chmod(path.c_str(), 0664), 0);
  ASSERT_EQ(::chmod(folder_.c_str(), 0777), 0);
  constexpr int kWritten = 0, kFailed = 1, kNobody = 2;
  const pid_t child = ::fork();
  if (child == 0) {
    const bool isAnother = ::setgroups(0, nullptr) == 0 && ::setgid(100) == 0 && ::setuid(2000) == 0;
    if (!isAnother || ::access(folder_.c_str(), W_OK) != 0)
      ::_exit(kNobody);
    ::_exit(writeFile(path, "new") ? kWritten : kFailed);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  if (WEXITSTATUS(status) == kNobody)
    GTEST_SKIP() << "this process cannot become another that may write here";
  ASSERT_EQ(WEXITSTATUS(status), kWritten);
  struct stat written{};
  ASSERT_EQ(::stat(path.c_str(), &written), 0);
  EXPECT_EQ(written.st_gid, 100U);
  EXPECT_EQ(written.st_mode & 0777U, 0644U);
}

TEST_F(LinkedFile, PipesAreNoneAndAskedForUnopened) {
  const std::string path = pathOf("pipe");
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  ::alarm(60); // Ends the test if it is opened, and waits for a reader.
  EXPECT_FALSE(*OutputFile::isRegularAt(path));
  EXPECT_FALSE(*OutputFile::isRegularAt(link("link", "pipe")));
  ::alarm(0);
  EXPECT_TRUE(*OutputFile::isRegularAt(pathOf("none")));
}

} // namespace
} // namespace voxc
