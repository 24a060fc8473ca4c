// A tracer on this processor: threads that take chunks of the rays as they come.
#include "Trace/Kernel/KernelFit.h"
#include "Trace/Kernel/Nontermination.h"
#include "Trace/Rays/Clock.h"
#include "Trace/Rays/FittingRays.h"
#include "Trace/Rays/OrderedTracer.h"

#include "Support/ParallelFor.h"
#include "Support/Platform/Memory.h"
#include "voxc/Trace/CpuKernel.h"

#include <algorithm>
#include <atomic>

namespace voxc {
namespace {

/// Small enough that threads end together and an interrupt is felt at once; far more work than taking it.
constexpr std::size_t kChunkRays = 2048;

/// One pass over all rays, shared by its threads.
struct Pass {
  const CpuKernel &kernel;
  const std::uint32_t *words;
  RaySpan rays;
  std::span<Hit> hits;
  const TraceOptions &options;
  std::atomic<std::size_t> next = 0; ///< The first ray that no thread has taken.
  std::atomic<std::size_t> done = 0;

  /// Traces one chunk; false if none is left or the caller wants to stop.
  bool step() {
    const std::size_t first = next.fetch_add(kChunkRays, std::memory_order_relaxed);
    if (first >= rays.size() || options.progress.stopped())
      return false;
    const std::size_t count = std::min(kChunkRays, rays.size() - first);
    kernel.function(words, rays.origin(first), reinterpret_cast<std::uint32_t *>(&hits[first]), count,
                    options.countSteps, options.spread);
    done.fetch_add(count, std::memory_order_relaxed);
    return true;
  }
};

class CpuTracer final : public Tracer {
public:
  CpuTracer(CpuKernel kernel, const Volume &volume, unsigned threads)
      : kernel_(std::move(kernel)), words_(volume.words()), threads_(threads) {}

  Expected<TraceReport> trace(RaySpan rays, std::span<Hit> hits, const TraceOptions &options) override;
  Expected<UpdateReport> update(const Volume &before, const Volume &after) override;
  Expected<UpdateReport> follow(const Volume &after, std::span<const WordRange> changed) override;

private:
  /// Traces the rays once. `before` rays of `total` were traced by earlier repeats.
  Expected<TraceTime> run(Pass &pass, double before, double total) const;

  CpuKernel kernel_;
  std::span<const std::uint32_t> words_;
  unsigned threads_;
  FittingRays fitting_;
};

Expected<TraceReport> CpuTracer::trace(RaySpan given, std::span<Hit> hits, const TraceOptions &options) {
  const RaySpan rays = VOXC_TRY(fitting_.fit(given, kernel_.bounded));
  if (rays.size() != hits.size())
    return Error::usage("there are " + std::to_string(rays.size()) + " rays, but room for " +
                        std::to_string(hits.size()) + " hits");
  if (options.countWords != kernel_.countsWords)
    return Error::usage(kernel_.countsWords
                            ? "the kernel counts words, but it is not asked to"
                            : "the kernel cannot count words; one that can is compiled for it");
  TraceReport report;
  const auto count = static_cast<double>(rays.size());
  const unsigned repeats = std::max(options.repeat, 1u);
  for (unsigned repeat = 0; repeat < repeats; ++repeat) {
    Pass pass{kernel_, words_.data(), rays, hits, options};
    auto time = VOXC_TRY(run(pass, repeat * count, repeats * count));
    report.repeats.push_back(time);
  }
  VOXC_TRY(checkEnded(hits));
  return report;
}

Expected<UpdateReport> CpuTracer::update(const Volume &before, const Volume &after) {
  VOXC_TRY(checkFit(kernel_.storageDigest, after, "cpu"));
  if (before.words().data() != words_.data() || before.words().size() != words_.size())
    return notTraced();
  words_ = after.words();
  return UpdateReport{};
}

Expected<UpdateReport> CpuTracer::follow(const Volume &after, std::span<const WordRange> /*changed*/) {
  VOXC_TRY(checkFit(kernel_.storageDigest, after, "cpu"));
  words_ = after.words();
  return UpdateReport{};
}

Expected<TraceTime> CpuTracer::run(Pass &pass, double before, double total) const {
  const double wall = wallSeconds();
  const double cpu = processCpuSeconds();
  const std::size_t chunks = (pass.rays.size() + kChunkRays - 1) / kChunkRays;
  {
    const auto others =
        startHelpers(std::min<std::size_t>(threads_, std::max<std::size_t>(chunks, 1)) - 1, [&pass] {
          while (pass.step())
            ;
        });
    // This thread works too, and tells of the progress of all.
    const Progress &progress = pass.options.progress;
    while (pass.step()) {
      const double traced = before + static_cast<double>(pass.done.load(std::memory_order_relaxed));
      progress.at("trace", traced / total, static_cast<std::uint64_t>(traced));
    }
  }
  if (pass.done != pass.rays.size())
    return Error::interrupted();
  const double traced = before + static_cast<double>(pass.done);
  pass.options.progress.at("trace", total > 0 ? traced / total : 1, static_cast<std::uint64_t>(traced));
  return TraceTime{.wall = wallSeconds() - wall, .cpu = processCpuSeconds() - cpu};
}

} // namespace

Expected<std::unique_ptr<Tracer>> createCpuTracer(const CpuKernel &kernel, const Volume &volume,
                                                  unsigned threads) {
  VOXC_TRY(checkFit(kernel.storageDigest, volume, "cpu"));
  if (kernel.isPaged)
    return Error::usage("this kernel is for volumes in pages: createPagedCpuTracer takes it");
  threads = threadsOrAll(threads);
  return inOrder(std::make_unique<CpuTracer>(kernel, volume, threads), volume, threads, true);
}

DeviceInfo cpuDeviceInfo() {
  DeviceInfo info;
  info.name = "cpu";
  info.driver = "voxc, " + std::to_string(std::max(std::thread::hardware_concurrency(), 1u)) + " threads";
  info.kind = "cpu";
  info.memoryBytes = platform::physicalMemory();
  info.maxStorageBufferBytes = info.maxAllocationBytes = info.memoryBytes;
  info.usable = info.deviceAddresses = true;
  return info;
}

} // namespace voxc
