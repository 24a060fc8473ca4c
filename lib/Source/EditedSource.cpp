// A volume with edits on top.
#include "voxc/Source/Edit.h"

#include "Source/CubeTools.h"
#include "voxc/Source/Sources.h"

#include <algorithm>
#include <string>
#include <utility>

namespace voxc {

namespace {

using Edits = std::shared_ptr<const std::vector<VoxelEdit>>;

class EditedSource final : public VoxelSource {
public:
  EditedSource(std::unique_ptr<VoxelSource> source, Edits edits)
      : source_(std::move(source)), edits_(std::move(edits)) {}

  Int3 extent() const override { return source_->extent(); }
  Transform voxelToModel() const override { return source_->voxelToModel(); }
  int log2Chunk() const override { return source_->log2Chunk(); }

  std::unique_ptr<VoxelSource> view() const override {
    auto view = source_->view();
    return view ? std::make_unique<EditedSource>(std::move(view), edits_) : nullptr;
  }

  /// What is cleared may be asked for in vain.
  bool empty(const Cube &cube) override {
    const bool isAdded = std::ranges::any_of(*edits_, [&](const VoxelEdit &edit) {
      return (edit.pasted || edit.word != 0) && edit.touches(cube);
    });
    return !isAdded && source_->empty(cube);
  }

  Expected<void> read(const Cube &cube, std::uint32_t *words) override {
    VOXC_TRY(source_->read(cube, words));
    for (const VoxelEdit &edit : *edits_)
      if (edit.touches(cube))
        apply(edit, cube, words);
    return {};
  }

private:
  static void apply(const VoxelEdit &edit, const Cube &cube, std::uint32_t *words) {
    forEachCell(cube, [&](std::uint64_t index, Int3 cell) {
      const Int3 inside = cell - edit.low;
      if (!contains(edit.size, inside))
        return;
      const std::uint32_t word = edit.pasted ? edit.pasted->lookup(inside).value : edit.word;
      if (!edit.pasted || word != 0)
        words[index] = word;
    });
  }

  std::unique_ptr<VoxelSource> source_;
  Edits edits_;
};

/// Whether all of an edit lies in the extent.
bool fits(const VoxelEdit &edit, Int3 extent) {
  for (int axis = 0; axis < 3; ++axis)
    if (edit.low[axis] < 0 || edit.size[axis] < 0 || edit.size[axis] > extent[axis] ||
        edit.low[axis] > extent[axis] - edit.size[axis])
      return false;
  return true;
}

std::string toText(Int3 cell) {
  return "(" + std::to_string(cell.x) + ", " + std::to_string(cell.y) + ", " + std::to_string(cell.z) + ")";
}

} // namespace

bool VoxelEdit::touches(const Cube &cube) const {
  for (int axis = 0; axis < 3; ++axis)
    if (cube.low[axis] >= low[axis] + size[axis] || cube.low[axis] + cube.side() <= low[axis])
      return false;
  return true;
}

Expected<void> checkEdits(std::span<const VoxelEdit> edits, Int3 extent) {
  for (std::size_t i = 0; i < edits.size(); ++i)
    if (!fits(edits[i], extent))
      return Error::input("edit " + std::to_string(i + 1) + " has " + toText(edits[i].size) +
                          " voxels from " + toText(edits[i].low) + " on, but the volume ends at " +
                          toText(extent));
  return {};
}

Expected<std::unique_ptr<VoxelSource>> makeEditedSource(std::shared_ptr<const Volume> volume,
                                                        std::vector<VoxelEdit> edits) {
  VOXC_TRY(checkEdits(edits, volume->info().extent));
  return std::unique_ptr<VoxelSource>(std::make_unique<EditedSource>(
      makeVolumeSource(std::move(volume)), std::make_shared<const std::vector<VoxelEdit>>(std::move(edits))));
}

} // namespace voxc
