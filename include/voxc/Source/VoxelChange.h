// What an edit makes of the voxels of a volume, asked cube by cube: so that what an edit does not touch, or
// makes all alike, is never gone through voxel by voxel.
#pragma once

#include "voxc/Source/Edit.h"
#include "voxc/Source/VoxelSource.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace voxc {

/// What becomes of an aligned cube.
struct CubeChange {
  enum Kind {
    Keep, ///< All its voxels stay what they are.
    Set,  ///< All become `word`; 0 clears them.
    Some, ///< Only smaller cubes can say, or single voxels.
  };
  Kind kind = Keep;
  std::uint32_t word = 0;
};

/// Asked by one thread at a time. Its functions throw nothing but `std::bad_alloc`, which fails the edit.
class VoxelChange {
public:
  virtual ~VoxelChange() = default;
  /// Cheap, and never wrong; `Some` may be answered of any cube.
  virtual CubeChange of(const Cube &cube) = 0;
  /// What a voxel becomes whose word is `old`; words as of `VoxelSource::read`.
  virtual std::uint32_t voxel(Int3 at, std::uint32_t old) = 0;
};

/// Voxels [low, low + size) become `word`; 0 clears them.
std::unique_ptr<VoxelChange> makeBoxChange(Int3 low, Int3 size, std::uint32_t word);

/// The largest sphere reaches from the middle of the largest volume to its faces.
inline constexpr int kMostSphereRadius = 1 << (kMaxLog2Extent - 1);

/// Voxels whose centre is no farther than `radius` from that of `centre` become `word`. `radius` is 0 to
/// 2^20; below 0 none is.
std::unique_ptr<VoxelChange> makeSphereChange(Int3 centre, int radius, std::uint32_t word);

/// A voxel and what it becomes.
struct VoxelWord {
  Int3 at;
  std::uint32_t word = 0;
};

/// Single voxels, in any order; of those given twice the last counts.
std::unique_ptr<VoxelChange> makeListChange(std::span<const VoxelWord> voxels);

/// Voxels that differ between two sources, as they are in `after`: 0 where it has none. Errors: those of the
/// sources; more than 2^30 of them (`Input`).
Expected<std::vector<VoxelWord>> differenceOf(VoxelSource &before, VoxelSource &after);

/// Voxel v of a volume is put at low + v where it is not empty.
std::unique_ptr<VoxelChange> makePasteChange(std::shared_ptr<const Volume> pasted, Int3 low);

/// Each voxel of [low, low + size) becomes what `function` says of its place and its word.
std::unique_ptr<VoxelChange> makeFunctionChange(Int3 low, Int3 size,
                                                std::function<std::uint32_t(Int3, std::uint32_t)> function);

/// What the edit of `Constructor::edit` does.
std::unique_ptr<VoxelChange> makeChange(const VoxelEdit &edit);

} // namespace voxc
