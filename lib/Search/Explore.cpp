// Going through the space of formats along its frontier.
#include "voxc/Search/Explore.h"

#include "voxc/Support/Stopwatch.h"

#include <algorithm>
#include <limits>
#include <set>
#include <string>

namespace voxc {
namespace {

/// Some packets of each set.
std::vector<RaySet> fewOf(std::span<const RaySet> rays, std::size_t count) {
  std::vector<RaySet> few;
  for (const RaySet &set : rays) {
    // From all over the set, in which those whose rays go far stand last.
    const std::size_t packets = set.rays.size() / kSimulatedPacket;
    const std::size_t wanted =
        std::clamp<std::size_t>(count / kSimulatedPacket, 1, std::max<std::size_t>(packets, 1));
    RaySet some{set.name, {}, set.isBinned};
    for (std::size_t i = 0; i < std::min(wanted, packets); ++i) {
      const auto first = set.rays.begin() +
                         static_cast<std::ptrdiff_t>((2 * i + 1) * packets / (2 * wanted) * kSimulatedPacket);
      some.rays.insert(some.rays.end(), first, first + kSimulatedPacket);
    }
    few.push_back(std::move(some));
  }
  return few;
}

class Explorer {
public:
  Explorer(FormatPredictor &predictor, const CandidateTraits &traits, std::span<const RaySet> rays,
           const SpeedModel &model, const Wish &wish, const ExploreOptions &options, const Progress &progress)
      : predictor_(predictor), traits_(traits), few_(fewOf(rays, options.sampledRays)), model_(model),
        wish_(wish), options_(options), progress_(progress) {}

  Explored run(std::vector<Candidate> seeds, std::span<const RaySet> rays) {
    for (Candidate &seed : seeds)
      if (!progress_.stopped())
        take(std::move(seed));
    while (!isOver()) {
      const std::vector<std::size_t> near = nearest();
      if (near.empty()) {
        explored_.isComplete = true;
        break;
      }
      for (const std::size_t i : near)
        expand(i);
    }
    keep(rays);
    return std::move(explored_);
  }

private:
  bool isOver() const {
    return progress_.stopped() || explored_.rated >= options_.mostFormats ||
           watch_.seconds() > options_.seconds;
  }

  /// What a format is known by: its plan, as another word for the same traversal makes no other kernel.
  static std::string keyOf(const Candidate &candidate) {
    const auto plan = makePlan(candidate.format, kCpuPlan);
    return plan ? printPlan(*plan) : printIr(candidate.format);
  }

  void take(Candidate candidate) {
    if (!known_.insert(keyOf(candidate)).second)
      return;
    ++explored_.rated;
    tell();
    if (auto format = predictor_.predict(std::move(candidate), few_, model_, wish_.maxBytes))
      formats_.push_back({std::move(*format)});
  }

  /// How far it is: the first half ends with the most formats, or with the time for rating.
  void tell() const {
    const double byCount = static_cast<double>(explored_.rated) / static_cast<double>(options_.mostFormats);
    progress_.at("explore", std::min(std::max(byCount, watch_.seconds() / options_.seconds), 1.0) / 2);
  }

  void expand(std::size_t index) {
    formats_[index].isExpanded = true;
    if (!formats_[index].format.candidate.composition)
      return;
    const Composition from = *formats_[index].format.candidate.composition;
    for (const Composition &to : rewritesOf(from, options_.maxLevels))
      if (tell(); !isOver() && tried_.insert(to).second)
        if (auto candidate = makeCandidate(toString(to), traits_, to.choices))
          take(std::move(*candidate));
  }

  /// For each format how many times the frontier's time at its size it takes.
  std::vector<double> distances() const {
    std::vector<std::size_t> order(formats_.size());
    for (std::size_t i = 0; i < order.size(); ++i)
      order[i] = i;
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return formats_[i].format.bytes(); });
    std::vector<double> distances(formats_.size());
    double fastest = std::numeric_limits<double>::infinity();
    for (const std::size_t i : order) {
      const double time = formats_[i].format.time();
      fastest = std::min(fastest, time);
      distances[i] = time / fastest;
    }
    return distances;
  }

  /// Those near the frontier whose rewrites were not looked at yet.
  std::vector<std::size_t> nearest() const {
    const std::vector<double> far = distances();
    std::vector<std::size_t> near;
    for (std::size_t i = 0; i < far.size(); ++i)
      if (far[i] <= options_.near && !formats_[i].isExpanded)
        near.push_back(i);
    std::ranges::stable_sort(near, {}, [&](std::size_t i) { return far[i]; });
    // A few at a time, since what they lead to moves the frontier.
    constexpr std::size_t kAtATime = 8;
    near.resize(std::min(near.size(), kAtATime));
    return near;
  }

  /// Simulates all rays for what comes near the frontier, the nearest first, for as long as exploring may
  /// have taken: what there is no time for keeps what few rays said of it.
  void simulateNear(std::span<const double> far, std::span<const RaySet> rays) {
    std::vector<std::size_t> near;
    for (std::size_t i = 0; i < far.size(); ++i)
      if (far[i] <= options_.simulated)
        near.push_back(i);
    std::ranges::stable_sort(near, {}, [&](std::size_t i) { return far[i]; });
    const double end = watch_.seconds() + options_.seconds;
    for (std::size_t i = 0; i < near.size() && !progress_.stopped() && watch_.seconds() <= end; ++i) {
      progress_.at("explore", (1 + static_cast<double>(i) / static_cast<double>(near.size())) / 2);
      predictor_.simulateAgain(formats_[near[i]].format, rays, model_);
    }
  }

  void keep(std::span<const RaySet> rays) {
    const std::vector<double> far = distances();
    simulateNear(far, rays);
    for (std::size_t i = 0; i < far.size(); ++i)
      if (far[i] <= options_.kept)
        explored_.formats.push_back(std::move(formats_[i].format));
  }

  struct Known {
    PredictedFormat format;
    bool isExpanded = false;
  };

  FormatPredictor &predictor_;
  const CandidateTraits &traits_;
  std::vector<RaySet> few_;
  const SpeedModel &model_;
  const Wish &wish_;
  const ExploreOptions &options_;
  const Progress &progress_;
  std::vector<Known> formats_;
  std::set<Composition> tried_;
  std::set<std::string> known_; ///< Their keys: so that equal formats are priced once.
  Explored explored_;
  Stopwatch watch_;
};

} // namespace

Explored explore(FormatPredictor &predictor, std::vector<Candidate> seeds, const CandidateTraits &traits,
                 std::span<const RaySet> rays, const SpeedModel &model, const Wish &wish,
                 const ExploreOptions &options, const Progress &progress) {
  return Explorer(predictor, traits, rays, model, wish, options, progress).run(std::move(seeds), rays);
}

} // namespace voxc
