// The oracle: a volume decoded into runs, and the exact walk over them.
#include "voxc/Oracle/Oracle.h"

#include "ExactWalk.h"
#include "VoxelRuns.h"

namespace voxc {

struct Oracle::State {
  VoxelRuns voxels;
};

Expected<Oracle> Oracle::of(const Volume &volume, const Progress &progress) {
  // A run takes twelve bytes, and there may be an empty one before each cube.
  constexpr std::uint64_t kMaxCubes = std::uint64_t{1} << 28;
  auto state = std::make_unique<State>(State{VoxelRuns(volume.format().extent())});
  std::uint64_t cubes = 0;
  const auto add = [&](const Cube &cube, std::uint32_t word) {
    state->voxels.add(cube, word);
    return ++cubes < kMaxCubes;
  };
  if (auto decoded = decode(volume, add, progress); !decoded)
    return decoded.error();
  if (cubes == kMaxCubes)
    return Error::input("the volume is made of " + std::to_string(kMaxCubes) +
                        " uniform cubes or more, which are too many to be checked one by one");
  state->voxels.finish();
  return Oracle(std::move(state));
}

Oracle::Oracle(std::unique_ptr<State> state) : state_(std::move(state)) {}
Oracle::~Oracle() = default;
Oracle::Oracle(Oracle &&) noexcept = default;

Hit Oracle::trace(const Ray &ray) const { return traceExactly(state_->voxels, ray); }

std::uint32_t Oracle::voxel(Int3 cell) const {
  return contains(state_->voxels.extent(), cell) ? state_->voxels.at(cell).word : 0;
}

} // namespace voxc
