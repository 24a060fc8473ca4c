// How far a picture is from the one that it stands for.
#pragma once

#include "voxc/Render/Picture.h"

namespace voxc::tool {

struct PictureDifference {
  double psnr = 0;    ///< Decibels over all channels of all pixels; +inf for equal pictures.
  int worst = 0;      ///< The largest difference of a channel, 0 to 255.
  double changed = 0; ///< Share of the pixels that differ at all, 0 to 1.
};

/// Compares red, green and blue of two pictures of the same size.
PictureDifference difference(const Picture &reference, const Picture &picture);

} // namespace voxc::tool
