// From a format and an input to a volume: what `build` and `run` share.
#pragma once

#include "building/ColourLoss.h"
#include "building/PayloadOption.h"

#include "common/Command.h"
#include "common/Json.h"
#include "frontend/PassOptions.h"
#include "options/BuildArguments.h"
#include "options/BuildFigures.h"
#include "options/InputArguments.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/Support/Progress.h"
#include "voxc/Volume/Volume.h"

#include <optional>
#include <string>
#include <vector>

namespace voxc::tool {

class BuildSession {
public:
  /// Adds FORMAT, INPUT, the passes and the input's options to a command.
  void declare(const CommandLine &command);
  /// Adds --threads, unless another part of the command has it: then `useThreads` passes it on.
  void declareThreads(const CommandLine &command);
  void useThreads(unsigned threads) { buildArguments_.threads = threads; }
  /// The memory and threads to build with.
  const BuildArguments &means() const { return buildArguments_; }
  /// Adds --compress.
  void declareCompress(const CommandLine &command);
  /// Adds --frames.
  void declareFrames(const CommandLine &command);
  /// Adds --max-bytes.
  void declareMaxBytes(const CommandLine &command);
  /// The options that say how the input becomes voxels, to be filled by options of the command's own.
  InputArguments &inputArguments() { return inputArguments_; }
  /// Lets INPUT be left out in favour of `input`, and FORMAT in favour of `auto`: one argument alone is the
  /// format, unless it names an input.
  void defaultInput(const CommandLine &command, const std::string &input);

  /// An opened input, and the options by which it was opened.
  struct Opened {
    Input input;
    InputArguments arguments;
    InputOptions options;
  };

  /// INPUT as written, also where it stands alone in FORMAT's place.
  const std::string &input() const { return hasInputAlone() ? format_ : input_; }
  bool isLossy() const { return lossy_; }
  bool takesFrames() const { return frames_; }
  /// Opens the input for a format, which gets its payload and the bits of short pointers by it if that is
  /// asked for.
  Expected<Opened> open(Format &format, const CommonOptions &common, const Progress &progress,
                        Json &figures) const;

  /// The format as FORMAT and the passes say; or, if that is `auto` or left out, as voxc suggest would choose
  /// for the input and a device of this name, which a note tells.
  Expected<Format> readFormat(const std::string &device, const CommonOptions &common,
                              const Progress &progress, Json &figures);
  /// Compiles the format's constructor, opens the input and builds the volume; it is written to `path` unless
  /// that is ""; with --frames, one of all frames. The format gets its payload by the input, if that is asked
  /// for. Its figures are added;
  /// `words` also if building fails.
  Expected<Volume> build(Format &format, const std::string &path, const CommonOptions &common,
                         const Progress &progress, Json &figures) const;
  /// The same for one of several fragments of the volume.
  Expected<void> buildFragment(Format &format, std::uint64_t index, std::uint64_t count,
                               const std::string &path, const CommonOptions &common, const Progress &progress,
                               Json &figures) const;

private:
  /// A compiled constructor and an opened input.
  struct Prepared {
    Constructor constructor;
    Input input;
    InputOptions inputOptions;
    BuildOptions options;
    std::unique_ptr<RoundedSource> reduced; ///< The input in fewer colours, if that is asked for.

    VoxelSource &source() { return reduced ? *reduced : *input.source; }
  };
  Expected<Format> suggestFormat(const std::string &device, const CommonOptions &common,
                                 const Progress &progress, Json &figures);
  Expected<Format> formOf(const Format &from, const PayloadChoice *choice,
                          std::optional<int> pointerBits) const;
  std::optional<int> choosePointers(const Facts &facts, const CommonOptions &common, Json &figures) const;
  Expected<void> chooseByFacts(Format &format, VoxelSource &source,
                               const std::shared_ptr<WorkingMemory> &memory, const CommonOptions &common,
                               const Progress &progress, Json &figures) const;
  static void tellLoss(const Prepared &prepared, const BuildReport &report, const CommonOptions &common,
                       Json &figures);
  Expected<Volume> buildFrames(const Format &format, Prepared prepared, Json &figures) const;
  Expected<Prepared> prepare(Format &format, const CommonOptions &common, const Progress &progress,
                             Json &figures) const;

  bool hasInputAlone() const;

  std::optional<CommandLine> command_;
  std::string format_;
  std::string defaultInput_;      ///< "": an input has to be named.
  std::optional<Format> written_; ///< What FORMAT says, without passes.
  std::string input_;
  PassOptions passes_;
  bool isSuggested_ = false;                 ///< The format, within the words that it may have.
  std::vector<std::string> suggestedPasses_; ///< In their place, of a format that was suggested.
  ToldSentences told_;                       ///< Of the input, while a format was suggested.
  PayloadOption payload_;
  bool lossy_ = false;
  bool frames_ = false;
  InputArguments inputArguments_;
  BuildArguments buildArguments_;
};

} // namespace voxc::tool
