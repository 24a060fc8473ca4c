// The same edits by OpenVDB's accessor, for comparison.
#pragma once

#include "Edits.h"

#include <memory>
#include <vector>

namespace voxc::edits {

/// A tree of OpenVDB with the voxels of a volume.
class VdbEdits {
public:
  /// Null in a build without OpenVDB.
  static std::unique_ptr<VdbEdits> create(const Volume &volume);
  virtual ~VdbEdits() = default;

  /// Does one edit; `pasted` holds the voxels of what pastes put, counted from its low corner.
  virtual void apply(const Edit &edit, const std::vector<VoxelWord> &pasted) = 0;
  /// Bytes of the tree.
  virtual std::uint64_t bytes() const = 0;
};

} // namespace voxc::edits
