// Groups of Minecraft's blocks: dyes, woods and parts of names.
#include "Input/Minecraft/BlockTables.h"

#include <array>

namespace voxc {

namespace {

constexpr std::array kDyes = std::to_array<BlockDye>({
    {"white", 0xe9ecec, 0xcfd5d6, 0xd1b2a1},
    {"orange", 0xf07613, 0xe06101, 0xa15325},
    {"magenta", 0xbd44b3, 0xa9309f, 0x95576c},
    {"light_blue", 0x3aafd9, 0x2389c7, 0x716c89},
    {"yellow", 0xf8c527, 0xf1af15, 0xba8523},
    {"lime", 0x70b919, 0x5ea918, 0x677535},
    {"pink", 0xed8dac, 0xd6658f, 0xa14e4e},
    {"gray", 0x3e4447, 0x36393d, 0x392a23},
    {"light_gray", 0x8e8e86, 0x7d7d73, 0x876a61},
    {"cyan", 0x158991, 0x157788, 0x565b5b},
    {"purple", 0x792aac, 0x641f9c, 0x764656},
    {"blue", 0x35399d, 0x2c2e8f, 0x4a3b5b},
    {"brown", 0x724728, 0x603b1f, 0x4d3323},
    {"green", 0x546d1b, 0x495b24, 0x4c532a},
    {"red", 0xa12722, 0x8e2020, 0x8f3d2e},
    {"black", 0x141519, 0x080a0f, 0x251610},
});

constexpr std::array kWoods = std::to_array<BlockWood>({
    {"oak", 0xa2834f, 0x6d5533, 0x4a7a26},
    {"spruce", 0x735531, 0x3b2611, 0x3f5f3f},
    {"birch", 0xc0af79, 0xd8d7d2, 0x61803c},
    {"jungle", 0xa07351, 0x554419, 0x30801c},
    {"acacia", 0xa85a32, 0x676157, 0x4c7a26},
    {"dark_oak", 0x432b14, 0x3c2f1a, 0x3c6620},
    {"pale_oak", 0xe3d9d8, 0x5a504c, 0x737a6f},
    {"mangrove", 0x763631, 0x544329, 0x4d7525},
    {"cherry", 0xe3b3ad, 0x36212c, 0xe5acc2},
    {"bamboo", 0xc2ad51, 0x7f903a, 0x5d7a1d},
    {"crimson", 0x653147, 0x5d1a1e, 0x831c1c},
    {"warped", 0x2b6963, 0x3a3b4e, 0x167e86},
    {"azalea", 0x647c2e, 0x5a4a30, 0x5a732c},
    {"flowering_azalea", 0x6e6f42, 0x5a4a30, 0x646f3c},
});

constexpr std::array kParts = std::to_array<PlainBlock>({
    {"deepslate_", 0x57575a},  {"dead_", 0x837b77},        {"tube_coral", 0x3157cf},
    {"brain_coral", 0xcf5b9f}, {"bubble_coral", 0xa51aa2}, {"fire_coral", 0xa3232e},
    {"horn_coral", 0xd8c842},  {"tulip", 0xc36b4b},        {"blackstone", 0x2f2a31},
    {"sandstone", 0xd8cb9b},   {"copper", 0xc06c50},       {"quartz", 0xece6df},
    {"prismarine", 0x639c97},  {"purpur", 0xaa7eaa},       {"tuff", 0x6c6d66},
    {"amethyst", 0x9a77c9},    {"cauldron", 0x4a494b},     {"sculk", 0x0c1d24},
    {"glass", 0xc8e4ea},       {"leaves", 0x4a7a26},       {"planks", 0xa2834f},
    {"_log", 0x6d5533},        {"mushroom", 0xb0604f},     {"torch", 0xffd86b},
    {"candle", 0xe8cc9c},      {"melon_stem", 0x8a9a3a},   {"pumpkin_stem", 0x8a9a3a},
    {"_skull", 0xc9c9c9},      {"_head", 0x8a7a5a},        {"_ore", 0x7d7d7d},
    {"vines", 0x5b6d29},       {"dripleaf", 0x708e34},     {"crop", 0x7a8a3a},
    {"eyeblossom", 0x6a6a6a},  {"moss", 0x596d2d},         {"weighted_pressure_plate", 0xc9b26a},
    {"brick", 0x976253},       {"stone", 0x7d7d7d},
});

constexpr std::array kPartial = std::to_array<std::string_view>({
    "_stairs",       "_slab",          "_fence",          "_fence_gate",     "_wall",
    "_door",         "_trapdoor",      "_button",         "_pressure_plate", "_sign",
    "_banner",       "_carpet",        "_pane",           "_bars",           "_bed",
    "_rail",         "_torch",         "_candle",         "_sapling",        "_coral",
    "_coral_fan",    "_wall_fan",      "_tulip",          "_skull",          "_head",
    "=lantern",      "=soul_lantern",  "_copper_lantern", "_chain",          "_rod",
    "_anvil",        "_grass",         "_fern",           "_vines",          "_vine",
    "_mushroom",     "=crimson_roots", "_fungus",         "_petals",         "_cluster",
    "_bud",          "_campfire",      "_lever",          "_ladder",         "=snow",
    "_hopper",       "_repeater",      "_comparator",     "_tripwire",       "_hook",
    "_wire",         "_chest",         "_cake",           "_poppy",          "_dandelion",
    "_allium",       "_orchid",        "_bluet",          "_daisy",          "_cornflower",
    "_rose",         "_sunflower",     "_lilac",          "_peony",          "_bush",
    "_lily_pad",     "_sugar_cane",    "_wheat",          "_carrots",        "_potatoes",
    "_beetroots",    "melon_stem",     "pumpkin_stem",    "_cobweb",         "_pot",
    "_seagrass",     "_kelp",          "_wart",           "_cactus",         "_fire",
    "_portal",       "_brewing_stand", "_bell",           "potted_",         "_lichen",
    "_egg",          "=warped_roots",  "=hanging_roots",  "_scaffolding",    "_conduit",
    "=bamboo",       "_pickle",        "_lectern",        "enchanting_",     "_stonecutter",
    "_grindstone",   "_cauldron",      "_composter",      "_azalea",         "_cocoa",
    "_plant",        "_flower",        "pointed_",        "_farmland",       "_path",
    "_detector",     "_sculk_sensor",  "_shrieker",       "_blossom",        "_vein",
    "_frogspawn",    "_torchflower",   "_dripleaf",       "_dripleaf_stem",  "_propagule",
    "_hanging_moss", "_eyeblossom",    "_wildflowers",    "_heavy_core",     "_clump",
    "_litter",       "_portal_frame",  "_crop",           "_sprouts",        "_valley",
});

} // namespace

std::span<const BlockDye> blockDyes() { return kDyes; }
std::span<const BlockWood> blockWoods() { return kWoods; }
std::span<const PlainBlock> blockParts() { return kParts; }
std::span<const std::string_view> partialBlocks() { return kPartial; }

} // namespace voxc
