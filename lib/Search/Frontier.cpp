// Stairs, and the area below them.
#include "voxc/Search/Frontier.h"

#include <algorithm>
#include <cmath>

namespace voxc {

Frontier::Stair Frontier::stairOf(const SizeTime &point) const {
  return {std::log2(point.bytes), 1000 / point.nanoseconds - leastSpeed_};
}

void Frontier::add(const SizeTime &point) {
  const Stair stair = stairOf(point);
  if (stair.speed <= 0 || point.bytes > mostBytes_ || gain(point) <= 0)
    return;
  std::erase_if(stairs_, [&](const Stair &other) {
    return other.octave >= stair.octave && other.speed <= stair.speed;
  });
  stairs_.insert(std::ranges::upper_bound(stairs_, stair.octave, {}, &Stair::octave), stair);
}

double Frontier::area() const {
  double area = 0;
  for (std::size_t i = 0; i < stairs_.size(); ++i) {
    const double end = i + 1 < stairs_.size() ? stairs_[i + 1].octave : std::log2(mostBytes_);
    area += stairs_[i].speed * (end - stairs_[i].octave);
  }
  return area;
}

double Frontier::gain(const SizeTime &point) const {
  const Stair stair = stairOf(point);
  // Each run of sizes from the point's on, up to the first stair that is as fast.
  double gain = 0, begin = stair.octave, below = 0;
  for (const Stair &other : stairs_) {
    if (other.octave > begin) {
      gain += std::max(stair.speed - below, 0.0) * (other.octave - begin);
      begin = other.octave;
    }
    below = other.speed;
    if (below >= stair.speed)
      return gain;
  }
  return gain + std::max(stair.speed - below, 0.0) * std::max(std::log2(mostBytes_) - begin, 0.0);
}

double Frontier::speedAt(double bytes) const {
  double speed = 0;
  for (const Stair &stair : stairs_)
    if (stair.octave <= std::log2(bytes))
      speed = stair.speed + leastSpeed_;
  return speed;
}

} // namespace voxc
