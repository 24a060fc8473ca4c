// Rounding words as they are read, and measuring by how much.
#include "voxc/Source/Rounding.h"

#include "CubeTools.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <mutex>
#include <utility>

namespace voxc {
namespace {

int channel(std::uint32_t word, std::size_t i) { return static_cast<int>(word >> 8 * i & 255); }

} // namespace

void ColourErrorSum::add(std::uint32_t word, std::uint32_t rounded) {
  for (std::size_t i = 0; i < 4; ++i) {
    const int error = std::abs(channel(rounded, i) - channel(word, i));
    largest_[i] = std::max(largest_[i], error);
    sum_[i] += static_cast<std::uint64_t>(error);
    squares_[i] += static_cast<std::uint64_t>(error * error);
  }
  ++voxels_;
}

void ColourErrorSum::add(const ColourErrorSum &other) {
  for (std::size_t i = 0; i < 4; ++i) {
    largest_[i] = std::max(largest_[i], other.largest_[i]);
    sum_[i] += other.sum_[i];
    squares_[i] += other.squares_[i];
  }
  voxels_ += other.voxels_;
}

ColourError ColourErrorSum::error() const {
  ColourError error{.largest = largest_, .voxels = voxels_};
  const auto voxels = static_cast<double>(voxels_);
  for (std::size_t i = 0; i < 4 && voxels_ > 0; ++i) {
    error.mean[i] = static_cast<double>(sum_[i]) / voxels;
    error.rms[i] = std::sqrt(static_cast<double>(squares_[i]) / voxels);
  }
  return error;
}

struct RoundedSource::Tally {
  std::mutex mutex; ///< Guards what follows.
  ColourErrorSum sum;
};

RoundedSource::RoundedSource(VoxelSource &source, Rounding rounding)
    : source_(&source), rounding_(std::move(rounding)), tally_(std::make_shared<Tally>()) {}

RoundedSource::RoundedSource(std::unique_ptr<VoxelSource> source, Rounding rounding,
                             std::shared_ptr<Tally> tally)
    : owned_(std::move(source)), source_(owned_.get()), rounding_(std::move(rounding)),
      tally_(std::move(tally)) {}

std::unique_ptr<VoxelSource> RoundedSource::view() const {
  auto view = source_->view();
  return view ? std::unique_ptr<VoxelSource>(new RoundedSource(std::move(view), rounding_, tally_)) : nullptr;
}

Expected<void> RoundedSource::read(const Cube &cube, std::uint32_t *words) {
  VOXC_TRY(source_->read(cube, words));
  ColourErrorSum sum;
  for (std::uint64_t at = 0; at < cellCount(cube.log2Side); ++at) {
    if (words[at] == 0)
      continue;
    const std::uint32_t rounded = rounding_(words[at]);
    sum.add(words[at], rounded);
    words[at] = rounded;
  }
  const std::lock_guard lock(tally_->mutex);
  tally_->sum.add(sum);
  return {};
}

ColourError RoundedSource::error() const {
  const std::lock_guard lock(tally_->mutex);
  return tally_->sum.error();
}

} // namespace voxc
