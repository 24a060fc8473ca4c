// The options of a flight.
#include "FlightOption.h"

#include <cstddef>

namespace voxc::tool {
namespace {

constexpr unsigned kMostFrames = 1000000;

/// Where the number stands.
struct Place {
  std::size_t first = 0;
  std::size_t count = 0;
};

Place placeIn(const std::string &pattern) {
  const std::size_t first = pattern.find('#');
  if (first == std::string::npos)
    return {};
  const std::size_t end = pattern.find_first_not_of('#', first);
  return {first, (end == std::string::npos ? pattern.size() : end) - first};
}

} // namespace

void FlightOption::declare(const CommandLine &command) {
  const OptionGroup group(command, "Picture");
  const Option flight =
      command
          .add("--flight", path_,
               "A picture for each frame of a flight through all cameras of a camera file; --output has # "
               "in its name, for the frame's number")
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
  const Place place = placeIn(output);
  if (place.count == 0 || output.find('#', place.first + place.count) != std::string::npos)
    return Error::usage("a flight is many pictures, but the name '" + output +
                        "' has not one place for the number of the frame; give one such as flight-###.png");
  auto flight = Flight::through(path_);
  if (!flight)
    return flight.error();
  flight_ = std::move(*flight);
  return {};
}

std::string frameName(const std::string &pattern, unsigned frame) {
  const Place place = placeIn(pattern);
  std::string number = std::to_string(frame);
  if (number.size() < place.count)
    number.insert(0, place.count - number.size(), '0');
  return std::string(pattern).replace(place.first, place.count, number);
}

} // namespace voxc::tool
