// One pass over a source, cube by cube in Morton order, that hands each brick to all tallies.
#include "voxc/Facts/Facts.h"

#include "Brick.h"
#include "ColourTally.h"
#include "HeightTally.h"
#include "InteriorTally.h"
#include "PlaceTally.h"
#include "RepetitionTally.h"

#include <algorithm>
#include <bit>
#include <optional>

namespace voxc {

namespace {

constexpr unsigned kBricksBetweenReports = 256;

int log2BoundingSide(Int3 extent) {
  const auto longest = static_cast<std::uint32_t>(std::max({extent.x, extent.y, extent.z, 1}));
  return static_cast<int>(std::bit_width(longest - 1));
}

class Measurement {
public:
  Measurement(VoxelSource &source, const FactsOptions &options, const Progress &progress)
      : source_(source), progress_(progress), log2Extent_(log2BoundingSide(source.extent())),
        colours_(options.mostWords), repetition_(options.mostBlocks), places_(log2Extent_),
        interior_(options.memory ? options.memory : WorkingMemory::createDefault()) {}

  Expected<Facts> run() {
    read({{0, 0, 0}, std::max(log2Extent_, Brick::kLog2Side)});
    if (error_)
      return *error_;
    return facts();
  }

private:
  /// What a cube tells the one that it is part of.
  struct Part {
    Filling filling;
    Digests digests;
  };

  Part read(const Cube &cube) {
    if (progress_.stopped())
      error_ = Error::interrupted();
    if (error_ || source_.empty(cube))
      return {};
    return cube.log2Side == Brick::kLog2Side ? readBrick(cube) : readChildren(cube);
  }

  Part readChildren(const Cube &cube) {
    const int half = cube.log2Side - 1;
    std::array<Filling, 8> fillings;
    std::array<Digests, 8> digests;
    for (unsigned child = 0; child < 8; ++child) {
      Part part = read({cube.low + mortonCell(child) * (1 << half), half});
      fillings[child] = part.filling;
      digests[child] = part.digests;
    }
    const Filling filling = heights_.ofChildren(fillings, cube.log2Side);
    return filling.voxels == 0 ? Part{} : Part{filling, repetition_.ofChildren(digests, cube.log2Side)};
  }

  Part readBrick(const Cube &cube) {
    brick_.low = cube.low;
    if (auto done = source_.read(cube, brick_.words.data()); !done) {
      error_ = done.error();
      return {};
    }
    if (bricks_++ % kBricksBetweenReports == 0)
      report();
    if (!brick_.findBits())
      return {};
    places_.add(brick_);
    colours_.add(brick_);
    if (auto added = interior_.add(brick_); !added)
      error_ = added.error();
    return {heights_.ofBrick(brick_), repetition_.ofBrick(brick_)};
  }

  void report() {
    const double codes = static_cast<double>(std::uint64_t{1} << 3 * log2Extent_);
    progress_.at("measure", static_cast<double>(mortonCode(brick_.low)) / codes, heights_.facts(0).occupied);
  }

  Facts facts() {
    Facts facts;
    facts.extent = source_.extent();
    facts.log2Extent = log2Extent_;
    facts.voxels = heights_.facts(0).occupied;
    facts.boxLow = places_.boxLow();
    facts.boxHigh = places_.boxHigh();
    facts.interior = interior_.finish();
    for (int height = 0; height <= log2Extent_; ++height)
      facts.heights.push_back(heights_.facts(height));
    facts.regions = places_.regions();
    facts.colours = colours_.finish();
    for (int height = 1; height <= std::min(log2Extent_, RepetitionTally::kHeights); ++height)
      facts.repetition.push_back(repetition_.facts(height));
    return facts;
  }

  VoxelSource &source_;
  const Progress &progress_;
  int log2Extent_;
  Brick brick_{};
  std::uint64_t bricks_ = 0;
  std::optional<Error> error_;

  HeightTally heights_;
  ColourTally colours_;
  RepetitionTally repetition_;
  PlaceTally places_;
  InteriorTally interior_;
};

} // namespace

int ColourFacts::indexBits() const { return words.count < 2 ? 0 : std::bit_width(words.count - 1); }

double Facts::fill() const {
  const Int3 box = boxHigh - boxLow;
  return voxels == 0 ? 0 : static_cast<double>(voxels) / (double(box.x) * double(box.y) * double(box.z));
}

double Facts::interiorShare() const {
  return voxels == 0 ? 0 : static_cast<double>(interior) / static_cast<double>(voxels);
}

double Facts::branching(int height) const {
  if (height < 1 || voxels == 0)
    return 0;
  const auto at = static_cast<std::size_t>(height);
  return static_cast<double>(heights[at - 1].occupied) / static_cast<double>(heights[at].occupied);
}

Expected<Facts> measureFacts(VoxelSource &source, const FactsOptions &options, const Progress &progress) {
  return Measurement(source, options, progress).run();
}

} // namespace voxc
