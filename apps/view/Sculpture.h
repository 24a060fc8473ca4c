// A volume of a scene while it is edited: what waits to be done to it, and its states.
#pragma once

#include "view/Brush.h"

#include "voxc/Construct/EditableVolume.h"
#include "voxc/Trace/Tracer.h"

#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace voxc::view {

/// What is done to a volume.
struct Stroke {
  Brush brush;
  int column = 0, row = 0; ///< The pixel of a stamp.
  bool isFirst = false;    ///< Of a stroke, which is undone as a whole.
};
struct Undo {};
struct Redo {};
/// Of an animation.
struct ShowFrame {
  std::size_t index = 0;
};
/// Makes the volume ready, so that the first stamp is not kept waiting.
struct Prepare {};
using Deed = std::variant<Prepare, Stroke, Undo, Redo, ShowFrame>;

/// Deeds come from one thread, and are done by another, which also traces the volume.
class Sculpture {
public:
  /// The volume of the beginning, which is not in pages.
  explicit Sculpture(std::shared_ptr<const Volume> volume);

  /// At least one.
  std::size_t frames() const { return frameCount_; }

  void add(Deed deed);
  /// What waits, in its order.
  std::vector<Deed> takeDeeds();

  /// Copies the volume, if that is not done yet. Errors: as of `EditableVolume::create`.
  Expected<void> prepare();
  /// Begins what is undone as a whole, if anything is applied.
  void begin();
  /// Errors: as of `EditableVolume::apply`.
  Expected<void> apply(VoxelChange &change);
  /// False if there is nothing to undo, or to redo.
  bool undo();
  bool redo();
  /// The frame is to be seen and edited from now on; strokes of the one before stay, and cannot be undone any
  /// more. False if it is that already.
  bool showFrame(std::size_t index);
  /// Brings what was done to a tracer of the volume.
  Expected<UpdateReport> show(Tracer &tracer);

  /// The volume as it is now; it is right until the next deed.
  std::shared_ptr<const Volume> volume() const;
  /// The same, which stays as it is. Null if it is that of the beginning. Of any thread.
  std::shared_ptr<const Volume> frozen() const;
  /// Whether any frame has strokes that were not undone. Of any thread.
  bool isEdited() const;
  /// All frames as they are now, in one volume, if there are several; else null. Of any thread. Error: no
  /// addresses.
  Expected<std::shared_ptr<const Volume>> frozenFrames() const;

private:
  std::vector<EditableVolume::Snapshot> framesNow() const;
  bool hasStrokes() const { return !done_.empty() || keepsStrokes_; }

  std::shared_ptr<const Volume> first_;
  mutable std::mutex mutex_; ///< Guards all that follows.
  std::vector<Deed> deeds_;
  mutable std::optional<EditableVolume> edited_;
  std::vector<EditableVolume::Snapshot> undone_, done_; ///< States to go back to, and on to.
  bool isBeginning_ = false;                            ///< The next stamp is the first of a stroke.
  bool keepsStrokes_ = false;                           ///< Of frames that were left.
  const std::size_t frameCount_;
  std::size_t frame_ = 0;
  std::vector<EditableVolume::Snapshot> frames_; ///< As they were when another was chosen.
};

} // namespace voxc::view
