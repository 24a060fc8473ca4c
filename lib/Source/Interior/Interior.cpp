// Dropping and filling what the water does not reach.
#include "voxc/Source/Interior.h"

#include "Source/Interior/FloodTree.h"
#include "Source/Interior/PaintedSource.h"

#include <utility>

namespace voxc {

namespace {

/// The source with `word` in what stays dry when all is flooded from outside.
Expected<ChangedSource> paintDry(std::unique_ptr<VoxelSource> source, Step step, Choice choice,
                                 std::uint32_t word, const InteriorOptions &options) {
  auto tree = FloodTree::read(*source, {step, Beyond::Empty}, options);
  if (!tree)
    return tree.error();
  if (auto flooded = tree->floodFromOutside(); !flooded)
    return flooded.error();
  auto dry = tree->choose(choice);
  if (!dry)
    return dry.error();
  // Nothing is asked in vain where nothing changes.
  if (dry->count == 0)
    return ChangedSource{std::move(source), 0};
  return ChangedSource{paint(std::move(source), std::move(dry->cells), word), dry->count};
}

} // namespace

Expected<ChangedSource> dropInterior(std::unique_ptr<VoxelSource> source, const InteriorOptions &options) {
  return paintDry(std::move(source), Step::Ray, Choice::DryAndVoxels, 0, options);
}

Expected<ChangedSource> fillInterior(std::unique_ptr<VoxelSource> source, std::uint32_t word,
                                     const InteriorOptions &options) {
  return paintDry(std::move(source), Step::Face, Choice::Dry, word, options);
}

} // namespace voxc
