// A compressed .hvx file, page by page: what is not asked for is neither read nor decoded.
#pragma once

#include "voxc/Support/Error.h"
#include "voxc/Volume/Volume.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace voxc {

/// What a compressed file says of one of its streams.
struct PagedStream {
  std::string name;               ///< As `Stream::name`.
  std::uint32_t elementBytes = 1; ///< 1 to 256. An element may begin in one page and end in the next.
  std::uint32_t pageBytes = 4096; ///< Of every page but the last, decoded: a power of two, 4 KiB to 1 MiB.
  std::uint64_t bytes = 0;        ///< Of all pages, decoded.
  std::uint64_t storedBytes = 0;  ///< Of all pages, in the file.

  std::uint64_t pages() const { return bytes / pageBytes + (bytes % pageBytes != 0); }
  /// Of one page, decoded: `pageBytes`, or what is left for the last. `page`: 0 to pages() - 1.
  std::uint64_t bytesOf(std::uint64_t page) const {
    return std::min<std::uint64_t>(pageBytes, bytes - page * pageBytes);
  }
};

/// A mapped file of version 3 whose head was checked, and whose pages are checked one by one as they are
/// decoded. What the words lead to is not proven here, as `Volume::load` does it. Cheap to move.
class PagedVolume {
public:
  /// Maps a file. Reads its head alone. Errors: as `Volume::load`; a file that is not compressed.
  static Expected<PagedVolume> open(const std::string &path);
  /// The same for a whole file in memory that `owner` keeps; errors call it `name`.
  static Expected<PagedVolume> read(std::span<const std::byte> file, std::shared_ptr<const void> owner,
                                    const std::string &name);
  ~PagedVolume();
  PagedVolume(PagedVolume &&) noexcept;
  PagedVolume &operator=(PagedVolume &&) noexcept;

  /// Makes frame `number`, from 1 on, of a volume of several (`voxc/Volume/Frames.h`) the one that its first
  /// page and `info` report. Errors (`Input`): no such frame; a damaged page.
  Expected<void> chooseFrame(int number);

  const VolumeInfo &info() const;
  /// In the order of the file; the first is `words`.
  std::span<const PagedStream> streams() const;
  /// Of the head, which has the checksums of all pages: files with the same one hold the same bytes.
  std::uint64_t headChecksum() const;
  std::uint64_t headBytes() const;
  std::uint64_t fileBytes() const;

  /// Decodes a page of the stream with this index into `room`, which has `bytesOf(page)` bytes. May be called
  /// by several threads. Errors: `Usage`, no such page or room of another size; `Input`, the page is damaged.
  Expected<void> decode(std::size_t stream, std::uint64_t page, std::span<std::byte> room) const;

private:
  struct State;
  explicit PagedVolume(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

} // namespace voxc
