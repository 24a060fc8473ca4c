// One picture of the faces of many rectangles.
#pragma once

#include "voxc/Support/Error.h"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace voxc {

/// Where a rectangle's first texel lies.
struct AtlasPlace {
  std::uint16_t x = 0;
  std::uint16_t y = 0;
};

/// Rectangles of at most 64 texels a side, placed without gaps on shelves, those of the highest rectangles
/// first. Theirs are all texels of the picture but those at the ends of shelves.
class FaceAtlas {
public:
  /// The longest side of a picture; more is beyond what devices take.
  static constexpr int kMostSide = 16384;

  /// Adds a rectangle with its texels, along the width first.
  void add(int width, int height, std::span<const std::uint32_t> texels);

  /// More texels were added than any picture has: to add others would only take memory.
  bool isOverfull() const { return texels_.size() > std::size_t{kMostSide} * kMostSide; }

  /// Places all rectangles. Error: they do not fit.
  Expected<void> pack();

  int width() const { return width_; }
  int height() const { return height_; }
  /// Of the rectangle that was added so many before.
  AtlasPlace place(std::size_t rectangle) const { return rectangles_[rectangle].place; }
  /// Other texels for all rectangles, one behind another.
  void setTexels(std::vector<std::uint32_t> texels) { texels_ = std::move(texels); }
  /// All texels, row by row; those of none are 0. The rectangles have none after that.
  std::vector<std::uint32_t> takePicture();

private:
  struct Rectangle {
    std::uint8_t width;
    std::uint8_t height;
    AtlasPlace place;
  };

  std::vector<Rectangle> rectangles_;
  std::vector<std::uint32_t> texels_; ///< Those of all, one behind another.
  int width_ = 1;
  int height_ = 1;
};

} // namespace voxc
