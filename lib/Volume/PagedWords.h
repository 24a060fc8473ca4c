// The words of a page file, read where they are asked for.
#pragma once

#include "voxc/Layout/WordReader.h"
#include "voxc/Volume/PageShelf.h"
#include "voxc/Volume/PagedVolume.h"

#include <array>
#include <optional>

namespace voxc {

/// Pages come from a shelf, or else from the file, and then lie on the shelf. It holds some of them itself,
/// so that most reads ask nobody. For one thread; many of them may share a shelf.
class PagedWords final : public WordSource {
public:
  /// `volume` must outlive it.
  PagedWords(const PagedVolume &volume, std::shared_ptr<PageShelf> shelf);

  std::uint64_t size() const override { return stream_->bytes / sizeof(std::uint32_t); }
  /// 0 where a page cannot be read, of which `problem` tells.
  std::uint32_t at(std::uint64_t offset) const override;

  /// What was wrong with the first page that could not be read.
  const std::optional<Error> &problem() const { return problem_; }
  /// Pages that came from the file.
  std::uint64_t pagesRead() const { return pagesRead_; }

private:
  struct Held {
    std::uint64_t page = ~std::uint64_t{0};
    PageBytes bytes; ///< Null if it could not be read.
  };

  PageBytes fetch(std::uint64_t page) const;

  /// The way down to a voxel and some beside it: more, and it would forget less but hold what nobody needs.
  static constexpr std::size_t kHeldPages = 32;

  const PagedVolume *volume_;
  const PagedStream *stream_;
  std::shared_ptr<PageShelf> shelf_;
  int log2PageWords_;
  // A reader of words does not change them.
  mutable std::array<Held, kHeldPages> held_; ///< Page n at n modulo their number.
  mutable std::optional<Error> problem_;
  mutable std::uint64_t pagesRead_ = 0;
};

} // namespace voxc
