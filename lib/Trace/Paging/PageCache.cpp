// Which pages of a volume are resident.
#include "PageCache.h"

#include "Trace/Rays/Clock.h"
#include "Trace/Vulkan/VulkanError.h"

#include "Support/ParallelFor.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <limits>

namespace voxc {
namespace {

// As in shaders-runtime/paging.glsl.
constexpr std::uint32_t kTouched = 0x80000000u;
constexpr std::uint32_t kAbsent = 0x40000000u;
constexpr std::uint32_t kSlotBits = 0x3fffffffu;

constexpr std::uint32_t kNoPage = ~0u;
constexpr std::uint32_t kZeros = 0; ///< The slots that no other page gets.
constexpr std::uint32_t kFirstPage = 1;
constexpr std::uint64_t kKeptSlots = 2;
constexpr std::uint64_t kForEver = std::numeric_limits<std::uint64_t>::max();

/// Pages that are decoded side by side before they are placed.
constexpr std::size_t kRunPages = 64;

// What one way down from the root looks at. A node of a tree is smaller than a page, and may lie in two. Of a
// grid there are words of its head, of its mask with a count, of its values and of the counts behind them.
constexpr std::uint64_t kPagesOfNode = 2;
constexpr std::uint64_t kPagesOfGrid = 8;
// A section's head, an entry, a block in up to two pages, and a colour, each at the end of a page.
constexpr std::uint64_t kPagesOfValue = 8;

/// How many pages any ray needs at once, with those that always stay.
std::uint64_t pagesAtOnce(const Layout &layout) {
  std::uint64_t pages = kKeptSlots + kPagesOfValue;
  for (const Stratum &stratum : layout.strata)
    pages += stratum.isGrid() ? kPagesOfGrid
                              : kPagesOfNode * static_cast<std::uint64_t>(std::max(stratum.depth, 1));
  return pages;
}

/// Of the volume, and of what edits may add.
std::uint64_t pagesOf(const PagedStream &words, std::uint64_t moreWords) {
  const std::uint64_t bytes = words.bytes + sizeof(std::uint32_t) * moreWords;
  return bytes / words.pageBytes + (bytes % words.pageBytes != 0);
}

std::uint64_t tableBytes(std::uint64_t pages) { return sizeof(std::uint32_t) * (pages + 1); }

} // namespace

std::uint64_t leastPagingBytes(const PagedVolume &volume, std::uint64_t moreWords) {
  const PagedStream &words = volume.streams().front();
  const std::uint64_t pages = pagesOf(words, moreWords),
                      most = pages + 1; // All of a small volume, and zeros.
  return tableBytes(pages) + std::min(most, pagesAtOnce(layoutOf(volume.info().format))) * words.pageBytes;
}

Expected<PageCache> PageCache::create(const PagedVolume &volume, const PagingOptions &options,
                                      std::uint64_t mostBytes) {
  const PagedStream &words = volume.streams().front();
  const std::uint64_t least = leastPagingBytes(volume, options.moreWords);
  const std::uint64_t pages = pagesOf(words, options.moreWords);
  if (options.memoryBytes < least)
    return Error::usage("a budget of " + bytesText(options.memoryBytes) +
                        " is too small for this volume: a ray needs up to " + bytesText(least) +
                        " at once; give more, or store it with smaller pages (--page-bytes)");
  if (pages >= kSlotBits)
    return Error::usage("this volume has " + std::to_string(pages) +
                        " pages, more than a table lists: store it with larger pages (--page-bytes)");
  const std::uint64_t bytes = std::min({options.memoryBytes - tableBytes(pages), mostBytes,
                                        std::uint64_t{4} << 32, (pages + 1) * words.pageBytes});
  PageCache cache(volume, options, bytes / words.pageBytes);
  return cache;
}

PageCache::PageCache(const PagedVolume &volume, const PagingOptions &options, std::uint64_t slots)
    : volume_(&volume), takesFrom_(options.takesFrom), putsOn_(options.putsOn),
      threads_(threadsOrAll(options.threads)) {
  const PagedStream &words = volume.streams().front();
  log2PageWords_ = static_cast<std::uint32_t>(std::countr_zero(words.pageBytes) - 2);
  const std::uint64_t pages = pagesOf(words, options.moreWords);
  table_.assign(pages + 1, kAbsent);
  table_.back() = kTouched; // What lies beyond all pages is zeros, for ever.
  pageOfSlot_.assign(slots, kNoPage);
  lastUse_.assign(slots, 0);
  lastUse_[kZeros] = kForEver;
  report_.pages = words.pages();
  report_.pageBytes = words.pageBytes;
  report_.slots = slots;
  report_.memoryBytes = slots * words.pageBytes + tableBytes(pages);
  wasUsed_.assign(pages, false);
  report_.usedBytes = words.pageBytes + tableBytes(pages); // Zeros have a slot, too.
  noteUse(0);                                              // Where every ray begins.
}

Expected<void> PageCache::begin(const Place &place) {
  const std::vector<std::byte> zeros(slotBytes());
  VOXC_TRY(place(kZeros, 0, zeros));
  const std::uint32_t first = 0;
  VOXC_TRY(load({&first, 1}, place));
  lastUse_[kFirstPage] = kForEver;
  return {};
}

PageRound PageCache::takeMarks() {
  PageRound round;
  ++round_;
  for (std::uint32_t page = 0; page < pages(); ++page) {
    if ((table_[page] & kTouched) == 0)
      continue;
    table_[page] &= ~kTouched;
    noteUse(page);
    if ((table_[page] & kAbsent) != 0) {
      round.asked.push_back(page);
      continue;
    }
    ++round.found;
    std::uint64_t &use = lastUse_[table_[page] & kSlotBits];
    use = std::max(use, round_);
  }
  ++report_.rounds;
  report_.found += round.found;
  return round;
}

void PageCache::noteUse(std::uint32_t page) {
  if (wasUsed_[page])
    return;
  wasUsed_[page] = true;
  ++report_.used;
  report_.usedBytes += slotBytes();
}

std::uint64_t PageCache::room() const {
  return static_cast<std::uint64_t>(
      std::ranges::count_if(lastUse_, [&](std::uint64_t use) { return use < round_; }));
}

/// Those that were used least recently, of equal ones the first.
std::vector<std::uint32_t> PageCache::slotsFor(std::uint64_t count) const {
  std::vector<std::uint32_t> slots;
  for (std::uint32_t slot = 0; slot < lastUse_.size(); ++slot)
    if (lastUse_[slot] != kForEver)
      slots.push_back(slot);
  count = std::min<std::uint64_t>(count, slots.size());
  const auto least = [&](std::uint32_t a, std::uint32_t b) {
    return lastUse_[a] != lastUse_[b] ? lastUse_[a] < lastUse_[b] : a < b;
  };
  std::ranges::partial_sort(slots, slots.begin() + static_cast<std::ptrdiff_t>(count), least);
  slots.resize(count);
  return slots;
}

/// The bytes that a volume has of a page; none of one behind its end.
std::span<const std::byte> PageCache::pageOf(const Volume &volume, std::uint32_t page) const {
  const std::span<const std::byte> bytes = std::as_bytes(volume.words());
  const std::uint64_t first = std::min<std::uint64_t>(page * slotBytes(), bytes.size());
  return bytes.subspan(first, std::min<std::uint64_t>(slotBytes(), bytes.size() - first));
}

/// From the edited volume, the shelf, or else from the file; true if it lay on the shelf.
Expected<bool> PageCache::fetch(std::uint32_t page, std::span<std::byte> slot) const {
  std::ranges::fill(slot, std::byte{});
  if (edited_) {
    std::ranges::copy(pageOf(*edited_, page), slot.begin());
    return false;
  }
  const PagedStream &words = volume_->streams().front();
  if (page >= words.pages()) // Of edits that are not there yet.
    return false;
  const auto room = slot.first(words.bytesOf(page));
  if (takesFrom_ && takesFrom_->take(page, room))
    return true;
  VOXC_TRY(volume_->decode(0, page, room));
  if (putsOn_)
    putsOn_->put(page, room);
  return false;
}

/// Into `decoded_`, one behind the other.
Expected<void> PageCache::decode(std::span<const std::uint32_t> pages) {
  decoded_.resize(kRunPages * slotBytes());
  std::atomic<std::uint64_t> ahead = 0;
  const auto decoded = parallelTry(pages.size(), threads_, [&](std::uint64_t i) -> Expected<void> {
    const auto fetched = VOXC_TRY(fetch(pages[i], {decoded_.data() + i * slotBytes(), slotBytes()}));
    ahead += fetched ? 1 : 0;
    return {};
  });
  report_.ahead += ahead;
  return decoded;
}

void PageCache::makeResident(std::uint32_t page, std::uint32_t slot) {
  if (pageOfSlot_[slot] != kNoPage)
    table_[pageOfSlot_[slot]] = kAbsent;
  else
    ++report_.resident;
  pageOfSlot_[slot] = page;
  lastUse_[slot] = round_;
  table_[page] = slot;
  ++report_.reads;
}

Expected<void> PageCache::load(std::span<const std::uint32_t> pages, const Place &place,
                               const Progress &progress) {
  const double begin = wallSeconds();
  const std::vector<std::uint32_t> slots = slotsFor(pages.size());
  for (std::size_t first = 0; first < slots.size(); first += kRunPages) {
    if (progress.stopped())
      return Error::interrupted();
    const auto run = pages.subspan(first, std::min(kRunPages, slots.size() - first));
    VOXC_TRY(decode(run));
    for (std::size_t i = 0; i < run.size(); ++i) {
      VOXC_TRY(place(slots[first + i], 0, {decoded_.data() + i * slotBytes(), slotBytes()}));
      makeResident(run[i], slots[first + i]);
    }
  }
  report_.decodeSeconds += wallSeconds() - begin;
  return {};
}

Expected<std::uint64_t> PageCache::follow(const Volume &after, std::span<const WordRange> changed,
                                          const Place &place) {
  if (after.words().size_bytes() > pages() * slotBytes())
    return Error::usage("the volume has " + std::to_string(after.words().size()) +
                        " words, and the table has room for " + std::to_string(pages() * slotBytes() / 4) +
                        "; make a new tracer");
  edited_ = &after;
  std::uint64_t placed = 0;
  for (const WordRange &range : changed) {
    const std::uint64_t begin = range.first * 4, end = range.end * 4;
    for (std::uint64_t page = begin / slotBytes(); page * slotBytes() < end; ++page) {
      const std::uint32_t entry = table_[page];
      if ((entry & kAbsent) != 0)
        continue;
      const std::uint64_t pageBegin = page * slotBytes();
      const std::uint64_t from = std::max(begin, pageBegin), to = std::min(end, pageBegin + slotBytes());
      const auto bytes = std::as_bytes(after.words()).subspan(from, to - from);
      VOXC_TRY(place(entry & kSlotBits, from - pageBegin, bytes));
      placed += bytes.size();
    }
  }
  return placed;
}

} // namespace voxc
