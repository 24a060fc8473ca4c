// Included before a kernel in C++ (voxc compile --emit=cpp) whose load_word asks it for words: it notes which
// are read.
#pragma once

#include <cstdint>
#include <unordered_set>

inline std::uint64_t wordsRead = 0;
inline std::unordered_set<std::uintptr_t> linesRead;

inline std::uint32_t touched(const std::uint32_t *word) {
  constexpr std::uintptr_t kLineBytes = 64;
  ++wordsRead;
  linesRead.insert(reinterpret_cast<std::uintptr_t>(word) / kLineBytes);
  return *word;
}
