// What a subject takes: CPU seconds, or on a GPU those that pass, and what can be counted.
#pragma once

#include "Subject.h"

#include <cstdint>

namespace voxc::cliffs {

struct Cost {
  double firstNanoseconds = 0;   ///< Time of the first call, which may compile and choose an order.
  double nanoseconds = 0;        ///< Time of a later call: the least of some.
  std::uint64_t allocations = 0; ///< Of a later call.
  std::uint64_t faults = 0;      ///< Pages of memory that a later call touched for the first time.
};

/// Traces the subject's rays again and again, first and then warm.
Expected<Cost> measure(Subject &subject);
/// Lowers the time of a cost by further calls.
Expected<void> measureAgain(Subject &subject, Cost &cost);

/// Allocations of one call.
Expected<std::uint64_t> countCall(Subject &subject);

} // namespace voxc::cliffs
