// A volume behind whose last word nothing can be read.
#pragma once

#include "voxc/Volume/Volume.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <memory>

#include <sys/mman.h>
#include <unistd.h>

namespace voxc::test {

/// A copy of a volume without attributes, which ends where its memory does.
inline Volume guarded(const Volume &volume) {
  const auto words = volume.words();
  const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  const std::size_t bytes = (words.size_bytes() + page - 1) / page * page;
  auto *const memory = static_cast<std::byte *>(
      ::mmap(nullptr, bytes + page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
  EXPECT_NE(memory, MAP_FAILED);
  EXPECT_EQ(::mprotect(memory + bytes, page, PROT_NONE), 0);
  const std::shared_ptr<const std::byte> owner(memory, [=](std::byte *) { ::munmap(memory, bytes + page); });
  auto *const begin = reinterpret_cast<std::uint32_t *>(memory + bytes - words.size_bytes());
  std::ranges::copy(words, begin);
  return Volume(volume.info(), std::span<const std::uint32_t>(begin, words.size()), owner);
}

} // namespace voxc::test
