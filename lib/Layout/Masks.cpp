// What masks of files must keep to.
#include "Masks.h"

namespace voxc {
namespace {

bool fail(WordReader &words, const char *problem) {
  words.fail(problem);
  return false;
}

} // namespace

bool Masks::check(WordReader &words, bool lowest) const {
  // Bits past those that mean something, in the only word that can have any.
  const std::uint64_t used = shape_.sharesWord ? 2 * shape_.children : shape_.children;
  if (used < 32 && words_[at_] >> used != 0)
    return fail(words, "a node's masks use bits that have no meaning");
  std::uint64_t sum = 0;
  for (std::uint64_t i = 0; i < shape_.setWords(); ++i) {
    if (shape_.counts && words_[at_ + 2 * i + 1] != sum)
      return fail(words, "a node counts other children than its mask has");
    sum += bits(word(i));
  }
  if (sum == 0)
    return fail(words, "a node has no child");
  if (!shape_.hasLeaves)
    return true;
  for (std::uint64_t i = 0; i < shape_.setWords(); ++i) {
    if ((leaves(i) & ~word(i)) != 0)
      return fail(words, "a node has a leaf that is empty");
    if (lowest && (word(i) & ~leaves(i)) != 0)
      return fail(words, "a node of cells has a child that is not a leaf");
  }
  return true;
}

} // namespace voxc
