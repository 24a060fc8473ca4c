// Memory within a bound: contents survive wherever they lie, and the process stays small.
#include "ResidentMemory.h"

#include "voxc/Support/WorkingMemory.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace voxc {
namespace {

constexpr std::uint64_t kMiB = std::uint64_t{1} << 20;

TEST(WorkingMemory, IsZeroInMemoryAndInTheFile) {
  const auto memory = WorkingMemory::create(4 * kMiB);
  auto inMemory = memory->allocate(2 * kMiB);
  ASSERT_TRUE(inMemory);
  EXPECT_EQ(memory->scratchPeak(), 0u);
  auto inFile = memory->allocate(8 * kMiB);
  ASSERT_TRUE(inFile);
  EXPECT_EQ(memory->scratchPeak(), 8 * kMiB);
  for (const MemoryBlock *block : {&*inMemory, &*inFile})
    for (std::uint64_t i = 0; i < block->size(); i += 512)
      ASSERT_EQ(block->data()[i], std::byte{0});
}

TEST(WorkingMemory, StaysWithinItsBoundAndLosesNothing) {
  const std::uint64_t before = test::residentBytes();
  const auto memory = WorkingMemory::create(16 * kMiB);
  ScratchArray<std::uint64_t> numbers(memory);
  constexpr std::uint64_t kCount = 8 * kMiB; // 64 MiB
  std::uint64_t peak = 0;
  for (std::uint64_t i = 0; i < kCount; ++i) {
    ASSERT_TRUE(numbers.push(i * i));
    if (i % 512 == 0)
      memory->relieve();
    if (i % 65536 == 0)
      peak = std::max(peak, test::residentBytes() - before);
  }
  for (std::uint64_t i = 0; i < kCount; ++i) {
    ASSERT_EQ(numbers[i], i * i);
    if (i % 512 == 0)
      memory->relieve();
    if (i % 65536 == 0)
      peak = std::max(peak, test::residentBytes() - before);
  }
  EXPECT_GT(memory->scratchPeak(), 48 * kMiB);
  EXPECT_LT(peak, 24 * kMiB + test::shadowBytes(kCount * sizeof(std::uint64_t)));
}

TEST(WorkingMemory, WhatIsCutOffAnArrayComesBackAsZero) {
  ScratchArray<int> array(WorkingMemory::create(kMiB));
  ASSERT_TRUE(array.resize(10));
  array[9] = 7;
  ASSERT_TRUE(array.resize(5));
  ASSERT_TRUE(array.resize(10));
  EXPECT_EQ(array[9], 0);
}

TEST(WorkingMemory, SaysWhereScratchSpaceIsMissing) {
  const auto memory = WorkingMemory::create(0, "/nowhere/at/all");
  const auto block = memory->allocate(kMiB);
  ASSERT_FALSE(block);
  EXPECT_EQ(block.error().kind, ErrorKind::Environment);
  EXPECT_NE(block.error().message.find("'/nowhere/at/all'"), std::string::npos);
}

TEST(WorkingMemory, LeavesNoFileBehind) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "voxc-scratch-test";
  std::filesystem::create_directories(folder);
  const auto memory = WorkingMemory::create(0, folder.string());
  const auto block = memory->allocate(kMiB);
  ASSERT_TRUE(block);
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

} // namespace
} // namespace voxc
