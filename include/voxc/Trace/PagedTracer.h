// Tracing through a volume that is larger than the memory it may take: its pages come when rays ask for them.
#pragma once

#include "voxc/Trace/CpuKernel.h"
#include "voxc/Trace/Tracer.h"
#include "voxc/Volume/PageShelf.h"
#include "voxc/Volume/PagedVolume.h"

#include <cstdint>
#include <memory>

namespace voxc {

struct PagingOptions {
  std::uint64_t memoryBytes = 0; ///< For pages and their table; rays and hits take more.
  unsigned threads = 0;          ///< That decode pages, and trace on the cpu; 0: all of the machine.
  /// Reads the volume's coarse blocks (voxc/Volume/CoarseBlocks.h), which this processor keeps beside that
  /// memory, so that `TraceOptions::coarse` can let them answer rays. Kernels must report the voxel, t and
  /// colour of the closest hits, and no more.
  bool coarse = false;
  /// Where pages are looked for before they are read, and where those go that were read; null: nowhere. So
  /// what one tracer has read another has at hand. Its memory is not of the above.
  std::shared_ptr<PageShelf> takesFrom = {}, putsOn = {};
  /// Words that edits may add to the volume while the tracer follows them (`Tracer::follow`); they take an
  /// entry of the table for each page.
  std::uint64_t moreWords = 0;
};

/// What paging has done since the tracer was made.
struct PagingReport {
  std::uint64_t pages = 0;       ///< Of the volume.
  std::uint64_t pageBytes = 0;   ///< Of one of them, decoded.
  std::uint64_t slots = 0;       ///< Pages that can be resident at once.
  std::uint64_t resident = 0;    ///< Pages that are.
  std::uint64_t memoryBytes = 0; ///< Of the slots and the table: at most the budget.
  std::uint64_t reads = 0;       ///< Pages that came: those that a round asked for and did not find.
  std::uint64_t ahead = 0;       ///< Of these, pages that lay on the shelf, and were not read from the file.
  std::uint64_t found = 0;       ///< Pages that a round used and found, summed over rounds.
  std::uint64_t used = 0;        ///< Different pages that rays have asked for or used.
  std::uint64_t usedBytes = 0; ///< Of slots for all of these at once, with the table: none would come twice.
  std::uint64_t rounds = 0;    ///< How often rays were sent on.
  double decodeSeconds = 0;    ///< Wall time of reading, decoding and placing pages.
  int coarseSide = 0;          ///< Of a coarse block, in voxels; 0: none were read.
  std::uint64_t coarseBlocks = 0;
  std::uint64_t coarseBytes = 0; ///< That they take on this processor.
};

/// A tracer whose hits are those of a resident one, bit by bit, however few pages are there at a time.
/// Lookups and words that it counts are more: a ray that has waited looks again. `trace` adds these errors: a
/// page is not what was stored, named (`Input`); a ray needs more pages at once than there is room for
/// (`Usage`). `follow` takes the words of later pages from the edited volume, and brings what changed into
/// pages that are there; it adds these errors: more words than `PagingOptions::moreWords` leave room for, or
/// coarse blocks, which are of the volume as stored (`Usage`).
class PagedTracer : public Tracer {
public:
  virtual PagingReport paging() const = 0;
};

/// The least budget that lets any ray go on, in bytes; `moreWords` as in `PagingOptions`.
std::uint64_t leastPagingBytes(const PagedVolume &volume, std::uint64_t moreWords = 0);

/// Prepares `kernel`, of `Addressing::Paged`, on `device`; `volume` must outlive the tracer. Errors: the
/// kernel was made for other storage or addressing (`Input`), the budget is less than `leastPagingBytes`
/// (`Usage`), the device lacks a feature or memory (`Environment`); of coarse blocks, as `readCoarseBlocks`,
/// or the kernel's rays have bounds (`Usage`).
Expected<std::unique_ptr<PagedTracer>> createPagedTracer(Device &device, const Kernel &kernel,
                                                         const PagedVolume &volume,
                                                         const PagingOptions &options);

/// The same on this processor, with a kernel that `isPaged`.
Expected<std::unique_ptr<PagedTracer>>
createPagedCpuTracer(const CpuKernel &kernel, const PagedVolume &volume, const PagingOptions &options);

} // namespace voxc
