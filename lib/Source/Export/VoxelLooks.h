// What the attributes of voxels say of light and metal, for files that have materials.
#pragma once

#include "voxc/Volume/Volume.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace voxc {

/// What the attributes `emission`, `emission-strength` and `metallic-roughness` say of a voxel.
struct VoxelLook {
  std::uint32_t emission = 0; ///< R, G and B in sRGB from the low byte, and 255; 0: it gives off nothing.
  float strength = 1;         ///< So many times as bright it is.
  std::uint32_t metal = 0;    ///< Clear, rough and metallic, of 255, and 255; 0: nothing is said.

  bool operator==(const VoxelLook &) const = default;
  bool operator<(const VoxelLook &) const;
};

/// Whether it is neither clear, smooth nor metallic.
inline bool isRough(const VoxelLook &look) { return look.metal == 0 || look.metal == 0xff00ff00; }

/// The looks of a volume's voxels, each kind once.
class VoxelLooks {
public:
  /// Errors: as `visitVoxels`; interrupted.
  static Expected<VoxelLooks> of(const Volume &volume, const Progress &progress);

  /// Whether attributes say anything.
  bool areAny() const { return looks_.size() > 1; }
  /// All kinds; the first is that of voxels of which nothing is said.
  std::span<const VoxelLook> all() const { return looks_; }

  /// Voxels [begin, end) by their Morton codes, in that order, of which something is said.
  struct Range {
    std::span<const std::uint64_t> codes;
    std::span<const std::uint32_t> looks; ///< Numbers in `all()`.
  };
  Range between(std::uint64_t begin, std::uint64_t end) const;
  /// The number of a voxel's look.
  std::uint32_t at(std::uint64_t code) const;

private:
  void sort();

  std::vector<VoxelLook> looks_{VoxelLook()};
  std::vector<std::uint64_t> codes_;
  std::vector<std::uint32_t> numbers_;
};

/// A sentence that names the attributes that a file has no place for, all of them or, with `holdsLooks`,
/// those that are no look; empty if there are none.
std::string attributesLeftOut(const Volume &volume, bool holdsLooks, const std::string &ending);

} // namespace voxc
