// Rounding words as they are read, and measuring by how much.
#include "voxc/Source/Rounding.h"

#include "CubeTools.h"

#include <algorithm>
#include <cstdlib>
#include <mutex>
#include <utility>

namespace voxc {
namespace {

int channel(std::uint32_t word, std::size_t i) { return static_cast<int>(word >> 8 * i & 255); }

} // namespace

struct RoundedSource::Tally {
  std::mutex mutex; ///< Guards what follows.
  std::array<int, 4> largest{};
  std::array<std::uint64_t, 4> sum{};
  std::uint64_t voxels = 0;
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

void RoundedSource::read(const Cube &cube, std::uint32_t *words) {
  source_->read(cube, words);
  std::array<int, 4> largest{};
  std::array<std::uint64_t, 4> sum{};
  std::uint64_t voxels = 0;
  for (std::uint64_t at = 0; at < cellCount(cube.log2Side); ++at) {
    if (words[at] == 0)
      continue;
    const std::uint32_t rounded = rounding_(words[at]);
    for (std::size_t i = 0; i < 4; ++i) {
      const int error = std::abs(channel(rounded, i) - channel(words[at], i));
      largest[i] = std::max(largest[i], error);
      sum[i] += static_cast<std::uint64_t>(error);
    }
    words[at] = rounded;
    ++voxels;
  }
  const std::lock_guard lock(tally_->mutex);
  for (std::size_t i = 0; i < 4; ++i) {
    tally_->largest[i] = std::max(tally_->largest[i], largest[i]);
    tally_->sum[i] += sum[i];
  }
  tally_->voxels += voxels;
}

ColourError RoundedSource::error() const {
  const std::lock_guard lock(tally_->mutex);
  ColourError error{.largest = tally_->largest, .voxels = tally_->voxels};
  for (std::size_t i = 0; i < 4 && error.voxels > 0; ++i)
    error.mean[i] = static_cast<double>(tally_->sum[i]) / static_cast<double>(error.voxels);
  return error;
}

} // namespace voxc
