// Open addressing over the numbers of colours.
#include "ColourTable.h"

#include <algorithm>

namespace voxc {
namespace {

std::size_t hashOf(std::uint32_t colour) {
  const std::uint64_t mixed = colour * 0x9e3779b97f4a7c15u;
  return static_cast<std::size_t>(mixed >> 32);
}

} // namespace

void ColourTable::grow() {
  places_.assign(std::max<std::size_t>(2 * places_.size(), 16), 0);
  for (std::size_t number = 0; number < colours_.size(); ++number) {
    std::size_t at = hashOf(colours_[number]);
    while (places_[at & (places_.size() - 1)] != 0)
      ++at;
    places_[at & (places_.size() - 1)] = static_cast<std::uint32_t>(number + 1);
  }
}

std::optional<std::uint32_t> ColourTable::numberOf(std::uint32_t colour) {
  if (colour == last_)
    return lastNumber_;
  if (2 * colours_.size() >= places_.size())
    grow();
  std::size_t at = hashOf(colour);
  std::uint32_t *place = &places_[at & (places_.size() - 1)];
  while (*place != 0 && colours_[*place - 1] != colour)
    place = &places_[++at & (places_.size() - 1)];
  if (*place == 0) {
    if (colours_.size() == most_)
      return std::nullopt;
    colours_.push_back(colour);
    *place = static_cast<std::uint32_t>(colours_.size());
  }
  last_ = colour;
  lastNumber_ = *place - 1;
  return lastNumber_;
}

} // namespace voxc
