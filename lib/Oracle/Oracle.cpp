// The oracle: voxels as runs, of a volume or a source, and the exact traversal over them.
#include "voxc/Oracle/Oracle.h"

#include "ExactTraversal.h"
#include "ParallelRanges.h"
#include "VoxelRuns.h"

#include <algorithm>
#include <array>
#include <string>

namespace voxc {

namespace {

// A run takes twelve bytes.
constexpr std::size_t kMaxRuns = std::size_t{1} << 29;

Error tooManyRuns() {
  return Error::input("the voxels fall into " + std::to_string(kMaxRuns) +
                      " runs of equal ones or more, which are too many to be checked one by one");
}

/// Asks a source for all its voxels, cube by cube in Morton order.
class SourceReader {
public:
  SourceReader(VoxelSource &source, VoxelRuns &runs, const Progress &progress)
      : source_(source), runs_(runs), progress_(progress) {}

  Expected<void> read() {
    return readCube({{0, 0, 0}, std::max(log2BoundingSide(source_.extent()), kLog2Brick)});
  }

private:
  static constexpr int kLog2Brick = 3;

  Expected<void> readCube(const Cube &cube) {
    if (progress_.stopped())
      return Error::interrupted();
    if (source_.empty(cube))
      return {};
    if (cube.log2Side == kLog2Brick)
      return readBrick(cube);
    const int half = cube.log2Side - 1;
    for (std::uint64_t child = 0; child < 8; ++child)
      VOXC_TRY(readCube({cube.low + mortonCell(child) * (1 << half), half}));
    return {};
  }

  Expected<void> readBrick(const Cube &brick) {
    VOXC_TRY(source_.read(brick, words_.data()));
    for (std::size_t i = 0; i < words_.size(); ++i)
      if (words_[i] != 0)
        runs_.add({brick.low + mortonCell(i), 0}, words_[i]);
    return runs_.size() >= kMaxRuns ? Expected<void>(tooManyRuns()) : Expected<void>();
  }

  VoxelSource &source_;
  VoxelRuns &runs_;
  const Progress &progress_;
  std::array<std::uint32_t, 1 << 3 * kLog2Brick> words_{};
};

} // namespace

struct Oracle::State {
  VoxelRuns voxels;
};

Expected<Oracle> Oracle::of(const Volume &volume, const Progress &progress) {
  auto state = std::make_unique<State>(State{VoxelRuns(volume.format().extent())});
  const auto add = [&](const Cube &cube, std::uint32_t word) {
    state->voxels.add(cube, word);
    return state->voxels.size() < kMaxRuns;
  };
  VOXC_TRY(decode(volume, add, progress));
  if (state->voxels.size() >= kMaxRuns)
    return tooManyRuns();
  state->voxels.finish();
  return Oracle(std::move(state));
}

Expected<Oracle> Oracle::of(VoxelSource &source, const Progress &progress) {
  auto state = std::make_unique<State>(State{VoxelRuns(source.extent())});
  VOXC_TRY(SourceReader(source, state->voxels, progress).read());
  state->voxels.finish();
  return Oracle(std::move(state));
}

Oracle::Oracle(std::unique_ptr<State> state) : state_(std::move(state)) {}
Oracle::~Oracle() = default;
Oracle::Oracle(Oracle &&) noexcept = default;

Hit Oracle::trace(const Ray &ray, const RayBounds &bounds) const {
  return traceExactly(state_->voxels, ray, bounds);
}

std::uint32_t faceNumber(const Face &face) {
  return face.axis < 0 ? 6 : static_cast<std::uint32_t>(2 * face.axis + (face.side > 0 ? 1 : 0));
}

Hit Oracle::answer(const Ray &ray, const Question &question, const RayBounds &bounds) const {
  const Outputs &outputs = question.outputs;
  Hit hit = isOfPoints(question.query) ? hitAtOrigin(state_->voxels, ray) : trace(ray, bounds);
  if (!hit.isHit())
    return hit;
  if (!outputs.voxel)
    std::ranges::fill(hit.voxel, 0);
  hit.rgba = outputs.colour ? hit.rgba : 0;
  hit.t = outputs.t ? hit.t : 0;
  hit.steps = outputs.face ? faceNumber(explain(ray, 0, bounds).face) : 0;
  return hit;
}

Expected<std::vector<Hit>> Oracle::trace(RaySpan rays, unsigned threads, const Progress &progress) const {
  std::vector<Hit> hits(rays.size());
  const auto traceRange = [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      hits[i] = trace(rays[i], rays.bounds(i));
  };
  VOXC_TRY(forEachRange(rays.size(), threads, progress, traceRange));
  return hits;
}

Explanation Oracle::explain(const Ray &ray, std::size_t maxCells, const RayBounds &bounds) const {
  return explainExactly(state_->voxels, ray, maxCells, bounds);
}

std::vector<Int3> Oracle::sampleVoxels(std::size_t count) const { return state_->voxels.sample(count); }

std::uint32_t Oracle::voxel(Int3 cell) const {
  return contains(state_->voxels.extent(), cell) ? state_->voxels.word(cell) : 0;
}

} // namespace voxc
