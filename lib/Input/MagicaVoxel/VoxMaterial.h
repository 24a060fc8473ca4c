// A material of a MagicaVoxel file, from the texts of its chunk.
#pragma once

#include "Input/MagicaVoxel/VoxFile.h"

#include <cstdint>
#include <optional>
#include <string_view>

namespace voxc {

/// What the pairs of a chunk MATL say, one after the other.
class VoxMaterial {
public:
  /// A text that is no number, or not from 0 up to the most it may be, says nothing.
  void read(std::string_view key, std::string_view value);

  /// Makes it that of the colour `number`, below 256.
  void keep(VoxFile &file, std::uint32_t number) const;

private:
  struct Row;
  static const Row kRows[];

  std::optional<VoxLook> look_;
  std::optional<double> rough_, metal_, emit_, flux_, trans_, alpha_;
  std::optional<double> weight_; ///< Old files have it in place of the share that their type is about.
};

} // namespace voxc
