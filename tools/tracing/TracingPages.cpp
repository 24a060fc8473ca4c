// Tracing volumes of which only some pages are on the device.
#include "tracing/TraceSession.h"

#include <algorithm>

namespace voxc::tool {

Expected<void> TraceSession::preparePages(const PagedVolume &volume, const Format &format,
                                          PagingOptions options, Json &figures) {
  options.threads = threads_;
  auto opened = VOXC_TRY(openTracerOn(volume, format, choice(), options));
  addSetupFigures(figures, opened);
  paged_ = opened.tracer.get();
  tracer_ = std::move(opened.tracer);
  return {};
}

std::optional<PagingReport> TraceSession::paging() const {
  return paged_ ? std::optional(paged_->paging()) : std::nullopt;
}

void TraceSession::addPagingFigures(Json &figures) const {
  if (!paged_)
    return;
  const PagingReport paging = paged_->paging();
  figures["pages"] = paging.pages;
  figures["page_bytes"] = paging.pageBytes;
  figures["page_slots"] = paging.slots;
  figures["paging_bytes"] = paging.memoryBytes;
  figures["resident_bytes"] = paging.resident * paging.pageBytes;
  figures["pages_read"] = paging.reads;
  figures["page_hits"] = paging.found;
  figures["page_hit_rate"] =
      double(paging.found) / double(std::max<std::uint64_t>(paging.found + paging.reads, 1));
  figures["pages_used"] = paging.used;
  figures["enough_bytes"] = paging.usedBytes;
  figures["rounds"] = paging.rounds;
  figures["page_seconds"] = paging.decodeSeconds;
  if (paging.coarseSide == 0)
    return;
  figures["coarse_side"] = paging.coarseSide;
  figures["coarse_blocks"] = paging.coarseBlocks;
  figures["coarse_bytes"] = paging.coarseBytes;
}

} // namespace voxc::tool
