// Memory within a bound: contents survive wherever they lie.
#include "voxc/Support/WorkingMemory.h"
#include "voxc/Support/File.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace voxc {
namespace {

constexpr std::uint64_t kMebibyte = std::uint64_t{1} << 20;

TEST(WorkingMemory, IsZeroInMemoryAndInTheFile) {
  const auto memory = WorkingMemory::create(4 * kMebibyte);
  auto inMemory = memory->allocate(2 * kMebibyte);
  ASSERT_TRUE(inMemory);
  EXPECT_EQ(memory->scratchPeak(), 0u);
  auto inFile = memory->allocate(8 * kMebibyte);
  ASSERT_TRUE(inFile);
  EXPECT_EQ(memory->scratchPeak(), 8 * kMebibyte);
  for (const MemoryBlock *block : {&*inMemory, &*inFile})
    for (std::uint64_t i = 0; i < block->size(); i += 512)
      ASSERT_EQ(block->data()[i], std::byte{0});
}

TEST(WorkingMemory, LosesNothingBeyondItsBound) {
  const auto memory = WorkingMemory::create(kMebibyte);
  ScratchArray<std::uint64_t> numbers(memory);
  constexpr std::uint64_t kCount = kMebibyte; // 8 MiB
  for (std::uint64_t i = 0; i < kCount; ++i) {
    ASSERT_TRUE(numbers.push(i * i));
    if (i % 512 == 0)
      memory->relieve();
  }
  EXPECT_GT(memory->scratchPeak(), 6 * kMebibyte);
  for (std::uint64_t i = 0; i < kCount; ++i)
    ASSERT_EQ(numbers[i], i * i);
}

TEST(WorkingMemory, ViewsSeeTheBlockButForWhatTheyWrite) {
  const auto memory = WorkingMemory::create(16 * kMebibyte);
  auto block = memory->reserveShared(8 * kMebibyte);
  ASSERT_TRUE(block);
  ASSERT_TRUE(memory->extend(*block, kMebibyte));
  block->data()[5] = std::byte{1};
  const auto view = memory->view(*block, kMebibyte);
  ASSERT_TRUE(view);
  EXPECT_EQ(view->data()[5], std::byte{1});
  view->data()[WorkingMemory::pageBytes()] = std::byte{2};
  EXPECT_EQ(block->data()[WorkingMemory::pageBytes()], std::byte{0});
  block->data()[6] = std::byte{3};
  EXPECT_EQ(view->data()[6], std::byte{3});
  ASSERT_TRUE(memory->extend(*block, kMebibyte));
  EXPECT_EQ(block->data()[5], std::byte{1});
  EXPECT_EQ(block->data()[block->size() - 1], std::byte{0});
}

TEST(WorkingMemory, WhatIsFlushedIsInTheFileAndCanBeRead) {
  const std::string path = (std::filesystem::path(testing::TempDir()) / "voxc-flush-test").string();
  const auto memory = WorkingMemory::create(16 * kMebibyte);
  auto block = memory->reserve(8 * kMebibyte);
  ASSERT_TRUE(block);
  ASSERT_TRUE(memory->extendInMemory(*block, 2 * kMebibyte));
  block->data()[kMebibyte + 7] = std::byte{9};
  auto file = OutputFile::create(path);
  ASSERT_TRUE(file);
  ASSERT_TRUE(memory->flush(*block, 0, 2 * kMebibyte, file->descriptor(), 0));
  EXPECT_EQ(block->data()[kMebibyte + 7], std::byte{9});
  ASSERT_TRUE(memory->extendInMemory(*block, kMebibyte));
  block->data()[2 * kMebibyte] = std::byte{4};
  ASSERT_TRUE(file->commit());
  const auto written = readTextFile(path);
  ASSERT_TRUE(written);
  EXPECT_EQ(written->size(), 2 * kMebibyte);
  EXPECT_EQ(written->find_first_not_of('\0'), kMebibyte + 7);
  *block = MemoryBlock();
  std::filesystem::remove(path);
}

TEST(WorkingMemory, WhatIsCutOffAnArrayComesBackAsZero) {
  ScratchArray<int> array(WorkingMemory::create(kMebibyte));
  ASSERT_TRUE(array.resize(10));
  array[9] = 7;
  ASSERT_TRUE(array.resize(5));
  ASSERT_TRUE(array.resize(10));
  EXPECT_EQ(array[9], 0);
}

TEST(WorkingMemory, SaysWhereScratchSpaceIsMissing) {
  const auto memory = WorkingMemory::create(0, "/nowhere/at/all");
  const auto block = memory->allocate(kMebibyte);
  ASSERT_FALSE(block);
  EXPECT_EQ(block.error().kind, ErrorKind::Environment);
  EXPECT_NE(block.error().message.find("'/nowhere/at/all'"), std::string::npos);
}

TEST(WorkingMemory, LeavesNoFileBehind) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "voxc-scratch-test";
  std::filesystem::create_directories(folder);
  const auto memory = WorkingMemory::create(0, folder.string());
  const auto block = memory->allocate(kMebibyte);
  ASSERT_TRUE(block);
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

} // namespace
} // namespace voxc
