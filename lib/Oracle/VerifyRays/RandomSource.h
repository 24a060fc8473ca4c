// Random numbers that are the same on every machine, unlike those of the standard distributions.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

namespace voxc::oracle {

class RandomSource {
public:
  explicit RandomSource(std::uint64_t seed) : engine_(seed) {}

  /// A whole number in [low, high]; low, if that is empty.
  int integer(int low, int high) {
    if (high <= low)
      return low;
    const auto choices = static_cast<std::uint64_t>(std::int64_t{high} - low + 1);
    return static_cast<int>(low + static_cast<std::int64_t>(engine_() % choices));
  }
  /// A number in [low, high).
  double real(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
  bool flip() { return engine_() >> 63 != 0; }
  float sign() { return flip() ? 1.0f : -1.0f; }

private:
  std::mt19937_64 engine_;
};

} // namespace voxc::oracle
