// Resampling axis by axis.
#include "Input/Dense/Resample.h"

#include "Input/Dense/DenseCells.h"
#include "Input/Openers/InputText.h"
#include "Source/GridExtent.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace voxc {

namespace {

/// Of a cell: what is less beyond a whole number comes of rounding.
constexpr double kRounding = 0x1p-24;

/// Where the cubes lie along an axis, in samples.
struct SampledAxis {
  std::int32_t samples = 0;
  double origin = 0; ///< Of the first cube; at most 0.
  double side = 1;

  std::int32_t cubes() const {
    const double count = std::ceil((samples - origin) / side - kRounding);
    return static_cast<std::int32_t>(std::clamp(count, 1.0, double((1 << kMaxLog2Extent) + 1)));
  }
};

/// Samples that a cube is made of, from `first` on, each with its weight.
struct Taps {
  std::int32_t first = 0;
  std::vector<double> weights;
};

/// The sample at the middle; none beside the volume.
Taps nearest(const SampledAxis &axis, std::int32_t cube) {
  const double middle = axis.origin + (cube + 0.5) * axis.side;
  if (middle < 0 || middle >= axis.samples)
    return {};
  return {static_cast<std::int32_t>(middle), {1}};
}

Taps tapsOf(const SampledAxis &axis, std::int32_t cube) {
  const double low = axis.origin + cube * axis.side, high = low + axis.side;
  Taps taps;
  if (axis.side >= 1) {
    taps.first = std::max(0, static_cast<std::int32_t>(std::floor(low + kRounding)));
    for (std::int32_t i = taps.first; i < axis.samples && i < high - kRounding; ++i)
      taps.weights.push_back(std::min(high, i + 1.0) - std::max(low, double(i)));
    return taps;
  }
  const double middle = (low + high) / 2;
  if (middle < 0 || middle >= axis.samples)
    return {};
  const double between = std::clamp(middle - 0.5, 0.0, axis.samples - 1.0);
  taps.first = static_cast<std::int32_t>(between);
  taps.weights = {1 - (between - taps.first)};
  if (taps.weights[0] < 1)
    taps.weights.push_back(1 - taps.weights[0]);
  return taps;
}

/// The words at the middles of cubes.
class NearestRows final : public DenseRows {
public:
  NearestRows(std::shared_ptr<const DenseRows> rows, const std::array<SampledAxis, 3> &axes)
      : rows_(std::move(rows)), axes_(axes) {}

  void read(Int3 first, std::int32_t count, std::uint32_t *words) const override {
    std::fill_n(words, count, 0u);
    const Taps y = nearest(axes_[1], first.y), z = nearest(axes_[2], first.z);
    if (y.weights.empty() || z.weights.empty())
      return;
    std::int32_t last = -1;
    for (std::int32_t i = 0; i < count; ++i) {
      const Taps x = nearest(axes_[0], first.x + i);
      if (x.weights.empty())
        continue;
      if (x.first == last)
        words[i] = words[i - 1];
      else
        rows_->read({x.first, y.first, z.first}, 1, words + i);
      last = x.first;
    }
  }

private:
  std::shared_ptr<const DenseRows> rows_;
  std::array<SampledAxis, 3> axes_;
};

/// The words of means of samples, and of what lies between them. What is no number counts for nothing. A mean
/// is from the least to the greatest of its samples, whatever its sum was rounded to: where all of them reach
/// the threshold, it does.
class MeanRows final : public DenseRows {
public:
  MeanRows(DenseVolume volume, const SampleMap &map, const std::array<SampledAxis, 3> &axes)
      : volume_(std::move(volume)), map_(map), axes_(axes), steps_(stepsOf(volume_)) {}

  void read(Int3 first, std::int32_t count, std::uint32_t *words) const override {
    std::vector<Taps> taps;
    std::int32_t low = volume_.extent.x, high = 0;
    for (std::int32_t i = 0; i < count; ++i) {
      taps.push_back(tapsOf(axes_[0], first.x + i));
      if (!taps.back().weights.empty())
        low = std::min(low, taps.back().first);
      high = std::max(high, taps.back().first + static_cast<std::int32_t>(taps.back().weights.size()));
    }
    std::fill_n(words, count, 0u);
    if (low >= high)
      return;
    const Line line = lineOf(low, high - low, tapsOf(axes_[1], first.y), tapsOf(axes_[2], first.z));
    for (std::int32_t i = 0; i < count; ++i) {
      double sum = 0, weight = 0;
      SampleRange range;
      const Taps &tap = taps[static_cast<std::size_t>(i)];
      for (std::size_t j = 0; j < tap.weights.size(); ++j) {
        const auto at = static_cast<std::size_t>(tap.first - low) + j;
        sum += tap.weights[j] * line.sums[at];
        weight += tap.weights[j] * line.weights[at];
        range.low = std::min(range.low, line.ranges[at].low);
        range.high = std::max(range.high, line.ranges[at].high);
      }
      if (weight > 0)
        words[i] = map_.wordOf(std::clamp(sum / weight, range.low, range.high));
    }
  }

private:
  struct Line {
    std::vector<double> sums, weights;
    std::vector<SampleRange> ranges;
  };

  /// The samples from `x` on, put together along y and z.
  Line lineOf(std::int32_t x, std::int32_t count, const Taps &y, const Taps &z) const {
    const auto size = static_cast<std::size_t>(count);
    const std::size_t bytes = byteSize(volume_.layout.type);
    Line line{std::vector<double>(size), std::vector<double>(size), std::vector<SampleRange>(size)};
    std::vector<std::byte> samples(size * bytes);
    std::vector<double> values(size);
    for (std::size_t k = 0; k < z.weights.size(); ++k)
      for (std::size_t j = 0; j < y.weights.size(); ++j) {
        const std::int64_t offset = steps_[0] * x + steps_[1] * (y.first + static_cast<std::int64_t>(j)) +
                                    steps_[2] * (z.first + static_cast<std::int64_t>(k));
        gatherSamples(volume_.samples + offset, steps_[0], size, bytes, samples.data());
        loadSamples(volume_.layout, samples.data(), size, values.data());
        const double weight = z.weights[k] * y.weights[j];
        for (std::size_t i = 0; i < size; ++i)
          if (std::isfinite(values[i])) {
            const double value = map_.value(values[i]);
            line.sums[i] += weight * value;
            line.weights[i] += weight;
            line.ranges[i] = {std::min(line.ranges[i].low, value), std::max(line.ranges[i].high, value)};
          }
      }
    return line;
  }

  DenseVolume volume_;
  SampleMap map_;
  std::array<SampledAxis, 3> axes_;
  std::array<std::int64_t, 3> steps_;
};

/// Where cubes of a side lie in the samples.
Expected<std::array<SampledAxis, 3>> axesOf(const DenseVolume &volume, double side,
                                            const InputOptions &options) {
  const std::array<double, 3> spacing = stepLengths(volume.sampleToModel);
  glm::dvec3 point(0);
  if (options.align)
    point = glm::dvec3(glm::inverse(glm::dmat4(volume.sampleToModel)) *
                       glm::dvec4((*options.align)[0], (*options.align)[1], (*options.align)[2], 1));
  std::array<SampledAxis, 3> axes;
  for (int i = 0; i < 3; ++i) {
    SampledAxis &axis = axes[static_cast<std::size_t>(i)];
    axis.samples = volume.extent[i];
    axis.side = side / spacing[static_cast<std::size_t>(i)];
    if (!(axis.side > 0) || !std::isfinite(axis.side) || !std::isfinite(point[i]))
      return Error::input("its samples are " + byThree(spacing) + " apart, which no cubes of side " +
                          toText(side) + " can be made of");
    axis.origin = point[i] - std::ceil(point[i] / axis.side - kRounding) * axis.side;
    axis.origin = std::abs(axis.origin) < kRounding * axis.side ? 0 : axis.origin;
  }
  return axes;
}

} // namespace

std::array<double, 3> stepLengths(const Transform &sampleToModel) {
  std::array<double, 3> lengths{};
  for (int axis = 0; axis < 3; ++axis)
    lengths[static_cast<std::size_t>(axis)] = glm::length(glm::dvec3(sampleToModel[axis]));
  return lengths;
}

Expected<Resampled> resample(DenseVolume volume, const SampleMap &map, double side,
                             const InputOptions &options) {
  const auto axes = VOXC_TRY(axesOf(volume, side, options));
  Resampled made;
  made.extent = {axes[0].cubes(), axes[1].cubes(), axes[2].cubes()};
  Int3 holds = options.mostExtent();
  if (options.zUp)
    std::swap(holds.y, holds.z);
  VOXC_TRY(checkGridExtent(made.extent));
  if (made.extent.x > holds.x || made.extent.y > holds.y || made.extent.z > holds.z)
    return Error::input("with voxels of side " + toText(side) + " it takes " + extentText(made.extent) +
                        " voxels, but the format holds " + extentText(holds) +
                        "; make the voxels larger or the format");
  made.voxelToModel = volume.sampleToModel;
  for (int axis = 0; axis < 3; ++axis) {
    made.voxelToModel[3] += volume.sampleToModel[axis] * axes[static_cast<std::size_t>(axis)].origin;
    made.voxelToModel[axis] = volume.sampleToModel[axis] * axes[static_cast<std::size_t>(axis)].side;
  }
  const bool isMeasured =
      volume.channels == 1 && map.threshold && !map.labels && map.kept == SampleMap::Kept::No;
  if (isMeasured)
    made.rows = std::make_shared<MeanRows>(std::move(volume), map, axes);
  else
    made.rows = std::make_shared<NearestRows>(makeRows(std::move(volume), map), axes);
  return made;
}

} // namespace voxc
