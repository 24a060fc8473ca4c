// The options of a flight.
#include "pictures/FlightOption.h"

namespace voxc::tool {
namespace {

constexpr unsigned kMostFrames = 1000000;

} // namespace

void FlightOption::declare(const CommandLine &command) {
  const OptionGroup group(command, "Picture");
  const Option flight = command
                            .add("--flight", path_,
                                 "A picture for each frame of a flight through all cameras of a camera file; "
                                 "--output has ### or %03d in its name, for the frame's number")
                            .takes("FILE")
                            .excludes(command.option("--camera"))
                            .excludes(command.option("--view"));
  command.add("--frames", frames_, "Frames of the flight, from its first camera to its last")
      .takes("N")
      .between(1u, kMostFrames)
      .showsDefault()
      .needs(flight);
}

Expected<void> FlightOption::check(const std::string &output) {
  name_ = parseNumberedName(output);
  if (!name_)
    return Error::usage("a flight is many pictures, but the name '" + output +
                        "' has not one place for the number of the frame; give one such as flight-###.png or "
                        "flight-%03d.png");
  flight_ = VOXC_TRY(Flight::through(path_));
  return {};
}

} // namespace voxc::tool
