// States of an edited volume.
#include "view/Sculpture.h"

#include "voxc/Support/UserCache.h"
#include "voxc/Volume/Frames.h"

#include <algorithm>
#include <utility>

namespace voxc::view {

Sculpture::Sculpture(std::shared_ptr<const Volume> volume)
    : first_(std::move(volume)), frameCount_(std::max<std::size_t>(framesOf(*first_).size(), 1)) {}

void Sculpture::add(Deed deed) {
  const std::lock_guard lock(mutex_);
  deeds_.push_back(std::move(deed));
}

std::vector<Deed> Sculpture::takeDeeds() {
  const std::lock_guard lock(mutex_);
  return std::exchange(deeds_, {});
}

Expected<void> Sculpture::prepare() {
  const std::lock_guard lock(mutex_);
  if (edited_)
    return {};
  // Strokes are few beside the scene: to go through all of it would keep the first one waiting.
  auto edited = VOXC_TRY(EditableVolume::create(*first_, {.cache = compileCache(), .shareWithFirst = false}));
  edited_.emplace(std::move(edited));
  frames_ = edited_->frames();
  return {};
}

void Sculpture::begin() {
  const std::lock_guard lock(mutex_);
  isBeginning_ = true;
}

Expected<void> Sculpture::apply(VoxelChange &change) {
  const std::lock_guard lock(mutex_);
  std::optional<EditableVolume::Snapshot> before;
  if (isBeginning_)
    before = edited_->snapshot();
  if (const auto report = edited_->apply(change); !report)
    return report.error();
  if (before) {
    isBeginning_ = false;
    done_.push_back(*before);
    undone_.clear();
  }
  return {};
}

bool Sculpture::undo() {
  const std::lock_guard lock(mutex_);
  if (done_.empty())
    return false;
  undone_.push_back(edited_->snapshot());
  edited_->restore(done_.back());
  done_.pop_back();
  return true;
}

bool Sculpture::redo() {
  const std::lock_guard lock(mutex_);
  if (undone_.empty())
    return false;
  done_.push_back(edited_->snapshot());
  edited_->restore(undone_.back());
  undone_.pop_back();
  return true;
}

bool Sculpture::showFrame(std::size_t index) {
  const std::lock_guard lock(mutex_);
  if (index == frame_ || index >= frames_.size())
    return false;
  frames_[frame_] = edited_->snapshot();
  edited_->restore(frames_[index]);
  frame_ = index;
  keepsStrokes_ = hasStrokes();
  done_.clear();
  undone_.clear();
  return true;
}

/// Precondition: `mutex_` is held, and the volume is ready.
std::vector<EditableVolume::Snapshot> Sculpture::framesNow() const {
  std::vector<EditableVolume::Snapshot> frames = frames_;
  if (!frames.empty())
    frames[frame_] = edited_->snapshot();
  return frames;
}

Expected<UpdateReport> Sculpture::show(Tracer &tracer) {
  const std::lock_guard lock(mutex_);
  const std::vector<WordRange> changes = edited_->takeChanges();
  auto report = tracer.follow(*edited_->volume(), changes);
  if (!report)
    edited_->putBackChanges(changes); // The device lacks them.
  return report;
}

std::shared_ptr<const Volume> Sculpture::volume() const {
  const std::lock_guard lock(mutex_);
  return edited_ ? edited_->volume() : first_;
}

std::shared_ptr<const Volume> Sculpture::frozen() const {
  const std::lock_guard lock(mutex_);
  if (!edited_ || (!hasStrokes() && frame_ == 0))
    return nullptr;
  auto view = edited_->view(edited_->snapshot());
  return view ? std::make_shared<const Volume>(std::move(*view)) : nullptr;
}

bool Sculpture::isEdited() const {
  const std::lock_guard lock(mutex_);
  return hasStrokes();
}

Expected<std::shared_ptr<const Volume>> Sculpture::frozenFrames() const {
  const std::lock_guard lock(mutex_);
  if (frameCount_ < 2 || !edited_)
    return frameCount_ < 2 ? nullptr : first_;
  auto framed = VOXC_TRY(edited_->framed(framesNow()));
  return std::make_shared<const Volume>(std::move(framed));
}

} // namespace voxc::view
