// What a format states of all voxels, proved of each as it comes.
#pragma once

#include "ColourFact.h"

#include "voxc/Layout/Layout.h"
#include "voxc/Support/Error.h"
#include "voxc/Support/Geometry.h"

#include <cstdint>
#include <optional>

namespace voxc {

class VoxelProof {
public:
  /// `isToCome`: of voxels that an edit would make, which messages say.
  explicit VoxelProof(VoxelFacts facts, bool isToCome = false)
      : facts_(facts), isToCome_(isToCome), colours_(facts) {}

  /// True if something is stated that not every voxel keeps.
  bool isNeeded() const;
  /// What is wrong with a voxel of this word, which is not 0.
  std::optional<Error> prove(Int3 at, std::uint32_t word);
  /// True if voxels keep their words, and what is kept of one.
  bool keepsWords() const { return kindOf(facts_.payload).varies; }
  std::uint32_t kept(std::uint32_t word) const {
    return word == 0 || kindOf(facts_.payload).varies ? word : kOccupied;
  }
  /// The one colour of all voxels so far, of a payload of one; 0: none yet.
  std::uint32_t colour() const { return colours_.one(); }

private:
  VoxelFacts facts_;
  bool isToCome_;
  ColourFact colours_;
};

} // namespace voxc
