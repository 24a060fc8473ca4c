// The options of a flight: its cameras, its frames, and the names of their pictures.
#pragma once

#include "common/CommandLine.h"
#include "common/Flight.h"
#include "common/NumberedName.h"

#include <optional>
#include <string>

namespace voxc::tool {

class FlightOption {
public:
  /// Adds --flight and --frames to a command that has --camera and --view.
  void declare(const CommandLine &command);

  bool isGiven() const { return !path_.empty(); }
  /// Reads the cameras before any work. Pictures are called `output`, in which ### or %03d is the
  /// place of the frame's number. Errors: those of `Flight::through`; `Usage`, the name has not one such
  /// place.
  Expected<void> check(const std::string &output);

  unsigned frames() const { return frames_; }
  FileCamera camera(unsigned frame) const { return flight_->at(frame, frames_); }
  /// The name of a frame's picture.
  std::string pictureName(unsigned frame) const { return (*name_)(frame); }

private:
  std::string path_;
  unsigned frames_ = 100;
  std::optional<Flight> flight_;
  std::optional<NumberedPath> name_;
};

} // namespace voxc::tool
