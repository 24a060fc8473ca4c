// Which pages of a volume are resident, and in which slots: the table that kernels look at.
#pragma once

#include "voxc/Trace/PagedTracer.h"

#include <functional>
#include <span>
#include <vector>

namespace voxc {

/// What the marks of a round say.
struct PageRound {
  std::vector<std::uint32_t> asked; ///< Absent pages that rays wait for, in their order.
  std::uint64_t found = 0;          ///< Resident pages that rays used.
};

/// Pages in slots, of which the first has zeros. The page that was used least recently makes room; the first
/// of the volume, where every ray begins, always stays.
class PageCache {
public:
  /// Brings decoded bytes, of a page or less, into a slot, from a byte of it on.
  using Place = std::function<Expected<void>(std::uint32_t slot, std::uint64_t offset,
                                             std::span<const std::byte> bytes)>;

  /// `mostBytes`: of all slots, on this device. Errors: `Usage`, a budget that is too small, or such pages.
  static Expected<PageCache> create(const PagedVolume &volume, const PagingOptions &options,
                                    std::uint64_t mostBytes);

  /// An entry for each page and one more, as shaders-runtime/paging.glsl has them.
  std::span<std::uint32_t> table() { return table_; }
  std::uint32_t pages() const { return static_cast<std::uint32_t>(table_.size() - 1); }
  std::uint32_t log2PageWords() const { return log2PageWords_; }
  std::uint64_t slots() const { return pageOfSlot_.size(); }
  std::uint64_t slotBytes() const { return std::uint64_t{4} << log2PageWords_; }

  /// Puts zeros into the first slot, and the first page into the next.
  Expected<void> begin(const Place &place);
  /// Takes the marks out of the table, and notes what was used.
  PageRound takeMarks();
  /// How many pages can come without any going that the last round used.
  std::uint64_t room() const;
  /// Decodes pages, and places as many of them as there are slots for. Errors: a damaged page, or those of
  /// `place`; interrupted, by `progress`, after which those that came are there.
  Expected<void> load(std::span<const std::uint32_t> pages, const Place &place,
                      const Progress &progress = {});

  /// Pages are those of `after` from now on, of which these words are others; those that are resident get
  /// them. Returns how many bytes were placed. Errors: `Usage`, more words than there is room for; those of
  /// `place`.
  Expected<std::uint64_t> follow(const Volume &after, std::span<const WordRange> changed, const Place &place);

  unsigned threads() const { return threads_; }
  const PagingReport &report() const { return report_; }

private:
  PageCache(const PagedVolume &volume, const PagingOptions &options, std::uint64_t slots);
  std::vector<std::uint32_t> slotsFor(std::uint64_t count) const;
  Expected<void> decode(std::span<const std::uint32_t> pages);
  Expected<bool> fetch(std::uint32_t page, std::span<std::byte> room) const;
  std::span<const std::byte> pageOf(const Volume &volume, std::uint32_t page) const;
  void makeResident(std::uint32_t page, std::uint32_t slot);
  void noteUse(std::uint32_t page);

  const PagedVolume *volume_;
  const Volume *edited_ = nullptr;                ///< In its place, once there were edits.
  std::shared_ptr<PageShelf> takesFrom_, putsOn_; ///< Or null.
  unsigned threads_;
  std::uint32_t log2PageWords_;
  std::vector<std::uint32_t> table_;
  std::vector<std::uint32_t> pageOfSlot_; ///< Or that there is none.
  std::vector<std::uint64_t> lastUse_;    ///< Of each slot, the round; 0: never.
  std::vector<bool> wasUsed_;             ///< Of each page of the volume.
  std::vector<std::byte> decoded_;        ///< Some pages, on their way.
  std::uint64_t round_ = 1;
  PagingReport report_;
};

} // namespace voxc
