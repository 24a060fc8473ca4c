// Pages that wait to be taken.
#include "voxc/Volume/PageShelf.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace voxc {

bool PageShelf::has(std::uint32_t page) const {
  const std::lock_guard lock(mutex_);
  return places_.contains(page);
}

/// Those that go. Whoever holds no lock ends them.
PageShelf::Rows PageShelf::makeRoom() {
  Rows gone;
  while (bytes_ > mostBytes_) {
    bytes_ -= rows_.back().bytes->size();
    places_.erase(rows_.back().page);
    gone.splice(gone.end(), rows_, std::prev(rows_.end()));
  }
  return gone;
}

void PageShelf::put(std::uint32_t page, std::span<const std::byte> bytes) {
  if (bytes.size() <= mostBytes_ && !has(page))
    put(page, std::make_shared<const std::vector<std::byte>>(bytes.begin(), bytes.end()));
}

void PageShelf::put(std::uint32_t page, PageBytes bytes) {
  if (bytes->size() > mostBytes_)
    return;
  Rows row;
  row.push_back({page, std::move(bytes)});
  Rows gone; // Outlives the lock.
  const std::lock_guard lock(mutex_);
  if (!places_.try_emplace(page, row.begin()).second)
    return;
  bytes_ += row.front().bytes->size();
  rows_.splice(rows_.begin(), row);
  gone = makeRoom();
}

PageBytes PageShelf::find(std::uint32_t page) {
  const std::lock_guard lock(mutex_);
  const auto place = places_.find(page);
  if (place == places_.end())
    return nullptr;
  rows_.splice(rows_.begin(), rows_, place->second);
  return place->second->bytes;
}

bool PageShelf::take(std::uint32_t page, std::span<std::byte> room) {
  const PageBytes bytes = find(page);
  if (!bytes || bytes->size() != room.size())
    return false;
  std::ranges::copy(*bytes, room.begin());
  return true;
}

std::uint64_t PageShelf::bytes() const {
  const std::lock_guard lock(mutex_);
  return bytes_;
}

} // namespace voxc
