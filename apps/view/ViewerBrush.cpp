// What the viewer does with brushes.
#include "view/Viewer.h"

#include "view/Carving.h"
#include "view/Words.h"

#include <variant>

namespace voxc::view {

void Viewer::setBrush(const Brush &brush) {
  brush_ = brush;
  state_.brush = describe(brush_);
  log_.tell("brush " + (state_.brush.empty() ? "none" : state_.brush));
  if (isBrushing() && isPlaced())
    act(Prepare{});
}

void Viewer::nextBrush() {
  Brush brush = brush_;
  brush.next();
  setBrush(brush);
}

void Viewer::toggleBrushShape() {
  Brush brush = brush_;
  brush.isBox = !brush.isBox;
  setBrush(brush);
}

void Viewer::resizeBrush(int by) {
  Brush brush = brush_;
  brush.resize(by);
  setBrush(brush);
}

/// Precondition of what follows: a voxel was clicked.
void Viewer::takeBrushColour() {
  if (!touched_ || !touched_->isHit())
    return;
  Brush brush = brush_;
  brush.colour = touched_->rgba;
  setBrush(brush);
}

void Viewer::copyUnderBrush() {
  if (!isPlaced() || !touched_ || !touched_->isHit())
    return;
  const Int3 at = {touched_->voxel[0], touched_->voxel[1], touched_->voxel[2]};
  painter_.ask([this, brush = brush_, at](const Shot &shot) {
    if (shot.scene->sculpture)
      cut_.put(copyUnder(brush, at, *shot.scene->sculpture->volume()));
  });
}

void Viewer::takeCut(const Expected<std::shared_ptr<const Volume>> &cut) {
  if (!cut)
    return fail(cut.error());
  brush_.copied = *cut;
  if (brush_.copied)
    log_.tell("copied " + std::to_string(brush_.copied->info().voxels) + " voxels");
}

void Viewer::stroke(int column, int row, bool isFirst) {
  if (isPlaced() && isBrushing() && column >= 0 && row >= 0)
    act(Stroke{brush_, column, row, isFirst});
}

/// Has the thread that paints do it, with all that waits.
void Viewer::act(Deed deed) {
  state_.isLeaving = false;
  if (!isPlaced())
    return;
  if (!scene_->sculpture)
    return fail(Error::usage("a volume in pages cannot be edited; open it without --device-memory"));
  if (!acted_)
    acted_.emplace();
  if (!std::holds_alternative<Prepare>(deed) && !std::holds_alternative<ShowFrame>(deed))
    ++edits_;
  scene_->sculpture->add(std::move(deed));
  // A question that came later would leave what is to be done undone.
  painter_.insist([this, scene = scene_](const Shot &shot) {
    if (shot.scene != scene)
      return;
    Expected<Carving> carving = carve(*scene, shot);
    // What was not taken yet is to be seen, too.
    if (const auto before = carving_.take(); before && *before && carving) {
      carving->isChanged |= (*before)->isChanged;
      carving->stamps += (*before)->stamps;
    }
    carving_.put(std::move(carving));
  });
}

void Viewer::takeCarving(const Expected<Carving> &carving) {
  if (!carving) {
    show(); // What was done until then; and frames go on.
    return fail(carving.error());
  }
  edits_ += std::size_t(carving->stamps);
  log_.note("carved " + std::to_string(carving->stamps) + " stamps, " + std::to_string(carving->copiedBytes) +
            " bytes to the device, " + std::to_string(carving->voxels) + " voxels");
  if (!carving->isChanged) {
    acted_.reset();
    return;
  }
  state_.error.clear();
  state_.size = sizeText(scene_->model, *carving);
  show();
}

} // namespace voxc::view
