// Fields of few bits, one behind the other in words.
#pragma once

#include "voxc/Layout/WordReader.h"

#include <cstdint>
#include <span>

namespace voxc {

/// The words that so many fields take.
inline std::uint64_t wordsOfFields(std::uint64_t fields, int bits) {
  return (fields * static_cast<std::uint64_t>(bits) + 31) / 32;
}

/// The field of `bits` bits, 32 at most, whose first is bit `first` of the words from `at` on.
inline std::uint32_t readBits(const WordReader &words, std::uint64_t at, std::uint64_t first, int bits) {
  const std::uint64_t pair = words[at + first / 32] | std::uint64_t{words[at + first / 32 + 1]} << 32;
  return static_cast<std::uint32_t>(pair >> first % 32 & ((std::uint64_t{1} << bits) - 1));
}

/// Field `i` of those of `bits` bits, 32 at most, that begin at word `at`.
inline std::uint32_t readField(const WordReader &words, std::uint64_t at, std::uint64_t i, int bits) {
  return readBits(words, at, i * static_cast<std::uint64_t>(bits), bits);
}

/// Replaces a field of at most 32 bits. The words hold all of it.
inline void writeField(std::span<std::uint32_t> words, std::uint64_t i, int bits, std::uint32_t field) {
  const std::uint64_t bit = i * static_cast<std::uint64_t>(bits);
  const std::uint64_t mask = ((std::uint64_t{1} << bits) - 1) << bit % 32;
  const std::uint64_t value = std::uint64_t{field} << bit % 32;
  std::uint32_t &low = words[bit / 32];
  low = static_cast<std::uint32_t>((low & ~mask) | value);
  if (mask >> 32 != 0) {
    std::uint32_t &high = words[bit / 32 + 1];
    high = static_cast<std::uint32_t>((high & ~(mask >> 32)) | value >> 32);
  }
}

} // namespace voxc
