// How far a kernel's hits are from the oracle's, and which differences rounding explains.
#include "voxc/Oracle/Oracle.h"

#include "ExactRay.h"
#include "ParallelRanges.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <utility>

namespace voxc {

namespace {

constexpr std::size_t kMaxExamples = 16;
constexpr double kRelativeMargin = 0x1p-20;

Int3 voxelOf(const Hit &hit) { return {hit.voxel[0], hit.voxel[1], hit.voxel[2]}; }

/// A reported t as a number: what is beyond float32, or no number at all, counts as 2^128.
double timeOf(const Hit &hit) { return std::isfinite(hit.t) ? double{hit.t} : 0x1p128; }

/// The distance from |t| to the next float32 above it.
double unitInLastPlace(const Hit &hit) {
  if (!std::isfinite(hit.t))
    return 0x1p104;
  const double next = std::nextafter(hit.t, std::numeric_limits<float>::infinity());
  return (std::isfinite(next) ? next : 0x1p128) - hit.t;
}

double length(const float (&direction)[3]) {
  return std::hypot(double{direction[0]}, double{direction[1]}, double{direction[2]});
}

/// When the ray meets a voxel's cell, grown by `margin` on every side; +inf if it does not.
double meets(const Ray &ray, Int3 voxel, double margin) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  double enter = 0, leave = kNever;
  for (int axis = 0; axis < 3; ++axis) {
    const double origin = ray.origin[axis], direction = ray.direction[axis];
    const double low = voxel[axis] - margin, high = voxel[axis] + 1 + margin;
    if (direction == 0) {
      if (origin < low || origin > high)
        return kNever;
      continue;
    }
    const double a = (low - origin) / direction, b = (high - origin) / direction;
    enter = std::max(enter, direction > 0 ? a : b);
    leave = std::min(leave, direction > 0 ? b : a);
  }
  return enter <= leave ? enter : kNever;
}

double marginFor(const Ray &ray, const Hit &exact, const Hit &hit) {
  double scale = 1;
  for (int axis = 0; axis < 3; ++axis)
    scale = std::max(
        {scale, std::abs(double{ray.origin[axis]}), double(exact.voxel[axis]), double(hit.voxel[axis])});
  return scale * kRelativeMargin;
}

bool areNeighbours(const Hit &a, const Hit &b) {
  const Int3 apart = voxelOf(a) - voxelOf(b);
  return std::max({std::abs(apart.x), std::abs(apart.y), std::abs(apart.z)}) <= 1;
}

/// The rule of `ErrorFigures::boundary` for a ray on which the two hits differ.
bool isExplained(const Oracle &oracle, const Ray &ray, const Hit &exact, const Hit &hit) {
  if (!isFinite(ray))
    return false;
  if (exact.isHit() && hit.isHit() && areNeighbours(exact, hit))
    return true;
  const double margin = marginFor(ray, exact, hit);
  double reached = std::numeric_limits<double>::infinity();
  if (hit.isHit()) {
    reached = meets(ray, voxelOf(hit), margin);
    if (std::isinf(reached) || oracle.voxel(voxelOf(hit)) == 0)
      return false;
  }
  return !exact.isHit() || (hit.isHit() && reached <= meets(ray, voxelOf(exact), margin)) ||
         std::isinf(meets(ray, voxelOf(exact), -margin));
}

/// Adds up figures, ray by ray.
class Comparison {
public:
  Comparison(const Oracle &oracle, const Question &question) : oracle_(oracle), question_(question) {}

  void add(const Ray &ray, const RayBounds &bounds, const Hit &closest, const Hit &hit) {
    const bool isOfPoint = isOfPoints(question_.query);
    const Hit exact = isOfPoint ? oracle_.answer(ray, question_) : closest;
    if (exact.isHit() != hit.isHit() || (exact.isHit() && !isSameVoxel(ray, bounds, exact, hit)))
      addDifference(ray, exact, hit);
    else if (exact.isHit())
      addTimes(ray, exact, hit);
    ++figures_.rays;
  }

  ErrorFigures figures() && {
    const auto count = static_cast<double>(figures_.sameVoxel);
    figures_.rmsDt = count == 0 ? 0 : std::sqrt(sumOfSquares_ / count);
    return std::move(figures_);
  }

private:
  /// As far as that is asked, and by which of its faces it is entered.
  bool isSameVoxel(const Ray &ray, const RayBounds &bounds, const Hit &exact, const Hit &hit) const {
    const Outputs &asked = question_.outputs;
    return (!asked.voxel || voxelOf(exact) == voxelOf(hit)) &&
           (!asked.face || oracle_.answer(ray, question_, bounds).steps == hit.steps);
  }

  void addDifference(const Ray &ray, const Hit &exact, const Hit &hit) {
    ++(!hit.isHit() ? figures_.missed : !exact.isHit() ? figures_.ghost : figures_.wrong);
    const bool isKnown = question_.outputs.voxel || !hit.isHit();
    figures_.boundary += isKnown && isExplained(oracle_, ray, exact, hit);
    addExample();
  }

  void addTimes(const Ray &ray, const Hit &exact, const Hit &hit) {
    ++figures_.sameVoxel;
    // Most hits of a good kernel agree to the last bit: nothing is left to measure.
    if (std::memcmp(&exact, &hit, offsetof(Hit, steps)) == 0)
      return;
    if (question_.outputs.t)
      addDifferenceOfTimes(ray, exact, hit);
    if (question_.outputs.colour && exact.rgba != hit.rgba) {
      ++figures_.colour;
      addExample();
    }
  }

  void addDifferenceOfTimes(const Ray &ray, const Hit &exact, const Hit &hit) {
    const double difference = std::abs(timeOf(hit) - timeOf(exact));
    const double distance = difference * length(ray.direction);
    const double ulps = difference / unitInLastPlace(exact);
    if (ulps > figures_.maxUlpDt)
      figures_.latest = figures_.rays;
    figures_.maxDt = std::max(figures_.maxDt, distance);
    figures_.maxUlpDt = std::max(figures_.maxUlpDt, ulps);
    sumOfSquares_ += distance * distance;
  }

  void addExample() {
    if (figures_.examples.size() < kMaxExamples)
      figures_.examples.push_back(figures_.rays);
  }

  const Oracle &oracle_;
  const Question &question_;
  ErrorFigures figures_;
  double sumOfSquares_ = 0;
};

/// The mean of two mean squares.
double joinedMeanSquare(const ErrorFigures &a, const ErrorFigures &b) {
  const auto countA = static_cast<double>(a.sameVoxel), countB = static_cast<double>(b.sameVoxel);
  return countA + countB == 0 ? 0
                              : (a.rmsDt * a.rmsDt * countA + b.rmsDt * b.rmsDt * countB) / (countA + countB);
}

} // namespace

void ErrorFigures::append(const ErrorFigures &further) {
  rmsDt = std::sqrt(joinedMeanSquare(*this, further));
  if (further.maxUlpDt > maxUlpDt)
    latest = rays + further.latest;
  maxUlpDt = std::max(maxUlpDt, further.maxUlpDt);
  maxDt = std::max(maxDt, further.maxDt);
  for (const std::uint64_t index : further.examples)
    if (examples.size() < kMaxExamples)
      examples.push_back(rays + index);
  for (const auto count :
       {&ErrorFigures::rays, &ErrorFigures::missed, &ErrorFigures::ghost, &ErrorFigures::wrong,
        &ErrorFigures::colour, &ErrorFigures::boundary, &ErrorFigures::sameVoxel})
    this->*count += further.*count;
}

ErrorFigures compare(const Oracle &oracle, RaySpan rays, std::span<const Hit> exact,
                     std::span<const Hit> hits, const Question &question) {
  std::vector<ErrorFigures> parts(rangeCount(rays.size()));
  forEachRange(rays.size(), [&](std::size_t part, std::size_t begin, std::size_t end) {
    Comparison comparison(oracle, question);
    for (std::size_t i = begin; i < end; ++i)
      comparison.add(rays[i], rays.bounds(i), exact[i], hits[i]);
    parts[part] = std::move(comparison).figures();
  });
  ErrorFigures figures;
  for (const ErrorFigures &part : parts)
    figures.append(part);
  return figures;
}

ErrorFigures compare(const Oracle &oracle, RaySpan rays, std::span<const Hit> hits,
                     const Question &question) {
  // Nothing asks this to stop, so there are hits.
  return compare(oracle, rays, *oracle.trace(rays), hits, question);
}

} // namespace voxc
