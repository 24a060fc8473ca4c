// In which steps a picture gets fine: coarse at once, so coarse that it comes in time, then finer while
// nothing changes.
#pragma once

#include <optional>

namespace voxc::view {

/// One rendering of the whole picture.
struct RefinementStep {
  int divisor = 1;      ///< A pixel of it is a square of so many pixels a side.
  unsigned samples = 1; ///< Rays through each of its pixels.
  bool isDraft = true;  ///< It does without what can be left for later (`RenderOptions::isDraft`).

  bool operator==(const RefinementStep &) const = default;
};

/// Pure bookkeeping: it looks at no clock.
class Refinement {
public:
  /// The first step of a picture, its draft, shall take at most `budget` seconds, if the coarsest one does;
  /// the last has so many samples.
  Refinement(double budget, unsigned mostSamples) : budget_(budget), mostSamples_(mostSamples) {}

  /// Something changed: the next step is the first again. What is known of times is kept.
  void restart() { last_.reset(); }
  /// The same for what makes times mean nothing: another scene, style or size.
  void forgetTimes();

  /// The step to render now; none if the picture is as fine as it gets.
  std::optional<RefinementStep> next() const;
  /// Whether the next step is the first, which is not to be ended early.
  bool isFirst() const { return !last_; }
  /// Takes note that `step` took so many seconds, for whatever picture that is like this one.
  void took(const RefinementStep &step, double seconds);
  /// `step` of this picture is rendered; the next one is finer.
  void done(const RefinementStep &step) { last_ = step; }

private:
  int firstDivisor() const;

  double budget_;
  unsigned mostSamples_;
  std::optional<double> secondsOfAll_; ///< That a draft of every pixel would take, by the last one.
  std::optional<RefinementStep> last_;
};

} // namespace voxc::view
