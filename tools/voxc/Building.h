// From a format and an input to a volume: what `build` and `run` share.
#pragma once

#include "BuildArguments.h"
#include "InputArguments.h"

#include "common/Command.h"
#include "common/Json.h"
#include "frontend/PassOptions.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/Support/Progress.h"
#include "voxc/Volume/Volume.h"

#include <string>

namespace voxc::tool {

class Building {
public:
  /// Adds FORMAT, INPUT, the passes and the input's options to a command.
  void declare(CLI::App &app);
  /// Adds --threads, unless another part of the command has it: then `useThreads` passes it on.
  void declareThreads(CLI::App &app);
  void useThreads(unsigned threads) { buildArguments_.threads = threads; }
  /// Adds --compress.
  void declareCompress(CLI::App &app);
  /// Adds --max-bytes.
  void declareMaxBytes(CLI::App &app);
  /// Lets INPUT be left out in favour of `input`.
  void defaultInput(CLI::App &app, const std::string &input);

  /// The format as FORMAT and the passes say.
  Expected<Format> readFormat() const;
  /// Compiles the format's constructor, opens the input and builds the volume; it is written to `path` unless
  /// that is "". Its figures are added; `words` also if building fails.
  Expected<Volume> build(const Format &format, const std::string &path, const CommonOptions &common,
                         const Progress &progress, Json &figures) const;
  /// The same for one of several fragments of the volume.
  Expected<void> buildFragment(const Format &format, std::uint64_t index, std::uint64_t count,
                               const std::string &path, const CommonOptions &common, const Progress &progress,
                               Json &figures) const;

private:
  /// A compiled constructor and an opened input.
  struct Prepared {
    Constructor constructor;
    Input input;
    BuildOptions options;
  };
  Expected<Prepared> prepare(const Format &format, const CommonOptions &common, const Progress &progress,
                             Json &figures) const;

  std::string format_;
  std::string input_;
  PassOptions passes_;
  InputArguments inputArguments_;
  BuildArguments buildArguments_;
};

/// Tells the warnings and notes about an input, unless told to be quiet.
void tellWarnings(const Input &input, const CommonOptions &common);

/// Adds the figures of opening an input.
void addInputFigures(Json &figures, const Input &input);

/// Adds the figures of a build.
void addBuildFigures(Json &figures, const BuildReport &report);

/// Adds the size of a file that was written.
void addFileFigure(Json &figures, const std::string &path);

} // namespace voxc::tool
