// How instances lie in a buffer of words.
#include "InstanceLayout.h"

#include <cstring>

namespace voxc {
namespace {

constexpr std::size_t kHeaderWords = 16, kWordBytes = sizeof(std::uint32_t);

/// Values as words, whatever they are.
template <typename T> void append(std::vector<std::uint32_t> &words, const T &value) {
  static_assert(sizeof(T) % kWordBytes == 0);
  const std::size_t at = words.size();
  words.resize(at + sizeof(T) / kWordBytes);
  std::memcpy(&words[at], &value, sizeof(T));
}

} // namespace

std::vector<std::uint32_t> worldWords(const InstanceTree &tree, std::span<const std::uint32_t> wordsOfRays,
                                      std::span<const InstanceRecord> instances) {
  std::vector<std::uint32_t> words;
  append(words, static_cast<std::uint32_t>(tree.nodes().size()));
  append(words, static_cast<std::uint32_t>(tree.everywhere().size()));
  append(words, tree.leastDirection());
  append(words, tree.low());
  append(words, tree.high());
  append(words, tree.slack());
  words.resize(kHeaderWords);
  words.insert(words.end(), wordsOfRays.begin(), wordsOfRays.end());
  for (const InstanceTree::Node &node : tree.nodes())
    append(words, node);
  words.insert(words.end(), tree.everywhere().begin(), tree.everywhere().end());
  for (const InstanceRecord &instance : instances) {
    for (int column = 0; column < 4; ++column)
      for (int row = 0; row < 3; ++row)
        append(words, instance.fromWorld[column][row]);
    append(words, instance.volume);
  }
  return words;
}

} // namespace voxc
