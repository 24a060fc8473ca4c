// Tracing in slices.
#include "view/SlicedTracer.h"

#include "voxc/Support/Stopwatch.h"

#include <algorithm>

namespace voxc::view {
namespace {

/// Rays of the first slice, and of the smallest and the largest.
constexpr std::size_t kFirst = std::size_t{1} << 14, kLeast = std::size_t{1} << 12,
                      kMost = std::size_t{1} << 22;

class SlicedTracer final : public Tracer {
public:
  SlicedTracer(std::unique_ptr<Tracer> tracer, double seconds)
      : tracer_(std::move(tracer)), seconds_(seconds) {}

  Expected<TraceReport> trace(RaySpan rays, std::span<Hit> hits, const TraceOptions &options) override {
    TraceReport all;
    all.repeats.resize(1);
    std::size_t first = 0;
    do {
      if (options.progress.stopped())
        return Error::interrupted();
      const std::size_t count = std::min(slice_, rays.size() - first);
      const Stopwatch watch;
      const auto report =
          VOXC_TRY(tracer_->trace(rays.subspan(first, count), hits.subspan(first, count), options));
      if (count == slice_)
        slice_ = std::clamp(std::size_t(double(count) * seconds_ / std::max(watch.seconds(), 1e-6)), kLeast,
                            kMost);
      add(report, all);
      first += count;
    } while (first < rays.size());
    return all;
  }

  Expected<UpdateReport> follow(const Volume &after, std::span<const WordRange> changed) override {
    return tracer_->follow(after, changed);
  }

private:
  static void add(const TraceReport &report, TraceReport &all) {
    for (const TraceTime &time : report.repeats) {
      all.repeats.front().wall += time.wall;
      all.repeats.front().cpu += time.cpu;
      all.repeats.front().device += time.device;
    }
    all.firstDispatch = std::max(all.firstDispatch, report.firstDispatch);
    all.transfer += report.transfer;
    all.coarse += report.coarse;
  }

  std::unique_ptr<Tracer> tracer_;
  double seconds_;
  std::size_t slice_ = kFirst;
};

} // namespace

std::unique_ptr<Tracer> inSlices(std::unique_ptr<Tracer> tracer, double seconds) {
  return std::make_unique<SlicedTracer>(std::move(tracer), seconds);
}

} // namespace voxc::view
