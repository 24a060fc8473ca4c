// Pictures of hits: shaded by face, or as a map of numbers such as the lookups that each ray took.
#pragma once

#include "voxc/Trace/Ray.h"

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace voxc {

/// Pixels in rows from the top, RGBA8 with R in the low byte, opaque.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint32_t> pixels;
};

/// Gives hits of labels (payload=material) a colour for each label in place of it: neighbouring ones differ
/// much.
void showLabels(std::span<Hit> hits);

/// The voxels' colours, shaded by the face that each ray entered so that shapes read; the sky elsewhere.
Picture shade(std::span<const Ray> rays, std::span<const Hit> hits, int width, int height);

/// Lookups a ray as colours, with a legend that names the scale.
Picture heatmap(std::span<const Hit> hits, int width, int height);

/// Numbers as colours from the least to the greatest, bright where they are great, or with `isFalling` where
/// they are small, with a legend that names the scale and its `unit` (capital letters, digits and blanks).
/// What is no number is background.
Picture mapPicture(std::span<const float> values, int width, int height, std::string_view unit,
                   bool isFalling = false);

} // namespace voxc
