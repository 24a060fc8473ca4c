// How many levels formats may have.
#include "voxc/IR/Limits.h"

#include <algorithm>
#include <atomic>

namespace voxc {
namespace {

std::atomic<std::size_t> allowed = kDefaultLevels;

} // namespace

void allowLevels(std::size_t most) { allowed = std::clamp(most, std::size_t{1}, kMostLevels); }

std::size_t allowedLevels() { return allowed; }

} // namespace voxc
