// The different colours of a scene, numbered as they come.
#pragma once

#include "Support/HashTable.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace voxc {

/// At most so many colours.
class ColourTable {
public:
  explicit ColourTable(std::size_t most) : most_(most) {}

  /// The number of a colour, which is kept if it is new; nothing if there is no room for it. Not of the word
  /// 0, which is no voxel.
  std::optional<std::uint32_t> numberOf(std::uint32_t colour);

  /// In the order of their numbers.
  std::span<const std::uint32_t> colours() const { return colours_; }

private:
  std::size_t most_;
  std::vector<std::uint32_t> colours_;
  HashTable<std::uint32_t, std::uint32_t> numbers_; ///< Of each colour, counted from 1 on.
  std::uint32_t last_ = 0;                          ///< Voxels often have the colour of the one before.
  std::uint32_t lastNumber_ = 0;
};

} // namespace voxc
