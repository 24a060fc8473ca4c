// Light and metal of voxels out to files, and back.
#include "Source/SourceTesting.h"

#include "voxc/Input/EmissionStrength.h"
#include "voxc/Input/Input.h"
#include "voxc/Source/Export.h"
#include "voxc/Volume/Attributes.h"

#include <gmock/gmock.h>

#include <bit>
#include <cstring>
#include <random>

namespace voxc {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr Int3 kExtent{15, 11, 9};

struct Look {
  std::uint32_t emission = 0;
  float strength = 1;
  std::uint32_t metal = 0xff00ff00;
};

class AttributeExport : public testing::Test {
protected:
  void add(Int3 voxel, std::uint32_t word, const Look &look) {
    voxels_[mortonCode(voxel)] = word;
    looks_[mortonCode(voxel)] = look;
  }

  Volume volume() const {
    auto volume = std::make_shared<const Volume>(denseVolume(voxels_, kExtent));
    const auto attach = [&](const char *name, auto element) {
      Attribute attribute{name, 4, *zeroElements(*volume, 4)};
      const auto visit = [&](Int3 voxel, std::uint64_t number) {
        const std::uint32_t word = element(looks_.at(mortonCode(voxel)));
        std::memcpy(&attribute.elements[4 * number], &word, 4);
        return true;
      };
      EXPECT_TRUE(visitVoxels(*volume, visit));
      volume = std::make_shared<const Volume>(*withAttribute(volume, std::move(attribute)));
    };
    attach("emission", [](const Look &look) { return look.emission; });
    attach("emission-strength", [](const Look &look) {
      return std::bit_cast<std::uint32_t>(look.emission == 0 ? 0 : look.strength);
    });
    attach("metallic-roughness", [](const Look &look) { return look.metal; });
    if (hasOther_)
      volume = std::make_shared<const Volume>(
          *withAttribute(volume, {"weight", 1, std::vector<std::byte>(voxels_.size())}));
    return std::move(const_cast<Volume &>(*volume));
  }

  std::vector<std::string> write(const std::string &name, const ExportOptions &options = {}) {
    const auto exported = exportVoxels(volume(), folder_.path(name), options);
    EXPECT_TRUE(exported) << exported.error().message;
    return exported ? exported->warnings : std::vector<std::string>();
  }

  Voxels read(const std::string &name, MaterialWords words) {
    InputOptions options;
    options.materialWords = words;
    if (name.ends_with(".glb")) {
      options.bounds = {{0, 0, 0, kExtent.x, kExtent.y, kExtent.z}};
      options.resolution = kExtent.x;
      options.coverage = Coverage::Thin;
    }
    auto input = openInput(folder_.path(name), options);
    EXPECT_TRUE(input) << input.error().message;
    return input ? voxelsOf(*input->source) : Voxels();
  }

  /// Expects that what is read is what was written.
  void expectSame(const std::string &name) {
    const Voxels colours = read(name, MaterialWords::Colours);
    const Voxels emission = read(name, MaterialWords::Emission);
    const Voxels strength = read(name, MaterialWords::EmissionStrength);
    const Voxels metal = read(name, MaterialWords::MetallicRoughness);
    for (const auto &[code, look] : looks_) {
      ASSERT_TRUE(colours.contains(code) && emission.contains(code) && metal.contains(code) &&
                  strength.contains(code));
      EXPECT_EQ(colours.at(code), voxels_.at(code)) << code;
      EXPECT_EQ(emission.at(code) & 0xffffff, look.emission & 0xffffff) << code;
      // Of what gives off nothing it means nothing.
      if (look.emission != 0) {
        EXPECT_EQ(strengthOfWord(strength.at(code)), look.strength) << code;
      }
      EXPECT_EQ(metal.at(code) | 0xff000000, look.metal) << code;
    }
  }

  /// Voxels that touch no other, of colours and looks by chance: `make` is given a number and the colour.
  template <typename Make> void fill(Make make) {
    Int3 at;
    for (at.z = 0; at.z < kExtent.z; at.z += 2)
      for (at.y = 0; at.y < kExtent.y; at.y += 2)
        for (at.x = 0; at.x < kExtent.x; at.x += 2) {
          const std::uint32_t word = static_cast<std::uint32_t>(random_()) | 0xff000000;
          add(at, word, make(static_cast<std::uint32_t>(random_()), word));
        }
  }

  std::mt19937 random_{5};
  Voxels voxels_;
  std::map<std::uint64_t, Look> looks_;
  bool hasOther_ = false; ///< The volume has an attribute that is no look.
  TemporaryFolder folder_;
};

/// Metal, smooth or clear, of any bytes.
std::uint32_t anyMetal(std::uint32_t number) { return number % 3 == 0 ? 0xff00ff00 : number | 0xff000000; }

/// No brighter than a colour.
std::uint32_t lightWithin(std::uint32_t number, std::uint32_t word) {
  std::uint32_t light = 0xff000000;
  for (int shift = 0; shift < 24; shift += 8)
    light |= (number >> shift & 255) * (word >> shift & 255) / 255 << shift;
  return number % 2 == 0 || (light & 0xffffff) == 0 ? 0 : light;
}

TEST_F(AttributeExport, GlbWithAMaterialForEachLook) {
  const std::array<float, 3> strengths{1, 2.5, 1000};
  fill([&](std::uint32_t number, std::uint32_t word) {
    return Look{lightWithin(number, word), strengths[number % 3], anyMetal(number >> 2)};
  });
  EXPECT_THAT(write("a.glb"), IsEmpty());
  expectSame("a.glb");
}

TEST_F(AttributeExport, GlbWithTextures) {
  fill([](std::uint32_t number, std::uint32_t word) {
    return Look{lightWithin(number, word), 2.5, anyMetal(number >> 2)};
  });
  ExportOptions options;
  options.texture = true;
  EXPECT_THAT(write("a.glb", options), IsEmpty());
  expectSame("a.glb");
  // One strength stands for all.
  add({0, 0, 0}, 0xffffffff, {0xff00ff00, 7});
  EXPECT_THAT(write("b.glb", options),
              ElementsAre(HasSubstr("of which a texture holds one: 7 stands for all")));
}

TEST_F(AttributeExport, GlbOfWhatIsBrighterThanItsColour) {
  add({0, 0, 0}, rgba(10, 20, 30), {rgba(10, 21, 30)});
  for (const bool texture : {false, true}) {
    ExportOptions options;
    options.texture = texture;
    EXPECT_THAT(write("a.glb", options), ElementsAre(HasSubstr("more light than their colour has")));
    EXPECT_EQ(read("a.glb", MaterialWords::Colours).at(0), rgba(10, 21, 30));
    EXPECT_EQ(read("a.glb", MaterialWords::Emission).at(0), rgba(10, 21, 30));
  }
}

/// A look that a material of MagicaVoxel has.
Look voxLook(std::uint32_t number, std::uint32_t word) {
  const std::uint32_t rough = number & 0xff00, some = number >> 24;
  const std::array<float, 4> strengths{0.25F, 1, 3.3330078125F, 1000};
  const std::array<Look, 4> looks{{{word, strengths[some % 4]},
                                   {0, 1, 0xff000000 | rough | some},         // Glass, or what is smooth,
                                   {0, 1, 0xff000000 | rough | (some << 16)}, // metal,
                                   {}}};
  return looks[number % 4];
}

TEST_F(AttributeExport, VoxWithAMaterialForEachColour) {
  fill([](std::uint32_t number, std::uint32_t word) { return voxLook(number, word); });
  // One colour with several materials, and the same of several colours.
  for (std::uint32_t i = 0; i < 4; ++i)
    add({static_cast<int>(i), 1, 0}, 0xff102030, voxLook(i, 0xff102030));
  EXPECT_THAT(write("a.vox"), IsEmpty());
  expectSame("a.vox");
  EXPECT_THAT(write("part%d.vox"), IsEmpty());
  expectSame("part%d.vox");
}

TEST_F(AttributeExport, VoxOfWhatItsMaterialsDoNotHold) {
  const std::uint32_t word = rgba(10, 20, 30);
  for (const Look &look : {Look{rgba(10, 20, 31)}, Look{word, 1, rgba(0, 1, 1)}, Look{0, 1, rgba(9, 8, 7)}}) {
    add({0, 0, 0}, word, look);
    EXPECT_THAT(write("a.vox"), ElementsAre(HasSubstr("is light of the voxel's own colour, metal or glass")));
    EXPECT_EQ(read("a.vox", MaterialWords::Colours), voxels_);
  }
  // More pairs than numbers, though not more colours.
  for (std::uint32_t i = 0; i < 256; ++i)
    add({static_cast<int>(i % 15), static_cast<int>(i / 15 % 11), static_cast<int>(i / 165)}, word,
        {0, 1, rgba(0, i, 1)});
  for (const char *const name : {"a.vox", "part%d.vox"}) {
    EXPECT_THAT(write(name), ElementsAre(HasSubstr("more than 255 pairs of colour and material")));
    EXPECT_EQ(read(name, MaterialWords::Colours), voxels_);
  }
}

TEST_F(AttributeExport, WhatHasNoPlaceIsSaid) {
  hasOther_ = true;
  add({0, 0, 0}, 0xffffffff, {});
  EXPECT_THAT(write("a.glb"),
              ElementsAre("a .glb file has no place for these attributes, which are left out: 'weight'"));
  EXPECT_THAT(write("a.ply"),
              ElementsAre(HasSubstr("'emission', 'emission-strength', 'metallic-roughness', 'weight'")));
  EXPECT_THAT(write("a.hvx"), IsEmpty());
}

} // namespace
} // namespace voxc
