// The edits whose cost is measured, at places on the surface of a scene.
#pragma once

#include "voxc/Source/VoxelChange.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace voxc::edits {

/// One edit, for whoever does it.
struct Edit {
  enum Shape { Voxel, Sphere, Paste } shape;
  Int3 at;                ///< The voxel, the centre, or the low corner.
  int radius = 0;         ///< Of a sphere.
  std::uint32_t word = 0; ///< 0 clears. Of a paste it does not count.
};

/// A row of the table.
struct EditKind {
  std::string_view name;
  Edit::Shape shape;
  int radius;
  std::uint32_t word;
  int count; ///< How many are measured.
};

std::span<const EditKind> editKinds();

/// The edits of a kind, at some of these places, the same at every call.
std::vector<Edit> editsOf(const EditKind &kind, std::span<const Int3> places);

/// The same for a volume; `pasted` is what pastes put, and may be null where there are none.
std::unique_ptr<VoxelChange> changeOf(const Edit &edit, const std::shared_ptr<const Volume> &pasted);

/// Voxels of a volume all over it, at most `most`.
std::vector<Int3> placesOn(const Volume &volume, std::size_t most);

} // namespace voxc::edits
