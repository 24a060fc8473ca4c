// Whatever words pass the structure check are read within bounds, by every format.
#include "TestLength.h"

#include "testing/HardScenes.h"
#include "testing/RandomFormat.h"
#include "voxc/Construct/Constructor.h"

#include <gtest/gtest.h>

namespace voxc {
namespace {

using Words = std::vector<std::uint32_t>;

/// Changes a word or two, mostly to what could pass for an offset or masks.
void mutate(Words &words, std::mt19937 &random) {
  for (int changes = test::pick(random, 1, 2); changes > 0; --changes) {
    std::uint32_t &word = words[random() % words.size()];
    switch (test::pick(random, 0, 3)) {
    case 0:
      word ^= 1u << random() % 32;
      break;
    case 1:
      word = random() % static_cast<std::uint32_t>(words.size() + 4);
      break;
    case 2:
      word = words[random() % words.size()];
      break;
    default:
      word += test::pick(random, -2, 2);
    }
  }
}

/// A read outside the words would find these instead.
Words withGarbageBehind(Words words) {
  words.insert(words.end(), 64, 0xdeadbeefu);
  return words;
}

Volume volumeOf(const Format &format, Words words, std::uint64_t voxels) {
  VolumeInfo info;
  info.format = storageFormat(format);
  info.extent = format.extent();
  info.voxels = voxels;
  return Volume(std::move(info), std::move(words));
}

/// All voxels by lookup, and all cubes of `decode`.
std::vector<std::uint64_t> everythingReadFrom(const Volume &volume) {
  std::vector<std::uint64_t> read;
  const Int3 extent = volume.format().extent();
  for (Int3 c; c.z < extent.z; ++c.z)
    for (c.y = 0; c.y < extent.y; ++c.y)
      for (c.x = 0; c.x < extent.x; ++c.x)
        read.push_back(volume.lookup(c).value);
  const auto decoded = decode(volume, [&](const Cube &cube, std::uint32_t word) {
    read.push_back(mortonCode(cube.low) << 8 | static_cast<std::uint64_t>(cube.log2Side));
    read.push_back(word);
    return true;
  });
  EXPECT_TRUE(decoded) << decoded.error().message;
  return read;
}

TEST(HostileWords, AreReadInBoundsOrRefused) {
  std::mt19937 random(5);
  int passed = 0;
  int refused = 0;
  for (int i = 0; i < test::rounds(10); ++i) {
    const Format format = test::randomFormat(random, 3);
    const auto scenes = test::hardScenes(format.extent());
    const auto built = Constructor::compile(format)->build(*scenes[random() % scenes.size()].source());
    ASSERT_TRUE(built) << built.error().message;
    const auto sound = built->volume.words();
    for (int mutation = 0; mutation < 400; ++mutation) {
      Words words(sound.begin(), sound.end());
      mutate(words, random);
      const auto voxels = checkStructure(format, words);
      if (!voxels) {
        ++refused;
        continue;
      }
      ++passed;
      const Volume changed = volumeOf(format, words, *voxels);
      const Volume extended = volumeOf(format, withGarbageBehind(words), *voxels);
      ASSERT_EQ(everythingReadFrom(changed), everythingReadFrom(extended)) << printIr(format);
    }
  }
  EXPECT_GT(passed, 100);
  EXPECT_GT(refused, 100);
}

} // namespace
} // namespace voxc
