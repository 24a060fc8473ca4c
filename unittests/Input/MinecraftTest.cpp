// Minecraft's schematics: every kind, colours by names, what is left out, and what is broken.
#include "Input/InputTesting.h"

#include "Input/Minecraft/BlockColours.h"
#include "voxc/Input/Input.h"

#include <gmock/gmock.h>

#include <map>

namespace voxc {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

using Words = std::vector<std::uint32_t>;

std::string big(std::uint64_t value, int bytes) {
  std::string text;
  for (int i = bytes; i-- > 0;)
    text += static_cast<char>(value >> 8 * i);
  return text;
}

/// A tag with its name: kind, name, payload.
std::string tag(int kind, const std::string &name, const std::string &payload) {
  return big(static_cast<unsigned>(kind), 1) + big(name.size(), 2) + name + payload;
}
std::string shortTag(const std::string &name, int value) {
  return tag(2, name, big(static_cast<std::uint64_t>(value), 2));
}
std::string intTag(const std::string &name, std::int64_t value) {
  return tag(3, name, big(static_cast<std::uint64_t>(value), 4));
}
std::string bytesTag(const std::string &name, const std::string &bytes) {
  return tag(7, name, big(bytes.size(), 4) + bytes);
}
std::string compound(const std::string &name, const std::string &tags) {
  return tag(10, name, tags + std::string(1, '\0'));
}
std::string listTag(const std::string &name, int kind, const std::vector<std::string> &items) {
  std::string payload = big(static_cast<unsigned>(kind), 1) + big(items.size(), 4);
  for (const std::string &item : items)
    payload += item;
  return tag(9, name, payload);
}
std::string text(const std::string &value) { return big(value.size(), 2) + value; }

std::string sizeTags(int width, int height, int length) {
  return shortTag("Width", width) + shortTag("Height", height) + shortTag("Length", length);
}
std::string paletteOf(const std::vector<std::string> &names) {
  std::string tags;
  for (std::size_t i = 0; i < names.size(); ++i)
    tags += intTag(names[i], static_cast<std::int64_t>(i));
  return compound("Palette", tags);
}

/// A Sponge schematic of 3 x 1 x 2: x is fastest, then z.
std::string sponge(int version, const std::string &data, const std::vector<std::string> &names,
                   const std::string &more = "") {
  const std::string head =
      intTag("Version", version) + intTag("DataVersion", 2586) + sizeTags(3, 1, 2) + more +
      tag(11, "Offset", big(3, 4) + big(3, 4) + big(7, 4) + big(static_cast<std::uint64_t>(-5), 4));
  if (version == 3)
    return compound(
        "", compound("Schematic", head + compound("Blocks", paletteOf(names) + bytesTag("Data", data))));
  return compound("Schematic", head + paletteOf(names) + bytesTag("BlockData", data));
}

/// A region of Litematica whose numbers are packed across longs.
std::string regionOf(const std::string &name, const Int3 &position, const Int3 &size,
                     const std::vector<std::string> &names, const std::vector<unsigned> &numbers) {
  const auto vector = [](const std::string &called, const Int3 &v) {
    return compound(called, intTag("x", v.x) + intTag("y", v.y) + intTag("z", v.z));
  };
  std::vector<std::string> palette;
  for (const std::string &block : names)
    palette.push_back(tag(8, "Name", text(block)) + compound("Properties", "") + std::string(1, '\0'));
  unsigned bits = 2;
  while (std::size_t{1} << bits < names.size())
    ++bits;
  std::vector<std::uint64_t> longs((numbers.size() * bits + 63) / 64);
  for (std::size_t i = 0; i < numbers.size() * bits; ++i)
    longs[i / 64] |= std::uint64_t{numbers[i / bits] >> i % bits & 1} << i % 64;
  std::string states = big(longs.size(), 4);
  for (const std::uint64_t value : longs)
    states += big(value, 8);
  return compound(name, vector("Position", position) + vector("Size", size) +
                            listTag("BlockStatePalette", 10, palette) + tag(12, "BlockStates", states));
}
std::string litematic(const std::string &regions) {
  return compound("", intTag("Version", 5) + intTag("MinecraftDataVersion", 2586) + compound("Metadata", "") +
                          compound("Regions", regions));
}

std::uint32_t wordOf(const std::string &name) { return blockLook(name).word; }

class Minecraft : public OpenedInputs {};

TEST_F(Minecraft, WhatItsTagsSayBesideIsTold) {
  const std::vector<std::string> names{"minecraft:air", "minecraft:stone"};
  const std::string data("\0\1\1\1\0\0", 6);
  words("a.schem", sponge(2, data, names));
  EXPECT_THAT(warnings_, IsEmpty());
  words("a.schem", sponge(2, data + "\1", names, intTag("Weather", 1)));
  EXPECT_THAT(warnings_, ElementsAre("1 number of blocks is left out, behind those of its box",
                                     "tags that are not known are left out: Weather"));
  const auto old = [&](const std::string &materials, const std::string &more) {
    words("a.schematic", compound("Schematic", sizeTags(3, 1, 2) + tag(8, "Materials", text(materials)) +
                                                   bytesTag("Blocks", data) +
                                                   bytesTag("Data", std::string(6, '\0')) + more));
    return warnings_;
  };
  EXPECT_THAT(old("Alpha", ""), IsEmpty());
  EXPECT_THAT(old("Classic", compound("SchematicaMapping", "")),
              ElementsAre("its numbers are those of 'Classic', and are taken for those of 'Alpha'",
                          "tags that are not known are left out: SchematicaMapping"));
}

TEST_F(Minecraft, SpongeSchematicsOfThreeVersions) {
  const std::uint32_t stone = wordOf("stone"), red = wordOf("red_wool");
  const std::vector<std::string> names{"minecraft:air", "minecraft:stone", "minecraft:red_wool[a=b]"};
  for (const int version : {1, 2, 3})
    for (const bool isPacked : {true, false}) {
      const std::string file = sponge(version, std::string("\0\1\2\1\0\0", 6), names);
      EXPECT_EQ(words("a.schem", isPacked ? gzipped(file) : file), (Words{0, stone, red, stone, 0, 0}));
      EXPECT_EQ(extent_, (Int3{3, 1, 2}));
      EXPECT_EQ(map_ * glm::dvec4(0, 0, 0, 1), glm::dvec3(3, 7, -5));
      EXPECT_THAT(warnings_, IsEmpty());
      for (std::size_t size = 0; size < file.size(); size += 11)
        EXPECT_NE(problem("b.schem", file.substr(0, size)), "none");
    }
  // Numbers above 127 have two bytes.
  std::vector<std::string> many(200, "minecraft:stone");
  for (std::size_t i = 0; i < many.size(); ++i)
    many[i] = i == 199 ? "dirt" : "stone[n=" + std::to_string(i) + "]";
  const std::uint32_t dirt = wordOf("dirt");
  EXPECT_EQ(words("a.schem", sponge(2, "\xc7\x01\1\x7f\xc7\x01\x80\x01\2", many)),
            (Words{dirt, stone, stone, dirt, stone, stone}));
}

TEST_F(Minecraft, BytesBehindTheTagsAreTold) {
  const std::string file =
      compound("Schematic", sizeTags(1, 1, 1) + tag(8, "Materials", text("Alpha")) +
                                bytesTag("Blocks", "\1") + bytesTag("Data", std::string(1, '\0')));
  const Words stone{wordOf("stone")};
  EXPECT_EQ(words("a.schematic", file), stone);
  EXPECT_THAT(warnings_, IsEmpty());
  EXPECT_EQ(words("a.schematic", file + "12"), stone);
  EXPECT_THAT(warnings_, ElementsAre("2 bytes are left out behind the end of its tags"));
  EXPECT_EQ(words("a.schematic", gzipped(file + "12") + "3"), stone);
  EXPECT_THAT(warnings_, ElementsAre("3 bytes are left out behind the end of its tags"));
}

TEST_F(Minecraft, RegionsOfLitematicaLieAtTheirPositions) {
  const std::vector<std::string> five{"minecraft:air", "minecraft:stone", "minecraft:dirt", "minecraft:sand",
                                      "minecraft:gravel"};
  // 3 bits each, so that the 22nd goes across two longs.
  std::vector<unsigned> numbers(5 * 5);
  for (unsigned i = 0; i < numbers.size(); ++i)
    numbers[i] = i % 5;
  Words expected;
  for (const unsigned number : numbers)
    expected.push_back(wordOf(five[number]));
  EXPECT_EQ(words("a.litematic", gzipped(litematic(regionOf("r", {2, 3, 4}, {5, 1, 5}, five, numbers)))),
            expected);
  EXPECT_EQ(map_ * glm::dvec4(0, 0, 0, 1), glm::dvec3(2, 3, 4));
  // Sizes below 0 go down from the position: x from -1 to 0, z from 4 to 5.
  const std::string two = litematic(regionOf("a", {0, 0, 0}, {-2, 1, 1}, {"air", "stone"}, {1, 0}) +
                                    regionOf("b", {1, 1, 1}, {1, 1, -2}, {"air", "sand"}, {0, 1}));
  EXPECT_EQ(take(openInput(folder_.file("b.litematic", two), options_)),
            (Voxels{{mortonCode({0, 0, 0}), wordOf("stone")}, {mortonCode({2, 1, 1}), wordOf("sand")}}));
  EXPECT_EQ(extent_, (Int3{3, 2, 2}));
  EXPECT_EQ(map_ * glm::dvec4(0, 0, 0, 1), glm::dvec3(-1, 0, 0));
  EXPECT_THAT(problem("c.litematic", litematic(regionOf("r", {0, 0, 0}, {5, 5, 5}, five, numbers))),
              HasSubstr("its box of 5x5x5 blocks has 16 bytes of numbers, which are too few"));
  EXPECT_THAT(problem("c.litematic", litematic(regionOf("a", {0, 0, 0}, {1, 1, 1}, five, {1}) +
                                               regionOf("b", {9000, 0, 0}, {1, 1, 1}, five, {1}))),
              HasSubstr("takes 9001x1x1 voxels, but the format holds 512x512x512; enlarge the format"));
}

TEST_F(Minecraft, SchematicsOfOldHaveNumbers) {
  const std::string blocks = sizeTags(2, 2, 1) + tag(8, "Materials", text("Alpha"));
  EXPECT_EQ(words("a.schematic",
                  gzipped(compound("Schematic", blocks + bytesTag("Blocks", std::string("\0\1\x23\x05", 4)) +
                                                    bytesTag("Data", std::string("\0\1\xe\1", 4))))),
            (Words{0, wordOf("granite"), wordOf("red_wool"), wordOf("spruce_planks")}));
  EXPECT_THAT(warnings_, IsEmpty());
  // Four bits more of each number: 256 + 1 is of a mod.
  EXPECT_EQ(words("a.schematic", compound("Schematic", blocks + bytesTag("Blocks", "\1\1\1\1") +
                                                           bytesTag("AddBlocks", std::string("\x10\0", 2)))),
            (Words{wordOf("stone"), wordOf("number:257"), wordOf("stone"), wordOf("stone")}));
  EXPECT_THAT(warnings_, ElementsAre(HasSubstr("made of their names: number:257")));
  EXPECT_THAT(problem("a.schematic", compound("Schematic", blocks + bytesTag("Blocks", "\1\1\1"))),
              HasSubstr("its box of 2x2x1 blocks needs as many numbers, but there are 3"));
}

/// The upper block of a tall plant says where it looks, and the lower one what it is.
TEST_F(Minecraft, TallPlantsOfOldAreOfTheirLowerHalf) {
  const std::string blocks = sizeTags(2, 2, 1) + bytesTag("Blocks", "\xaf\xaf\xaf\xaf");
  EXPECT_EQ(words("a.schematic", compound("Schematic", blocks + bytesTag("Data", "\2\5\x8\xb"))),
            (Words{wordOf("tall_grass"), wordOf("peony"), wordOf("tall_grass"), wordOf("peony")}));
  EXPECT_EQ(words("a.schematic", compound("Schematic", blocks + bytesTag("Data", "\xc\x8\xd\1"))),
            (Words{wordOf("rose_bush"), wordOf("sunflower"), wordOf("peony"), wordOf("lilac")}));
}

TEST_F(Minecraft, ASpongeSchematicWithoutAVersionIsOfTheFirst) {
  const std::string file = compound("Schematic", sizeTags(2, 1, 1) + paletteOf({"air", "stone"}) +
                                                     bytesTag("BlockData", std::string("\0\1", 2)));
  EXPECT_EQ(words("a.schem", file), (Words{0, wordOf("stone")}));
}

TEST_F(Minecraft, WhatIsLeftOutIsSaid) {
  const std::string empty(1, '\0');
  const std::string more = listTag("Entities", 10, {empty, empty}) + listTag("BlockEntities", 10, {empty}) +
                           bytesTag("BiomeData", "\1");
  words("a.schem",
        sponge(2, std::string("\0\1\2\3\0\0", 6), {"air", "mod:a", "mod:b", "oak_stairs[x=1]"}, more));
  EXPECT_THAT(warnings_,
              ElementsAre("blocks that are not known have colours made of their names: mod:a, mod:b",
                          "blocks that do not fill their cells are taken as if they did: oak_stairs",
                          HasSubstr("is left out, of 1 block"), HasSubstr("are left out: 2"),
                          HasSubstr("biomes")));
}

TEST_F(Minecraft, WhatIsBrokenIsAnError) {
  const std::vector<std::string> names{"air", "stone"};
  EXPECT_THAT(problem("a.schem", sponge(2, std::string("\0\1\2\1\0\0", 6), names)),
              HasSubstr("a block has the number 2, but those of the palette end at 1"));
  EXPECT_THAT(problem("a.schem", sponge(2, std::string("\0\1", 2), names)), HasSubstr("which are too few"));
  EXPECT_THAT(problem("a.schem", sponge(2, "\xff\xff\xff\xff\xff\xff", names)), HasSubstr("too few"));
  EXPECT_THAT(problem("a.schem", sponge(4, "\1", names)), HasSubstr("of version 4; voxc reads 1 to 3"));
  EXPECT_THAT(problem("a.schem", compound("Schematic", intTag("Version", 2) + sizeTags(0, 1, 1))),
              HasSubstr("its box of 0x1x1 blocks has none"));
  EXPECT_THAT(problem("a.schem", compound("Schematic", intTag("Version", 2) + sizeTags(1, 1, 1) +
                                                           compound("Palette", intTag("stone", 1 << 30)))),
              HasSubstr("its palette is none"));
  EXPECT_THAT(problem("a.schem", compound("", intTag("a", 1))),
              HasSubstr("it has no blocks that voxc knows"));
  EXPECT_THAT(problem("a.schem", "nonsense"), HasSubstr("does not begin with a compound"));
  std::string deep;
  for (int i = 0; i < 100000; ++i)
    deep += tag(10, "", "");
  EXPECT_THAT(problem("a.schem", deep), HasSubstr("more than 512 deep"));
  EXPECT_THAT(problem("a.schem", compound("", tag(9, "x", big(0, 1) + big(1 << 30, 4)))),
              HasSubstr("its NBT is damaged"));
  EXPECT_THAT(problem("a.schem", compound("", tag(12, "x", big(0x7fffffff, 4)))),
              HasSubstr("its NBT is damaged"));
}

TEST_F(Minecraft, ABlockHasOneNameOfThePalette) {
  const auto file = [](const std::string &palette, const std::string &data) {
    return compound("Schematic", intTag("Version", 2) + sizeTags(2, 1, 1) + compound("Palette", palette) +
                                     bytesTag("BlockData", data));
  };
  const std::string gap = intTag("stone", 0) + intTag("dirt", 2);
  EXPECT_EQ(words("a.schem", file(gap, std::string("\0\2", 2))), (Words{wordOf("stone"), wordOf("dirt")}));
  EXPECT_THAT(problem("a.schem", file(gap, std::string("\0\1", 2))),
              HasSubstr("a block has the number 1, which its palette gives to no kind"));
  EXPECT_THAT(problem("a.schem", file(intTag("air", 0) + intTag("dirt", 0), std::string(2, '\0'))),
              HasSubstr("its palette gives the number 0 to two names; each should have its own"));
}

TEST_F(Minecraft, SizesOfShortsHaveNoSign) {
  const auto file = [](const std::string &width) {
    return compound("Schematic", intTag("Version", 2) + width + shortTag("Height", 1) +
                                     shortTag("Length", 1) + paletteOf({"stone"}) +
                                     bytesTag("BlockData", std::string(1, '\0')));
  };
  EXPECT_EQ(words("a.schem", file(intTag("Width", 1))), Words{wordOf("stone")});
  EXPECT_THAT(problem("a.schem", file(intTag("Width", 65537))),
              HasSubstr("its Width is 65537; there may be 65535 blocks on an axis"));
  EXPECT_THAT(problem("a.schem", file(intTag("Width", -65535))), HasSubstr("its box of -65535x1x1"));
  EXPECT_THAT(problem("a.schem", file(shortTag("Width", 65535))), HasSubstr("takes 65535x1x1 voxels"));
}

TEST_F(Minecraft, OtherFilesOfItAreRefusedWithAdvice) {
  EXPECT_THAT(problem("r.0.0.mca", "x"),
              HasSubstr("is a region of a Minecraft world, which voxc does not read"));
  EXPECT_THAT(problem("a.mcstructure", "x"), HasSubstr("save it as .schem"));
}

TEST_F(Minecraft, FewBytesMakeNoEndlessWork) {
  const std::string air(1 << 20, '\0');
  const std::string size = shortTag("Width", 1024) + shortTag("Height", 1024) + shortTag("Length", 1);
  int asked = 0;
  options_.formatExtent = {1024, 1024, 1024};
  options_.progress.ask = [&] { return ++asked < 0; };
  // Of air there is nothing to place; it is gone through twice.
  EXPECT_TRUE(take(openInput(folder_.file("a.schem", compound("Schematic", intTag("Version", 2) + size +
                                                                               paletteOf({"air"}) +
                                                                               bytesTag("BlockData", air))),
                             options_))
                  .empty());
  EXPECT_GE(asked, 32);
  asked = 0;
  EXPECT_TRUE(
      take(openInput(folder_.file("a.schematic", compound("Schematic", size + bytesTag("Blocks", air))),
                     options_))
          .empty());
  EXPECT_GE(asked, 48);
  const auto strings = [](std::uint64_t count) {
    return tag(9, "x", big(8, 1) + big(count, 4) + std::string(2 * count, '\0'));
  };
  EXPECT_THAT(problem("a.schem", compound("", strings(1 << 20))), HasSubstr("it has no blocks"));
  EXPECT_THAT(problem("a.schem", compound("", strings((1 << 24) + 1))), HasSubstr("more than 16777216 tags"));
  // Numbers of a list are passed over at once.
  EXPECT_THAT(problem("a.schem", compound("", tag(9, "x",
                                                  big(1, 1) + big((1 << 24) + 1, 4) +
                                                      std::string((1 << 24) + 1, '\0')))),
              HasSubstr("it has no blocks"));
}

TEST_F(Minecraft, RegionsOfAnyNumbersAreErrors) {
  const auto region = [](std::uint64_t x, const std::string &palette) {
    const std::string place = tag(4, "x", big(x, 8)) + intTag("y", 0) + intTag("z", 0);
    return litematic(compound("r", compound("Position", place) +
                                       compound("Size", intTag("x", 1) + intTag("y", 1) + intTag("z", 1)) +
                                       tag(9, "BlockStatePalette", palette)));
  };
  const std::string one = big(10, 1) + big(1, 4) + std::string(1, '\0');
  EXPECT_THAT(problem("a.litematic", region(std::uint64_t{1} << 63, one)), HasSubstr("beyond 2^31"));
  EXPECT_THAT(problem("a.litematic", region(std::uint64_t{1} << 32, one)), HasSubstr("beyond 2^31"));
  const std::string many = big(1, 1) + big((1 << 20) + 1, 4) + std::string((1 << 20) + 1, '\0');
  EXPECT_THAT(problem("a.litematic", region(0, many)), HasSubstr("has 1048577 kinds of blocks"));
}

} // namespace
} // namespace voxc
