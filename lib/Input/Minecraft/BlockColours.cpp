// A table of colours, in which most blocks stand by what they are made of: a wood, a dye, a stone.
#include "Input/Minecraft/BlockColours.h"

#include "Input/Minecraft/BlockTables.h"

#include <algorithm>
#include <array>

namespace voxc {

namespace {

/// 0xRRGGBB as an opaque word.
std::uint32_t wordOf(std::uint32_t colour) {
  return (colour >> 16 & 0xff) | (colour & 0xff00) | (colour & 0xff) << 16 | 0xff000000;
}

/// A colour that is the same wherever the name is met, neither dark nor pale.
std::uint32_t hashedColour(std::string_view name) {
  std::uint32_t hash = 2166136261u;
  for (const char letter : name)
    hash = (hash ^ static_cast<unsigned char>(letter)) * 16777619u;
  std::uint32_t colour = 0;
  for (unsigned channel = 0; channel < 3; ++channel)
    colour = colour << 8 | (64 + (hash >> (8 * channel + 4) & 0x7f));
  return colour;
}

bool endsWith(std::string_view name, std::string_view end, std::string_view &rest) {
  if (!name.ends_with(end))
    return false;
  rest = name.substr(0, name.size() - end.size());
  return true;
}

template <typename Row> const Row *find(std::span<const Row> rows, std::string_view name) {
  const auto row = std::ranges::find(rows, name, &Row::name);
  return row == rows.end() ? nullptr : &*row;
}

/// Blocks of 16 colours.
std::optional<std::uint32_t> dyedColour(std::string_view name) {
  for (const BlockDye &dye : blockDyes()) {
    if (!name.starts_with(dye.name) || name.size() <= dye.name.size() || name[dye.name.size()] != '_')
      continue;
    const std::string_view thing = name.substr(dye.name.size() + 1);
    if (thing == "terracotta")
      return dye.terracotta;
    if (thing == "concrete")
      return dye.concrete;
    constexpr std::array<std::string_view, 13> kThings{
        "wool",   "carpet", "concrete_powder", "glazed_terracotta", "stained_glass", "stained_glass_pane",
        "bed",    "banner", "wall_banner",     "shulker_box",       "candle",        "candle_cake",
        "harness"};
    if (std::ranges::find(kThings, thing) != kThings.end())
      return dye.wool;
  }
  return std::nullopt;
}

/// Blocks of a kind of tree.
std::optional<std::uint32_t> woodColour(std::string_view name) {
  const bool isStripped = name.starts_with("stripped_");
  if (isStripped)
    name.remove_prefix(std::string_view("stripped_").size());
  for (const BlockWood &wood : blockWoods()) {
    if (!name.starts_with(wood.name) || name.size() <= wood.name.size() || name[wood.name.size()] != '_')
      continue;
    const std::string_view thing = name.substr(wood.name.size() + 1);
    if (thing == "log" || thing == "wood" || thing == "stem" || thing == "hyphae" || thing == "block")
      return isStripped ? wood.planks : wood.bark;
    if (thing == "leaves" || thing == "sapling" || thing == "propagule" || thing == "fungus" ||
        thing == "roots" || thing == "bush")
      return wood.leaves;
    constexpr std::array<std::string_view, 17> kThings{"planks",
                                                       "stairs",
                                                       "slab",
                                                       "fence",
                                                       "fence_gate",
                                                       "door",
                                                       "trapdoor",
                                                       "pressure_plate",
                                                       "button",
                                                       "sign",
                                                       "wall_sign",
                                                       "hanging_sign",
                                                       "wall_hanging_sign",
                                                       "mosaic",
                                                       "mosaic_stairs",
                                                       "mosaic_slab",
                                                       "shelf"};
    if (std::ranges::find(kThings, thing) != kThings.end())
      return wood.planks;
  }
  return std::nullopt;
}

/// A name of the table, or what is left of it when a shape is taken off: "stone_brick_stairs" is of
/// "stone_bricks", "quartz_slab" of "quartz_block".
std::optional<std::uint32_t> plainColour(std::string_view name) {
  for (const std::string_view front : {"cracked_", "chiseled_"})
    if (name.starts_with(front) && !find(plainBlocks(), name))
      name.remove_prefix(front.size());
  if (const PlainBlock *const row = find(plainBlocks(), name))
    return row->colour;
  std::string_view material;
  for (const std::string_view shape :
       {"_stairs", "_slab", "_wall", "_fence", "_fence_gate", "_pressure_plate", "_button", "_door",
        "_trapdoor", "_bars", "_block", "_pillar", "_grate", "_pane"})
    if (endsWith(name, shape, material))
      for (const char *const end : {"", "s", "_block", "_planks"})
        if (const PlainBlock *const row = find(plainBlocks(), std::string(material) + end))
          return row->colour;
  return std::nullopt;
}

/// What a part of the name says.
std::optional<std::uint32_t> partColour(std::string_view name) {
  for (const PlainBlock &row : blockParts())
    if (name.find(row.name) != std::string_view::npos)
      return row.colour;
  return std::nullopt;
}

bool fillsCell(std::string_view name) {
  return std::ranges::none_of(partialBlocks(), [&](std::string_view part) {
    if (part.front() == '=')
      return name == part.substr(1);
    return part.front() == '_' ? name.ends_with(part) || name == part.substr(1)
                               : name.find(part) != std::string_view::npos;
  });
}

} // namespace

BlockLook blockLook(std::string_view name) {
  name = name.substr(0, name.find('['));
  constexpr std::string_view kSpace = "minecraft:";
  const bool isForeign = name.find(':') != std::string_view::npos && !name.starts_with(kSpace);
  if (name.starts_with(kSpace))
    name.remove_prefix(kSpace.size());
  for (const std::string_view air : {"air", "cave_air", "void_air", "structure_void", "barrier", "light"})
    if (name == air)
      return {0, true, true};
  const bool fills = fillsCell(name);
  // What a block looks like is not changed by these.
  for (const std::string_view front : {"infested_", "waxed_", "potted_", "petrified_"})
    if (name.starts_with(front))
      name.remove_prefix(front.size());
  if (!isForeign)
    for (const auto colourOf : {dyedColour, woodColour, plainColour, partColour})
      if (const auto colour = colourOf(name))
        return {wordOf(*colour), true, fills};
  return {wordOf(hashedColour(name)), false, fills};
}

} // namespace voxc
