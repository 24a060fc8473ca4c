// Compressed files: written, decoded whole and page by page, and files whose pages are not what they should
// be.
#include "PagedTesting.h"

#include "voxc/Input/Input.h"
#include "voxc/Support/WorkingMemory.h"
#include "voxc/Volume/PagedVolume.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>

namespace voxc {
namespace {

using ::testing::HasSubstr;

using test::at;
using test::kPage;
using test::PagedFile;

void expectEqual(std::span<const Stream> a, std::span<const Stream> b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].name, b[i].name);
    EXPECT_EQ(a[i].elementBytes, b[i].elementBytes);
    EXPECT_TRUE(std::ranges::equal(a[i].bytes, b[i].bytes)) << a[i].name;
  }
}

TEST_F(PagedFile, RoundTrips) {
  const Volume saved = several();
  const std::string bytes = compressed(saved);
  EXPECT_LT(bytes.size(), saved.bytes() / 2);
  EXPECT_EQ(bytes[8], 3);
  const auto loaded = Volume::load(path_);
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ(loaded->format(), saved.format());
  EXPECT_EQ(loaded->info().extent, saved.info().extent);
  EXPECT_EQ(loaded->info().voxelToModel, saved.info().voxelToModel);
  EXPECT_EQ(loaded->info().provenance, saved.info().provenance);
  EXPECT_EQ(loaded->lookup({1, 0, 0}).value, 9u);
  expectEqual(loaded->streams(), saved.streams());
  std::uint64_t stored = 0;
  for (const Stream &stream : loaded->streams()) {
    EXPECT_LE(stream.storedBytes, stream.bytes.size()) << stream.name;
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(stream.bytes.data()) % 4096, 0u) << stream.name;
    stored += stream.storedBytes;
  }
  EXPECT_EQ(bytes.size(), 4096 + stored);
  EXPECT_EQ(loaded->findStream("noise")->storedBytes, kPage + 7); // As it is.
  EXPECT_LT(loaded->findStream("ramp")->storedBytes, kPage / 4);
}

TEST_F(PagedFile, BecomesAMappedOneAgain) {
  const std::string mapped = saved(several());
  ASSERT_NE(compressed(several()), mapped);
  const auto loaded = Volume::load(path_);
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ(saved(*loaded), mapped);
}

TEST_F(PagedFile, IsTheSameWhateverTheMeans) {
  const std::string one = compressed(several(), {.threads = 1});
  EXPECT_EQ(compressed(several(), {.threads = 5}), one);
  EXPECT_EQ(compressed(several(), {.threads = 3, .memory = WorkingMemory::create(1 << 20)}), one);
  for (const unsigned threads : {1u, 2u, 7u}) {
    const auto loaded = Volume::load(path_, {.memory = WorkingMemory::create(1 << 20), .threads = threads});
    ASSERT_TRUE(loaded) << loaded.error().message;
    expectEqual(loaded->streams(), several().streams());
  }
}

TEST_F(PagedFile, IsNotWrittenWhenItIsInterruptedOrHasNoPlace) {
  const std::string before = saved(small());
  const std::atomic<bool> stop = true;
  const auto stopped = several().save(path_, {.compress = true, .progress = {{}, &stop}});
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().kind, ErrorKind::Interrupted);
  EXPECT_EQ(*readTextFile(path_), before);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1);
  EXPECT_FALSE(small().save(folder_, {.compress = true}));
  EXPECT_THAT(small().save("/dev/null", {.compress = true}).error().message, HasSubstr("no regular file"));
}

TEST_F(PagedFile, DecodesAnyPage) {
  const Volume saved = several();
  compressed(saved);
  const auto file = PagedVolume::open(path_);
  ASSERT_TRUE(file) << file.error().message;
  EXPECT_EQ(file->info().format, saved.format());
  ASSERT_EQ(file->streams().size(), saved.streams().size());
  const std::uint64_t pages[] = {1, 0, 3, 2, 2};
  for (std::size_t i = saved.streams().size(); i-- > 0;) {
    const PagedStream &stream = file->streams()[i];
    EXPECT_EQ(stream.name, saved.streams()[i].name);
    EXPECT_EQ(stream.bytes, saved.streams()[i].bytes.size());
    ASSERT_EQ(stream.pages(), pages[i]);
    for (std::uint64_t page = stream.pages(); page-- > 0;) {
      std::vector<std::byte> room(stream.bytesOf(page));
      const auto decoded = file->decode(i, page, room);
      ASSERT_TRUE(decoded) << decoded.error().message;
      EXPECT_TRUE(
          std::ranges::equal(room, saved.streams()[i].bytes.subspan(page * stream.pageBytes, room.size())));
    }
  }
}

TEST_F(PagedFile, HasNoOtherPages) {
  compressed(several());
  const auto file = PagedVolume::open(path_);
  ASSERT_TRUE(file);
  std::vector<std::byte> room(16);
  EXPECT_TRUE(file->decode(0, 0, room));
  for (const auto &[stream, page] : {std::pair{0, 1}, {1, 0}, {5, 0}, {0, -1}})
    EXPECT_EQ(file->decode(stream, page, room).error().kind, ErrorKind::Usage);
  EXPECT_THAT(file->decode(0, 0, std::span(room).first(15)).error().message,
              HasSubstr("needs room for 16 bytes, not 15"));
  EXPECT_THAT(file->decode(2, 0, room).error().message, HasSubstr("'ramp' needs room for 262144 bytes"));
  saved(small());
  EXPECT_THAT(PagedVolume::open(path_).error().message, HasSubstr("is not compressed"));
}

/// Only the page that is damaged is lost.
TEST_F(PagedFile, TellsADamagedPage) {
  std::string bytes = compressed(several());
  const std::size_t middle = at<std::uint64_t>(bytes, rowOf(bytes, 1)) + 100; // In the ramp's page 1.
  bytes[middle] ^= 1;
  EXPECT_THAT(errorOf(bytes), HasSubstr("is damaged: page 1 of stream 'ramp' is not what was stored"));
  const auto file = PagedVolume::read(std::as_bytes(std::span(bytes)), nullptr, "volume.hvx");
  ASSERT_TRUE(file) << file.error().message;
  std::vector<std::byte> room(kPage);
  EXPECT_TRUE(file->decode(2, 0, room));
  EXPECT_FALSE(file->decode(2, 1, room));
  // The first of several, whichever thread is faster.
  bytes.back() ^= 1;
  for (int i = 0; i < 20; ++i)
    ASSERT_THAT(errorOf(bytes), HasSubstr("page 1 of stream 'ramp'"));
}

/// A file that an earlier voxc wrote: `voxc build "R(1^3) G(4)" builtin:terrain:32 --compress`.
TEST_F(PagedFile, StaysReadable) {
  const auto volume = Volume::load(VOXC_UNITTESTS_DIR "/Volume/Golden/v3/terrain.hvx");
  ASSERT_TRUE(volume) << volume.error().message;
  EXPECT_LT(volume->streams()[0].storedBytes, volume->bytes());
  const Int3 extent = volume->format().extent();
  const auto scene = openInput("builtin:terrain:32", {.formatExtent = extent});
  ASSERT_TRUE(scene) << scene.error().message;
  for (Int3 c; c.z < extent.z; ++c.z)
    for (c.y = 0; c.y < extent.y; ++c.y)
      for (c.x = 0; c.x < extent.x; ++c.x) {
        std::uint32_t word = 0;
        ASSERT_TRUE(scene->source->read({c, 0}, &word));
        ASSERT_EQ(volume->lookup(c).value, word) << c.x << "," << c.y << "," << c.z;
      }
}

} // namespace
} // namespace voxc
