// Tables of Minecraft's blocks. Colours are 0xRRGGBB, about what a block looks like from afar.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace voxc {

struct BlockDye {
  std::string_view name;
  std::uint32_t wool, concrete, terracotta;
};

struct BlockWood {
  std::string_view name;
  std::uint32_t planks, bark, leaves;
};

struct PlainBlock {
  std::string_view name;
  std::uint32_t colour;
};

/// In the order of their numbers before version 1.13.
std::span<const BlockDye> blockDyes();
/// The first six in the order of their numbers before version 1.13.
std::span<const BlockWood> blockWoods();
/// Blocks by their whole name, without the shapes that there are of many.
std::span<const PlainBlock> plainBlocks();
/// Parts of names of which there are many, the surest first.
std::span<const PlainBlock> blockParts();
/// Parts of the names of blocks that do not fill their cell; one that begins with '_' ends the name, and
/// one that begins with '=' is all of it.
std::span<const std::string_view> partialBlocks();

} // namespace voxc
