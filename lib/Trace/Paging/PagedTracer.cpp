// Paged tracing on any back end.
#include "PagedRounds.h"

#include "CoarseRounds.h"
#include "Trace/Kernel/KernelFit.h"
#include "Trace/Kernel/Nontermination.h"
#include "Trace/Rays/Clock.h"
#include "Trace/Rays/FittingRays.h"

#include <algorithm>
#include <optional>

namespace voxc {
namespace {

/// Rounds of a single ray after which it is asked whether it came further.
constexpr std::uint64_t kPatience = 4096;

/// True of a ray that waits for a page, or that the device cut short.
bool isUnfinished(const Hit &hit) { return hit.voxel[0] < -1; }

class Driver final : public PagedTracer {
public:
  Driver(std::unique_ptr<PagedBackEnd> backEnd, PageCache cache, std::unique_ptr<CoarseStandIn> standIn,
         bool bounded)
      : backEnd_(std::move(backEnd)), cache_(std::move(cache)), standIn_(std::move(standIn)),
        bounded_(bounded) {}

  Expected<void> begin() { return cache_.begin(place()); }
  PagingReport paging() const override;
  Expected<TraceReport> trace(RaySpan rays, std::span<Hit> hits, const TraceOptions &options) override;
  Expected<UpdateReport> follow(const Volume &after, std::span<const WordRange> changed) override;

private:
  /// What is left of a batch, and how its rays are taken.
  struct Batch {
    std::span<Hit> hits;
    const TraceOptions &options;
    TraceReport &report;
    TraceTime &time;
    RayGroup group;
    std::optional<CoarseRounds> coarse = {}; ///< If blocks may answer.
    std::uint64_t lonely = 0;                ///< Rounds of a group of one ray.
    Hit before = {};                         ///< That ray, some rounds ago.
  };

  PageCache::Place place() {
    return [this](std::uint32_t slot, std::uint64_t offset, std::span<const std::byte> bytes) {
      return backEnd_->place(slot, offset, bytes);
    };
  }
  Expected<void> traceBatch(Batch &batch);
  Expected<bool> answerCoarsely(Batch &batch);
  Expected<void> endGroup(Batch &batch);
  Expected<void> bring(Batch &batch, const PageRound &round);
  Expected<void> checkProgress(Batch &batch);

  std::unique_ptr<PagedBackEnd> backEnd_;
  PageCache cache_;
  std::unique_ptr<CoarseStandIn> standIn_; ///< Or null.
  bool bounded_;
  FittingRays fitting_;
};

PagingReport Driver::paging() const {
  PagingReport report = cache_.report();
  if (standIn_) {
    report.coarseSide = 1 << standIn_->tree().log2Side();
    report.coarseBlocks = standIn_->tree().blocks();
    report.coarseBytes = standIn_->tree().bytes();
  }
  return report;
}

Expected<UpdateReport> Driver::follow(const Volume &after, std::span<const WordRange> changed) {
  if (standIn_)
    return Error::usage("coarse blocks are of the volume as stored; leave them out to trace edits");
  const auto placed = VOXC_TRY(cache_.follow(after, changed, place()));
  return UpdateReport{.copiedBytes = placed};
}

Expected<TraceReport> Driver::trace(RaySpan given, std::span<Hit> hits, const TraceOptions &options) {
  const RaySpan rays = VOXC_TRY(fitting_.fit(given, bounded_));
  if (rays.size() != hits.size())
    return Error::usage("there are " + std::to_string(rays.size()) + " rays, but room for " +
                        std::to_string(hits.size()) + " hits");
  TraceReport report;
  report.repeats.resize(std::max(options.repeat, 1u));
  const std::uint64_t most = std::min<std::uint64_t>(backEnd_->mostRays(), rays.size());
  double traced = 0;
  const double total = static_cast<double>(rays.size()) * static_cast<double>(report.repeats.size());
  for (std::uint64_t first = 0; first < rays.size(); first += most) {
    const std::uint64_t count = std::min(most, rays.size() - first);
    const RaySpan partRays = rays.subspan(first, count);
    const auto part = hits.subspan(first, count);
    std::uint64_t answered = 0;
    for (TraceTime &time : report.repeats) {
      VOXC_TRY(backEnd_->take(partRays, part, options, report));
      Batch batch = {part, options, report, time, {0, count}};
      if (standIn_ && options.coarse.spread > 0)
        batch.coarse.emplace(*standIn_, partRays, part, options.coarse, cache_.threads());
      VOXC_TRY(traceBatch(batch));
      answered = batch.coarse ? batch.coarse->answered() : 0;
      traced += static_cast<double>(count);
      options.progress.at("trace", traced / total, static_cast<std::uint64_t>(traced));
    }
    report.coarse += answered;
  }
  return report;
}

// All rays begin at once. Of the pages that they ask for, as many come as can without any going that was just
// used: so a ray that waits keeps what it has of its way, each page that comes takes some ray further, and
// many rays share it. When all that is resident is in use, half of the group goes on, and the others wait for
// their turn.
Expected<void> Driver::traceBatch(Batch &batch) {
  const double wall = wallSeconds();
  const double cpu = processCpuSeconds();
  bool goesOn = false;
  while (batch.group.first < batch.hits.size()) {
    if (batch.options.progress.stopped())
      return Error::interrupted();
    auto time = VOXC_TRY(backEnd_->trace(batch.group, goesOn, cache_.table(), batch.options));
    batch.time.device += time.device;
    goesOn = true;
    const PageRound round = cache_.takeMarks();
    if (!round.asked.empty() && batch.coarse) {
      const auto answered = VOXC_TRY(answerCoarsely(batch));
      if (answered)
        continue; // What the others wait for they tell once more.
    }
    VOXC_TRY(round.asked.empty() ? endGroup(batch) : bring(batch, round));
  }
  batch.time.wall += wallSeconds() - wall;
  batch.time.cpu += processCpuSeconds() - cpu;
  return {};
}

/// Whether blocks have stood in for what some rays waited for.
Expected<bool> Driver::answerCoarsely(Batch &batch) {
  VOXC_TRY(backEnd_->fetch(batch.report));
  if (batch.coarse->answer(batch.group.first, batch.group.count) == 0)
    return false;
  VOXC_TRY(backEnd_->put(batch.report));
  return true;
}

/// Nobody waits for a page; but a device may have cut rays short, which then go on.
Expected<void> Driver::endGroup(Batch &batch) {
  VOXC_TRY(backEnd_->fetch(batch.report));
  RayGroup &group = batch.group;
  const auto hits = batch.hits.subspan(group.first, group.count);
  VOXC_TRY(checkEnded(hits));
  if (std::ranges::any_of(hits, isUnfinished))
    return {};
  group.first += group.count;
  group.count = std::min(2 * group.count, batch.hits.size() - group.first);
  batch.lonely = 0;
  return {};
}

Expected<void> Driver::bring(Batch &batch, const PageRound &round) {
  // A ray alone asks for one page. Where it goes on it uses no more than those of one way down, all of which
  // have room: so what goes now it has used before that.
  if (batch.group.count == 1) {
    VOXC_TRY(checkProgress(batch));
    return cache_.load(round.asked, place(), batch.options.progress);
  }
  const std::uint64_t room = cache_.room();
  if (room == 0) {
    batch.group.count = (batch.group.count + 1) / 2;
    return {};
  }
  const auto asked = std::span(round.asked).first(std::min<std::size_t>(room, round.asked.size()));
  return cache_.load(asked, place(), batch.options.progress);
}

Expected<void> Driver::checkProgress(Batch &batch) {
  if (++batch.lonely % kPatience != 0)
    return {};
  VOXC_TRY(backEnd_->fetch(batch.report));
  const Hit &hit = batch.hits[batch.group.first];
  if (batch.lonely > kPatience && std::ranges::equal(hit.voxel, batch.before.voxel))
    return Error::usage("a ray needs more pages at once than the " + std::to_string(cache_.slots()) +
                        " that have room: give more memory");
  batch.before = hit;
  return {};
}

} // namespace

Expected<std::unique_ptr<CoarseStandIn>> readStandIn(const PagedVolume &volume, const PagingOptions &options,
                                                     bool bounded) {
  if (!options.coarse)
    return std::unique_ptr<CoarseStandIn>();
  if (bounded)
    return Error::usage("coarse blocks answer rays without bounds, but the kernel's have bounds");
  const auto blocks = VOXC_TRY(readCoarseBlocks(volume));
  const Int3 log2 = volume.info().format.log2Extent();
  return std::make_unique<CoarseStandIn>(CoarseTree(blocks, std::max({log2.x, log2.y, log2.z})));
}

Expected<std::unique_ptr<PagedTracer>> drivePages(std::unique_ptr<PagedBackEnd> backEnd, PageCache cache,
                                                  std::unique_ptr<CoarseStandIn> standIn, bool bounded) {
  auto driver = std::make_unique<Driver>(std::move(backEnd), std::move(cache), std::move(standIn), bounded);
  VOXC_TRY(driver->begin());
  return std::unique_ptr<PagedTracer>(std::move(driver));
}

Expected<void> checkPagedFit(std::uint64_t storageDigest, const PagedVolume &volume, std::string_view emit) {
  // An outline of the volume: what fits is told by its format.
  return checkFit(storageDigest, Volume(volume.info(), std::vector<std::uint32_t>(1)), emit);
}

} // namespace voxc
