// Formats that are worth a look.
#include "voxc/Search/Candidate.h"

#include "voxc/Layout/Edits.h"
#include "voxc/Layout/Layout.h"
#include "voxc/Passes/Pass.h"

#include <algorithm>
#include <set>

namespace voxc {
namespace {

/// Of a grid at the top: 2^27 cells, half a gigabyte.
constexpr int kMaxLog2Grid = 9;
constexpr int kMinLog2Grid = 2;

/// What lies below a grid, or is all: `side` heights.
std::vector<std::string> tailsOf(int side) {
  if (side == 0)
    return {""};
  const auto number = [](int value) { return std::to_string(value); };
  std::vector<std::string> tails = {"G(" + number(side) + ")", "S(" + number(side) + ")"};
  // Grids with masks of 4^3 cells, and one of 2^3 where a height is left over.
  const auto masked = [](int heights) {
    std::string text;
    for (int i = 0; i < heights / 2; ++i)
      text += " M(2^3)";
    return text + (heights % 2 != 0 ? " M(1^3)" : "");
  };
  tails.push_back(masked(side).substr(1));
  if (side % 2 == 0)
    tails.push_back("G(" + number(side) + ", 2)");
  if (side > 2)
    tails.push_back("G(" + number(side - 2) + ")" + masked(2));
  if (side > 2 && side % 2 == 0)
    tails.push_back("G(" + number(side - 2) + ", 2)" + masked(2));
  // A small grid takes few words where most of its cells are full, and is read with one look.
  for (const int grid : {1, 2})
    if (side > grid + 1)
      tails.push_back("R(" + number(grid) + "^3)" + masked(side - grid));
  if (side <= 3)
    tails.push_back("R(" + number(side) + "^3)");
  return tails;
}

std::vector<std::string> textsFor(int log2Side) {
  std::vector<std::string> texts = tailsOf(log2Side);
  for (int grid = kMinLog2Grid; grid <= std::min(log2Side, kMaxLog2Grid); ++grid)
    for (const std::string &tail : tailsOf(log2Side - grid))
      for (const char *kind : {"R", "D"}) {
        std::string &text = texts.emplace_back(kind);
        text.append("(").append(std::to_string(grid)).append("^3").append(*kind == 'R' ? ")" : ", 15)");
        text.append(tail.empty() ? "" : " ").append(tail);
      }
  return texts;
}

/// The same format, if the pass does not apply.
void applyPass(Candidate &candidate, const std::string &pass) {
  Format changed = candidate.format;
  Diagnostics diagnostics;
  const Pass &found = *findPass(pass);
  const std::size_t number = pass.find('=');
  const auto with =
      number == std::string::npos ? std::nullopt : std::optional(std::stoi(pass.substr(number + 1)));
  if (found.run(changed, diagnostics, with) != PassResult::Changed)
    return;
  candidate.format = std::move(changed);
  candidate.passes.push_back(pass);
}

} // namespace

Expected<Candidate> makeCandidate(const std::string &text, const CandidateTraits &traits,
                                  const FormatChoices &choices) {
  auto format = VOXC_TRY(parseFormat(text));
  Candidate candidate{text, {}, std::move(format), {}};
  candidate.composition = compositionOf(candidate.format);
  if (candidate.composition)
    candidate.composition->choices = choices;
  if (traits.visible)
    applyPass(candidate, "visible-voxels");
  for (const char *pass : {"whole-level-dedup", "share-grids", "octant-distances", "df-packing"})
    applyPass(candidate, pass);
  if (traits.oneColour || !traits.editable)
    applyPass(candidate, traits.oneColour         ? "constant-colour"
                         : traits.paletteBits > 0 ? "palette=" + std::to_string(traits.paletteBits)
                                                  : "values-apart");
  if (choices.grids != SmallGrids::Pointed && !traits.editable) {
    applyPass(candidate, "short-pointers=" + std::to_string(traits.pointerBits));
    for (const Pass &pass : passes())
      if (pass.besidePointers)
        applyPass(candidate, std::string(pass.name));
  }
  if (choices.grids == SmallGrids::ByOctants && !traits.editable)
    applyPass(candidate, "octant-masks");
  if (!choices.traversal.empty())
    applyPass(candidate, std::string(choices.traversal));
  if (const std::string reason = traits.editable ? whyNoEdits(layoutOf(candidate.format)) : "";
      !reason.empty())
    return Error::input("'" + text + "' cannot be edited: " + reason);
  return candidate;
}

FormatChoices choicesOf(const std::vector<std::string> &passes) {
  FormatChoices choices;
  for (const std::string &pass : passes) {
    if (pass.starts_with("short-pointers"))
      choices.grids = SmallGrids::Numbered;
    if (pass == "octant-masks") // Which stands behind it.
      choices.grids = SmallGrids::ByOctants;
    if (const auto traversal = std::ranges::find(searchedTraversals(), pass);
        traversal != searchedTraversals().end())
      choices.traversal = *traversal;
  }
  return choices;
}

std::vector<Candidate> candidatesFor(int log2Side, const CandidateTraits &traits) {
  std::vector<Candidate> candidates;
  std::set<std::string> known;
  for (const std::string &text : textsFor(log2Side))
    for (const SmallGrids grids : {SmallGrids::Pointed, SmallGrids::Numbered, SmallGrids::ByOctants})
      if (auto candidate = makeCandidate(text, traits, {.grids = grids}))
        if (known.insert(printIr(candidate->format)).second)
          candidates.push_back(std::move(*candidate));
  return candidates;
}

} // namespace voxc
