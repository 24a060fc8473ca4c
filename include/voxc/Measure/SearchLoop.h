// A search's measurements: batches chosen by what is expected of them, for as long as there is time, and at
// the end the frontier once more, in turn.
#pragma once

#include "voxc/Measure/MeasurementSession.h"
#include "voxc/Search/Acquisition.h"
#include "voxc/Support/Stopwatch.h"

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace voxc::measure {

struct SearchLoopOptions {
  TimeBudget budget;         ///< In which it has to end.
  std::size_t together = 4;  ///< Formats of a batch.
  unsigned rounds = 3;       ///< In which each is traced; 3 at most.
  unsigned lastRounds = 7;   ///< The same of the frontier; 0: what is best is not measured once more.
  double leastGain = 0.0001; ///< Of the area below the frontier, that a format must promise; below 0: none.
};

/// What is done with each record as it is found; after an error the search ends.
using KeepRecord = std::function<Expected<void>(const Record &)>;

class SearchLoop {
public:
  /// Both must outlive it.
  SearchLoop(Acquisition &acquisition, MeasurementSession &session, KeepRecord keep,
             const SearchLoopOptions &options)
      : acquisition_(acquisition), session_(session), keep_(std::move(keep)), options_(options) {}

  /// Takes in what an earlier search measured.
  void takeKnown(const std::vector<Record> &records);

  /// Ends when nothing promises enough, or with the budget: what it leaves unfinished counts for nothing.
  /// Errors: `Interrupted`, with which everything that was found is there; `Environment`.
  Expected<void> run(const Progress &progress);

  /// Nothing was left that promised enough.
  bool isComplete() const { return isComplete_; }
  /// What was found of each format, by its number in the acquisition.
  const std::map<std::size_t, Finding> &findings() const { return findings_; }
  /// Whether the times of a format were taken together with those of the others that this holds for.
  bool isCompared(std::size_t index) const { return last_.empty() || last_.contains(index); }
  /// Numbers of measured formats that no other beats in both size and speed, from small to large; of those of
  /// the last rounds, if there were any, since times of other moments may be those of a busy machine.
  std::vector<std::size_t> frontier() const { return nearFrontier(1); }

private:
  Expected<void> measure(const std::vector<std::size_t> &formats, const RoundOptions &roundOptions,
                         const Progress &progress);
  Expected<void> measureFrontier(const Progress &progress);
  /// Seconds that a format is expected to take.
  double secondsOfOne() const;
  /// How many formats may be measured together in the time that is left for batches.
  std::size_t nextBatch() const;
  /// Those that take at most so many times the time of the frontier at their size.
  std::vector<std::size_t> nearFrontier(double times) const;
  void forgetBeaten() const;
  std::vector<double> predict(std::size_t index) const;
  /// Seconds that the last rounds are expected to take.
  double reserve() const;

  Acquisition &acquisition_;
  MeasurementSession &session_;
  KeepRecord keep_;
  SearchLoopOptions options_;
  std::map<std::size_t, Finding> findings_;
  std::set<std::size_t> last_;       ///< Formats of the last rounds,
  std::set<std::size_t> unfinished_; ///< and those that there was no time for.
  double measuredSeconds_ = 0;       ///< Of batches,
  std::size_t measuredCount_ = 0;    ///< and their formats.
  bool isComplete_ = false;
};

} // namespace voxc::measure
