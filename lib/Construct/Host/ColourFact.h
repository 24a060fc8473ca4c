// What a format states of the colours of all voxels, proven as they come.
#pragma once

#include "Construct/Nodes/ColourTable.h"

#include "voxc/Layout/Layout.h"
#include "voxc/Support/Error.h"

#include <cstdint>
#include <string>

namespace voxc {

/// That there are at most so many, one, or 2^n of a palette; or that each is
/// a label of n bits, of `PayloadKind::labels`. Others state nothing.
class ColourFact {
public:
  explicit ColourFact(VoxelFacts facts);

  bool isStated() const { return most_ > 0; }
  /// The next voxel's colour, of a fact that is stated. False if it is one too much.
  bool take(std::uint32_t colour) {
    return kindOf(facts_.payload).labels ? colour < most_ : colours_.numberOf(colour).has_value();
  }
  /// The first colour if there may be but one, 0 if there is none.
  std::uint32_t one() const { return most_ == 1 && !colours_.colours().empty() ? colours_.colours()[0] : 0; }
  /// What `take` refused; `whatIs`: "voxel (1, 2, 3) is". `isToCome`: an edit would make it.
  Error broken(const std::string &whatIs, std::uint32_t colour, bool isToCome = false) const;

private:
  VoxelFacts facts_;
  std::size_t most_;
  ColourTable colours_;
};

} // namespace voxc
