// A tracer before another, that hands it the rays in an order in which they are traced faster.
#include "OrderedTracer.h"

#include "Clock.h"
#include "OrderChoice.h"
#include "RayBins.h"

#include <algorithm>
#include <cstring>

namespace voxc {
namespace {

/// Rays are ordered among so many at most: more would take memory, and are not traced faster.
constexpr std::size_t kMaxSliceRays = std::size_t{1} << 22;

/// Rays and hits lie scattered; by the time one is needed, the memory system has brought it.
constexpr std::size_t kAhead = 16;

int longestEdge(Int3 extent) { return std::max({extent.x, extent.y, extent.z, 1}); }

class OrderedTracer final : public Tracer {
public:
  OrderedTracer(std::unique_ptr<Tracer> tracer, const Volume &volume, unsigned threads, bool pays)
      : tracer_(std::move(tracer)), edge_(longestEdge(volume.info().extent)), team_(threads), pays_(pays) {}

  Expected<TraceReport> trace(RaySpan rays, std::span<Hit> hits, const TraceOptions &options) override;
  Expected<UpdateReport> update(const Volume &before, const Volume &after) override {
    auto report = tracer_->update(before, after);
    if (report)
      edge_ = longestEdge(after.info().extent);
    return report;
  }
  Expected<UpdateReport> follow(const Volume &after, std::span<const WordRange> changed) override {
    auto report = tracer_->follow(after, changed);
    if (report)
      edge_ = longestEdge(after.info().extent);
    return report;
  }

private:
  Expected<double> learn(const RaySpan &rays, std::span<Hit> hits, const TraceOptions &options);
  Expected<TraceReport> traceBins(const RaySpan &rays, std::span<Hit> hits, const TraceOptions &options);
  Expected<TraceReport> traceSlice(const RaySpan &rays, std::span<Hit> hits, const TraceOptions &options);
  RaySpan gatherRays(const RaySpan &rays, std::span<const std::uint32_t> order);
  template <typename AnyRay>
  RaySpan gather(const RaySpan &rays, std::span<const std::uint32_t> order, std::vector<AnyRay> &gathered);
  void scatterHits(std::span<Hit> hits, std::span<const std::uint32_t> order) const;

  std::unique_ptr<Tracer> tracer_;
  int edge_; ///< Voxels on the volume's longest axis.
  ThreadTeam team_;
  bool pays_;
  OrderChoice choice_;
  RayBins bins_;
  std::vector<Ray> rays_; ///< Of a slice, bin by bin; those with bounds in the other. They only grow.
  std::vector<BoundedRay> boundedRays_;
  std::vector<Hit> hits_;
};

/// Seconds since it was made, by both clocks.
class Watch {
public:
  void addTo(TraceTime &time) const {
    time.wall += wallSeconds() - wall_;
    time.cpu += cpuSeconds();
  }
  double cpuSeconds() const { return processCpuSeconds() - cpu_; }

private:
  double wall_ = wallSeconds();
  double cpu_ = processCpuSeconds();
};

void add(TraceReport &all, const TraceReport &part) {
  all.repeats.resize(part.repeats.size());
  for (std::size_t i = 0; i < part.repeats.size(); ++i) {
    all.repeats[i].wall += part.repeats[i].wall;
    all.repeats[i].cpu += part.repeats[i].cpu;
    all.repeats[i].device += part.repeats[i].device;
  }
  all.firstDispatch += part.firstDispatch;
  all.transfer += part.transfer;
}

/// Progress of a part of the rays, told as progress of all: `before` of `total` are done, and the part has
/// `count`.
Progress partOf(const Progress &all, std::size_t before, std::size_t count, std::size_t total,
                unsigned repeats) {
  Progress part = all;
  if (!all.report)
    return part;
  part.report = [&all, before, count, total, repeats](std::string_view stage, double fraction,
                                                      std::uint64_t) {
    const double done = static_cast<double>(before) + fraction * static_cast<double>(count);
    all.at(stage, done / static_cast<double>(total), static_cast<std::uint64_t>(done * repeats));
  };
  return part;
}

Expected<TraceReport> OrderedTracer::trace(RaySpan rays, std::span<Hit> hits, const TraceOptions &options) {
  const bool isOpen = options.order == RayOrder::Auto && pays_ && areScattered(rays, edge_);
  if ((options.order != RayOrder::Binned && !isOpen) || rays.empty() || rays.size() != hits.size())
    return tracer_->trace(rays, hits, options);
  double choosing = 0, firstDispatch = 0;
  if (isOpen && !choice_.isKnown(rays.size())) {
    const double begin = wallSeconds();
    firstDispatch = VOXC_TRY(learn(rays, hits, options));
    choosing = wallSeconds() - begin - firstDispatch;
  }
  const bool bins = !isOpen || choice_.use();
  auto report = bins ? traceBins(rays, hits, options) : tracer_->trace(rays, hits, options);
  if (report) {
    report->binned = bins;
    report->choosing = choosing;
    report->firstDispatch += firstDispatch;
  }
  return report;
}

/// The CPU seconds that a ray takes.
double secondsOfOne(const TraceReport &report, std::size_t rays) {
  return std::ranges::min(report.repeats, {}, &TraceTime::cpu).cpu / static_cast<double>(rays);
}

/// Learns from some of the rays whether bins pay. Their hits are traced once more. Returns the seconds of the
/// tracer's first dispatch, which is then behind it.
Expected<double> OrderedTracer::learn(const RaySpan &rays, std::span<Hit> hits, const TraceOptions &options) {
  TraceOptions some = options;
  some.repeat = 2;
  some.progress.report = {};
  const std::size_t count = OrderChoice::comparedRays(rays.size());
  const RaySpan first = rays.subspan(0, OrderChoice::kFirstRays), compared = rays.subspan(0, count);
  auto given = tracer_->trace(first, hits.first(first.size()), some);
  if (!given)
    return given.error();
  const double firstDispatch = given->firstDispatch;
  Watch watch;
  bins_.order(first, edge_, team_);
  const double ordering = watch.cpuSeconds() / OrderChoice::kFirstRays;
  const bool mayPay = OrderChoice::mayPay(secondsOfOne(*given, first.size()), ordering);
  if (!mayPay || count < OrderChoice::kFirstRays) {
    choice_.learn(mayPay, rays.size());
    return firstDispatch;
  }
  const auto binned = VOXC_TRY(traceSlice(compared, hits.first(count), some));
  given = tracer_->trace(compared, hits.first(count), some);
  if (!given)
    return given.error();
  choice_.learn(OrderChoice::pays(secondsOfOne(*given, count), secondsOfOne(binned, count)), rays.size());
  return firstDispatch;
}

Expected<TraceReport> OrderedTracer::traceBins(const RaySpan &rays, std::span<Hit> hits,
                                               const TraceOptions &options) {
  TraceReport report;
  TraceOptions slice = options;
  for (std::size_t first = 0; first < rays.size(); first += kMaxSliceRays) {
    const std::size_t count = std::min(kMaxSliceRays, rays.size() - first);
    slice.progress = partOf(options.progress, first, count, rays.size(), std::max(options.repeat, 1u));
    auto traced = VOXC_TRY(traceSlice(rays.subspan(first, count), hits.subspan(first, count), slice));
    add(report, traced);
  }
  return report;
}

Expected<TraceReport> OrderedTracer::traceSlice(const RaySpan &rays, std::span<Hit> hits,
                                                const TraceOptions &options) {
  TraceTime ordering;
  Watch before;
  const std::span<const std::uint32_t> order = bins_.order(rays, edge_, team_);
  const RaySpan gathered = gatherRays(rays, order);
  if (hits.size() > hits_.size())
    hits_.resize(hits.size());
  before.addTo(ordering);
  auto report = VOXC_TRY(tracer_->trace(gathered, std::span(hits_).first(hits.size()), options));
  Watch after;
  scatterHits(hits, order);
  after.addTo(ordering);
  for (TraceTime &repeat : report.repeats) {
    repeat.wall += ordering.wall;
    repeat.cpu += ordering.cpu;
  }
  return report;
}

RaySpan OrderedTracer::gatherRays(const RaySpan &rays, std::span<const std::uint32_t> order) {
  return rays.isBounded() ? gather(rays, order, boundedRays_) : gather(rays, order, rays_);
}

template <typename AnyRay>
RaySpan OrderedTracer::gather(const RaySpan &rays, std::span<const std::uint32_t> order,
                              std::vector<AnyRay> &gathered) {
  if (rays.size() > gathered.size())
    gathered.resize(rays.size());
  team_.share(rays.size(), [&](std::size_t first, std::size_t last, unsigned) {
    for (std::size_t i = first; i < last; ++i) {
      __builtin_prefetch(rays.origin(order[std::min(i + kAhead, last - 1)]));
      std::memcpy(&gathered[i], rays.origin(order[i]), sizeof(AnyRay));
    }
  });
  return std::span(gathered).first(rays.size());
}

void OrderedTracer::scatterHits(std::span<Hit> hits, std::span<const std::uint32_t> order) const {
  team_.share(hits.size(), [&](std::size_t first, std::size_t last, unsigned) {
    for (std::size_t i = first; i < last; ++i) {
      __builtin_prefetch(&hits[order[std::min(i + kAhead, last - 1)]], 1);
      hits[order[i]] = hits_[i];
    }
  });
}

} // namespace

std::unique_ptr<Tracer> inOrder(std::unique_ptr<Tracer> tracer, const Volume &volume, unsigned threads,
                                bool pays) {
  return std::make_unique<OrderedTracer>(std::move(tracer), volume, threads, pays);
}

} // namespace voxc
