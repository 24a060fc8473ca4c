// Parts of an edited volume, one after the other.
#include "EditedParts.h"

#include "Source/CubeTools.h"

#include <algorithm>
#include <utility>

namespace voxc {
namespace {

/// Where nothing changes, parts are as large as memory for a fragment allows; what changes is cut as small as
/// a split does.
constexpr int kLog2Part = 6;
constexpr int kLog2LargestPart = 9;

PartGrid gridOf(const Volume &volume) {
  return PartGrid::of(volume.info().extent, volume.layout(), kLog2Part)
      .upTo(kLog2LargestPart, volume.layout());
}

bool isEmpty(const Fragment &fragment) {
  return fragment.cells.empty() && fragment.node.kind == construct::Node::Empty;
}

} // namespace

EditedParts::EditedParts(const Volume &volume, std::unique_ptr<VoxelSource> edited,
                         std::span<const VoxelEdit> edits, PartBuilder builder, const BuildOptions &options)
    : edited_(std::move(edited)), edits_(edits), extraction_(volume.words(), volume.layout()),
      builder_(std::move(builder)),
      sequence_(
          gridOf(volume), 0, gridOf(volume).count(),
          [this](const Cube &cube) { return isOutside(cube, edited_->extent()) || edited_->empty(cube); },
          [this](const Cube &cube) { return isTouched(cube); }),
      progress_(options.progress) {}

Expected<std::unique_ptr<EditedParts>> EditedParts::create(const Volume &volume,
                                                           std::unique_ptr<VoxelSource> edited,
                                                           std::span<const VoxelEdit> edits,
                                                           const ConstructCode &code,
                                                           const BuildOptions &options) {
  auto builder = VOXC_TRY(PartBuilder::create(edited->view(), code, volume.layout(), options.memory, true));
  return std::unique_ptr<EditedParts>(
      new EditedParts(volume, std::move(edited), edits, std::move(builder), options));
}

bool EditedParts::isTouched(const Cube &cube) const {
  if (!extraction_.canTakeOut())
    return true;
  return std::ranges::any_of(edits_, [&](const VoxelEdit &edit) { return edit.touches(cube); });
}

Next<Cube> EditedParts::next() {
  while (!ahead_) {
    const std::optional<Cube> cube = sequence_.next();
    if (!cube)
      return End{};
    const bool isBuilt = isTouched(*cube);
    Expected<Fragment> part =
        isBuilt ? builder_.build(*cube, progress_) : extraction_.cube(cube->low, cube->log2Side);
    if (!part || !isEmpty(*part))
      ahead_ = std::move(part);
  }
  return *ahead_ ? Next<Cube>((*ahead_)->cube) : ahead_->error();
}

Expected<Fragment> EditedParts::take() { return *std::exchange(ahead_, std::nullopt); }

} // namespace voxc
