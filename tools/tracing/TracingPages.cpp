// Tracing volumes of which only some pages are on the device.
#include "tracing/TraceSession.h"

#include "voxc/Kernel/Compile.h"
#include "voxc/Kernel/CompileCpu.h"
#include "voxc/Support/Stopwatch.h"

#include <algorithm>

namespace voxc::tool {

Expected<void> TraceSession::preparePages(const PagedVolume &volume, const Format &format,
                                          PagingOptions options, Json &figures) {
  options.threads = threads_;
  if (Expected<void> suits = checkPaging(format); !suits)
    return suits;
  auto tracer = device_ ? makePagedVulkanTracer(volume, format, options, figures)
                        : makePagedCpuTracer(volume, format, options, figures);
  if (!tracer)
    return tracer.error();
  paged_ = tracer->get();
  tracer_ = std::move(*tracer);
  return {};
}

Expected<std::unique_ptr<PagedTracer>> TraceSession::makePagedCpuTracer(const PagedVolume &volume,
                                                                        const Format &format,
                                                                        const PagingOptions &options,
                                                                        Json &figures) {
  const Stopwatch watch;
  const Expected<CpuKernel> kernel =
      compileCpuKernel(format, {.cache = cache_, .addressing = Addressing::Paged, .start = start_});
  if (!kernel)
    return kernel.error();
  figures["kernel_seconds"] = watch.seconds();
  return createPagedCpuTracer(*kernel, volume, options);
}

Expected<std::unique_ptr<PagedTracer>> TraceSession::makePagedVulkanTracer(const PagedVolume &volume,
                                                                           const Format &format,
                                                                           const PagingOptions &options,
                                                                           Json &figures) {
  const Stopwatch watch;
  const Expected<Kernel> kernel = compileKernel(format, {.addressing = Addressing::Paged,
                                                         .loops = device_->info().loops,
                                                         .arithmetic = arithmetic(),
                                                         .optimise = optimise_,
                                                         .cache = cache_});
  if (!kernel)
    return kernel.error();
  figures["kernel_seconds"] = watch.seconds();
  figures["addressing"] = toString(Addressing::Paged);
  return createPagedTracer(*device_, *kernel, volume, options);
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
