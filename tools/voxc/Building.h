// From a format and an input to a volume: what `build` and `run` share.
#pragma once

#include "InputArguments.h"

#include "common/Command.h"
#include "common/Json.h"
#include "frontend/PassOptions.h"
#include "voxc/Support/Progress.h"
#include "voxc/Volume/Volume.h"

#include <string>

namespace voxc::tool {

class Building {
public:
  /// Adds FORMAT, INPUT, the passes and the input's options to a command.
  void declare(CLI::App &app);
  /// Lets INPUT be left out in favour of `input`.
  void defaultInput(CLI::App &app, const std::string &input);

  /// The format as FORMAT and the passes say.
  Expected<Format> readFormat() const;
  /// Compiles the format's constructor, opens the input and builds the volume. Its figures are added.
  Expected<Volume> build(const Format &format, const CommonOptions &common, const Progress &progress,
                         Json &figures) const;

private:
  std::string format_;
  std::string input_;
  PassOptions passes_;
  InputArguments inputArguments_;
};

/// Writes a volume and adds file_bytes.
Expected<void> saveVolume(const Volume &volume, const std::string &path, Json &figures);

} // namespace voxc::tool
