// Materials of MagicaVoxel files: those that are read, and those that are written.
#include "Input/InputTesting.h"
#include "VoxBytes.h"

#include "voxc/Input/EmissionStrength.h"
#include "voxc/Input/Input.h"

#include <gmock/gmock.h>

#include <bit>

namespace voxc {
namespace {

using testing::ElementsAre;

class VoxMaterials : public OpenedInputs {};

TEST_F(VoxMaterials, OldChunksHaveThemToo) {
  const auto material = [](std::uint32_t number, std::uint32_t type, float share, std::uint32_t bits,
                           std::initializer_list<float> properties) {
    std::string content = wordBytes({number, type, std::bit_cast<std::uint32_t>(share), bits});
    for (const float property : properties)
      content += wordBytes({std::bit_cast<std::uint32_t>(property)});
    return chunkBytes("MATT", content);
  };
  // A metal with plastic and roughness, glass without more; light with power, and the bit that has no number.
  const std::string file = voxBytes(modelChunks(3, 1, 1, {{0, 0, 0, 1}, {1, 0, 0, 2}, {2, 0, 0, 3}}) +
                                    material(1, 1, 0.6f, 3, {1.f, 0.4f}) + material(2, 2, 0.8f, 0, {}) +
                                    material(3, 3, 0.5f, 0xa0, {0.25f}));
  options_.materialWords = MaterialWords::MetallicRoughness;
  EXPECT_EQ(words("a.vox", file),
            (std::vector<std::uint32_t>{rgba(0, 102, 153), rgba(204, 255, 0), rgba(0, 255, 0)}));
  options_.materialWords = MaterialWords::EmissionStrength;
  EXPECT_EQ(words("a.vox", file)[2], strengthWord(0.5f));
  EXPECT_NE(problem("b.vox", voxBytes(modelChunks(1, 1, 1, {}) + chunkBytes("MATT", wordBytes({1, 1})))),
            "none");
}

TEST_F(VoxMaterials, ClearGlassAndStrongLight) {
  std::uint32_t number = 0;
  const auto material = [&](Pairs pairs) {
    return chunkBytes("MATL", wordBytes({++number}) + dictionaryBytes(pairs));
  };
  std::string chunks = modelChunks(
      7, 1, 1,
      {{0, 0, 0, 1}, {1, 0, 0, 2}, {2, 0, 0, 3}, {3, 0, 0, 4}, {4, 0, 0, 5}, {5, 0, 0, 6}, {6, 0, 0, 7}});
  chunks += material(
      {{"_type", "_glass"}, {"_trans", "0.6"}, {"_alpha", "0.1"}, {"_rough", "0.2"}, {"_weight", "1"}});
  chunks += material({{"_type", "_glass"}, {"_alpha", "0.4"}});
  chunks += material({{"_type", "_glass"}, {"_weight", "0.8"}}); // As files of before 0.99 have it.
  chunks += material({{"_type", "_emit"}, {"_emit", "0.75"}, {"_flux", "3"}, {"_trans", "1"}});
  chunks += material({{"_type", "_emit"}});
  chunks += material({{"_type", "_emit"}, {"_emit", "-nan"}, {"_flux", "1e300"}, {"_weight", "0.5"}});
  chunks += material({{"_type", "_metal"}, {"_weight", "0.2"}, {"_emit", "1"}});
  const std::string path = folder_.file("m.vox", voxBytes(chunks));
  const auto wordsOf = [&](MaterialWords words) {
    options_.materialWords = words;
    const auto input = openInput(path, options_);
    EXPECT_TRUE(input) << input.error().message;
    std::vector<std::uint32_t> row(7);
    for (const auto &[code, word] : voxelsOf(*input->source))
      row[static_cast<std::size_t>(mortonCell(code).x)] = word;
    return row;
  };
  const std::uint32_t rough = rgba(0, 255, 0);
  EXPECT_THAT(wordsOf(MaterialWords::MetallicRoughness),
              ElementsAre(rgba(153, 51, 0), rgba(102, 255, 0), rgba(204, 255, 0), rough, rough, rough,
                          rgba(0, 255, 51)));
  std::vector<float> strengths;
  for (const std::uint32_t word : wordsOf(MaterialWords::EmissionStrength))
    strengths.push_back(strengthOfWord(word));
  EXPECT_THAT(strengths, ElementsAre(0, 0, 0, 3, 1, 0.5, 0));
}

} // namespace
} // namespace voxc
