// The tags of schematics, and the numbers of their blocks.
#include "Input/Minecraft/BlockScene.h"

#include "Input/Minecraft/BlockColours.h"
#include "Support/Text.h"

#include <algorithm>
#include <bit>
#include <optional>
#include <set>

namespace voxc {

namespace {

using BlockBox = std::array<std::int64_t, 3>;

constexpr std::int64_t kMostKinds = std::int64_t{1} << 20; ///< Of blocks, in a palette.

std::string textOf(const BlockBox &size) {
  return std::to_string(size[0]) + "x" + std::to_string(size[1]) + "x" + std::to_string(size[2]);
}

/// What is said of all palettes together.
class BlockPalette {
public:
  explicit BlockPalette(const Progress &progress) : progress_(progress) {}

  /// Names are looked for in long tables, and a file may have many.
  bool isStopped() const { return isStopped_; }

  /// The word of a block with this name.
  std::uint32_t wordOf(std::string_view name) {
    isStopped_ = isStopped_ || (++looks_ % kLooksBetween == 0 && progress_.stopped());
    const BlockLook look = blockLook(name);
    name = name.substr(0, name.find('['));
    if (!look.isKnown)
      note(name, unknown_);
    if (!look.fillsCell)
      note(name, partial_);
    return look.word;
  }

  void warn(std::vector<std::string> &warnings) const {
    if (!unknown_.empty())
      warnings.push_back("blocks that are not known have colours made of their names: " + named(unknown_));
    if (!partial_.empty())
      warnings.push_back("blocks that do not fill their cells are taken as if they did: " + named(partial_));
  }

private:
  using Names = std::set<std::string>;

  /// Of names there may be as many as bytes; those that are told are few.
  static constexpr std::size_t kMostKept = 1 << 16;
  static void note(std::string_view name, Names &names) {
    if (names.size() < kMostKept)
      names.emplace(name.substr(0, 80));
  }
  static std::string named(const Names &names) {
    constexpr std::size_t kMostNamed = 6;
    std::string text;
    std::size_t count = 0;
    for (const std::string &name : names)
      if (++count <= kMostNamed)
        text += (count == 1 ? "" : ", ") + name;
    if (count <= kMostNamed)
      return text;
    return text + " and " + counted(count - kMostNamed, "other") +
           (names.size() == kMostKept ? " or more" : "");
  }

  static constexpr std::uint64_t kLooksBetween = 1 << 12;
  const Progress &progress_;
  Names unknown_, partial_;
  std::uint64_t looks_ = 0;
  bool isStopped_ = false;
};

/// What else a file has, all regions together.
struct Beside {
  std::uint64_t entities = 0, blockEntities = 0, biomes = 0;
  std::uint64_t surplus = 0;     ///< Numbers of blocks behind those of a box.
  std::string materials;         ///< Whose numbers blocks have, if not those of the game.
  std::set<std::string> unknown; ///< Tags.

  void warn(std::vector<std::string> &warnings) const {
    if (blockEntities > 0)
      warnings.push_back("what blocks such as chests and signs hold or say is left out, of " +
                         counted(blockEntities, "block"));
    if (entities > 0)
      warnings.push_back("entities such as animals and paintings are left out: " + std::to_string(entities));
    if (biomes > 0)
      warnings.push_back("biomes are left out: grass, leaves and water have the colours of plains");
    if (surplus > 0)
      warnings.push_back(counted(surplus, "number") + " of blocks " + (surplus == 1 ? "is" : "are") +
                         " left out, behind those of its box");
    if (!materials.empty())
      warnings.push_back("its numbers are those of '" + materials + "', and are taken for those of 'Alpha'");
    std::string names;
    for (const std::string &name : unknown)
      names += (names.empty() ? "" : ", ") + name;
    if (!names.empty())
      warnings.push_back("tags that are not known are left out: " + names);
  }
};

/// Tags of a schematic that are read, or say nothing of blocks: where a program copied it, and for whom.
constexpr auto kKnownTags = std::to_array<std::string_view>(
    {"Version",   "DataVersion", "Width",         "Height",       "Length",          "Offset",
     "Metadata",  "Palette",     "PaletteMax",    "BlockData",    "Blocks",          "Data",
     "AddBlocks", "Materials",   "BlockEntities", "Entities",     "BiomeData",       "Biomes",
     "WEOffsetX", "WEOffsetY",   "WEOffsetZ",     "TileEntities", "WEOriginX",       "WEOriginY",
     "WEOriginZ", "Icon",        "Platform",      "BiomePalette", "BiomePaletteMax", "itemStackVersion"});

void noteTags(const NbtTag &schematic, Beside &beside) {
  constexpr std::size_t kMost = 8;
  schematic.forEach([&](const NbtTag &tag) {
    if (std::ranges::find(kKnownTags, tag.name()) == kKnownTags.end())
      beside.unknown.emplace(tag.name().substr(0, 40));
    return beside.unknown.size() < kMost;
  });
}

/// Error: no blocks, or more than any file has.
Expected<void> checkSize(const BlockBox &size) {
  constexpr std::int64_t kMost = std::int64_t{1} << 40;
  if (size[0] < 1 || size[1] < 1 || size[2] < 1)
    return Error::input("its box of " + textOf(size) + " blocks has none");
  if (size[0] > kMost || size[1] > kMost / size[0] || size[2] > kMost / size[0] / size[1])
    return Error::input("its box of " + textOf(size) + " blocks is larger than any file");
  return {};
}

Error lacks(std::string_view what) { return Error::input("it has no " + std::string(what)); }

/// Width, height and length. Shorts have no sign here, whatever NBT says.
Expected<BlockBox> sizeOf(const NbtTag &schematic) {
  BlockBox size{};
  constexpr std::array<std::string_view, 3> kNames{"Width", "Height", "Length"};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    constexpr std::int64_t kMost = 0xffff;
    const NbtTag tag = schematic[kNames[axis]];
    const auto number = tag.number();
    if (!number)
      return lacks("tag " + std::string(kNames[axis]) + " with a number");
    size[axis] = tag.kind() == NbtKind::Short ? *number & kMost : *number;
    if (size[axis] > kMost)
      return Error::input("its " + std::string(kNames[axis]) + " is " + std::to_string(size[axis]) +
                          "; there may be " + std::to_string(kMost) + " blocks on an axis");
  }
  VOXC_TRY(checkSize(size));
  return size;
}

/// Three numbers as an array, else 0.
BlockBox offsetOf(const NbtTag &tag) {
  BlockBox low{};
  const auto bytes = tag.array(NbtKind::IntArray);
  for (std::size_t i = 0; i < 12 && bytes.size() >= 12; ++i)
    low[i / 4] =
        i % 4 == 0 ? static_cast<std::int8_t>(bytes[i]) : low[i / 4] * 256 + std::to_integer<int>(bytes[i]);
  return low;
}

/// The words of a compound that says the number of each name.
Expected<std::vector<std::uint32_t>> wordsOf(const NbtTag &palette, BlockPalette &names) {
  std::vector<std::uint32_t> words;
  bool isRight = palette.kind() == NbtKind::Compound;
  std::optional<std::size_t> twice;
  palette.forEach([&](const NbtTag &tag) {
    const std::int64_t value = tag.number().value_or(-1);
    isRight = isRight && value >= 0 && value < kMostKinds;
    if (!isRight)
      return false;
    const auto number = static_cast<std::size_t>(value);
    if (words.size() <= number)
      words.resize(number + 1, kNoBlock);
    if (words[number] != kNoBlock)
      twice = number;
    words[number] = names.wordOf(tag.name());
    return !twice && !names.isStopped();
  });
  if (!isRight)
    return Error::input("its palette is none: each name should have a number from 0 to " +
                        std::to_string(kMostKinds - 1));
  if (twice)
    return Error::input("its palette gives the number " + std::to_string(*twice) +
                        " to two names; each should have its own");
  return words;
}

/// A schematic of Sponge. Version 3 has blocks in a compound of their own.
Expected<void> readSponge(const NbtTag &schematic, BlockScene &scene, BlockPalette &names, Beside &beside) {
  const std::int64_t version = schematic["Version"].number().value_or(1);
  if (version < 1 || version > 3)
    return Error::input("it is a schematic of version " + std::to_string(version) + "; voxc reads 1 to 3");
  const NbtTag blocks = version == 3 ? schematic["Blocks"] : schematic;
  const auto size = VOXC_TRY(sizeOf(schematic));
  auto words = VOXC_TRY(wordsOf(blocks["Palette"], names));
  BlockRegion region{.low = offsetOf(schematic["Offset"]), .size = size, .words = std::move(words)};
  region.data = blocks[version == 3 ? "Data" : "BlockData"].array(NbtKind::ByteArray);
  noteTags(schematic, beside);
  const auto numbers = static_cast<std::uint64_t>(std::ranges::count_if(
      region.data, [](std::byte byte) { return (byte & std::byte{0x80}) == std::byte{}; }));
  beside.surplus += numbers - std::min(numbers, region.count());
  beside.blockEntities += blocks["BlockEntities"].size() + blocks["TileEntities"].size();
  beside.entities += schematic["Entities"].size();
  beside.biomes += schematic["BiomeData"].size() + schematic["Biomes"].size();
  scene.regions.push_back(std::move(region));
  return {};
}

Expected<BlockBox> vectorOf(const NbtTag &tag, std::string_view what) {
  const auto x = tag["x"].number(), y = tag["y"].number(), z = tag["z"].number();
  if (!x || !y || !z)
    return lacks(std::string(what) + " of a region");
  return BlockBox{*x, *y, *z};
}

/// A region of Litematica. A negative size goes from its position down.
Expected<void> readRegion(const NbtTag &tag, BlockScene &scene, BlockPalette &names, Beside &beside) {
  const auto low = vectorOf(tag["Position"], "Position"), size = vectorOf(tag["Size"], "Size");
  if (!low || !size)
    return low ? size.error() : low.error();
  BlockRegion region{.low = *low, .size = *size};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    constexpr std::int64_t kFar = std::int64_t{1} << 31;
    const auto isFar = [](std::int64_t number) { return number < -kFar || number > kFar; };
    if (isFar((*low)[axis]) || isFar((*size)[axis]))
      return Error::input("a region of it lies beyond 2^31 blocks");
    if ((*size)[axis] < 0) {
      region.size[axis] = -(*size)[axis];
      region.low[axis] += (*size)[axis] + 1;
    }
  }
  VOXC_TRY(checkSize(region.size));
  const NbtTag palette = tag["BlockStatePalette"];
  if (palette.kind() != NbtKind::List || palette.size() == 0)
    return lacks("BlockStatePalette of a region");
  if (palette.size() > kMostKinds)
    return Error::input("a palette of it has " + std::to_string(palette.size()) +
                        " kinds of blocks; there may be " + std::to_string(kMostKinds));
  palette.forEach([&](const NbtTag &block) {
    region.words.push_back(names.wordOf(block["Name"].text().value_or("")));
    return !names.isStopped();
  });
  region.coding = BlockCoding::Packed;
  region.bits = std::max(2u, static_cast<unsigned>(std::bit_width(region.words.size() - 1)));
  region.data = tag["BlockStates"].array(NbtKind::LongArray);
  beside.blockEntities += tag["TileEntities"].size();
  beside.entities += tag["Entities"].size();
  scene.regions.push_back(std::move(region));
  return {};
}

/// A schematic from before blocks had names.
Expected<void> readOld(const NbtTag &schematic, BlockScene &scene, BlockPalette &names, Beside &beside,
                       const Progress &progress) {
  const auto size = VOXC_TRY(sizeOf(schematic));
  BlockRegion region{.size = size, .coding = BlockCoding::Bytes};
  region.data = schematic["Blocks"].array(NbtKind::ByteArray);
  region.kinds = schematic["Data"].array(NbtKind::ByteArray);
  region.more = schematic["AddBlocks"].array(NbtKind::ByteArray);
  const auto count = static_cast<std::size_t>(region.count());
  if (region.data.size() != count || (!region.kinds.empty() && region.kinds.size() != count) ||
      (!region.more.empty() && region.more.size() < (count + 1) / 2))
    return Error::input("its box of " + textOf(size) + " blocks needs as many numbers, but there are " +
                        std::to_string(region.data.size()));
  constexpr std::size_t kNumbers = 4096 * 16;
  std::vector<bool> isUsed(kNumbers);
  for (std::size_t i = 0; i < count; ++i) {
    if (i % kBlocksBetweenLooks == 0 && progress.stopped())
      return Error::interrupted();
    isUsed[region.numberAt(i)] = true;
  }
  region.words.resize(kNumbers);
  for (unsigned i = 0; i < kNumbers; ++i)
    if (isUsed[i])
      region.words[i] =
          names.wordOf(oldBlockName(i >> 4, i & 15).value_or("number:" + std::to_string(i >> 4)));
  noteTags(schematic, beside);
  if (const auto materials = schematic["Materials"].text(); materials && *materials != "Alpha")
    beside.materials = materials->substr(0, 40);
  beside.blockEntities += schematic["TileEntities"].size();
  beside.entities += schematic["Entities"].size();
  scene.regions.push_back(std::move(region));
  return {};
}

Expected<void> readRegions(const NbtTag &regions, BlockScene &scene, BlockPalette &names, Beside &beside) {
  Expected<void> read;
  regions.forEach([&](const NbtTag &region) {
    read = readRegion(region, scene, names, beside);
    return bool(read) && !names.isStopped();
  });
  if (read && scene.regions.empty())
    return lacks("regions");
  return read;
}

} // namespace

Expected<BlockScene> readBlockScene(const NbtTag &file, const Progress &progress) {
  BlockScene scene;
  BlockPalette names(progress);
  Beside beside;
  const NbtTag schematic = file["Schematic"] ? file["Schematic"] : file;
  const auto read =
      file["Regions"]                                  ? readRegions(file["Regions"], scene, names, beside)
      : schematic["Version"] || schematic["BlockData"] ? readSponge(schematic, scene, names, beside)
      : schematic["Blocks"]
          ? readOld(schematic, scene, names, beside, progress)
          : lacks("blocks that voxc knows: a Sponge schematic, one of MCEdit, or regions of Litematica");
  if (names.isStopped())
    return Error::interrupted();
  if (!read)
    return read.error();
  names.warn(scene.warnings);
  beside.warn(scene.warnings);
  return scene;
}

} // namespace voxc
