// Volumes that change: generated code replaces what an edit touches, from the cells up to the root, behind
// the words that are there. What was before stays readable, so that a snapshot costs nothing.
#pragma once

#include "voxc/Construct/Constructor.h"
#include "voxc/Source/VoxelChange.h"
#include "voxc/Support/CompileCache.h"
#include "voxc/Support/WorkingMemory.h"
#include "voxc/Volume/Volume.h"
#include "voxc/Volume/WordRange.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace voxc {

struct EditableOptions {
  /// Where the words lie; null: `WorkingMemory::createDefault()`.
  std::shared_ptr<WorkingMemory> memory;
  const CompileCache *cache = nullptr; ///< Where compiled code is looked for.
  /// Finds nodes of the first volume that are equal to new ones, which takes a pass over all of them; else
  /// new ones are shared among each other alone.
  bool shareWithFirst = true;
};

/// What an edit came to.
struct EditReport {
  std::int64_t moreVoxels = 0;  ///< Than there were.
  std::uint64_t addedWords = 0; ///< Behind those that were there.
};

/// A volume in memory and what it becomes by edits. Its words are only added to, but for those of its head
/// and of a grid of the first level, until a snapshot is taken. One thread edits; others may trace a `view`.
class EditableVolume {
public:
  /// Copies the words of a volume. Attributes and other streams do not come along, but for frames. Errors:
  /// the format cannot be edited (`Input`, naming what stands against it); no memory; the compiler's.
  static Expected<EditableVolume> create(const Volume &volume, const EditableOptions &options = {});
  ~EditableVolume();
  EditableVolume(EditableVolume &&) noexcept;
  EditableVolume &operator=(EditableVolume &&) noexcept;

  /// Does one edit as a whole; voxels outside of the extent stay empty. Errors, after which nothing has
  /// changed: a word that the format cannot keep, more words than references can reach (`Input`); no memory.
  Expected<EditReport> apply(VoxelChange &change);

  /// A state to come back to. It holds as long as the volume was not compacted.
  struct Snapshot {
    Ref root = 0;
    std::uint64_t voxels = 0;
  };
  /// The state now. From here on no word of it changes: the next edit of a large grid in the first level
  /// copies it.
  Snapshot snapshot();
  /// Makes a state that of the volume again, be it older or newer: undo and redo.
  void restore(const Snapshot &snapshot);

  /// The frames of the volume that this began with, if it had several; else none.
  std::vector<Snapshot> frames() const;

  /// The volume as it is now. Its words are those that edits change: it is right until the next edit, and
  /// then asked for again. A tracer that traces it goes on after `Tracer::follow`.
  std::shared_ptr<const Volume> volume();
  /// A state as a volume of its own, at the cost of the addresses: it may be traced by other threads while
  /// edits go on. Error: no addresses.
  Expected<Volume> view(const Snapshot &snapshot);

  /// A volume whose frames are these states, at least one, of which it begins with the first
  /// (`voxc/Volume/Frames.h`); edits may go on beside it. Error: no addresses.
  Expected<Volume> framed(const std::vector<Snapshot> &states);

  /// Non-empty voxels.
  std::uint64_t voxels() const;
  /// Words of all states together.
  std::uint64_t words() const;
  /// The words that are others than at the last call, in rising order: what a copy of `volume()` lacks.
  std::vector<WordRange> takeChanges();
  /// Changes that were taken and not copied, as where `Tracer::follow` failed: the next call has them again.
  void putBackChanges(std::span<const WordRange> changes);

  /// True if the words are more than half as many again as those of the first volume: much of them is of no
  /// state.
  bool wantsCompaction() const;
  /// Builds the volume of the voxels as they are: the bytes are those of any build of them. Errors: as
  /// `Constructor::build`.
  BuildResult compact(const BuildOptions &options = {}) const;

  /// Seconds from the text to callable code.
  double compileSeconds() const;

private:
  struct State;
  explicit EditableVolume(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

} // namespace voxc
