// The oracle: a volume decoded into runs, and the exact walk over them.
#include "voxc/Oracle/Oracle.h"

#include "ExactWalk.h"
#include "VoxelRuns.h"

namespace voxc {

struct Oracle::State {
  VoxelRuns voxels;
};

Oracle::Oracle(const Volume &volume)
    : state_(std::make_unique<State>(State{VoxelRuns(volume.format().extent())})) {
  decode(volume, [this](const Cube &cube, std::uint32_t word) { state_->voxels.add(cube, word); });
  state_->voxels.finish();
}

Oracle::~Oracle() = default;
Oracle::Oracle(Oracle &&) noexcept = default;

Hit Oracle::trace(const Ray &ray) const { return traceExactly(state_->voxels, ray); }

std::uint32_t Oracle::voxel(Int3 cell) const {
  return contains(state_->voxels.extent(), cell) ? state_->voxels.at(cell).word : 0;
}

} // namespace voxc
