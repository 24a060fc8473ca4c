// Serving parts to generated code.
#include "PartStream.h"

#include "Source/CubeTools.h"

namespace voxc {

bool MergeHost::isEmpty(const Cube &cube) {
  const auto next = parts_.next();
  return !next || mortonCode(*next) - mortonCode(cube.low) >= cellCount(cube.log2Side);
}

void MergeHost::readBrick(Int3, std::uint32_t *) {
  store().fail(Error::input("a part is smaller than the cells that it was to be built of"));
}

construct::Part MergeHost::takePart(Int3 low) {
  auto fragment = parts_.take();
  if (!fragment) {
    store().fail(fragment.error());
    return {};
  }
  fragment_ = std::move(*fragment);
  splice_.join(fragment_, log2Part_);
  values_.put(fragment_.values);
  voxels_ += fragment_.voxels;
  if (colour_ != 0 && fragment_.colour != 0 && fragment_.colour != colour_)
    store().fail(Error::input("the voxels around (" + std::to_string(low.x) + ", " + std::to_string(low.y) +
                              ", " + std::to_string(low.z) + ") are " + colourText(fragment_.colour) +
                              ", others are " + colourText(colour_) +
                              ", but the format states payload=constant; build it without constant-colour"));
  colour_ = fragment_.colour != 0 ? fragment_.colour : colour_; // Some parts turn out to be empty.
  for (std::size_t i = 0; i < fragment_.shared.size(); ++i)
    store().shared()[i] += fragment_.shared[i];
  store().pause(fragment_.words.size());
  if (!progress_.at(low, voxels_))
    store().fail(Error::interrupted());
  return {fragment_.node, fragment_.cells.data(), fragment_.cells.size(), fragment_.values.size()};
}

} // namespace voxc
