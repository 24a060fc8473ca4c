// Where one thread leaves a thing for another; only the newest is kept.
#pragma once

#include <mutex>
#include <optional>
#include <utility>

namespace voxc::view {

template <typename Thing> class LatestValue {
public:
  void put(Thing thing) {
    const std::lock_guard lock(mutex_);
    thing_ = std::move(thing);
  }
  std::optional<Thing> take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(thing_, std::nullopt);
  }

private:
  std::mutex mutex_;
  std::optional<Thing> thing_;
};

} // namespace voxc::view
