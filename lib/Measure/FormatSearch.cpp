// The steps of a search.
#include "voxc/Measure/FormatSearch.h"

#include "voxc/Measure/SavedWeights.h"
#include "voxc/Search/SampleRays.h"

#include <algorithm>
#include <limits>
#include <map>

namespace voxc::measure {
namespace {

/// Volumes of more than so many times the bytes of the smallest are not looked for.
constexpr double kSizesOfUse = 64;

/// Of the time that is left when the input was read, that rating formats may take, and simulating rays again,
constexpr double kExploringShare = 0.25;
/// and both together at most, whatever the formats are that it begins with: less where few seconds are left.
constexpr double kMostExploring = 0.6, kLeastExploring = 0.25, kSecondsOfMeasuring = 12;

/// Rays that stand for the measured ones, in the order in which the device takes them.
RaySet simulatedRays(const SearchScene &scene, const MeasuredSet &set, bool isProcessor) {
  // A tracer of a device that is no processor takes rays as they are given.
  RayOrder order = set.order();
  if (order == RayOrder::Auto && (set.camera || !isProcessor))
    order = RayOrder::Given;
  const int edge = std::max({scene.extent.x, scene.extent.y, scene.extent.z});
  const RaySet considered = set.camera && order == RayOrder::Given
                                ? RaySet{set.part.name, sampleCamera(*set.camera, kConsideredRays)}
                                : samplePackets(set.part.name, set.rays, kConsideredRays, edge, order);
  return typicalPackets(scene.shape, considered, kSimulatedRays);
}

} // namespace

FormatSearch::FormatSearch(const SearchScene &scene, std::vector<MeasuredSet> sets,
                           FormatSearchOptions options)
    : scene_(&scene), sets_(std::move(sets)), options_(std::move(options)) {
  const DevicePart device = devicePart(options_.measurement.device, options_.measurement.threads);
  model_ = knownSpeedsOf(device.name).model;
  for (const MeasuredSet &set : sets_)
    simulated_.push_back(simulatedRays(scene, set, device.clock == "cpu"));
}

Explored FormatSearch::explore(std::vector<Candidate> seeds, const TimeBudget &budget,
                               const Progress &progress) const {
  FormatPredictor predictor(scene_->modelled());
  const double left = std::max(budget.left(), 0.0);
  ExploreOptions options = options_.explore;
  options.seconds = kExploringShare * left;
  Progress bounded = budget.within(progress);
  if (options_.onlySeeds) {
    options.mostFormats = seeds.size();
    options.near = 0; // Nothing is rewritten, also where several seeds have one plan.
    options.kept = std::numeric_limits<double>::infinity();
  } else {
    const double most =
        std::min(kMostExploring * left, std::max(kLeastExploring * left, left - kSecondsOfMeasuring));
    bounded = budget.endingAfter(budget.spent() + most).within(progress);
  }
  if (!options_.onlySeeds && options_.maxLevels > 0) {
    options.maxLevels = options_.maxLevels;
    std::erase_if(seeds,
                  [&](const Candidate &seed) { return seed.format.levels.size() > options.maxLevels; });
  }
  return voxc::explore(predictor, std::move(seeds), scene_->traits, simulated_, model_, options_.wish,
                       options, bounded);
}

Expected<void> FormatSearch::measure(Explored explored, const std::vector<Record> &known,
                                     const KeepRecord &keep, const TimeBudget &budget,
                                     const Progress &progress) {
  const auto smallest = std::ranges::min_element(explored.formats, {}, &PredictedFormat::bytes);
  const double mostBytes = kSizesOfUse * static_cast<double>(smallest->bytes());
  acquisition_ = std::make_unique<Acquisition>(
      std::move(explored.formats), model_,
      AcquisitionOptions{.mostBytes = mostBytes, .leastSpeed = options_.leastSpeed});
  session_ = VOXC_TRY(
      MeasurementSession::create(*scene_, std::move(sets_), options_.measurement, budget.within(progress)));
  SearchLoopOptions loopOptions{.budget = budget};
  if (options_.measuresAll)
    loopOptions.leastGain = -1;
  if (!options_.measuresAgain)
    loopOptions.lastRounds = 0;
  loop_ = std::make_unique<SearchLoop>(*acquisition_, *session_, keep, loopOptions);
  loop_->takeKnown(known);
  return loop_->run(progress);
}

SearchVerdict FormatSearch::verdict(const std::vector<Record> &records) const {
  std::map<std::string, std::size_t> formats; // By the digest of each cell.
  for (const auto &[index, finding] : loop_->findings())
    for (const Record &record : finding.records)
      formats[record.cell] = index;
  std::vector<const Record *> own;
  for (const Record &record : records)
    if (formats.contains(record.cell))
      own.push_back(&record);
  return makeSearchVerdict(
      own, [&](const Record &record) { return loop_->isCompared(formats.at(record.cell)); },
      std::string(toString(options_.wish.objective)), options_.leastSpeed);
}

std::optional<MeasuredSet> bouncedSet(const SearchScene &scene, const std::vector<Ray> &eye,
                                      std::uint32_t seed, RayOrder order) {
  std::vector<Ray> rays = sampleBounces(scene.shape, eye, eye.size(), seed);
  return rays.empty() ? std::nullopt : std::optional(listSet("bounced", std::move(rays), order));
}

} // namespace voxc::measure
