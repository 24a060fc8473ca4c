// What tests of compressed .hvx files share: where their fields lie, volumes of several pages, and files that
// are put right after a change.
#pragma once

#include "VolumeTesting.h"

#include "Volume/PageTable.h"

#include <algorithm>
#include <cstring>
#include <memory>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace voxc::test {

// Where fields of version 3 lie (docs/hvx.md).
inline constexpr std::size_t kChecksum = 16;
inline constexpr std::size_t kFileBytes = 24;
inline constexpr std::size_t kHeadBytes = 32;
inline constexpr std::size_t kTable = 168;
inline constexpr std::size_t kRow = 56;
inline constexpr std::size_t kElementBytes = 32;
inline constexpr std::size_t kPageBytes = 36;
inline constexpr std::size_t kElements = 40;
inline constexpr std::size_t kOffset = 48;
inline constexpr std::size_t kPage = std::size_t{1} << 18; ///< As voxc writes them.

template <typename T> T at(const std::string &bytes, std::size_t place) {
  T value;
  std::memcpy(&value, bytes.data() + place, sizeof value);
  return value;
}

template <typename T> std::string with(std::string bytes, std::size_t place, T value) {
  std::memcpy(bytes.data() + place, &value, sizeof value);
  return bytes;
}

inline std::uint64_t checksumOf(std::string_view bytes) {
  Checksum checksum;
  checksum.add(bytes.data(), bytes.size());
  return checksum.digest();
}

/// The file with a head whose checksum is right.
inline std::string sealedHead(std::string bytes) {
  const auto head = std::min<std::uint64_t>(at<std::uint64_t>(bytes, kHeadBytes), bytes.size());
  return with(bytes, kChecksum,
              checksumOf(bytes.substr(0, kChecksum) + bytes.substr(kFileBytes, head - kFileBytes)));
}

class PagedFile : public VolumeFile {
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

} // namespace voxc::test
