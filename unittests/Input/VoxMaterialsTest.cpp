// Materials of MagicaVoxel files: those that are read, and those that are written.
#include "Source/SourceTesting.h"
#include "VoxBytes.h"

#include "voxc/Input/EmissionStrength.h"
#include "voxc/Input/Input.h"

#include <gmock/gmock.h>

namespace voxc {
namespace {

using testing::ElementsAre;

class VoxMaterials : public testing::Test {
protected:
  TemporaryFolder folder_;
  InputOptions options_;
};

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
