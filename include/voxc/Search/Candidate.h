// Formats that are worth a look, as a user would write them: a string of the grammar and passes.
#pragma once

#include "voxc/IR/Format.h"
#include "voxc/Search/Composition.h"

#include <optional>
#include <string>
#include <vector>

namespace voxc {

struct Candidate {
  std::string text;                       ///< Of the grammar.
  std::vector<std::string> passes;        ///< By name, in order; those that change nothing are left out.
  Format format;                          ///< What the passes make of it.
  std::optional<Composition> composition; ///< None if its levels have other shapes than a search knows.
};

/// What all candidates for a scene have in common.
struct CandidateTraits {
  bool oneColour = false; ///< All voxels have one: it is kept once, else values stand apart.
  int paletteBits = 0;    ///< Else, of a palette for values apart; 0: none.
  bool visible = false;   ///< No voxel has an alpha of 0.
  bool editable = false;  ///< The volume will be edited in place: no choice is made that stands against it.
  int pointerBits = 20;   ///< Of short pointers: 8 to 24, enough for the different grids of 4^3 voxels.
};

/// A candidate of this text, with the passes that make any format smaller or faster, and with those of the
/// choices as far as its levels allow it. Errors: those of the text; its
/// volumes cannot be edited, where they should be.
Expected<Candidate> makeCandidate(const std::string &text, const CandidateTraits &traits,
                                  const FormatChoices &choices);

/// The choices that passes of a candidate stand for.
FormatChoices choicesOf(const std::vector<std::string> &passes);

/// The formats of 2^log2Side voxels a side that `voxc suggest` chooses from: a grid, or one with distances,
/// of any size that is no larger than some, and below it grids with masks, DAGs or an octree; and the same
/// without a grid. Each differs from all others. Precondition: log2Side is 1 to 21.
std::vector<Candidate> candidatesFor(int log2Side, const CandidateTraits &traits);

} // namespace voxc
