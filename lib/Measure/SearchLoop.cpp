// Batches, and the last rounds.
#include "voxc/Measure/SearchLoop.h"

#include <algorithm>
#include <limits>
#include <set>

namespace voxc::measure {

namespace {

/// A format whose best time is so many times the frontier's at its size is not traced on.
constexpr double kBeaten = 1.25;
/// Formats that take so many times the frontier's time are in the last rounds too: they may be as fast.
constexpr double kNear = 1.04;
/// The last rounds are more than those of a batch, and count words by a kernel of their own.
constexpr double kLastCost = 1.5;
/// What a format takes, until that is measured.
constexpr double kAssumedSeconds = 0.7;
/// Of the last rounds, so many make times that can be compared: more than those of a batch, by which a later
/// search tells them apart.
constexpr unsigned kLeastLastRounds = 4;
/// Seconds by which the first format may be late, so that a search has an answer.
constexpr double kGrace = 1.2;

/// What a record says of the time of a ray.
std::optional<double> nanosecondsOf(const Record &record) {
  const auto &speed = speedOf(record);
  const bool isUsable = record.isMeasured() && speed && speed->median > 0;
  return isUsable ? std::optional(1000 / speed->median) : std::nullopt;
}

} // namespace

void SearchLoop::takeKnown(const std::vector<Record> &records) {
  std::map<std::string, const Record *> known;
  std::set<std::string> names;
  for (const Record &record : records) {
    known[record.cell] = &record;
    names.insert(record.format.name);
  }
  for (std::size_t i = 0; i < acquisition_.formats().size(); ++i) {
    if (!names.contains(acquisition_.formats()[i].candidate.text))
      continue;
    Finding finding;
    for (const Record &record : session_.recordsOf(acquisition_.formats()[i].candidate))
      if (const auto before = known.find(record.cell); before != known.end()) {
        finding.records.push_back(*before->second);
        if (const auto time = nanosecondsOf(*before->second))
          finding.nanoseconds.push_back(*time);
      }
    if (finding.nanoseconds.size() != acquisition_.formats()[i].costs.size())
      continue; // Those that failed are tried again.
    acquisition_.take(i, finding.nanoseconds);
    if (finding.records.front().speed.rounds >= kLeastLastRounds)
      last_.insert(i);
    findings_[i] = std::move(finding);
  }
  acquisition_.learn();
}

std::vector<double> SearchLoop::predict(std::size_t index) const {
  const PredictedFormat &format = acquisition_.formats()[index];
  const double correction = acquisition_.expect(index).nanoseconds / format.time();
  std::vector<double> times;
  times.reserve(format.nanoseconds.size());
  for (const double nanoseconds : format.nanoseconds)
    times.push_back(nanoseconds * correction);
  return times;
}

Expected<void> SearchLoop::measure(const std::vector<std::size_t> &formats, const RoundOptions &roundOptions,
                                   const Progress &progress) {
  const Stopwatch watch;
  std::vector<const PredictedFormat *> rated;
  std::vector<std::vector<double>> predicted;
  for (const std::size_t i : formats) {
    rated.push_back(&acquisition_.formats()[i]);
    predicted.push_back(predict(i));
  }
  auto found = VOXC_TRY(session_.measure(rated, predicted, roundOptions, progress));
  const auto isUnfinished = [](const Finding &finding) { return finding.records.empty(); };
  const bool isLast = roundOptions.leastRounds == kLeastLastRounds;
  // Their times are to be compared: all are used, or none.
  if (isLast && std::ranges::any_of(found, isUnfinished))
    return {};
  for (std::size_t i = 0; i < formats.size(); ++i) {
    Finding &finding = found[i];
    if (isUnfinished(finding)) {
      unfinished_.insert(formats[i]);
      continue;
    }
    for (Record &record : finding.records) {
      // What was predicted before anything was known of the format stays.
      if (const auto before = findings_.find(formats[i]); before != findings_.end())
        record.predicted =
            before->second.records[static_cast<std::size_t>(&record - finding.records.data())].predicted;
      VOXC_TRY(keep_(record));
    }
    if (finding.nanoseconds.empty())
      acquisition_.drop(formats[i]);
    else
      acquisition_.take(formats[i], finding.nanoseconds);
    findings_[formats[i]] = std::move(finding);
  }
  acquisition_.learn();
  measuredSeconds_ += watch.seconds();
  measuredCount_ += formats.size();
  if (isLast)
    last_.insert(formats.begin(), formats.end());
  return {};
}

std::vector<std::size_t> SearchLoop::nearFrontier(double times) const {
  std::vector<std::size_t> order;
  for (const auto &[index, finding] : findings_)
    if (acquisition_.timeOf(index) && isCompared(index))
      order.push_back(index);
  std::ranges::stable_sort(order, {}, [&](std::size_t i) {
    return std::pair(acquisition_.formats()[i].bytes(), *acquisition_.timeOf(i));
  });
  std::vector<std::size_t> near;
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t i : order) {
    const double time = *acquisition_.timeOf(i);
    if (time < least || (times > 1 && time <= times * least))
      near.push_back(i);
    least = std::min(least, time);
  }
  return near;
}

/// Volumes of formats that are not on the frontier any more, or that there was no time for, make room.
void SearchLoop::forgetBeaten() const {
  std::set<std::string> needed;
  for (const std::size_t i : frontier())
    needed.insert(session_.volumePath(acquisition_.formats()[i]));
  const auto forget = [&](std::size_t index) {
    if (!needed.contains(session_.volumePath(acquisition_.formats()[index])))
      session_.forget(acquisition_.formats()[index]);
  };
  for (const auto &[index, finding] : findings_)
    forget(index);
  std::ranges::for_each(unfinished_, forget);
}

double SearchLoop::secondsOfOne() const {
  return measuredCount_ == 0 ? kAssumedSeconds : measuredSeconds_ / static_cast<double>(measuredCount_);
}

double SearchLoop::reserve() const {
  return options_.lastRounds == 0
             ? 0
             : kLastCost * secondsOfOne() * static_cast<double>(nearFrontier(kNear).size());
}

std::size_t SearchLoop::nextBatch() const {
  const double formats = (options_.budget.left() - reserve()) / secondsOfOne();
  if (formats <= 0)
    return findings_.empty() ? 1 : 0;
  // Until one was measured, how long it takes is a guess, and a batch has no answer before its last one is
  // built.
  return measuredCount_ == 0 ? 1 : std::min(options_.together, static_cast<std::size_t>(formats) + 1);
}

Expected<void> SearchLoop::measureFrontier(const Progress &progress) {
  const std::vector<std::size_t> near = nearFrontier(kNear);
  if (near.empty() || options_.budget.isOver())
    return {};
  return measure(near,
                 {.rounds = options_.lastRounds,
                  .countsWork = true,
                  .budget = options_.budget,
                  .leastRounds = kLeastLastRounds},
                 progress);
}

Expected<void> SearchLoop::run(const Progress &progress) {
  const double begin = options_.budget.spent();
  const double end = begin + options_.budget.left();
  // How far it is, is told by the time that has gone.
  const auto tell = [&](std::string_view stage, double, std::uint64_t) {
    progress.at(stage, std::clamp((options_.budget.spent() - begin) / (end - begin), 0.0, 1.0),
                findings_.size());
  };
  const Progress telling{.report = tell, .stop = progress.stop};
  while (const std::size_t together = nextBatch()) {
    const std::vector<std::size_t> batch = acquisition_.next(together, options_.leastGain);
    isComplete_ = batch.empty();
    if (isComplete_)
      break;
    const Frontier leading = acquisition_.frontier();
    const auto isBeaten = [&](double bytes, double nanoseconds) {
      return nanoseconds > kBeaten * 1000 / std::max(leading.speedAt(bytes), 1e-9);
    };
    const TimeBudget budget = findings_.empty() ? options_.budget.endingAfter(end + kGrace) : options_.budget;
    const std::size_t before = findings_.size();
    if (Expected<void> measured =
            measure(batch, {.rounds = options_.rounds, .isBeaten = isBeaten, .budget = budget}, telling);
        !measured)
      return measured;
    const bool isOver = findings_.size() == before && options_.budget.isOver();
    if (!isOver)
      last_.clear();
    forgetBeaten();
    if (isOver)
      break; // Nothing was finished in time.
  }
  if (options_.lastRounds == 0 || (measuredCount_ == 0 && !last_.empty()))
    return {}; // Not asked for, or all is known from before.
  VOXC_TRY(measureFrontier(telling));
  forgetBeaten();
  return {};
}

} // namespace voxc::measure
