// Memory for the largest model, of which each model sets and clears only its own voxels.
#include "Input/MagicaVoxel/VoxTwice.h"

#include "Support/Text.h"

#include <set>

namespace voxc {

namespace {

/// How many voxels are there before in another colour, those of a model that is placed often once.
Expected<std::uint64_t> countTwice(const VoxScene &scene, const std::shared_ptr<WorkingMemory> &memory) {
  std::set<const VoxModel *> models;
  for (const VoxInstance &instance : scene.instances)
    models.insert(instance.model);
  std::uint64_t twice = 0;
  ScratchArray<std::byte> colours(memory); // By the cell; 0 between models.
  for (const VoxModel *model : models) {
    const auto &[x, y, z] = model->size;
    const auto cells = static_cast<std::uint64_t>(x * y * z);
    if (cells > colours.size())
      VOXC_TRY(colours.resize(cells));
    const auto colourAt = [&](std::size_t at) -> std::byte & {
      const auto along = [&](std::size_t axis) {
        return std::to_integer<std::int64_t>(model->voxels[at + axis]);
      };
      return colours[static_cast<std::uint64_t>(along(0) + x * (along(1) + y * along(2)))];
    };
    for (std::size_t at = 0; at < model->voxels.size(); at += 4) {
      std::byte &colour = colourAt(at);
      if (colour == std::byte{0})
        colour = model->voxels[at + 3];
      else
        twice += model->voxels[at + 3] != std::byte{0} && model->voxels[at + 3] != colour;
    }
    // Only what was set: files may have thousands of large models that are nearly empty.
    for (std::size_t at = 0; at < model->voxels.size(); at += 4)
      colourAt(at) = std::byte{0};
  }
  return twice;
}

} // namespace

Expected<void> warnOfVoxelsTwice(const VoxScene &scene, const std::shared_ptr<WorkingMemory> &memory,
                                 std::vector<std::string> &warnings) {
  const auto twice = VOXC_TRY(countTwice(scene, memory));
  if (twice != 0)
    warnings.push_back(countedAre(twice, "voxel") + " left out, which a model has before in another colour");
  return {};
}

} // namespace voxc
