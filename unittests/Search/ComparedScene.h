// A scene for which formats are priced, and of which they are built: the words are to be the same.
#pragma once

#include "voxc/Construct/Constructor.h"
#include "voxc/Search/Candidate.h"
#include "voxc/Search/SceneValues.h"
#include "voxc/Search/SizeModel.h"
#include "voxc/Source/VoxelSource.h"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace voxc::test {

/// Volumes of more words take too long for every day.
inline constexpr std::uint64_t kMostComparedWords = std::uint64_t{1} << 25;

class ComparedScene {
public:
  /// Reads the source once. It has few voxels: a grid of all is kept.
  ComparedScene(std::string name, VoxelSource &source);

  const CandidateTraits &traits() const { return traits_; }

  /// True if the format is priced, and its words are said to be exact. False too where `compare` compares
  /// nothing.
  bool claimsExactness(const Format &format);

  /// Expects that as many words are built as are predicted; about as many, where no more is claimed. Returns
  /// true if they were compared exactly. They are not compared where the scene is larger than the format, its
  /// values are not counted for the format's payload, or there are too many words.
  bool compare(const Format &format, const Constructor &constructor);

private:
  /// Of one side, which is that of a format.
  struct Graphs {
    std::unique_ptr<SceneDag> colours, shape;
    std::array<std::unique_ptr<SizeModel>, 2> sizeModels; ///< By shape, and by colours.
  };

  /// None where nothing is to be compared.
  std::optional<Price> price(const Format &format);
  SizeModel &sizeModel(int log2Side, bool byColours);

  std::string name_;
  std::unique_ptr<VoxelSource> grid_;
  SceneValues::Cheapest values_;
  CandidateTraits traits_;
  std::map<int, Graphs> graphs_;
};

} // namespace voxc::test
