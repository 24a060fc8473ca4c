// Counting colours, and telling which is one too much.
#include "ColourFact.h"

#include <array>
#include <cstdio>

namespace voxc {
namespace {

std::size_t mostColours(VoxelFacts facts) {
  const PayloadKind &kind = kindOf(facts.payload);
  if (kind.oneColour)
    return 1;
  return kind.mostBits > 0 ? std::size_t{1} << facts.payloadBits : 0;
}

/// "#rrggbbaa".
std::string colourText(std::uint32_t word) {
  std::array<char, 12> text{};
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x%02x", word & 255, word >> 8 & 255, word >> 16 & 255,
                word >> 24);
  return text.data();
}

constexpr int kMostLabelBits = 16;

bool isLabel(std::uint32_t word) { return word >> kMostLabelBits == 0; }

std::string ofLabel(std::uint32_t word, bool isToCome) {
  if (isLabel(word))
    return " of label " + std::to_string(word);
  return isToCome ? " of a colour" : " of a colour, or of a sample that is no whole number below 2^16";
}

/// What would be right for a word that is no label; an edit has no input whose options could help.
const char *remedyFor(std::uint32_t word, bool isToCome) {
  if (isLabel(word))
    return "build it with more bits";
  return isToCome ? "the word of a label is its number, as label 5 is written 05000000 in digits rrggbbaa"
                  : "--colour-map labels takes labels from a dense volume or MagicaVoxel models, other "
                    "inputs have none; numbers below 0 and fractions are attached to a volume without "
                    "labels: voxc attach V.hvx --words hu=INPUT -o V.hvx";
}

} // namespace

ColourFact::ColourFact(VoxelFacts facts)
    : facts_(facts), most_(mostColours(facts)), colours_(mostColours(facts)) {}

Error ColourFact::broken(const std::string &whatIs, std::uint32_t colour, bool isToCome) const {
  if (kindOf(facts_.payload).labels)
    return Error::input(whatIs + ofLabel(colour, isToCome) + ", but the format states payload=material(" +
                        std::to_string(facts_.payloadBits) + "), labels from 1 to " +
                        std::to_string(most_ - 1) + "; " + remedyFor(colour, isToCome));
  const std::string is = whatIs + " " + colourText(colour) + ", others ";
  if (kindOf(facts_.payload).oneColour)
    return Error::input(is + "are " + colourText(one()) +
                        ", but the format states payload=constant; build it without constant-colour");
  return Error::input(is + "have " + std::to_string(colours_.colours().size()) +
                      " colours, but the format states payload=palette(" +
                      std::to_string(facts_.payloadBits) +
                      "); build it without palette, or with a larger number");
}

} // namespace voxc
