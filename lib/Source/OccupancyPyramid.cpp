// The occupancy pyramid of a dense grid.
#include "Source/OccupancyPyramid.h"

#include <algorithm>

namespace voxc {

std::size_t OccupancyPyramid::Layer::index(Int3 cube) const {
  return static_cast<std::size_t>(cube.x) +
         static_cast<std::size_t>(size.x) *
             (static_cast<std::size_t>(cube.y) +
              static_cast<std::size_t>(size.y) * static_cast<std::size_t>(cube.z));
}

OccupancyPyramid::OccupancyPyramid(Int3 extent) {
  const int longest = std::max({extent.x, extent.y, extent.z});
  for (int log2Side = kLog2Brick; layers_.empty() || (longest - 1) >> (log2Side - 1) > 0; ++log2Side) {
    const Int3 last = (extent - Int3{1, 1, 1}) >> log2Side;
    Layer layer{last + Int3{1, 1, 1}, {}};
    layer.marked.resize(layer.index(last) + 1);
    layers_.push_back(std::move(layer));
  }
}

void OccupancyPyramid::mark(Int3 cell) {
  Int3 cube = cell >> kLog2Brick;
  for (Layer &layer : layers_) {
    const std::size_t index = layer.index(cube);
    // Whoever marked this cube has marked those around it.
    if (layer.marked[index])
      return;
    layer.marked[index] = true;
    cube = cube >> 1;
  }
}

bool OccupancyPyramid::empty(const Cube &cube) const {
  const int top = kLog2Brick + static_cast<int>(layers_.size()) - 1;
  const int log2Side = std::min(cube.log2Side, top);
  const Layer &layer = layers_[static_cast<std::size_t>(log2Side - kLog2Brick)];
  return !layer.marked[layer.index(cube.low >> log2Side)];
}

} // namespace voxc
