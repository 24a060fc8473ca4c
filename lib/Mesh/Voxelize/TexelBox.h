// The mean colour of a box of texels.
#pragma once

#include "Mesh/Voxelize/TextureMeans.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace voxc {

/// Part of a texture's plane, in texels: the texture reaches from 0 to its width and height, and goes on as
/// it is wrapped. It may have no area.
struct TexelBox {
  std::array<double, 2> low;
  std::array<double, 2> high;
};

/// Finds means of one box after the other.
class BoxMeans {
public:
  /// The mean over a box, of a dozen or two cells of a level that is fine enough: red, green and blue in sRGB
  /// as in a texel, without alpha. Nothing where all is invisible.
  std::optional<std::uint32_t> of(const TextureMeans &means, const std::array<TextureWrap, 2> &wrap,
                                  const TexelBox &box);

private:
  using Tap = TextureMeans::Column; ///< Or a row; what counts is how much of the box is in it, in texels.
  /// One axis of a box and of a texture.
  struct Axis {
    double low;
    double high;
    TextureWrap wrap;
    int size;
  };

  static void addPiece(double low, double high, int size, int level, std::vector<Tap> &taps);
  static void addTaps(const Axis &axis, int level, std::vector<Tap> &taps);

  std::vector<Tap> columns_;
  std::vector<Tap> rows_;
};

} // namespace voxc
