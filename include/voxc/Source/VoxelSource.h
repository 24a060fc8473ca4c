// Where voxels come from: one interface for meshes, grids, points, procedures and finished volumes.
#pragma once

#include "voxc/Support/Error.h"
#include "voxc/Support/Geometry.h"
#include "voxc/Support/Transform.h"

#include <cstdint>
#include <functional>
#include <memory>

namespace voxc {

/// Packs a voxel's colour: R in the low byte, A in the high one.
constexpr std::uint32_t rgba(std::uint32_t r, std::uint32_t g, std::uint32_t b, std::uint32_t a = 255) {
  return r | g << 8 | b << 16 | a << 24;
}

/// A finite set of coloured voxels, asked in Morton order.
///
/// A builder asks for aligned cubes so that their Morton codes never fall: for each it first asks `empty`,
/// and then either leaves the cube or asks for cubes inside it. A source may thus make its voxels piece by
/// piece and drop what lies behind; who goes back is answered all the same, if slowly.
/// Cubes may reach outside `extent()`; whatever is outside is empty.
///
/// A source may fail, or be stopped, at any cube. Only `read` says so: `empty` is then false, so that who
/// asks goes on to read, and no voxel that could not be made is taken for one that is not there.
class VoxelSource {
public:
  virtual ~VoxelSource() = default;

  /// Voxels on each axis; every voxel lies in [0, extent). At most 2^21 an axis.
  virtual Int3 extent() const = 0;

  /// True only if `cube` (aligned) is known to hold no voxel. May be false for an empty cube, and is so where
  /// the source cannot decide; must be cheap.
  virtual bool empty(const Cube &cube) = 0;

  /// Writes the 8^log2Side words of the aligned `cube` (log2Side <= 3) to `words`, in Morton order; 0 is
  /// "empty", anything else RGBA8 with R in the low byte. Errors: the voxels could not be made, or the work
  /// was stopped; `words` then mean nothing.
  virtual Expected<void> read(const Cube &cube, std::uint32_t *words) = 0;

  /// Another reader of the same voxels, for another thread or another run; it may outlive this one. Null if
  /// the source has but one reader.
  virtual std::unique_ptr<VoxelSource> view() const { return nullptr; }

  /// log2 of the side of the cubes that the source makes at once: who shares work out gives whole ones.
  virtual int log2Chunk() const { return 6; }

  /// How many records, such as triangles, are gone through to make the voxels of the aligned `cube`, which
  /// is no smaller than a chunk, about; 0 where the source keeps none. Cheap.
  virtual std::uint64_t records(const Cube &) const { return 0; }

  /// Seconds of computing that went into `empty` and `read` so far, over all views.
  virtual double readSeconds() const { return 0; }

  /// Maps voxel coordinates to those of the model that the voxels were made from.
  virtual Transform voxelToModel() const { return {}; }
};

/// A source made of a function of the coordinates, which returns the voxel's word; `empty` may be left out.
/// Views copy the functions and call them from several threads.
std::unique_ptr<VoxelSource> makeFunctionSource(Int3 extent, std::function<std::uint32_t(Int3)> voxel,
                                                std::function<bool(const Cube &)> empty = {});

} // namespace voxc
