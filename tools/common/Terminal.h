// What a person at a terminal sees while work goes on: a progress bar, and Ctrl-C that stops in good order.
#pragma once

#include "voxc/Support/Progress.h"

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>

namespace voxc::tool {

/// `text` with a question mark for each control character: what a file says shall not command a terminal.
std::string printable(std::string text);

/// A bar on standard error with rate and time left, drawn over itself and removed at the end. It shows
/// nothing if it is told to be quiet or standard error is no terminal.
class ProgressBar {
public:
  explicit ProgressBar(bool quiet);
  ~ProgressBar();
  ProgressBar(const ProgressBar &) = delete;
  ProgressBar &operator=(const ProgressBar &) = delete;

  /// For work that may report from any one thread at a time; its `stop` is the flag of `catchInterrupts`.
  /// It must not outlive the bar.
  Progress progress();
  /// Removes the bar, so that other text can be printed.
  void clear();

private:
  using Clock = std::chrono::steady_clock;
  void draw(std::string_view stage, double fraction, std::uint64_t done);

  bool visible_;
  bool drawn_ = false;
  std::string stage_;
  Clock::time_point stageBegin_{};
  Clock::time_point lastDraw_{};
};

/// What stands behind the bar.
struct Pace {
  std::string rate; ///< "  12.3 M rays/s"; "" if nothing is counted.
  std::string left; ///< "  0:42 left"; "" before that can be told.
};
Pace paceOf(double seconds, double fraction, std::uint64_t done, std::string_view counted);

/// "build        [####........]  33%  12.3 M voxels/s  0:42 left", in at most so many columns. Where there
/// are fewer, first the bar becomes shorter, then the rate is left out, then the bar, and then the stage is
/// cut: the percentage and the time that is left stay.
std::string barText(std::string_view stage, double fraction, const Pace &pace, int columns);

} // namespace voxc::tool
