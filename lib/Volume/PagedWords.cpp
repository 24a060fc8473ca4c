// Words from pages.
#include "PagedWords.h"

#include <bit>
#include <cstring>

namespace voxc {

PagedWords::PagedWords(const PagedVolume &volume, std::shared_ptr<PageShelf> shelf)
    : volume_(&volume), stream_(&volume.streams().front()), shelf_(std::move(shelf)),
      log2PageWords_(std::countr_zero(stream_->pageBytes) - 2) {}

std::uint32_t PagedWords::at(std::uint64_t offset) const {
  const std::uint64_t page = offset >> log2PageWords_;
  Held &held = held_[page % kHeldPages];
  if (held.page != page)
    held = {page, fetch(page)};
  if (!held.bytes)
    return 0;
  std::uint32_t word;
  std::memcpy(&word, held.bytes->data() + sizeof word * (offset & ((std::uint64_t{1} << log2PageWords_) - 1)),
              sizeof word);
  return word;
}

PageBytes PagedWords::fetch(std::uint64_t page) const {
  const auto number = static_cast<std::uint32_t>(page);
  if (PageBytes found = shelf_->find(number))
    return found;
  const auto bytes = std::make_shared<std::vector<std::byte>>(stream_->bytesOf(page));
  if (const Expected<void> decoded = volume_->decode(0, page, *bytes); !decoded) {
    if (!problem_)
      problem_ = decoded.error();
    return nullptr;
  }
  ++pagesRead_;
  shelf_->put(number, PageBytes(bytes));
  return bytes;
}

} // namespace voxc
