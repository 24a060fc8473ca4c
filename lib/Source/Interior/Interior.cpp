// Dropping and filling what a flood fill from outside does not reach.
#include "voxc/Source/Interior.h"

#include "Source/Interior/FloodTree.h"
#include "Source/Interior/PaintedSource.h"

#include <utility>

namespace voxc {

namespace {

/// The source with `word` in what a flood fill from outside does not reach.
Expected<ChangedSource> fillUnreached(std::unique_ptr<VoxelSource> source, Step step, Choice choice,
                                      std::uint32_t word, const InteriorOptions &options) {
  auto tree = VOXC_TRY(FloodTree::read(*source, {step, Outside::Empty}, options));
  VOXC_TRY(tree.floodFromOutside());
  auto unreached = VOXC_TRY(tree.choose(choice));
  // Nothing is asked in vain where nothing changes.
  if (unreached.count == 0)
    return ChangedSource{std::move(source), 0};
  return ChangedSource{paint(std::move(source), std::move(unreached.cells), word), unreached.count};
}

} // namespace

Expected<ChangedSource> dropInterior(std::unique_ptr<VoxelSource> source, const InteriorOptions &options) {
  return fillUnreached(std::move(source), Step::Ray, Choice::UnreachedAndVoxels, 0, options);
}

Expected<ChangedSource> fillInterior(std::unique_ptr<VoxelSource> source, std::uint32_t word,
                                     const InteriorOptions &options) {
  return fillUnreached(std::move(source), Step::Face, Choice::Unreached, word, options);
}

} // namespace voxc
