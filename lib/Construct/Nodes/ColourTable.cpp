// Colours by their numbers, and numbers by their colours.
#include "ColourTable.h"

namespace voxc {

std::optional<std::uint32_t> ColourTable::numberOf(std::uint32_t colour) {
  if (colour == last_)
    return lastNumber_;
  if (colours_.size() == most_ && !numbers_.find(colour))
    return std::nullopt;
  std::uint32_t &number = numbers_[colour];
  if (number == 0) {
    colours_.push_back(colour);
    number = static_cast<std::uint32_t>(colours_.size());
  }
  last_ = colour;
  lastNumber_ = number - 1;
  return lastNumber_;
}

} // namespace voxc
