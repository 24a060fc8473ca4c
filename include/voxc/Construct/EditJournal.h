// A journal of edits beside a volume file: an edit is on the disk in the time that writing it takes, and the
// file is built anew when that is asked for.
#pragma once

#include "voxc/Source/Edit.h"
#include "voxc/Support/CompileCache.h"
#include "voxc/Support/Error.h"
#include "voxc/Volume/Volume.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace voxc {

/// The journal `journalPathOf(path)` of the volume file `path`, opened for adding. No other process has it
/// open so.
class EditJournal {
public:
  /// Opens it, or begins one, which is removed again if no edits come to it. What a process that was killed
  /// has left of a last transaction is cut off.
  /// Errors: no volume file; a journal of another file (`Input`); another process has it; nothing can be
  /// written there
  /// (`Environment`).
  static Expected<EditJournal> open(const std::string &path);
  ~EditJournal();
  EditJournal(EditJournal &&) noexcept;
  EditJournal &operator=(EditJournal &&) = delete;

  /// What the file says of itself.
  const VolumeInfo &volume() const { return info_; }
  /// Transactions so far.
  std::uint64_t transactions() const { return transactions_; }

  /// Adds edits as one transaction; it is on the disk on return. Volumes that they paste are kept in the
  /// journal. Where the format states something of all voxels, the volume is loaded, and makes the edits
  /// first. Errors, after which nothing was added: an edit that reaches out of the extent, naming its place
  /// among them, or a word that the format cannot keep (`Input`); those of `loadEdited`; `Environment`.
  Expected<void> append(const std::vector<VoxelEdit> &edits, const LoadOptions &options = {},
                        const CompileCache *cache = nullptr);

  /// Gives `compacted`, a volume file with all edits in the folder of this volume's file, the name and the
  /// permissions of that, and removes the journal. Whenever the process ends, file and journal fit each
  /// other. Errors (`Environment`), after which the volume and its journal are as before, and `compacted` is
  /// removed.
  Expected<void> fold(const std::string &compacted);

private:
  EditJournal(std::string volumePath, std::string path, int file)
      : volumePath_(std::move(volumePath)), path_(std::move(path)), file_(file) {}
  Expected<void> prove(const std::vector<VoxelEdit> &edits, const LoadOptions &options,
                       const CompileCache *cache) const;
  Expected<void> close(const std::string &compacted);
  Expected<void> write(const std::string &record);

  std::string volumePath_;
  std::string path_;
  int file_ = -1;
  bool isEmpty_ = false; ///< It has been begun, and has no edits yet.
  VolumeInfo info_;
  std::uint64_t transactions_ = 0;
};

/// The edits of all whole transactions of the journal beside a volume file, in their order; none where there
/// is no journal. The volumes that they paste are decoded within the bound of `memory`, all of them together;
/// null: the default one. Errors (`Input`): a journal of another file, or a broken one.
Expected<std::vector<VoxelEdit>> readJournal(const std::string &path,
                                             std::shared_ptr<WorkingMemory> memory = nullptr);

/// A volume as its file has it, and the edits that wait for it, of one moment: other processes may put them
/// into the file meanwhile. Errors: as `Volume::load` and `readJournal`.
struct WaitingVolume {
  Volume volume;
  std::vector<VoxelEdit> edits;
};
Expected<WaitingVolume> loadWaiting(const std::string &path, const LoadOptions &options = {});

/// A volume file with the edits of its journal. Errors: as `Volume::load`, `readJournal` and
/// `EditableVolume`.
Expected<Volume> loadEdited(const std::string &path, const LoadOptions &options = {},
                            const CompileCache *cache = nullptr);

} // namespace voxc
