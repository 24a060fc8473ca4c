// Brushes: what a stamp at a voxel does to those around it.
#pragma once

#include "voxc/Source/VoxelChange.h"
#include "voxc/Trace/Ray.h"

#include <cstdint>
#include <memory>
#include <string>

namespace voxc::view {

enum class BrushKind {
  None,  ///< The mouse turns.
  Add,   ///< Voxels.
  Erase, ///< Those that are there.
  Paint, ///< The colour of those that are there.
  Paste, ///< What was copied.
};

struct Brush {
  BrushKind kind = BrushKind::None;
  bool isBox = false; ///< Else a sphere.
  int radius = 4;     ///< 0 to `kMostRadius`: a stamp is 2 * radius + 1 voxels wide.
  std::uint32_t colour = rgba(255, 128, 0);
  std::shared_ptr<const Volume> copied; ///< Null: nothing was.

  static constexpr int kMostRadius = 64;

  /// The next kind; `Paste` only if there is something.
  void next();
  void resize(int by);
  /// The low corner of a stamp at a voxel, and its size along each axis.
  Int3 lowAt(Int3 at) const { return at - Int3{radius, radius, radius}; }
  int side() const { return 2 * radius + 1; }
};

/// "add a sphere of 9 voxels, #ff8000"; "" of none.
std::string describe(const Brush &brush);

/// What a stamp does at a voxel. Precondition: the brush is of some kind.
std::unique_ptr<VoxelChange> stamp(const Brush &brush, Int3 at);

/// What a stamp at a voxel would cover, as a volume; null if there is no voxel. Errors: those of building.
Expected<std::shared_ptr<const Volume>> copyUnder(const Brush &brush, Int3 at, const Volume &volume);

} // namespace voxc::view
