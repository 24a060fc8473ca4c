// The palette of a MagicaVoxel file: colours with materials.
#pragma once

#include "Source/Export/VoxBytes.h"
#include "Source/Export/VoxelLooks.h"

#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace voxc {

/// So many entries has a palette.
inline constexpr std::size_t kMostVoxEntries = 255;

/// What entries are made of: words that are labels or colours, and looks, the first of which says nothing.
struct VoxLooksOf {
  bool areLabels = false;
  std::span<const VoxelLook> looks;
};

/// The numbers of pairs of colour and look: given out as they come, or, of labels, those themselves, each
/// with the first look that comes.
class VoxEntries {
public:
  explicit VoxEntries(const VoxLooksOf &looks);

  /// From 1 to 255, or more if there is none.
  std::uint32_t numberOf(std::uint32_t word, std::uint32_t look);

  /// The chunk of colours and those of materials.
  void addChunks(VoxBytes &children) const;

  /// Whether each voxel's look is one that its material holds.
  bool areWhole() const;

private:
  struct Entry {
    std::uint32_t colour = 0;
    std::uint32_t look = 0;
    bool isUsed = false;
  };

  VoxLooksOf of_;
  std::vector<Entry> entries_; ///< From number 1 on.
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> numbers_;
  bool haveLabelsOneLook_ = true;
};

} // namespace voxc
