// Rays that are looked at between two moments, and lists of rays with such bounds or without.
#pragma once

#include "voxc/Trace/Ray.h"

#include <cstddef>
#include <limits>
#include <span>
#include <type_traits>

namespace voxc {

/// The moments between which voxels are looked for. A ray enters a voxel at one moment, 0 if it begins in it;
/// that exact t, not the rounded one of the hit, is compared with both, which belong to the interval. A tmin
/// below 0 is as good as 0. Nothing lies in an interval that is empty or has a NaN at an end.
struct RayBounds {
  float tmin = 0;
  float tmax = std::numeric_limits<float>::infinity();

  bool operator==(const RayBounds &) const = default;
};

/// A ray and its bounds. 32 bytes, little-endian float32.
struct BoundedRay {
  float origin[3];
  float tmin;
  float direction[3];
  float tmax;

  Ray ray() const { return {{origin[0], origin[1], origin[2]}, {direction[0], direction[1], direction[2]}}; }
  RayBounds bounds() const { return {tmin, tmax}; }
};

static_assert(sizeof(BoundedRay) == 32);

/// A ray with bounds.
inline BoundedRay bounded(const Ray &ray, const RayBounds &bounds = {}) {
  return {{ray.origin[0], ray.origin[1], ray.origin[2]},
          bounds.tmin,
          {ray.direction[0], ray.direction[1], ray.direction[2]},
          bounds.tmax};
}

/// A view of rays that lie one behind another, all with bounds or all without. Whatever a `std::span` of
/// either can be made of is one.
class RaySpan {
public:
  constexpr RaySpan() = default;
  template <typename Rays>
    requires std::is_convertible_v<const Rays &, std::span<const Ray>>
  RaySpan(const Rays &rays) : RaySpan(std::span<const Ray>(rays), 3) {}
  template <typename Rays>
    requires std::is_convertible_v<const Rays &, std::span<const BoundedRay>>
  RaySpan(const Rays &rays) : RaySpan(std::span<const BoundedRay>(rays), 4) {}

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  /// Whether each has bounds.
  bool isBounded() const { return half_ == 4; }

  /// The coordinates of ray `i`, three each.
  const float *origin(std::size_t i) const { return words_ + 2 * half_ * i; }
  const float *direction(std::size_t i) const { return origin(i) + half_; }
  Ray operator[](std::size_t i) const {
    const float *const o = origin(i), *const d = direction(i);
    return {{o[0], o[1], o[2]}, {d[0], d[1], d[2]}};
  }
  /// Those of ray `i`; of one without, all that there are: [0, +inf].
  RayBounds bounds(std::size_t i) const {
    return isBounded() ? RayBounds{origin(i)[3], direction(i)[3]} : RayBounds{};
  }

  /// The rays as they lie.
  std::size_t bytesOfOne() const { return 2 * half_ * sizeof(float); }
  std::span<const std::byte> bytes() const {
    return {reinterpret_cast<const std::byte *>(words_), size_ * bytesOfOne()};
  }
  RaySpan subspan(std::size_t first, std::size_t count) const {
    RaySpan part = *this;
    part.words_ = origin(first);
    part.size_ = count;
    return part;
  }

private:
  template <typename AnyRay>
  RaySpan(std::span<const AnyRay> rays, std::size_t half)
      : words_(reinterpret_cast<const float *>(rays.data())), size_(rays.size()), half_(half) {
    static_assert(std::is_trivially_copyable_v<AnyRay> && alignof(AnyRay) == alignof(float));
  }

  const float *words_ = nullptr;
  std::size_t size_ = 0;
  std::size_t half_ = 3; ///< Floats from the origin to the direction.
};

} // namespace voxc
