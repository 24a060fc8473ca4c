// Minecraft's blocks by their names, and by the numbers that they had before.
#include "Input/Minecraft/BlockColours.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace voxc {
namespace {

std::uint32_t blockWord(const std::string &name) { return blockLook(name).word; }

TEST(BlockColours, NamesHaveColours) {
  EXPECT_EQ(blockWord("minecraft:white_wool"), 0xffecece9u);
  EXPECT_EQ(blockWord("oak_planks"), blockWord("minecraft:oak_stairs[facing=east]"));
  EXPECT_EQ(blockWord("stone_bricks"), blockWord("stone_brick_wall"));
  EXPECT_EQ(blockWord("quartz_block"), blockWord("quartz_slab"));
  EXPECT_EQ(blockWord("stripped_birch_log"), blockWord("birch_planks"));
  EXPECT_EQ(blockWord("waxed_cut_copper_stairs"), blockWord("cut_copper"));
  EXPECT_NE(blockWord("red_concrete"), blockWord("red_terracotta"));
  EXPECT_NE(blockWord("red_sandstone"), blockWord("red_wool"));
  for (const char *air : {"air", "minecraft:cave_air", "minecraft:void_air", "structure_void"})
    EXPECT_EQ(blockWord(air), 0u);
  for (const char *known :
       {"deepslate_diamond_ore", "polished_blackstone_brick_stairs", "lime_stained_glass_pane",
        "potted_dark_oak_sapling", "petrified_oak_slab", "potted_flowering_azalea_bush", "cherry_leaves",
        "dark_oak_wall_hanging_sign", "mossy_stone_brick_slab", "warped_hyphae",
        "light_gray_glazed_terracotta", "dead_tube_coral_block", "bamboo_mosaic", "end_stone_brick_wall"})
    EXPECT_TRUE(blockLook(known).isKnown) << known;
  EXPECT_FALSE(blockLook("mod:stone").isKnown);
  EXPECT_FALSE(blockLook("zorkmid").isKnown);
  EXPECT_EQ(blockWord("zorkmid[a=1]"), blockWord("zorkmid[a=2]"));
  EXPECT_NE(blockWord("zorkmid"), blockWord("zorkmie"));
}

TEST(BlockColours, SomeBlocksDoNotFillTheirCells) {
  for (const char *whole :
       {"stone", "sea_lantern", "powder_snow", "mushroom_stem", "bedrock", "grass_block", "mangrove_roots",
        "muddy_mangrove_roots", "bamboo_block", "crafting_table", "dripstone_block"})
    EXPECT_TRUE(blockLook(whole).fillsCell) << whole;
  for (const char *part :
       {"oak_stairs", "torch", "wall_torch", "snow", "lantern", "red_bed", "potted_cactus", "chest",
        "lava_cauldron", "bamboo", "enchanting_table", "pointed_dripstone", "crimson_roots", "kelp_plant",
        "dragon_egg", "flowering_azalea", "end_portal_frame", "big_dripleaf_stem", "torchflower"})
    EXPECT_FALSE(blockLook(part).fillsCell) << part;
}

TEST(BlockColours, NumbersOfOldHaveKinds) {
  const std::pair<unsigned, std::string> flowers[]{{0, "sunflower"},  {1, "lilac"},     {2, "tall_grass"},
                                                   {3, "large_fern"}, {4, "rose_bush"}, {5, "peony"}};
  for (const auto &[kind, name] : flowers)
    EXPECT_EQ(oldBlockName(175, kind), name);
  EXPECT_EQ(oldBlockName(43, 8), "smooth_stone");
  EXPECT_EQ(oldBlockName(43, 9), "smooth_sandstone");
  EXPECT_EQ(oldBlockName(43, 15), "smooth_quartz");
  EXPECT_EQ(oldBlockName(43, 12), "bricks");
  EXPECT_EQ(oldBlockName(44, 8), oldBlockName(44, 0));
  EXPECT_EQ(oldBlockName(44, 12), "brick_slab");
  EXPECT_EQ(oldBlockName(38, 6), "white_tulip");
  EXPECT_EQ(oldBlockName(100, 10), "mushroom_stem");
  EXPECT_EQ(oldBlockName(100, 14), "red_mushroom_block");
  for (unsigned number = 0; number < 256; ++number)
    for (unsigned kind = 0; kind < 16; ++kind) {
      const std::string name = oldBlockName(number, kind).value_or("air");
      EXPECT_TRUE(blockLook(name).isKnown) << name;
    }
}

} // namespace
} // namespace voxc
