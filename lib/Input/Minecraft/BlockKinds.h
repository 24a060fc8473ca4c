// What blocks of one number are, from before they had names: stone and granite, the flowers, the slabs.
#pragma once

#include <algorithm>
#include <iterator>
#include <string_view>

namespace voxc {

struct OldKind {
  unsigned number, kind;
  std::string_view name;
};

/// Kinds of other blocks, of which kind 0 is that of the list.
inline constexpr OldKind kOldKinds[] = {{1, 1, "granite"},
                                        {1, 2, "polished_granite"},
                                        {1, 3, "diorite"},
                                        {1, 4, "polished_diorite"},
                                        {1, 5, "andesite"},
                                        {1, 6, "polished_andesite"},
                                        {3, 1, "coarse_dirt"},
                                        {3, 2, "podzol"},
                                        {12, 1, "red_sand"},
                                        {19, 1, "wet_sponge"},
                                        {31, 0, "dead_bush"},
                                        {31, 2, "fern"},
                                        {38, 1, "blue_orchid"},
                                        {38, 2, "allium"},
                                        {38, 3, "azure_bluet"},
                                        {38, 4, "red_tulip"},
                                        {38, 5, "orange_tulip"},
                                        {38, 6, "white_tulip"},
                                        {38, 7, "pink_tulip"},
                                        {38, 8, "oxeye_daisy"},
                                        {43, 1, "sandstone"},
                                        {43, 2, "oak_planks"},
                                        {43, 3, "cobblestone"},
                                        {43, 4, "bricks"},
                                        {43, 5, "stone_bricks"},
                                        {43, 6, "nether_bricks"},
                                        {43, 7, "quartz_block"},
                                        {43, 9, "smooth_sandstone"},
                                        {43, 15, "smooth_quartz"},
                                        {44, 1, "sandstone_slab"},
                                        {44, 2, "oak_slab"},
                                        {44, 3, "cobblestone_slab"},
                                        {44, 4, "brick_slab"},
                                        {44, 5, "stone_brick_slab"},
                                        {44, 6, "nether_brick_slab"},
                                        {44, 7, "quartz_slab"},
                                        {98, 1, "mossy_stone_bricks"},
                                        {98, 2, "cracked_stone_bricks"},
                                        {98, 3, "chiseled_stone_bricks"},
                                        {99, 10, "mushroom_stem"},
                                        {99, 15, "mushroom_stem"},
                                        {100, 10, "mushroom_stem"},
                                        {100, 15, "mushroom_stem"},
                                        {139, 1, "mossy_cobblestone_wall"},
                                        {168, 1, "prismarine_bricks"},
                                        {168, 2, "dark_prismarine"},
                                        {175, 1, "lilac"},
                                        {175, 2, "tall_grass"},
                                        {175, 3, "large_fern"},
                                        {175, 4, "rose_bush"},
                                        {175, 5, "peony"}};

/// The row of a kind; "" if it has none.
constexpr std::string_view rowOfKind(unsigned number, unsigned kind) {
  const auto *const row = std::ranges::find_if(
      kOldKinds, [&](const OldKind &old) { return old.number == number && old.kind == kind; });
  return row == std::end(kOldKinds) ? std::string_view() : row->name;
}

/// The name of a kind that has one beside that of its number, else "". The highest bit of slabs says that
/// they hang, and of double ones that they are smooth.
constexpr std::string_view oldKindName(unsigned number, unsigned kind) {
  constexpr unsigned kDoubleSlab = 43, kSlab = 44;
  const std::string_view own = rowOfKind(number, kind);
  const bool isSlab = number == kDoubleSlab || number == kSlab;
  return own.empty() && isSlab ? rowOfKind(number, kind & 7) : own;
}

} // namespace voxc
