// Compressed files: written, decoded whole and page by page, and files whose pages are not what they should
// be.
#include "VolumeTesting.h"

#include "Volume/PageTable.h"
#include "voxc/Input/Input.h"
#include "voxc/Support/WorkingMemory.h"
#include "voxc/Volume/PagedVolume.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zstd.h>

#include <atomic>
#include <numeric>
#include <random>

namespace voxc {
namespace {

using ::testing::HasSubstr;

// Where fields of version 3 lie (docs/hvx.md).
constexpr std::size_t kChecksum = 16;
constexpr std::size_t kFileBytes = 24;
constexpr std::size_t kHeadBytes = 32;
constexpr std::size_t kTable = 168;
constexpr std::size_t kRow = 56;
constexpr std::size_t kElementBytes = 32;
constexpr std::size_t kPageBytes = 36;
constexpr std::size_t kElements = 40;
constexpr std::size_t kOffset = 48;
constexpr std::size_t kPage = std::size_t{1} << 18; ///< As voxc writes them.

template <typename T> T at(const std::string &bytes, std::size_t place) {
  T value;
  std::memcpy(&value, bytes.data() + place, sizeof value);
  return value;
}

template <typename T> std::string with(std::string bytes, std::size_t place, T value) {
  std::memcpy(bytes.data() + place, &value, sizeof value);
  return bytes;
}

std::uint64_t checksumOf(std::string_view bytes) {
  Checksum checksum;
  checksum.add(bytes.data(), bytes.size());
  return checksum.digest();
}

/// The file with a head whose checksum is right.
std::string sealedHead(std::string bytes) {
  const auto head = std::min<std::uint64_t>(at<std::uint64_t>(bytes, kHeadBytes), bytes.size());
  return with(bytes, kChecksum,
              checksumOf(bytes.substr(0, kChecksum) + bytes.substr(kFileBytes, head - kFileBytes)));
}

class PagedFile : public test::VolumeFile {
protected:
  struct Arrays {
    std::vector<std::uint32_t> words = {2, 9, 0x0202, 1};
    std::vector<std::uint64_t> ramp = std::vector<std::uint64_t>(3 * kPage / 8 - 5);
    std::vector<std::uint8_t> noise = std::vector<std::uint8_t>(kPage + 7);
    std::vector<std::uint8_t> triples = std::vector<std::uint8_t>(2 * kPage - kPage / 2 + 3);
    Arrays() {
      std::iota(ramp.begin(), ramp.end(), 1u << 30);
      std::mt19937 random(7);
      std::ranges::generate(noise, [&] { return static_cast<std::uint8_t>(random()); });
      for (std::size_t i = 0; i < triples.size(); ++i)
        triples[i] = static_cast<std::uint8_t>(i % 3 * 80 + i / 5000);
    }
  };

  /// The words of the small volume, no normals, and three streams of several pages.
  static Volume several() {
    auto arrays = std::make_shared<const Arrays>();
    std::vector<Stream> streams = {wordStream(arrays->words),
                                   {"normals", 4, {}},
                                   {"ramp", 8, std::as_bytes(std::span(arrays->ramp))},
                                   {"noise", 1, std::as_bytes(std::span(arrays->noise))},
                                   {"triples", 3, std::as_bytes(std::span(arrays->triples))}};
    return Volume(smallInfo(), std::move(streams), std::move(arrays));
  }

  /// A file of two streams, the words and 64 zeros: 4096 bytes of head, a page as it is, and a compressed
  /// one.
  std::string two() const {
    const Volume words = small();
    const std::vector<std::byte> zeros(64);
    return compressed(Volume(smallInfo(), {words.streams()[0], {"zeros", 1, zeros}}, nullptr));
  }

  std::string compressed(const Volume &volume, SaveOptions options = {}) const {
    options.compress = true;
    const auto written = volume.save(path_, options);
    EXPECT_TRUE(written) << written.error().message;
    return *readTextFile(path_);
  }

  /// Where the row of a page lies in a file of the small volume.
  static std::size_t rowOf(const std::string &bytes, std::size_t page) {
    return bytes.find("resolution=2") + 12 + page * sizeof(PageRow);
  }

  /// The file with its last page stored otherwise, and all checksums right.
  static std::string withLastPage(std::string bytes, std::size_t page, const std::string &stored) {
    const std::size_t begin = at<std::uint64_t>(bytes, rowOf(bytes, page - 1));
    bytes = bytes.substr(0, begin) + stored;
    bytes = with(bytes, rowOf(bytes, page), PageRow{bytes.size(), checksumOf(stored)});
    return sealedHead(with(bytes, kFileBytes, std::uint64_t{bytes.size()}));
  }
};

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

TEST_F(PagedFile, NoticesEveryFlippedBitAndEveryLength) {
  std::string bytes = two();
  ASSERT_EQ(errorOf(bytes), "no error");
  for (std::size_t place = 0; place < bytes.size(); ++place)
    for (int bit = 0; bit < 8; ++bit) {
      bytes[place] ^= static_cast<char>(1 << bit);
      ASSERT_NE(errorOf(bytes), "no error") << "byte " << place << ", bit " << bit;
      bytes[place] ^= static_cast<char>(1 << bit);
    }
  for (std::size_t length = kTable; length < bytes.size(); ++length) {
    const std::string cut = bytes.substr(0, length);
    ASSERT_NE(errorOf(sealedHead(with(cut, kFileBytes, std::uint64_t{length}))), "no error") << length;
  }
  EXPECT_THAT(errorOf(bytes + '\0'), HasSubstr("surplus"));
  EXPECT_THAT(errorOf(sealedHead(with(bytes + '\0', kFileBytes, std::uint64_t{bytes.size() + 1}))),
              HasSubstr("surplus"));
}

TEST_F(PagedFile, OfAHostileTableIsRefused) {
  const std::string whole = two();
  const auto errorWith = [&](std::size_t place, auto value) {
    return errorOf(sealedHead(with(whole, place, value)), true);
  };
  for (const std::uint32_t bytes : {0u, 1u, 2048u, 4095u, 4096u + 2048, 1u << 21, ~0u})
    EXPECT_THAT(errorWith(kTable + kRow + kPageBytes, bytes), HasSubstr("no possible size")) << bytes;
  EXPECT_EQ(errorWith(kTable + kRow + kPageBytes, 4096u), "no error");
  const auto all = ~std::uint64_t{0};
  for (const std::uint64_t elements : {all, all - kPage, all / 2, std::uint64_t{1} << 40})
    EXPECT_THAT(errorWith(kTable + kRow + kElements, elements),
                HasSubstr("more pages than its head tells of"));
  EXPECT_THAT(errorWith(kTable + kElements, all), HasSubstr("that no file can hold"));
  EXPECT_THAT(errorWith(kTable + kElements, std::uint64_t{0}), HasSubstr("has no words"));
  EXPECT_THAT(errorWith(kTable + kRow + kElementBytes, 257u), HasSubstr("no possible size"));
  for (const std::uint64_t offset : {std::uint64_t{0}, std::uint64_t{4096}, std::uint64_t{4113}, all})
    EXPECT_THAT(errorWith(kTable + kRow + kOffset, offset),
                HasSubstr("'zeros' that does not lie where it must"));
  for (const std::uint64_t head : {std::uint64_t{0}, std::uint64_t{8192}, std::uint64_t{4095}, all - 4095})
    EXPECT_THAT(errorWith(kHeadBytes, head), HasSubstr("contradicts itself")) << head;
}

TEST_F(PagedFile, WhosePagesDoNotLieWhereTheyMustIsRefused) {
  const std::string whole = two();
  const auto errorWith = [&](std::size_t page, std::uint64_t end) {
    return errorOf(sealedHead(with(whole, rowOf(whole, page), end)), true);
  };
  for (const std::uint64_t end :
       {std::uint64_t{0}, std::uint64_t{4096}, std::uint64_t{4113}, ~std::uint64_t{0}})
    EXPECT_THAT(errorWith(0, end), HasSubstr("page 0 of stream 'words' that does not lie where it must"))
        << end;
  for (const std::uint64_t end : {std::uint64_t{0}, std::uint64_t{4112}, std::uint64_t{whole.size() + 1}})
    EXPECT_THAT(errorWith(1, end), HasSubstr("page 0 of stream 'zeros' that does not lie where it must"))
        << end;
  EXPECT_THAT(errorWith(1, whole.size() - 1), HasSubstr("surplus"));
}

std::string frameOf(const std::string &bytes, bool tellsSize = true) {
  ZSTD_CCtx *context = ZSTD_createCCtx();
  ZSTD_CCtx_setParameter(context, ZSTD_c_contentSizeFlag, tellsSize);
  std::string frame(ZSTD_compressBound(bytes.size()), '\0');
  frame.resize(ZSTD_compress2(context, frame.data(), frame.size(), bytes.data(), bytes.size()));
  ZSTD_freeCCtx(context);
  return frame;
}

/// Frames that are whole, but not one of the page's bytes.
TEST_F(PagedFile, OfHostileFramesIsRefused) {
  const std::string whole = two();
  const auto errorWith = [&](const std::string &stored) { return errorOf(withLastPage(whole, 1, stored)); };
  const std::string zeros(64, '\0');
  const std::string frame = frameOf(zeros);
  EXPECT_EQ(errorWith(frame), "no error");
  EXPECT_EQ(errorWith(std::string(64, 'x')), "no error"); // As many bytes as the page has are the page.
  const std::string skipped("\x50\x2a\x4d\x18\x01\0\0\0x", 9);
  for (const std::string &stored :
       {std::string("x"), frame.substr(0, frame.size() - 1), frame + '\0', frame + frame, frame + skipped,
        skipped + frame, skipped, frameOf(zeros, false), frameOf(zeros + '\0'), frameOf(zeros.substr(1)),
        frameOf(std::string(1 << 20, '\0')), frameOf("")})
    EXPECT_THAT(errorWith(stored), HasSubstr("page 0 of stream 'zeros' is not what was stored"))
        << stored.size();
  EXPECT_THAT(errorWith(std::string(65, '\0')), HasSubstr("does not lie where it must"));
  EXPECT_THAT(errorWith(""), HasSubstr("does not lie where it must"));
}

/// 2^14 pages of a byte each claim 4 GiB.
TEST_F(PagedFile, TakesNoMemoryForPagesThatAreNot) {
  constexpr std::uint64_t kPages = 1 << 14;
  const std::string whole = compressed(small());
  const std::size_t tables = rowOf(whole, 0);
  const std::uint64_t head = wholePages(tables + kPages * sizeof(PageRow));
  std::string bytes = whole.substr(0, tables);
  const std::uint64_t checksum = checksumOf("x");
  for (std::uint64_t page = 1; page <= kPages; ++page) {
    const PageRow row{head + page, checksum};
    bytes.append(reinterpret_cast<const char *>(&row), sizeof row);
  }
  bytes.resize(head);
  bytes.append(kPages, 'x');
  bytes = with(bytes, kHeadBytes, head);
  bytes = with(bytes, kFileBytes, std::uint64_t{bytes.size()});
  bytes = with(bytes, kTable + kElements, kPages * kPage / 4);
  bytes = sealedHead(with(bytes, kTable + kOffset, head));
  // What is more than three quarters of the bound goes to the scratch file, which is not touched.
  const auto memory = WorkingMemory::create(std::uint64_t{100} << 20);
  const auto loaded =
      readVolumeFile(std::as_bytes(std::span(bytes)), nullptr, "volume.hvx", {.memory = memory});
  ASSERT_FALSE(loaded);
  EXPECT_THAT(loaded.error().message, HasSubstr("page 0 of stream 'words' is not what was stored"));
  EXPECT_EQ(memory->scratchPeak(), 0u);
}

/// Whatever a head says, loading ends in an error or in a volume that can be read.
TEST_F(PagedFile, IsHarmlessWhateverBitOfTheHeadIsFlipped) {
  const std::string whole = two();
  int loaded = 0;
  for (std::size_t place = 0; place < rowOf(whole, 2); ++place)
    for (int bit = 0; bit < 8; ++bit) {
      const auto volume = load(sealedHead(with(whole, place, static_cast<char>(whole[place] ^ 1 << bit))));
      if (!volume)
        continue;
      ++loaded;
      EXPECT_TRUE(decode(*volume, [](const Cube &, std::uint32_t) { return true; }));
      EXPECT_EQ(volume->bytes(), 16u + 64) << "byte " << place << ", bit " << bit;
    }
  EXPECT_GT(loaded, 100); // Names, the transform and the provenance are free.
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
        scene->source->read({c, 0}, &word);
        ASSERT_EQ(volume->lookup(c).value, word) << c.x << "," << c.y << "," << c.z;
      }
}

} // namespace
} // namespace voxc
