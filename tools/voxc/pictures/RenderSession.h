// From a prepared volume to a picture file, or to those of a flight: what `render` and `run` share.
#pragma once

#include "pictures/FlightOption.h"
#include "pictures/PictureRays.h"

#include "common/ClipOptions.h"
#include "common/Command.h"
#include "common/PictureOptions.h"
#include "common/Terminal.h"
#include "tracing/ErrorCheck.h"
#include "tracing/TraceSession.h"

#include <optional>
#include <string>

namespace voxc::tool {

class RenderSession {
public:
  /// Adds --output, --check and the options of pictures to a command.
  void declare(const CommandLine &command);

  /// Looks at the options before any work. The picture of `source`, a file's name or another word, is named
  /// after that where no name was given.
  Expected<void> check(const std::string &source, const CommonOptions &common);
  /// Lets the kernel stop early if --lod says so. Error: the format asks for less than a picture needs.
  Expected<void> applyTo(Format &format) const;
  /// Lets coarse blocks that look smaller than so many pixels stand in for pages.
  void allowCoarse(double pixels) { picture_.coarse = pixels; }
  /// Whether the picture asks for normals.
  bool looksAround(const VolumeInfo &info) const { return tool::looksAround(picture_, info); }
  /// Takes the picture and writes it, or all frames of a flight. Its figures are added, `files` and `camera`
  /// among them, and `frames` of a flight. `normals` are the volume's, found as they are needed.
  Expected<void> render(const Volume &volume, SurfaceNormals &normals, TraceSession &tracing,
                        const CommonOptions &common, ProgressBar &bar, Json &figures) const;

private:
  /// What is odd about a camera, if anything is.
  using Warning = std::optional<std::string>;

  Expected<Warning> takeOne(const Volume &volume, const RenderOptions &options, PictureRays &rays,
                            Json &figures) const;
  Expected<Warning> takeFlight(const Volume &volume, const RenderOptions &options, PictureRays &rays,
                               Json &figures) const;

  std::string output_;
  PictureOptions picture_;
  FlightOption flight_;
  ClipOptions clip_;
  ErrorCheck check_{0}; // A picture is to be seen; checking takes an oracle of the whole volume.
};

} // namespace voxc::tool
