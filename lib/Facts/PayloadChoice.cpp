// The rules, from what asks most of the colours to what asks nothing.
#include "voxc/Facts/PayloadChoice.h"

#include <algorithm>

namespace voxc {
namespace {

/// Bits of an index into the largest palette that there is.
constexpr int kLargestIndex = 16;
/// Voxels for each colour of a palette, at least: each takes a word there.
constexpr std::uint64_t kVoxelsOfColour = 16;

std::string counted(const ColourFacts &colours) {
  return (colours.words.exact ? "" : "about ") + std::to_string(colours.words.count) + " colours";
}

} // namespace

std::vector<PayloadChoice> choosePayload(const Facts &facts) {
  const ColourFacts &colours = facts.colours;
  std::vector<PayloadChoice> choices;
  if (colours.words.count == 1)
    choices.push_back({"constant", false, "all voxels have one colour"});
  const int bits = std::max(colours.indexBits(), 1);
  if (colours.words.count > 0 && colours.words.exact && bits <= kLargestIndex &&
      colours.words.count * kVoxelsOfColour <= facts.voxels)
    choices.push_back({"palette(" + std::to_string(bits) + ")", true,
                       counted(colours) + ", which indices of " + std::to_string(bits) +
                           (bits == 1 ? " bit" : " bits") + " distinguish"});
  choices.push_back({"rgba8", true, counted(colours) + ", too many for a palette to gain"});
  choices.push_back({"rgba8", false, counted(colours)});
  return choices;
}

} // namespace voxc
