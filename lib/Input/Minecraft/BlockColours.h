// The colours of Minecraft's blocks, by their names.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voxc {

/// What a block looks like from afar.
struct BlockLook {
  std::uint32_t word = 0; ///< 0: air and what is not seen.
  bool isKnown = true;    ///< False: nothing is known of the name; the colour is one made of it.
  bool fillsCell = true;  ///< False: stairs, torches and the like.
};

/// The look of a name such as "minecraft:oak_stairs[facing=east]"; what stands in brackets has no part in it.
BlockLook blockLook(std::string_view name);

/// The name of a block of the numbers that were used before version 1.13, such as 35 and 14 for red wool;
/// nothing for a number that was not used.
std::optional<std::string> oldBlockName(unsigned number, unsigned kind);

} // namespace voxc
