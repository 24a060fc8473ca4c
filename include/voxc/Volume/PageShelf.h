// Decoded pages that one reader puts down and another takes: what is there needs not be read from the file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <span>
#include <unordered_map>
#include <vector>

namespace voxc {

/// A decoded page, whole for as long as it is held.
using PageBytes = std::shared_ptr<const std::vector<std::byte>>;

/// At most so many bytes of pages; where there is no room, the page goes that was put or taken longest ago.
/// All functions may be called by several threads. None waits for more than a look into a table: bytes are
/// copied outside of the lock.
class PageShelf {
public:
  explicit PageShelf(std::uint64_t mostBytes) : mostBytes_(mostBytes) {}

  /// Keeps a copy of a page. One that is there already, or that is larger than the shelf, is left.
  void put(std::uint32_t page, std::span<const std::byte> bytes);
  /// The same for one that others hold already: nothing is copied.
  void put(std::uint32_t page, PageBytes bytes);
  /// A page that is there, or null.
  PageBytes find(std::uint32_t page);
  /// Copies a page into `room`, if it is there and has as many bytes; else false.
  bool take(std::uint32_t page, std::span<std::byte> room);

  std::uint64_t mostBytes() const { return mostBytes_; }
  /// Of all pages that are there.
  std::uint64_t bytes() const;

private:
  struct Row {
    std::uint32_t page;
    PageBytes bytes;
  };
  using Rows = std::list<Row>;

  bool has(std::uint32_t page) const;
  Rows makeRoom();

  const std::uint64_t mostBytes_;
  mutable std::mutex mutex_;
  Rows rows_; ///< That was put or taken last stands first.
  std::unordered_map<std::uint32_t, Rows::iterator> places_;
  std::uint64_t bytes_ = 0;
};

} // namespace voxc
