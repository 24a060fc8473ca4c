// Named attributes of voxels.
#include "VolumeTesting.h"

#include "voxc/Render/NormalAttribute.h"
#include "voxc/Volume/Attributes.h"
#include "voxc/Volume/Frames.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <random>

namespace voxc {
namespace {

using ::testing::HasSubstr;

using test::VolumeFile;

std::vector<std::byte> bytesOf(std::initializer_list<int> values) {
  std::vector<std::byte> bytes;
  for (const int value : values)
    bytes.push_back(std::byte(value));
  return bytes;
}

TEST_F(VolumeFile, KeepsAttributes) {
  const auto volume = std::make_shared<const Volume>(small());
  auto more = withAttribute(volume, {"weight", 2, bytesOf({7, 9})});
  ASSERT_TRUE(more) << more.error().message;
  for (const bool compress : {false, true}) {
    ASSERT_TRUE(more->save(path_, {.compress = compress}));
    const auto loaded = Volume::load(path_);
    ASSERT_TRUE(loaded) << loaded.error().message;
    const Stream *weight = findAttribute(*loaded, "weight");
    ASSERT_TRUE(weight);
    EXPECT_EQ(weight->elements(), 1u);
    EXPECT_EQ(weight->bytes[1], std::byte{9});
    EXPECT_TRUE(std::ranges::equal(loaded->words(), volume->words()));
    EXPECT_FALSE(findAttribute(*loaded, "words"));
    EXPECT_FALSE(findAttribute(*loaded, "height"));
  }
}

TEST_F(VolumeFile, ReplacesAndDropsAttributes) {
  auto volume = std::make_shared<const Volume>(small());
  const auto take = [&](Expected<Volume> changed) {
    ASSERT_TRUE(changed) << changed.error().message;
    volume = std::make_shared<const Volume>(std::move(*changed));
  };
  take(withAttribute(volume, {"a", 1, bytesOf({1})}));
  take(withAttribute(volume, {"b", 1, bytesOf({2})}));
  take(withAttribute(volume, {"a", 2, bytesOf({3, 4})}));
  ASSERT_EQ(volume->streams().size(), 3u);
  EXPECT_EQ(findAttribute(*volume, "a")->elementBytes, 2u);
  take(withoutAttribute(volume, "b"));
  EXPECT_EQ(volume->streams().size(), 2u);
  EXPECT_THAT(withoutAttribute(volume, "b").error().message, HasSubstr("no attribute 'b'"));
  EXPECT_THAT(withoutAttribute(volume, "words").error().message, HasSubstr("no attribute 'words'"));
}

TEST_F(VolumeFile, TakesNoAttributeThatIsNone) {
  const auto volume = std::make_shared<const Volume>(small());
  const auto errorWith = [&](Attribute attribute) {
    return withAttribute(volume, std::move(attribute)).error().message;
  };
  EXPECT_THAT(errorWith({"words", 1, bytesOf({1})}), HasSubstr("cannot be called 'words'"));
  EXPECT_THAT(errorWith({"frames", 1, bytesOf({1})}), HasSubstr("cannot be called 'frames'"));
  EXPECT_THAT(errorWith({"coarse-8", 1, bytesOf({1})}), HasSubstr("as coarse blocks of a volume are"));
  EXPECT_THAT(errorWith({"Weight", 1, bytesOf({1})}), HasSubstr("is no name"));
  EXPECT_THAT(errorWith({"a-name-that-is-longer-than-thirty-one", 1, bytesOf({1})}), HasSubstr("is no name"));
  EXPECT_THAT(errorWith({"a", 0, {}}), HasSubstr("1 to 256 bytes, not 0"));
  EXPECT_THAT(errorWith({"a", 257, std::vector<std::byte>(257)}), HasSubstr("1 to 256 bytes, not 257"));
  EXPECT_THAT(errorWith({"a", 1, bytesOf({1, 2})}), HasSubstr("has 2 bytes, but the volume has 1 voxels"));
  EXPECT_THAT(errorWith({"a", 2, bytesOf({1, 2, 3})}), HasSubstr("has 3 bytes"));
}

/// A file may call anything an attribute; only what has an element for each voxel is found as one.
TEST_F(VolumeFile, FindsNoAttributeOfAnotherSize) {
  const auto volume = std::make_shared<const Volume>(small());
  const std::vector<std::byte> elements(3);
  std::vector<Stream> streams(volume->streams().begin(), volume->streams().end());
  streams.push_back({"weight", 1, elements});
  ASSERT_TRUE(Volume(volume->info(), std::move(streams), volume).save(path_));
  const auto loaded = Volume::load(path_);
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_TRUE(loaded->findStream("weight"));
  EXPECT_FALSE(findAttribute(*loaded, "weight"));
}

/// An animation of one voxel a frame has as many frames as a frame has voxels, and still no attribute of
/// them.
TEST_F(VolumeFile, FindsNoAttributeInItsFrames) {
  const auto words = std::make_shared<const Volume>(small());
  const std::array<Frame, 1> frames{{{words->words()[0], 0, 1}}};
  std::vector<Stream> streams(words->streams().begin(), words->streams().end());
  streams.push_back(frameStream(frames));
  const auto volume = std::make_shared<const Volume>(words->info(), std::move(streams), words);
  ASSERT_EQ(framesOf(*volume).size(), 1u);
  EXPECT_FALSE(findAttribute(*volume, "frames"));
  EXPECT_THAT(withoutAttribute(volume, "frames").error().message, HasSubstr("no attribute 'frames'"));
}

/// A file of a few bytes may stand for more voxels than there is memory, or than bytes can be counted.
TEST(Attributes, AreNotMadeOfWhatTakesTooMuch) {
  for (const std::uint64_t voxels : {std::uint64_t{1} << 33, std::uint64_t{1} << 62}) {
    VolumeInfo info;
    info.format = *parseFormat("G(1)");
    info.voxels = voxels;
    const Volume volume(info, {2, 9, 0x0202, 1});
    EXPECT_THAT(normalAttribute(volume, 1).error().message, HasSubstr("would take more than"));
    EXPECT_FALSE(zeroElements(volume, 256));
  }
}

TEST(PackedNormal, KeepsDirections) {
  std::mt19937 random(5);
  std::normal_distribution<float> number;
  float furthest = 0;
  for (int i = 0; i < 100000; ++i) {
    const glm::vec3 direction = glm::normalize(glm::vec3(number(random), number(random), number(random)));
    furthest = std::max(furthest, glm::distance(direction, unpackNormal(packNormal(direction))));
  }
  EXPECT_LT(furthest, glm::radians(0.02f));
  for (const glm::vec3 axis : {glm::vec3{1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}})
    EXPECT_EQ(unpackNormal(packNormal(axis * 3.0f)), axis);
  EXPECT_EQ(packNormal({}), 0x80008000u);
  EXPECT_EQ(unpackNormal(packNormal({})), glm::vec3());
}

/// A plate: all normals but those at its rim stand upright.
TEST(NormalAttribute, StandsOnAPlate) {
  std::vector<std::uint32_t> words = {1};
  VolumeInfo info;
  info.format = *parseFormat("R(4,4,4)");
  info.extent = {16, 16, 16};
  for (int i = 0; i < 16 * 16 * 16; ++i)
    words.push_back((i >> 4 & 15) == 7 ? 1 : 0);
  info.voxels = 256;
  const Volume volume(info, words);
  const auto attribute = normalAttribute(volume, 1);
  ASSERT_TRUE(attribute) << attribute.error().message;
  EXPECT_EQ(attribute->name, "normal");
  ASSERT_EQ(attribute->elements.size(), 1024u);
  int upright = 0;
  for (std::size_t i = 0; i < 256; ++i) {
    std::uint32_t packed = 0;
    std::memcpy(&packed, &attribute->elements[4 * i], sizeof packed);
    upright += std::abs(unpackNormal(packed).y) > 0.99f;
  }
  EXPECT_EQ(upright, 256);
}

} // namespace
} // namespace voxc
