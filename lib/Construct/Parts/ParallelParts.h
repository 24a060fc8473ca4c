// Parts built by several threads, handed over in Morton order.
#pragma once

#include "PartBuilder.h"
#include "PartStream.h"

#include "Source/CubeTools.h"

#include <atomic>
#include <condition_variable>
#include <map>
#include <mutex>
#include <thread>

namespace voxc {

/// Builds the parts of a range on threads of its own. No more than a few parts a thread wait to be taken, so
/// that memory stays bounded.
class ParallelParts final : public PartStream {
public:
  /// The parts of `grid` that cover its smallest ones [begin, end). Errors: the source has but one reader; no
  /// memory.
  static Expected<std::unique_ptr<ParallelParts>>
  start(const VoxelSource &source, const ConstructCode &code, const Layout &layout, const PartGrid &grid,
        std::uint64_t begin, std::uint64_t end, unsigned threads,
        const std::shared_ptr<WorkingMemory> &memory, const Progress &progress);
  ~ParallelParts() override;

  Next<Cube> next() override;
  Expected<Fragment> take() override;

  /// How many of the smallest parts were looked at so far.
  std::uint64_t looked();

private:
  ParallelParts(std::unique_ptr<VoxelSource> source, const PartGrid &grid, std::uint64_t begin,
                std::uint64_t end, unsigned threads, const Progress &progress)
      : source_(std::move(source)), progress_(progress.silent()),
        sequence_(
            grid, begin, end,
            [this](const Cube &cube) { return isOutside(cube, source_->extent()) || source_->empty(cube); }),
        share_(end - begin), window_(kPartsAhead * threads) {}

  static constexpr std::uint64_t kPartsAhead = 8;

  struct Job {
    std::uint64_t number;
    Cube cube;
  };
  struct Built {
    Cube cube;
    Expected<Fragment> fragment;
  };

  Expected<void> startThreads(std::vector<PartBuilder> builders);
  std::optional<Job> nextJob();
  void work(PartBuilder builder);
  void buildAll(PartBuilder &builder);

  std::unique_ptr<VoxelSource> source_;
  Progress progress_; ///< For the builders: no more than whether to stop.

  std::mutex mutex_; ///< Guards what follows.
  std::condition_variable changed_;
  PartSequence sequence_;
  std::uint64_t share_; ///< The smallest parts that the sequence is to look at.
  std::uint64_t window_;
  std::uint64_t started_ = 0; ///< Parts that the sequence has given.
  std::uint64_t taken_ = 0;
  std::optional<std::uint64_t> end_; ///< How many parts there are, once known.
  bool abandoned_ = false;
  std::optional<Error> failure_;         ///< Of a thread that can go on no more.
  std::map<std::uint64_t, Built> built_; ///< By number.

  std::vector<std::thread> threads_;
};

} // namespace voxc
