#include "common/Process.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace voxc::tool {
namespace {

/// What the system says of all ranges that are called [heap].
std::string heapFlags() {
  std::ifstream maps("/proc/self/smaps");
  std::string line, flags;
  bool isHeap = false;
  while (std::getline(maps, line)) {
    if (line.find('-') < line.find(' '))
      isHeap = line.ends_with("[heap]");
    if (isHeap && line.starts_with("VmFlags:"))
      flags += line;
  }
  return flags;
}

TEST(Process, TheHeapGrowsOntoHugePages) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(__GLIBC__)
  GTEST_SKIP() << "the heap is not the C library's";
#endif
  if (!std::filesystem::exists("/sys/kernel/mm/transparent_hugepage"))
    GTEST_SKIP() << "the system has no huge pages";
  ASSERT_TRUE(prepareProcess());
  EXPECT_NE(heapFlags().find(" hg"), std::string::npos) << heapFlags();
}

} // namespace
} // namespace voxc::tool
