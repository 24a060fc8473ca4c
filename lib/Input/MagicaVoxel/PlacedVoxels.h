// The voxels of MagicaVoxel scenes, in the axes of volumes. A scene may lie in several files.
#pragma once

#include "Input/MagicaVoxel/VoxScene.h"
#include "Support/WatchedFile.h"
#include "voxc/Support/Progress.h"

#include <algorithm>
#include <cstdint>
#include <deque>
#include <memory>
#include <string>

namespace voxc {

/// One file of a scene. The scene points into the file's models.
struct ScenePart {
  std::shared_ptr<const WatchedFile> bytes;
  VoxFile file;
  VoxScene scene;
};
using SceneParts = std::deque<ScenePart>;

/// A scene cannot be longer, whatever its files say.
inline constexpr std::int64_t kMostSide = std::int64_t{1} << 30;

/// The voxels of a scene, with +z turned to +y and the low corner of the box moved to (0, 0, 0).
class PlacedVoxels {
public:
  explicit PlacedVoxels(const SceneParts &parts)
      : parts_(parts), low_(parts.front().scene.low), size_(parts.front().scene.size) {
    for (const ScenePart &part : parts)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::int64_t end =
            std::max(low_[axis] + size_[axis], part.scene.low[axis] + part.scene.size[axis]);
        low_[axis] = std::min(low_[axis], part.scene.low[axis]);
        size_[axis] = std::min(end - low_[axis], kMostSide);
      }
  }

  Int3 extent() const {
    return {static_cast<int>(size_[0]), static_cast<int>(size_[2]), static_cast<int>(size_[1])};
  }

  /// From voxels back to the cells of the scene.
  Transform voxelToModel() const {
    const auto &[x, y, z] = low_;
    const auto farY = static_cast<double>(y + size_[1]);
    return transformOfRows(
        {1, 0, 0, static_cast<double>(x), 0, 0, -1, farY, 0, 1, 0, static_cast<double>(z)});
  }

  std::uint64_t count() const {
    std::uint64_t count = 0;
    for (const ScenePart &part : parts_)
      for (const VoxInstance &instance : part.scene.instances)
        count += instance.model->voxels.size() / 4;
    return count;
  }

  /// Calls `visit(voxel, colour, file)` for each voxel, the number of its colour being 0 to 255. Errors: a
  /// voxel outside its model; interrupted.
  template <typename Visit> Expected<void> forEach(const Progress &progress, Visit visit) const {
    for (const ScenePart &part : parts_)
      VOXC_TRY(forEachOf(part, progress, visit));
    return {};
  }

private:
  template <typename Visit>
  Expected<void> forEachOf(const ScenePart &part, const Progress &progress, Visit visit) const {
    for (const VoxInstance &instance : part.scene.instances) {
      if (progress.stopped())
        return Error::interrupted();
      const VoxModel &model = *instance.model;
      for (std::size_t at = 0; at < model.voxels.size(); at += 4) {
        Long3 cell;
        bool isInside = true;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          cell[axis] = std::to_integer<std::int64_t>(model.voxels[at + axis]);
          isInside = isInside && cell[axis] < model.size[axis];
        }
        if (!isInside)
          return outside(cell, model);
        visit(turned(instance.placement.moveCell(cell)), std::to_integer<unsigned>(model.voxels[at + 3]),
              part.file);
      }
    }
    return {};
  }

  static Error outside(const Long3 &cell, const VoxModel &model) {
    const auto text = [](const Long3 &v, const char *between) {
      return std::to_string(v[0]) + between + std::to_string(v[1]) + between + std::to_string(v[2]);
    };
    return Error::input("the voxel " + text(cell, ", ") + " lies outside its model of " +
                        text(model.size, "x"));
  }

  Int3 turned(const Long3 &cell) const {
    return {static_cast<int>(cell[0] - low_[0]), static_cast<int>(cell[2] - low_[2]),
            static_cast<int>(size_[1] - 1 - (cell[1] - low_[1]))};
  }

  const SceneParts &parts_;
  Long3 low_; ///< The box around all files' boxes.
  Long3 size_;
};

} // namespace voxc
