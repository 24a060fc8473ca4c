// Paged tracing on any back end: rounds of rays that go on until a page is lacking.
#pragma once

#include "CoarseStandIn.h"
#include "PageCache.h"

#include <memory>

namespace voxc {

/// Some of the rays that a back end holds.
struct RayGroup {
  std::uint64_t first = 0;
  std::uint64_t count = 0;
};

/// What a back end does for paging.
class PagedBackEnd {
public:
  virtual ~PagedBackEnd() = default;
  /// The most rays that it holds at once.
  virtual std::uint64_t mostRays() const = 0;
  /// Brings bytes into a slot, from a byte of it on; nothing is being traced.
  virtual Expected<void> place(std::uint32_t slot, std::uint64_t offset,
                               std::span<const std::byte> bytes) = 0;
  /// Takes rays, and room for their hits; both stay until others are taken.
  virtual Expected<void> take(RaySpan rays, std::span<Hit> hits, const TraceOptions &options,
                              TraceReport &report) = 0;
  /// Traces a group of them from their beginning, or on from where they wait, and marks pages in `table`.
  virtual Expected<TraceTime> trace(RayGroup group, bool goesOn, std::span<std::uint32_t> table,
                                    const TraceOptions &options) = 0;
  /// Brings the hits into the room that was given for them.
  virtual Expected<void> fetch(TraceReport &report) = 0;
  /// Takes hits back from that room, where rays were answered.
  virtual Expected<void> put(TraceReport &report) = 0;
};

/// Reads the coarse blocks of a volume if `options` ask for them, else null. `bounded`: the kernel's rays
/// have bounds. Errors as `createPagedTracer`.
Expected<std::unique_ptr<CoarseStandIn>> readStandIn(const PagedVolume &volume, const PagingOptions &options,
                                                     bool bounded);

/// The tracer that drives a back end, whose slots and table are those of `cache`; `bounded`: its kernel's
/// rays have bounds; `standIn` may be null.
Expected<std::unique_ptr<PagedTracer>> drivePages(std::unique_ptr<PagedBackEnd> backEnd, PageCache cache,
                                                  std::unique_ptr<CoarseStandIn> standIn, bool bounded);

/// Error (`Input`) if a kernel of that storage digest was made for another format than the volume's.
Expected<void> checkPagedFit(std::uint64_t storageDigest, const PagedVolume &volume, std::string_view emit);

} // namespace voxc
