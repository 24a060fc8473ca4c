// The thread that paints: always what was asked for last, coarse at once and then finer.
#pragma once

#include "view/LatestValue.h"
#include "view/Painting.h"

#include "voxc/Support/Error.h"

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace voxc::view {

/// What was painted.
struct Painting {
  std::uint64_t number = 0; ///< Of the shot, as `show` gave it.
  Expected<Picture> picture;
  RefinementStep step;
  double seconds = 0;                      ///< That the step took.
  bool isLast = false;                     ///< Nothing finer follows.
  std::optional<PagingReport> paging = {}; ///< Of the scene until then, if it has pages.
};

class Painter {
public:
  /// `wake` is called from the thread whenever there is something to take. `refinement` says in which steps a
  /// shot is painted.
  Painter(const Refinement &refinement, std::function<void()> wake);
  ~Painter();

  /// Paints `shot` from now on. A step that refines the shot before it is ended; a first step is not, so that
  /// what moves without pause is seen. Returns the shot's number, which rises.
  std::uint64_t show(Shot shot);
  /// Calls `question` on the thread, the only one that uses the tracer, before it paints on. It is given what
  /// is shown; of several questions the last is asked, and none before there is something to show.
  using Question = std::function<void(const Shot &shot)>;
  void ask(Question question);
  /// The same, before any question that was asked so, none of which takes its place; only the next one of its
  /// own kind does.
  void insist(Question question);

  /// The newest painting that was not taken yet.
  std::optional<Painting> take() { return painting_.take(); }

private:
  void run();
  void paintStep(std::unique_lock<std::mutex> &lock);
  void answer(std::unique_lock<std::mutex> &lock);
  void put(Question &place, Question question);

  std::function<void()> wake_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::atomic<bool> stop_ = false; ///< Ends the step that is being painted.
  bool isEnding_ = false;
  std::optional<Shot> shot_;
  std::uint64_t number_ = 0;
  Refinement refinement_;
  Question question_, insisted_;
  LatestValue<Painting> painting_;
  std::thread thread_; // The last: it uses all others.
};

} // namespace voxc::view
