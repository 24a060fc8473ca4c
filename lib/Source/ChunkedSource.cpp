// A source of lists: the chunk that was asked for last is kept as bricks.
#include "Source/ChunkedSource.h"

#include "Source/ChunkBricks.h"
#include "Source/CubeTools.h"
#include "voxc/Support/Stopwatch.h"

#include <algorithm>
#include <atomic>
#include <utility>

namespace voxc {

namespace {

class ChunkedSource final : public VoxelSource {
public:
  using Seconds = std::atomic<double>;

  ChunkedSource(Int3 extent, std::unique_ptr<ChunkLists> lists, const Transform &voxelToModel,
                std::shared_ptr<Seconds> seconds)
      : extent_(extent), lists_(std::move(lists)), voxelToModel_(voxelToModel), seconds_(std::move(seconds)) {
  }

  Int3 extent() const override { return extent_; }
  Transform voxelToModel() const override { return voxelToModel_; }
  int log2Chunk() const override { return ChunkBricks::kLog2Chunk; }
  double readSeconds() const override { return *seconds_; }

  std::unique_ptr<VoxelSource> view() const override {
    auto lists = lists_->view();
    return lists ? std::make_unique<ChunkedSource>(extent_, std::move(lists), voxelToModel_, seconds_)
                 : nullptr;
  }

  bool empty(const Cube &cube) override {
    if (isOutside(cube, extent_))
      return true;
    if (cube.log2Side >= ChunkBricks::kLog2Chunk)
      return lists_->empty(cube);
    return load(cube.low >> ChunkBricks::kLog2Chunk) && bricks_.empty(cube);
  }

  Expected<void> read(const Cube &cube, std::uint32_t *words) override {
    if (isOutside(cube, extent_)) {
      std::fill_n(words, cellCount(cube.log2Side), 0u);
      return {};
    }
    VOXC_TRY(load(cube.low >> ChunkBricks::kLog2Chunk));
    bricks_.read(cube, words);
    return {};
  }

private:
  Expected<void> load(Int3 chunk) {
    if (chunk == chunk_)
      return {};
    const Stopwatch watch;
    const auto voxels = VOXC_TRY(lists_->voxels(chunk));
    bricks_.fill(voxels);
    chunk_ = chunk;
    seconds_->fetch_add(watch.seconds(), std::memory_order_relaxed);
    return {};
  }

  Int3 extent_;
  std::unique_ptr<ChunkLists> lists_;
  Transform voxelToModel_;
  std::shared_ptr<Seconds> seconds_; ///< Of all views.
  ChunkBricks bricks_;
  Int3 chunk_{-1, -1, -1}; ///< The one that `bricks_` holds.
};

} // namespace

std::unique_ptr<VoxelSource> makeChunkedSource(Int3 extent, std::unique_ptr<ChunkLists> lists,
                                               const Transform &voxelToModel) {
  return std::make_unique<ChunkedSource>(extent, std::move(lists), voxelToModel,
                                         std::make_shared<ChunkedSource::Seconds>(0));
}

} // namespace voxc
