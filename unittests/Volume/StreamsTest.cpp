// Volumes of several streams, and files whose table of them is not what it should be.
#include "VolumeTesting.h"

#include "Volume/VolumeFileWriter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

namespace voxc {
namespace {

using test::sealed;
using ::testing::HasSubstr;

// Where fields of version 2 lie (docs/hvx.md).
constexpr std::size_t kFileBytes = 24;
constexpr std::size_t kHeadBytes = 32;
constexpr std::size_t kStreams = 68;
constexpr std::size_t kTable = 168;
constexpr std::size_t kRow = 56;
constexpr std::size_t kElementBytes = 32;
constexpr std::size_t kPageBytes = 36;
constexpr std::size_t kElements = 40;
constexpr std::size_t kOffset = 48;
constexpr std::size_t kPageOfMemory = 4096;

template <typename T> std::string with(std::string bytes, std::size_t at, T value) {
  std::memcpy(bytes.data() + at, &value, sizeof value);
  return bytes;
}

std::string withName(std::string bytes, std::size_t row, std::string name) {
  name.resize(kElementBytes);
  return bytes.replace(kTable + row * kRow, name.size(), name);
}

/// Of all bytes of all streams.
std::uint64_t sumOf(const Volume &volume) {
  std::uint64_t sum = 0;
  for (const Stream &stream : volume.streams())
    for (const std::byte byte : stream.bytes)
      sum += std::to_integer<std::uint64_t>(byte);
  return sum;
}

class Streams : public test::VolumeFile {
protected:
  /// The words of the small volume, no normals, 3 weights and 5 groups of three bytes.
  static Volume several() {
    struct Arrays {
      std::vector<std::uint32_t> words = {2, 9, 0x0202, 1};
      std::vector<std::uint64_t> weights = {7, 8, std::uint64_t{1} << 63};
      std::vector<std::uint8_t> groups = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
    };
    auto arrays = std::make_shared<const Arrays>();
    std::vector<Stream> streams = {wordStream(arrays->words),
                                   {"normals", 4, {}},
                                   {"weights-2", 8, std::as_bytes(std::span(arrays->weights))},
                                   {"groups", 3, std::as_bytes(std::span(arrays->groups))}};
    return Volume(smallInfo(), std::move(streams), std::move(arrays));
  }
};

TEST_F(Streams, OfWordsAloneAreWhatEveryVolumeHas) {
  const Volume volume = small();
  ASSERT_EQ(volume.streams().size(), 1u);
  EXPECT_EQ(volume.streams()[0].name, kWordStream);
  EXPECT_EQ(volume.findStream("words"), &volume.streams()[0]);
  EXPECT_EQ(volume.findStream("normals"), nullptr);
  EXPECT_TRUE(std::ranges::equal(volume.streams()[0].as<std::uint32_t>(), volume.words()));
  EXPECT_EQ(volume.bytes(), 16u);
}

TEST_F(Streams, RoundTrip) {
  const Volume saved = several();
  ASSERT_TRUE(saved.save(path_));
  const auto loaded = Volume::load(path_);
  ASSERT_TRUE(loaded) << loaded.error().message;
  ASSERT_EQ(loaded->streams().size(), saved.streams().size());
  for (std::size_t i = 0; i < saved.streams().size(); ++i) {
    const Stream &stream = loaded->streams()[i];
    EXPECT_EQ(stream.name, saved.streams()[i].name);
    EXPECT_EQ(stream.elementBytes, saved.streams()[i].elementBytes);
    EXPECT_TRUE(std::ranges::equal(stream.bytes, saved.streams()[i].bytes)) << stream.name;
    const auto address = reinterpret_cast<std::uintptr_t>(stream.bytes.data());
    EXPECT_TRUE(stream.bytes.empty() || address % kPageOfMemory == 0) << stream.name;
  }
  EXPECT_EQ(loaded->bytes(), 16u + 24 + 15);
  EXPECT_EQ(loaded->findStream("groups")->elements(), 5u);
  EXPECT_EQ(loaded->findStream("weights-2")->as<std::uint64_t>()[2], std::uint64_t{1} << 63);
  EXPECT_TRUE(loaded->findStream("weights-2")->as<std::uint32_t>().empty());
  EXPECT_EQ(loaded->lookup({1, 0, 0}).value, 9u);
  EXPECT_EQ(std::filesystem::file_size(path_), 3 * kPageOfMemory + 15);
}

TEST_F(Streams, AreWrittenWhileWordsAreMadeAsTheyAreSaved) {
  std::vector<std::uint32_t> words(3 * kPageOfMemory / 4 - 5);
  std::iota(words.begin(), words.end(), 1u);
  const Volume other = several();
  std::vector<Stream> streams(other.streams().begin(), other.streams().end());
  streams[0] = wordStream(words);
  const std::string expected = saved(Volume(smallInfo(), streams, nullptr));

  const auto memory = WorkingMemory::create(1 << 20);
  auto block = memory->reserve(4 * kPageOfMemory);
  ASSERT_TRUE(block && memory->extendInMemory(*block, 3 * kPageOfMemory));
  std::ranges::copy(streams[0].bytes, block->data());
  auto writer = VolumeFileWriter::create(path_, smallInfo(), streams.size());
  ASSERT_TRUE(writer);
  ASSERT_TRUE(writer->flush(*block, kPageOfMemory, kPageOfMemory, *memory));
  streams[0].bytes = {block->data(), streams[0].bytes.size()};
  ASSERT_TRUE(writer->finish(smallInfo(), streams, {kPageOfMemory, 2 * kPageOfMemory}, *memory));
  EXPECT_EQ(*readTextFile(path_), expected);
}

TEST_F(Streams, NoticeEveryFlippedBitAndEveryLength) {
  std::string bytes = saved(several());
  for (std::size_t at = 0; at < bytes.size(); ++at)
    for (int bit = 0; bit < 8; ++bit) {
      bytes[at] ^= static_cast<char>(1 << bit);
      ASSERT_NE(errorOf(bytes), "no error") << "byte " << at << ", bit " << bit;
      bytes[at] ^= static_cast<char>(1 << bit);
    }
  EXPECT_EQ(errorOf(bytes), "no error");
  for (std::size_t length = 0; length < bytes.size(); ++length)
    ASSERT_NE(errorOf(sealed(bytes.substr(0, length))), "no error") << length;
  EXPECT_THAT(errorOf(sealed(bytes + '\0')), HasSubstr("surplus"));
}

TEST_F(Streams, OfAHostileHeaderAreRefused) {
  const std::string whole = saved(several());
  const auto errorWith = [&](std::size_t at, auto value) {
    return errorOf(sealed(with(whole, at, value)), true);
  };
  EXPECT_EQ(errorOf(sealed(whole)), "no error");
  EXPECT_THAT(errorWith(8, std::uint32_t{4}), HasSubstr("is of version 4; this voxc reads versions up to 3"));
  EXPECT_THAT(errorWith(8, std::uint32_t{0}), HasSubstr("damaged"));
  for (const std::uint32_t other : {1u, 3u})
    EXPECT_NE(errorWith(8, other), "no error");
  for (const std::uint64_t bytes : {std::uint64_t{0}, whole.size() - 1, whole.size() + 1, ~std::uint64_t{0}})
    EXPECT_THAT(errorWith(kFileBytes, bytes), HasSubstr("truncated or has surplus bytes"));
  for (const std::uint64_t bytes :
       {std::uint64_t{0}, kPageOfMemory - 1, 2 * kPageOfMemory, ~std::uint64_t{0} - kPageOfMemory + 1})
    EXPECT_THAT(errorWith(kHeadBytes, bytes), HasSubstr("contradicts itself"));
  for (const std::uint32_t streams : {0u, 65u, ~0u})
    EXPECT_THAT(errorWith(kStreams, streams), HasSubstr("contradicts itself"));
  for (const std::uint32_t streams : {1u, 2u, 3u, 5u, 64u})
    EXPECT_NE(errorWith(kStreams, streams), "no error");
}

TEST_F(Streams, WithoutAProperNameAreRefused) {
  const std::string whole = saved(several());
  const auto errorNamed = [&](std::size_t row, const std::string &name) {
    return errorOf(sealed(withName(whole, row, name)), true);
  };
  for (const std::string &name :
       {std::string(), std::string("Weights"), std::string("2-weights"), std::string("-"), std::string("a b"),
        std::string("a\0b", 3), std::string("../a"), std::string(32, 'a')})
    EXPECT_THAT(errorNamed(2, name), HasSubstr("without a name")) << name;
  EXPECT_EQ(errorNamed(2, std::string(31, 'a')), "no error");
  EXPECT_THAT(errorNamed(3, "weights-2"), HasSubstr("more than one stream 'weights-2'"));
  EXPECT_THAT(errorNamed(3, "words"), HasSubstr("more than one stream 'words'"));
  EXPECT_THAT(errorNamed(0, "word"), HasSubstr("words first"));
}

TEST_F(Streams, OfAHostileTableAreRefused) {
  const std::string whole = saved(several());
  const auto errorWith = [&](std::size_t row, std::size_t at, auto value) {
    return errorOf(sealed(with(whole, kTable + row * kRow + at, value)), true);
  };
  EXPECT_THAT(errorWith(0, kElementBytes, 2u), HasSubstr("words first"));
  EXPECT_THAT(errorWith(0, kElements, std::uint64_t{0}), HasSubstr("has no words"));
  for (const std::uint32_t size : {0u, 257u, ~0u})
    EXPECT_THAT(errorWith(2, kElementBytes, size), HasSubstr("no possible size"));
  EXPECT_THAT(errorWith(1, kPageBytes, 4096u),
              HasSubstr("'normals' in pages, which its version does not know"));
  const auto all = ~std::uint64_t{0};
  for (const std::uint64_t elements :
       {std::uint64_t{0}, all, all / 4 + 1, (all >> 3) + 4, std::uint64_t{kPageOfMemory}})
    for (const std::size_t row : {0, 2, 3})
      EXPECT_NE(errorWith(row, kElements, elements), "no error") << row << ", " << elements;
  for (const std::uint64_t offset :
       {std::uint64_t{0}, std::uint64_t{kPageOfMemory - 4}, all - kPageOfMemory + 1, all - 15})
    for (const std::size_t row : {0, 1, 2, 3})
      EXPECT_THAT(errorWith(row, kOffset, offset), HasSubstr("does not lie where it must"));
  EXPECT_THAT(errorWith(2, kOffset, std::uint64_t{kPageOfMemory}),
              HasSubstr("stream 'weights-2' that does not lie"));
  EXPECT_THAT(errorWith(3, kElements, std::uint64_t{4}), HasSubstr("surplus"));
  EXPECT_THAT(errorWith(3, kElements, std::uint64_t{6}), HasSubstr("does not lie where it must"));
}

/// Whatever a head says, loading ends in an error or in a volume that can be read.
TEST_F(Streams, AreHarmlessWhateverBitOfTheHeadIsFlipped) {
  const std::string whole = saved(several());
  const std::size_t textEnd = whole.find("resolution=2") + 12;
  int loaded = 0;
  for (std::size_t at = 0; at < textEnd; ++at)
    for (int bit = 0; bit < 8; ++bit) {
      const std::string changed = sealed(with(whole, at, static_cast<char>(whole[at] ^ 1 << bit)));
      const auto volume = load(changed);
      if (!volume)
        continue;
      ++loaded;
      EXPECT_TRUE(decode(*volume, [](const Cube &, std::uint32_t) { return true; }));
      EXPECT_LE(sumOf(*volume), 2u + 9 + 2 + 2 + 1 + 7 + 8 + 128 + 120) << "byte " << at << ", bit " << bit;
    }
  EXPECT_GT(loaded, 100); // Names, the transform and the provenance are free.
}

} // namespace
} // namespace voxc
