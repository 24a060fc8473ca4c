// Compressed files whose tables and pages are not what they should be.
#include "PagedTesting.h"

#include "voxc/Support/WorkingMemory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zstd.h>

namespace voxc {
namespace {

using namespace test;
using ::testing::HasSubstr;

using HostilePages = PagedFile;

TEST_F(HostilePages, NoticesEveryFlippedBitAndEveryLength) {
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

TEST_F(HostilePages, OfAHostileTableIsRefused) {
  const std::string whole = two();
  const auto errorWith = [&](std::size_t place, auto value) {
    return errorOf(sealedHead(with(whole, place, value)), true);
  };
  for (const std::uint32_t bytes : {0u, 1u, 2048u, 4095u, 4096u + 2048, 1u << 21, ~0u})
    EXPECT_THAT(errorWith(kTable + kRow + kPageBytes, bytes), HasSubstr("no possible size")) << bytes;
  EXPECT_EQ(errorWith(kTable + kRow + kPageBytes, 4096u), "no error");
  const auto all = ~std::uint64_t{0};
  for (const std::uint64_t elements : {all, all - kPage, all / 2, std::uint64_t{1} << 40})
    EXPECT_THAT(errorWith(kTable + kRow + kElements, elements), HasSubstr("more pages than its head lists"));
  EXPECT_THAT(errorWith(kTable + kElements, all), HasSubstr("that no file can hold"));
  EXPECT_THAT(errorWith(kTable + kElements, std::uint64_t{0}), HasSubstr("has no words"));
  EXPECT_THAT(errorWith(kTable + kRow + kElementBytes, 257u), HasSubstr("no possible size"));
  for (const std::uint64_t offset : {std::uint64_t{0}, std::uint64_t{4096}, std::uint64_t{4113}, all})
    EXPECT_THAT(errorWith(kTable + kRow + kOffset, offset),
                HasSubstr("'zeros' that does not lie where it must"));
  for (const std::uint64_t head : {std::uint64_t{0}, std::uint64_t{8192}, std::uint64_t{4095}, all - 4095})
    EXPECT_THAT(errorWith(kHeadBytes, head), HasSubstr("contradicts itself")) << head;
}

TEST_F(HostilePages, WhosePagesDoNotLieWhereTheyMustIsRefused) {
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
TEST_F(HostilePages, OfHostileFramesIsRefused) {
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
TEST_F(HostilePages, TakesNoMemoryForPagesThatAreNot) {
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

/// Pages of zeros take next to nothing: 2^26 elements of a volume of one voxel lie in a few kilobytes.
TEST_F(HostilePages, TakesNoMemoryForElementsWithoutVoxels) {
  const Volume words = small();
  const std::vector<std::byte> zeros(std::size_t{1} << 26);
  const auto with = [&](std::size_t bytes, std::uint64_t voxels) {
    VolumeInfo info = smallInfo();
    info.voxels = voxels;
    const Stream stream{"zeros", 1, std::span(zeros).first(bytes)};
    return compressed(Volume(info, {words.streams()[0], stream}, nullptr));
  };
  EXPECT_THAT(errorOf(with(zeros.size(), 1)), HasSubstr("has a stream 'zeros' of 67108864 bytes"));
  EXPECT_EQ(errorOf(with(std::size_t{1} << 20, 1)), "no error");
  // A head that claims the voxels is not believed before they are counted, let alone the page that is
  // damaged.
  std::string claims = with(zeros.size(), zeros.size());
  claims.back() ^= 1;
  EXPECT_THAT(errorOf(claims), HasSubstr("holds 1 voxels, but its header says 67108864"));
}

/// The same of a volume that has the voxels is an attribute as any other.
TEST_F(HostilePages, TakesZerosOfEachVoxel) {
  constexpr std::size_t kVoxels = std::size_t{1} << 21;
  VolumeInfo info = smallInfo();
  info.format = *parseFormat("R(7,7,7)");
  info.voxels = kVoxels;
  const std::vector<std::uint32_t> words(1 + kVoxels, 1);
  const std::vector<std::byte> zeros(kVoxels);
  const std::string bytes = compressed(Volume(info, {wordStream(words), {"zeros", 1, zeros}}, nullptr));
  const auto loaded = load(bytes);
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_TRUE(std::ranges::equal(loaded->streams()[1].bytes, zeros));
  EXPECT_LT(loaded->streams()[1].storedBytes, kVoxels / 1024);
}

/// Whatever a head says, loading ends in an error or in a volume that can be read.
TEST_F(HostilePages, IsHarmlessWhateverBitOfTheHeadIsFlipped) {
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

} // namespace
} // namespace voxc
