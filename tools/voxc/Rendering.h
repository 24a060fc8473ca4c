// From a prepared volume to a picture file: what `render` and `run` share.
#pragma once

#include "ErrorCheck.h"
#include "Tracing.h"

#include "common/CameraOptions.h"
#include "common/Command.h"
#include "voxc/Support/Progress.h"

#include <string>

namespace voxc::tool {

class Rendering {
public:
  /// Adds --output, --heatmap, --check and the camera's options to a command.
  void declare(CLI::App &app);

  /// Looks at the output's path and the camera's options, before any work.
  Expected<void> check(const CommonOptions &common) const;
  /// Lets the kernel stop early if --lod says so. Error: the format asks for less than a picture needs.
  Expected<void> applyTo(Format &format) const;
  /// Traces the camera's rays and writes the picture. Its figures are added.
  Expected<void> render(const Volume &volume, Tracing &tracing, const Progress &progress,
                        Json &figures) const;

private:
  std::string output_;
  bool heatmap_ = false;
  double lod_ = 0; ///< Pixels; 0: full detail.
  CameraOptions camera_;
  ErrorCheck check_;
};

} // namespace voxc::tool
