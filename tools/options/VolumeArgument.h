// The V.hvx argument of the commands that take a finished volume.
#pragma once

#include "common/Command.h"
#include "common/CommandLine.h"
#include "frontend/AttributeOptions.h"
#include "frontend/PassOptions.h"
#include "voxc/Construct/EditJournal.h"
#include "voxc/Volume/Frames.h"
#include "voxc/Volume/VolumeSummary.h"

#include <memory>
#include <string>
#include <type_traits>

namespace voxc::tool {

/// The error of opening a volume; where the file is none, with what is done with other inputs.
Error volumeFailure(Error error);

/// What a file keeps of its voxels beside the words, which edits leave out.
struct SideStreams {
  bool attributes = false, coarseBlocks = false;
};
SideStreams sideStreamsOf(const VolumeSummary &summary);

class VolumeArgument {
public:
  /// Adds VOLUME and --trusted to a command. `help`: what else it takes.
  void declare(const CommandLine &command, const std::string &help = "A .hvx file");
  /// Adds --precision and the traversal passes, for a command that traces the volume.
  void declareKernelOptions(const CommandLine &command);
  /// Adds --ray-bounds, for a command that gives its rays bounds.
  void declareBounds(const CommandLine &command) { attributes_.declareBounds(command); }

  /// The volume, with the edits that wait in its journal.
  /// Decoded within the bound of `memory`; null: the default one.
  Expected<Volume> load(std::shared_ptr<WorkingMemory> memory = nullptr) const;
  /// The volume as its file has it, and those edits.
  Expected<WaitingVolume> loadWaiting(std::shared_ptr<WorkingMemory> memory) const;
  std::string path() const { return withoutFrame(path_); }
  /// Which frame was asked for, from 1 on, by --frame or behind the path; 0: none.
  Expected<int> frame() const;
  /// How the volume is loaded. Error: as of `frame`.
  Expected<LoadOptions> loadOptions() const;
  /// Before the frame that was asked for is written to a file: says which part of the volume that is, if it
  /// has others. Error (`Usage`): the file is the one that is read, and would lose them.
  Expected<void> leaveOtherFrames(const std::string &output, const CommonOptions &common) const;
  /// Says of a volume that `load` gave that edits in its journal have taken its attributes or its coarse
  /// blocks away, if they have.
  void noteLostStreams(const Volume &loaded, const CommonOptions &common) const;
  /// Whether offsets were left unproven.
  bool trusted() const { return trusted_; }
  /// The format that a kernel of `volume` shall traverse. Error: options that do not go together.
  Expected<Format> kernelFormat(const Volume &volume) const;

private:
  template <typename Load>
  std::invoke_result_t<Load, LoadOptions> loadBy(std::shared_ptr<WorkingMemory> memory,
                                                 const Load &load) const;

  std::string path_;
  int frame_ = 0;
  bool trusted_ = false;
  std::uint64_t mostCubes_ = kMostCubes;
  AttributeOptions attributes_;
  PassOptions traversalPasses_;
};

} // namespace voxc::tool
