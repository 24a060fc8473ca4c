// Whatever volume of a stranger is edited, a volume comes out that any kernel may read, or an error.
#include "TestLength.h"

#include "testing/HardScenes.h"
#include "testing/RandomFormat.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/Source/Sources.h"

#include <gtest/gtest.h>

#include <random>

namespace voxc {
namespace {

using Words = std::vector<std::uint32_t>;

/// Changes a bit of one word, or makes it what stands elsewhere.
Words mutated(Words words, std::mt19937 &random) {
  const std::size_t at = random() % words.size();
  if (random() % 3 == 0)
    words[at] ^= 1u << random() % 32;
  else
    words[at] = words[random() % words.size()];
  return words;
}

/// Edits nothing, so that all parts are taken out of the words as they are. Whether the words are a volume.
bool editWords(const VolumeInfo &like, Words words, const Constructor &constructor) {
  const auto voxels = checkStructure(like.format, words);
  if (!voxels)
    return false;
  VolumeInfo info = like;
  info.voxels = *voxels;
  const auto hostile = std::make_shared<const Volume>(std::move(info), std::move(words));
  const auto edited = constructor.edit(hostile, {});
  if (!edited)
    return true;
  const auto after = checkStructure(like.format, edited->volume.words());
  EXPECT_EQ(after ? *after : 0, edited->volume.info().voxels)
      << printIr(like.format) << (after ? "" : after.error().message);
  return true;
}

TEST(HostileEdit, GivesAWholeVolumeOrNone) {
  std::mt19937 random(19);
  int sound = 0;
  for (int i = 0; i < test::rounds(12); ++i) {
    const Format format = test::randomFormat(random, 5);
    const auto constructor = Constructor::compile(format);
    ASSERT_TRUE(constructor);
    const auto scenes = test::hardScenes(format.extent());
    const auto source = scenes[std::size_t(test::pick(random, 0, int(scenes.size()) - 1))].source();
    const auto built = constructor->build(*source);
    if (!built)
      continue;
    const Words words(built->volume.words().begin(), built->volume.words().end());
    for (int j = 0; j < 200; ++j)
      sound += editWords(built->volume.info(), mutated(words, random), *constructor);
  }
  EXPECT_GT(sound, 100);
}

/// Each word leads to each place: a word may then be a voxel to one level and a reference to another.
TEST(HostileEdit, OfWordsThatTwoLevelsShare) {
  for (const char *text : {"G(1) G(1)", "G(1) R(1, 1, 1)", "R(1, 1, 1) G(1)", "D(1, 1, 1, 1) G(1) G(1)"}) {
    const Format format = *parseFormat(text);
    const auto constructor = Constructor::compile(format);
    ASSERT_TRUE(constructor);
    const auto source = makeFunctionSource(format.extent(), [](Int3 cell) {
      return cell.x < 2 && cell.y == cell.z ? 1u + unsigned(cell.x) : 0u;
    });
    const auto built = constructor->build(*source);
    ASSERT_TRUE(built);
    const Words words(built->volume.words().begin(), built->volume.words().end());
    int sound = 0;
    for (std::size_t at = 0; at < words.size(); ++at)
      for (std::uint32_t place = 1; place < words.size(); ++place) {
        Words changed = words;
        changed[at] = place;
        sound += editWords(built->volume.info(), std::move(changed), *constructor);
      }
    EXPECT_GT(sound, 10) << text;
  }
}

} // namespace
} // namespace voxc
