// The rules, as a table of functions from facts to a sentence.
#include "voxc/Facts/Recommendations.h"

#include "voxc/Facts/PointerChoice.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdio>

namespace voxc {

namespace {

constexpr double kSolid = 0.25;           // Interior voxels from here up are worth a word,
constexpr double kSurface = 0.05;         // and below here are none to speak of.
constexpr double kMerged = 0.25;          // Voxels in uniform cubes, from here up: trees gain by merging.
constexpr double kRepeats = 0.25;         // Blocks that repeat another, from here up: sharing pays.
constexpr double kSmallPalette = 16;      // Colours of a block that an index of 4 bits tells apart.
constexpr int kLargestIndex = 16;         // Bits of an index into a palette of the whole scene.
constexpr std::uint64_t kFewBlocks = 64;  // Too few to say how often blocks repeat.
constexpr std::size_t kRepeatHeight = 3;  // Of the blocks that are compared.
constexpr std::size_t kUniformHeight = 2; // Of the cubes whose merging is looked at.
constexpr std::size_t kGridHeight = 2;    // Of the sub-volumes that short pointers lead to.

std::string percent(double share) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f %%", 100 * share);
  return text;
}

std::string tenths(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", number);
  return text;
}

std::string colourCount(const DistinctCount &words) {
  return (words.exact ? "" : "About ") + std::to_string(words.count) + " colours";
}

std::string ruleOfVoxels(const Facts &facts) {
  return facts.voxels > 0 ? "" : "There are no voxels: any format will do.";
}

std::string ruleOfBox(const Facts &facts) {
  const Int3 box = facts.boxHigh - facts.boxLow;
  const auto longest = static_cast<std::uint32_t>(std::max({box.x, box.y, box.z}));
  const int log2Side = longest == 0 ? 0 : std::bit_width(longest - 1);
  if (facts.voxels == 0 || log2Side >= facts.log2Extent)
    return "";
  return "The voxels lie in a box of " + std::to_string(box.x) + " x " + std::to_string(box.y) + " x " +
         std::to_string(box.z) + ": with --crop a cube of 2^" + std::to_string(log2Side) + " holds them.";
}

std::string ruleOfAlpha(const Facts &facts) {
  const ColourFacts &colours = facts.colours;
  if (facts.voxels == 0)
    return "";
  if (colours.transparent > 0)
    return "Voxels with an alpha of 0: " + std::to_string(colours.transparent) +
           "; a build with --visible-voxels would fail.";
  if (colours.opaque == facts.voxels)
    return "All voxels are opaque: --visible-voxels holds, and alpha says nothing.";
  return "No voxel has an alpha of 0: --visible-voxels holds.";
}

std::string ruleOfColours(const Facts &facts) {
  const ColourFacts &colours = facts.colours;
  if (facts.voxels == 0)
    return "";
  if (colours.words.count == 1)
    return "All voxels have one colour: --constant-colour keeps it once, and shapes alone besides.";
  std::string text = colourCount(colours.words) + ": ";
  if (colours.indexBits() <= kLargestIndex)
    return text + "an index into one palette takes " + std::to_string(colours.indexBits()) +
           (colours.indexBits() == 1 ? " bit" : " bits") + " in place of the 32 of a word.";
  text += "too many for one palette";
  if (colours.perBlock8 <= kSmallPalette)
    text += ", but a block of 8^3 has " + tenths(colours.perBlock8) +
            " of them in the mean, which a small palette of its own holds";
  return text + ".";
}

std::string ruleOfInterior(const Facts &facts) {
  if (facts.voxels == 0)
    return "";
  if (facts.interiorShare() < kSurface)
    return percent(facts.interiorShare()) + " of the voxels are interior: nearly all touch an empty cell.";
  if (facts.interiorShare() < kSolid || facts.heights.size() <= kUniformHeight)
    return "";
  const double merged =
      double(facts.heights[kUniformHeight].uniform) * double(1 << 3 * kUniformHeight) / double(facts.voxels);
  return percent(facts.interiorShare()) + " of the voxels are interior, " +
         (merged < kMerged ? "but only " : "and ") + percent(merged) +
         " lie in full cubes of 4^3 of one colour: trees (S, G) " +
         (merged < kMerged ? "merge little" : "keep each as one leaf") +
         "; --interior drop leaves out all that no ray from outside reaches.";
}

std::string ruleOfRepetition(const Facts &facts) {
  if (facts.repetition.size() < kRepeatHeight || facts.repetition[kRepeatHeight - 1].blocks < kFewBlocks)
    return "";
  const RepetitionFacts &blocks = facts.repetition[kRepeatHeight - 1];
  const double shapes = 1 - double(blocks.shapes.count) / double(blocks.blocks);
  const double coloured = 1 - double(blocks.coloured.count) / double(blocks.blocks);
  if (shapes < kRepeats)
    return percent(shapes) + " of the blocks of 8^3 repeat another's shape: a DAG (G) has little to share.";
  if (coloured < kRepeats)
    return percent(shapes) + " of the blocks of 8^3 repeat another's shape, but " + percent(coloured) +
           " its colours too: a DAG (G) shares them with --values-apart.";
  return percent(coloured) + " of the blocks of 8^3 repeat another with its colours: a DAG (G) shares them.";
}

/// How many bits number the sub-volumes of a last M(2^3).
std::string ruleOfPointers(const Facts &facts) {
  if (facts.repetition.size() < kGridHeight || facts.repetition[kGridHeight - 1].blocks < kFewBlocks)
    return "";
  const DistinctCount &shapes = facts.repetition[kGridHeight - 1].shapes;
  const std::optional<int> bits = choosePointerBits(facts);
  if (!shapes.exact || !bits)
    return "";
  return "The blocks of 4^3 have " + std::to_string(shapes.count) +
         " shapes: --short-pointers=" + std::to_string(*bits) +
         " numbers them, where M(2^3) is the last level.";
}

/// What a volume that is edited in place cannot have.
std::string ruleOfEdits(const Facts &facts) {
  if (facts.voxels == 0 || facts.colours.words.count == 1)
    return "";
  return "Edits in place (voxc edit --journal) ask for colours in the nodes, 32 bits each: a palette, "
         "--values-apart and --short-pointers forbid them, and voxc suggest --editable leaves these out.";
}

struct Rule {
  std::string_view name;
  std::string (*apply)(const Facts &); ///< A sentence, or "".
};

constexpr std::array<Rule, 8> kRules{{{"voxels", ruleOfVoxels},
                                      {"box", ruleOfBox},
                                      {"alpha", ruleOfAlpha},
                                      {"colours", ruleOfColours},
                                      {"interior", ruleOfInterior},
                                      {"repetition", ruleOfRepetition},
                                      {"pointers", ruleOfPointers},
                                      {"edits", ruleOfEdits}}};

} // namespace

std::vector<Recommendation> recommend(const Facts &facts) {
  std::vector<Recommendation> recommendations;
  for (const Rule &rule : kRules)
    if (std::string text = rule.apply(facts); !text.empty())
      recommendations.push_back({rule.name, std::move(text)});
  return recommendations;
}

} // namespace voxc
