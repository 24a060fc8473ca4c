// From a payload to how its values are coded.
#include "voxc/Layout/Values.h"

#include "voxc/Layout/PaletteBlocks.h"
#include "voxc/Layout/Rgb565.h"
#include "voxc/Layout/ValueBlocks.h"

#include <array>

namespace voxc {
namespace {

/// How the values of a payload are read and checked.
struct Coding {
  std::uint32_t (*valueOfRank)(const WordReader &words, std::uint64_t section, std::uint64_t rank);
  void (*check)(WordReader &words, std::uint64_t section, std::uint64_t voxels, std::uint64_t mostColours);
};

void checkColours(WordReader &words, std::uint64_t section, std::uint64_t voxels, std::uint64_t) {
  checkValues(words, section, voxels, false);
}

void checkRgb565(WordReader &words, std::uint64_t section, std::uint64_t voxels, std::uint64_t) {
  checkValues(words, section, voxels, true);
}

std::uint32_t rgb565OfRank(const WordReader &words, std::uint64_t section, std::uint64_t rank) {
  return ofRgb565(valueOfRank(words, section, rank));
}

/// Labels are below 2^n, be they few or many.
void checkLabels(WordReader &words, std::uint64_t section, std::uint64_t voxels, std::uint64_t labels) {
  checkPalette(words, section, voxels, labels);
  for (std::uint64_t i = 0; !words.problem() && i < paletteColours(words, section); ++i)
    if (words[section + 1 + i] >= labels)
      words.fail("label " + std::to_string(words[section + 1 + i]) + " is none of those below " +
                 std::to_string(labels) + ", which the format states");
}

/// In the order of `Payload`; those without values are never asked.
constexpr std::array<Coding, kEnumNames<Payload>.size()> kCodings = {{
    {valueOfRank, checkColours},
    {nullptr, nullptr},
    {nullptr, nullptr},
    {colourOfRank, checkPalette},
    {rgb565OfRank, checkRgb565},
    {colourOfRank, checkLabels},
}};

const Coding &codingOf(Payload payload) { return kCodings[static_cast<std::size_t>(payload)]; }

} // namespace

std::uint32_t valueOfRank(const WordReader &words, Payload payload, std::uint64_t rank) {
  return codingOf(payload).valueOfRank(words, words.wordOf(words[1]), rank);
}

std::uint32_t valueOfVoxel(const WordReader &words, const Layout &layout, std::uint32_t value,
                           std::uint64_t rank) {
  if (layout.ranksVoxels())
    return valueOfRank(words, layout.payload, rank);
  return layout.hasOneColour() ? words[1] : value;
}

std::function<std::uint32_t(std::uint32_t)> roundingOf(Payload payload) {
  const PayloadKind &kind = kindOf(payload);
  if (!kind.code)
    return {};
  return [&kind](std::uint32_t word) { return kind.decode(kind.code(word)); };
}

void checkValues(WordReader &words, const Layout &layout, std::uint64_t voxels) {
  codingOf(layout.payload)
      .check(words, words.wordOf(words[1]), voxels, std::uint64_t{1} << layout.payloadBits);
}

} // namespace voxc
