// Which voxels are there, of a volume in memory or of a page file.
#pragma once

#include "voxc/Support/Error.h"
#include "voxc/Volume/PageShelf.h"
#include "voxc/Volume/PagedVolume.h"
#include "voxc/Volume/Volume.h"

#include <cstdint>
#include <memory>
#include <optional>

namespace voxc {

class PagedWords;

/// An aligned cube of voxels that all are there, or all are not.
struct ShapeCube {
  bool isFull = false;
  int log2Side = 0;
};

/// Reads shapes alone, of no voxel its value: so of pages no more than say that. For one thread; many of
/// them may read one volume, and share a shelf. The volume must outlive it.
class ShapeReader {
public:
  explicit ShapeReader(const Volume &volume);
  /// Pages come from `shelf`, or from the file and then lie there; beside those it holds 32 at most.
  ShapeReader(const PagedVolume &volume, std::shared_ptr<PageShelf> shelf);
  ~ShapeReader();
  ShapeReader(ShapeReader &&) noexcept;

  /// The largest cube around a voxel that one look covers. What lies outside of the format is empty.
  ShapeCube at(Int3 voxel) const;
  /// The voxels of the aligned cube of 4^3 from `low` on: bit x + 4 y + 16 z says that one is there.
  std::uint64_t brick(Int3 low) const;
  /// Of the input, in voxels.
  Int3 extent() const { return extent_; }

  /// What was wrong with the first page that could not be read; what is asked for from there on is of no use.
  std::optional<Error> problem() const;
  /// Pages that came from the file.
  std::uint64_t pagesRead() const;

private:
  std::unique_ptr<PagedWords> pages_; ///< Null: the words are in memory.
  std::unique_ptr<Layout> ownLayout_; ///< Of pages.
  const Layout *layout_;
  WordReader words_;
  Int3 extent_;
};

} // namespace voxc
