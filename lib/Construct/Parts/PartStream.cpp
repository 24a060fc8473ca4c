// Serving parts to generated code.
#include "PartStream.h"

#include "Source/CubeTools.h"

namespace voxc {

std::optional<Cube> MergeHost::lookAhead() {
  const auto next = parts_.next();
  if (next.failed())
    store().fail(next.error());
  return next.failed() || next.isEnd() ? std::nullopt : std::optional(*next);
}

bool MergeHost::isEmpty(const Cube &cube) {
  const auto next = lookAhead();
  if (!next || mortonCode(next->low) - mortonCode(cube.low) >= cellCount(cube.log2Side))
    return true;
  setPartSide(next->log2Side);
  return false;
}

void MergeHost::readBrick(Int3 low, construct::Brick &brick) {
  brick = {};
  if (!isEmpty({low, construct::kLog2Brick}))
    store().fail(Error::input("a part is smaller than the cells that it was to be built of"));
}

/// Parts were proven apart; together they may have a colour too much.
void MergeHost::proveColours(Int3 low) {
  const auto take = [&](std::uint32_t colour) {
    if (!colours_.take(colour) && !store().failure())
      store().fail(colours_.broken("a voxel around (" + std::to_string(low.x) + ", " + std::to_string(low.y) +
                                       ", " + std::to_string(low.z) + ") is",
                                   colour));
  };
  if (fragment_.colour != 0) // Some parts turn out to be empty.
    take(fragment_.colour);
  for (const std::uint32_t value : fragment_.values)
    take(value);
  if (layout_.ranksVoxels() && layout_.holdsVoxels(layout_.stratumOfPart(fragment_.cube.log2Side)))
    for (const construct::PlacedCell &cell : fragment_.cells)
      take(cell.value);
}

construct::Part MergeHost::takePart(Int3 low) {
  auto fragment = parts_.take();
  if (!fragment) {
    store().fail(fragment.error());
    return {};
  }
  fragment_ = std::move(*fragment);
  splice_.join(fragment_);
  if (colours_.isStated())
    proveColours(low);
  putValues(fragment_.values);
  voxels_ += fragment_.voxels;
  store().pause(fragment_.words.size());
  if (!progress_.at(low, voxels_))
    store().fail(Error::interrupted());
  return {fragment_.node, fragment_.cells.data(), fragment_.cells.size(), fragment_.values.size()};
}

} // namespace voxc
