// Packing by shelves: rectangles by height, side by side until a row is full.
#include "Source/Export/FaceAtlas.h"

#include <algorithm>
#include <numeric>
#include <string>

namespace voxc {

void FaceAtlas::add(int width, int height, std::span<const std::uint32_t> texels) {
  rectangles_.push_back({static_cast<std::uint8_t>(width), static_cast<std::uint8_t>(height), {}});
  texels_.insert(texels_.end(), texels.begin(), texels.end());
}

Expected<void> FaceAtlas::pack() {
  std::vector<std::uint32_t> order(rectangles_.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, std::greater(), [&](std::uint32_t i) { return rectangles_[i].height; });
  width_ = 64;
  while (width_ < kMostSide && std::size_t(width_) * std::size_t(width_) < texels_.size())
    width_ *= 2;
  int x = 0, y = 0, shelf = 0;
  for (const std::uint32_t i : order) {
    Rectangle &rectangle = rectangles_[i];
    if (x + rectangle.width > width_) {
      x = 0;
      y += shelf;
      shelf = 0;
    }
    shelf = std::max<int>(shelf, rectangle.height);
    if (y + shelf > kMostSide)
      return Error::input("the " + std::to_string(texels_.size()) +
                          " visible faces do not fit into a texture of " + std::to_string(kMostSide) +
                          " texels a side; leave --texture out, for a colour a vertex");
    rectangle.place = {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y)};
    x += rectangle.width;
  }
  height_ = std::max(y + shelf, 1);
  return {};
}

std::vector<std::uint32_t> FaceAtlas::takePicture() {
  std::vector<std::uint32_t> picture(std::size_t(width_) * std::size_t(height_));
  std::size_t from = 0;
  for (const Rectangle &rectangle : rectangles_)
    for (int row = 0; row < rectangle.height; ++row) {
      const std::size_t to = std::size_t(rectangle.place.y + row) * std::size_t(width_) + rectangle.place.x;
      std::copy_n(&texels_[from], rectangle.width, &picture[to]);
      from += rectangle.width;
    }
  texels_ = {};
  return picture;
}

} // namespace voxc
