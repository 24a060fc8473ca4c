// Colours in place of others: what a lossy payload keeps of a source, and how far that is from it.
#pragma once

#include "voxc/Source/VoxelSource.h"
#include "voxc/Support/Progress.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>

namespace voxc {

/// How far colours are from those that stand for them, in steps of 1/255; of R, G, B and alpha.
struct ColourError {
  std::array<int, 4> largest{};
  std::array<double, 4> mean{};
  std::array<double, 4> rms{}; ///< The root of the mean square.
  std::uint64_t voxels = 0;    ///< Over so many.
};

/// Sums up the errors of colours.
class ColourErrorSum {
public:
  void add(std::uint32_t word, std::uint32_t rounded);
  void add(const ColourErrorSum &other);
  ColourError error() const;

private:
  std::array<int, 4> largest_{};
  std::array<std::uint64_t, 4> sum_{};
  std::array<std::uint64_t, 4> squares_{};
  std::uint64_t voxels_ = 0;
};

/// The word that stands for a word; neither is 0. May be called by several threads.
using Rounding = std::function<std::uint32_t(std::uint32_t word)>;

/// The voxels of a source, which outlives this, in other colours. Views of it measure together.
class RoundedSource final : public VoxelSource {
public:
  RoundedSource(VoxelSource &source, Rounding rounding);

  Int3 extent() const override { return source_->extent(); }
  bool empty(const Cube &cube) override { return source_->empty(cube); }
  Expected<void> read(const Cube &cube, std::uint32_t *words) override;
  std::unique_ptr<VoxelSource> view() const override;
  int log2Chunk() const override { return source_->log2Chunk(); }
  double readSeconds() const override { return source_->readSeconds(); }
  Transform voxelToModel() const override { return source_->voxelToModel(); }

  /// Of all voxels that were read so far, as often as they were.
  ColourError error() const;

private:
  struct Tally;
  RoundedSource(std::unique_ptr<VoxelSource> source, Rounding rounding, std::shared_ptr<Tally> tally);

  std::unique_ptr<VoxelSource> owned_; ///< Of a view.
  VoxelSource *source_;
  Rounding rounding_;
  std::shared_ptr<Tally> tally_;
};

/// At most `most` colours that stand for those of a source, by variance cuts and, of up to 256, some steps of
/// k-means (Lloyd), over its colours in 64 steps a channel; or null if it has no more colours than that.
/// Reads the source once. Errors: the source's, interrupted.
Expected<Rounding> reduceColours(VoxelSource &source, std::size_t most, const Progress &progress = {});

} // namespace voxc
