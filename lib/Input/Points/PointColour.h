// The words of points: their colours, or those of Gaussian splats.
#pragma once

#include "Mesh/Ply/PlyColour.h"

#include <cstdint>
#include <string>
#include <vector>

namespace voxc {

/// Knows where the colour of a point is. Points of which `f_dc_0` to `f_dc_2` are known are Gaussian splats:
/// their colour is the zeroth of their spherical harmonics, and those with an opacity below a tenth have the
/// word 0.
class PointColour {
public:
  explicit PointColour(const PlyElement &vertices);

  explicit operator bool() const { return areSplats_ || bool(colour_); }
  bool areSplats() const { return areSplats_; }
  /// To be shown all rows before the first word is asked for, if it needs them.
  PlyColour &colour() { return colour_; }
  const PlyColour &colour() const { return colour_; }

  /// 0: the point is none.
  std::uint32_t operator()(const PlyRow &row) const;

  /// Marks the properties as used, those that make up a splat too, of which `warnings` tells.
  void take(PlyUse &use) const;
  std::vector<std::string> warnings() const;
  /// Why so many points have the word 0.
  std::string saysDropped(std::uint64_t count, std::uint64_t all) const;

private:
  const PlyElement &vertices_;
  PlyColour colour_;
  std::array<std::optional<std::size_t>, 3> harmonics_;
  std::optional<std::size_t> opacity_;
  bool areSplats_ = false;
};

} // namespace voxc
