// Paged tracing on this processor.
#include "PagedRounds.h"
#include "Trace/Rays/Clock.h"

#include "Support/ParallelFor.h"

#include <algorithm>
#include <limits>

namespace voxc {
namespace {

/// As many as a kernel takes at once, so that an interrupt is felt.
constexpr std::uint64_t kChunkRays = 2048;

class CpuPaging final : public PagedBackEnd {
public:
  CpuPaging(CpuKernel kernel, const PageCache &cache, unsigned threads)
      : kernel_(std::move(kernel)), threads_(threadsOrAll(threads)),
        slotWords_(std::size_t{1} << cache.log2PageWords()), slots_(cache.slots() * slotWords_) {
    pages_.slots = slots_.data();
    pages_.log2PageWords = cache.log2PageWords();
    pages_.pages = cache.pages();
  }

  std::uint64_t mostRays() const override { return std::numeric_limits<std::uint64_t>::max(); }

  Expected<void> place(std::uint32_t slot, std::uint64_t offset, std::span<const std::byte> bytes) override {
    const auto slots = std::as_writable_bytes(std::span(slots_));
    std::ranges::copy(bytes, slots.subspan(slot * slotWords_ * sizeof(std::uint32_t) + offset).begin());
    return {};
  }

  Expected<void> take(RaySpan rays, std::span<Hit> hits, const TraceOptions &options,
                      TraceReport &) override {
    if (options.countWords != kernel_.countsWords)
      return Error::usage(kernel_.countsWords
                              ? "the kernel counts words, but it is not asked to"
                              : "the kernel cannot count words; one that can is compiled for it");
    rays_ = rays;
    hits_ = hits;
    return {};
  }

  Expected<TraceTime> trace(RayGroup group, bool goesOn, std::span<std::uint32_t> table,
                            const TraceOptions &options) override {
    pages_.table = table.data();
    pages_.goesOn = goesOn;
    const auto *words = reinterpret_cast<const std::uint32_t *>(&pages_);
    const std::uint64_t chunks = (group.count + kChunkRays - 1) / kChunkRays;
    const auto traced = parallelTry(chunks, threads_, [&](std::uint64_t chunk) -> Expected<void> {
      if (options.progress.stopped())
        return Error::interrupted();
      const std::uint64_t first = group.first + chunk * kChunkRays;
      const std::uint64_t count = std::min(kChunkRays, group.first + group.count - first);
      kernel_.function(words, rays_.origin(first), reinterpret_cast<std::uint32_t *>(&hits_[first]), count,
                       options.countSteps, options.spread);
      return {};
    });
    return traced ? Expected<TraceTime>(TraceTime{}) : traced.error();
  }

  // Hits lie where they are asked for.
  Expected<void> fetch(TraceReport &) override { return {}; }
  Expected<void> put(TraceReport &) override { return {}; }

private:
  CpuKernel kernel_;
  unsigned threads_;
  std::size_t slotWords_;
  std::vector<std::uint32_t> slots_;
  CpuPages pages_;
  RaySpan rays_;
  std::span<Hit> hits_;
};

} // namespace

Expected<std::unique_ptr<PagedTracer>>
createPagedCpuTracer(const CpuKernel &kernel, const PagedVolume &volume, const PagingOptions &options) {
  if (!kernel.isPaged)
    return Error::input(
        "this kernel is for volumes that are loaded as a whole: compile one with addressing=paged");
  VOXC_TRY(checkPagedFit(kernel.storageDigest, volume, "cpu"));
  auto cache = VOXC_TRY(PageCache::create(volume, options, std::numeric_limits<std::uint64_t>::max()));
  auto standIn = VOXC_TRY(readStandIn(volume, options, kernel.bounded));
  auto backEnd = std::make_unique<CpuPaging>(kernel, cache, options.threads);
  return drivePages(std::move(backEnd), std::move(cache), std::move(standIn), kernel.bounded);
}

} // namespace voxc
