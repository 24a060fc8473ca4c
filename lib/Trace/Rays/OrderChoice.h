// Whether bins pay for rays without order: measured where it is asked, and kept for a while.
#pragma once

#include <bit>
#include <cstddef>

namespace voxc {

/// Rays are scattered, and it is open whether ordering them costs more than it saves. That depends on rays,
/// scene, format and machine, so that it is measured on the first rays of a call, by seconds a ray: what they
/// take as given, what ordering takes, and, unless that alone is too much, what they take bin by bin.
class OrderChoice {
public:
  /// So many rays tell what they take as given, and what ordering takes.
  static constexpr std::size_t kFirstRays = std::size_t{1} << 12;

  /// Rays of a call on which both orders are compared: enough for bins of several rays, and few of all.
  static std::size_t comparedRays(std::size_t rays) { return rays / 16; }

  /// Bins were never seen to save more than this of the time that rays take as given.
  static constexpr double kMostSaved = 0.7;
  static bool mayPay(double given, double ordering) { return ordering < kMostSaved * given; }
  /// Bins of all rays are fuller than those of the compared ones, and save a little more.
  static constexpr double kFuller = 1.15;
  static bool pays(double given, double binned) { return binned < kFuller * given; }

  /// What was learnt from so many rays, or about as many; it is forgotten after some calls, for rays change.
  bool isKnown(std::size_t rays) const { return calls_ > 0 && classOf(rays) == class_; }
  void learn(bool bins, std::size_t rays) {
    bins_ = bins;
    class_ = classOf(rays);
    calls_ = kCalls;
  }
  /// What is known, for one call.
  bool use() {
    --calls_;
    return bins_;
  }

private:
  static constexpr int kCalls = 64;
  /// Numbers of rays that differ by less than four times are of one class, or of two that lie side by side.
  static int classOf(std::size_t rays) { return static_cast<int>(std::bit_width(rays)) / 2; }

  bool bins_ = false;
  int class_ = 0;
  int calls_ = 0;
};

} // namespace voxc
