// The process stays small; under Windows that is a matter of its paging.
#include "ResidentMemory.h"

#include "voxc/Support/WorkingMemory.h"

#include <gtest/gtest.h>

namespace voxc {
namespace {

constexpr std::uint64_t kMiB = std::uint64_t{1} << 20;

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

} // namespace
} // namespace voxc
