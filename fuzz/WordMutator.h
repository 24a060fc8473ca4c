// A mutator that knows that files are made of words: half of the time one is changed to what could pass for
// an offset, masks or a count, and the rest is libFuzzer's. To be included by one file of a fuzzer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <random>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t *data, std::size_t size, std::size_t most);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t *data, std::size_t size, std::size_t most,
                                               unsigned seed) {
  constexpr std::size_t kWord = 4;
  std::minstd_rand random(seed);
  if (size < kWord || random() % 2 == 0)
    return LLVMFuzzerMutate(data, size, most);
  // What is counted in words often lies at the file's end: places are counted from there.
  const std::size_t words = size / kWord;
  std::uint8_t *const end = data + size;
  std::uint32_t word = 0;
  const std::size_t at = (1 + random() % words) * kWord;
  std::memcpy(&word, end - at, kWord);
  switch (random() % 5) {
  case 0:
    word ^= std::uint32_t{1} << random() % 32;
    break;
  case 1:
    word = static_cast<std::uint32_t>(random() % (words + 2));
    break;
  case 2:
    std::memcpy(&word, end - (1 + random() % words) * kWord, kWord);
    break;
  case 3:
    word += static_cast<std::uint32_t>(random() % 5) - 2;
    break;
  default:
    word = random() % 2 == 0 ? 0 : ~std::uint32_t{0};
  }
  std::memcpy(end - at, &word, kWord);
  return size;
}
