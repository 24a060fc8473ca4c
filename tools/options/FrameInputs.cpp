// Frames by their numbers behind the name of a file.
#include "options/FrameInputs.h"

#include <utility>

namespace voxc::tool {

OpenFrame makeFrameInputs(const std::string &input, std::unique_ptr<VoxelSource> first,
                          InputOptions options) {
  options.describe = false;
  // What is copied must not own the source alone.
  const auto held = std::make_shared<std::unique_ptr<VoxelSource>>(std::move(first));
  return [=](std::size_t index) -> Expected<std::unique_ptr<VoxelSource>> {
    if (index == 0)
      return std::move(*held);
    Expected<Input> next = openInput(input + "#" + std::to_string(index + 1), options);
    return next ? std::move(next->source) : Expected<std::unique_ptr<VoxelSource>>(next.error());
  };
}

} // namespace voxc::tool
