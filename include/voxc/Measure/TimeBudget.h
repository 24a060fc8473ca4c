// The wall time that a command may take, asked by what it does whether there is enough left.
#pragma once

#include "voxc/Support/Progress.h"

#include <functional>
#include <limits>

namespace voxc::measure {

class TimeBudget {
public:
  /// So many seconds from now on. `clock` returns the seconds since any moment and has to be safe to be asked
  /// by several threads at once; without one it is the machine's.
  explicit TimeBudget(double seconds = std::numeric_limits<double>::infinity(),
                      std::function<double()> clock = {});

  double spent() const { return clock_() - begin_; }
  /// Below 0 when it is over.
  double left() const { return seconds_ - spent(); }
  bool isOver() const { return left() <= 0; }
  /// Whether what takes so many seconds can be finished: what cannot should not begin.
  bool allows(double seconds) const { return seconds < left(); }
  /// The same beginning with another end.
  TimeBudget endingAfter(double seconds) const;

  /// Work that reports as `progress` does, and that stops as it does or when the budget is over.
  Progress within(const Progress &progress) const;

private:
  std::function<double()> clock_;
  double begin_ = 0;
  double seconds_ = 0;
};

} // namespace voxc::measure
