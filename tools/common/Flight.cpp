// A camera that flies: cubic curves through the numbers of cameras.
#include "Flight.h"

#include <algorithm>

namespace voxc::tool {
namespace {

/// What goes from one camera to the next.
constexpr std::size_t kNumbers = 7;

std::array<double, kNumbers> numbersOf(const FileCamera &camera) {
  return {camera.position.x, camera.position.y, camera.position.z, camera.pitch,
          camera.yaw,        camera.fov,        camera.height};
}

FileCamera cameraOf(const std::array<double, kNumbers> &numbers, const FileCamera &like) {
  FileCamera camera = like;
  camera.position = {numbers[0], numbers[1], numbers[2]};
  camera.pitch = numbers[3];
  camera.yaw = numbers[4];
  camera.fov = numbers[5];
  camera.height = numbers[6];
  return camera;
}

/// The slope between two steps: their harmonic mean, and none where it turns. So the curve never goes beyond
/// the numbers that it joins.
double slope(double before, double after) {
  return before * after > 0 ? 2 * before * after / (before + after) : 0;
}

/// The numbers before, at the begin, at the end and behind, and how far between the middle two.
double between(double p, double a, double b, double q, double part) {
  const double step = b - a;
  const double first = slope(a - p, step);
  const double last = slope(step, q - b);
  const double number =
      a + part * (first + part * (3 * step - 2 * first - last + part * (first + last - 2 * step)));
  return std::clamp(number, std::min(a, b), std::max(a, b)); // Rounding may go beyond by its last bit.
}

} // namespace

Expected<Flight> Flight::through(const std::string &path) {
  auto stops = VOXC_TRY(readCameras(path));
  if (stops.size() < 2)
    return Error::input(path + " should have two cameras or more for a flight through them; it has " +
                        std::to_string(stops.size()));
  const bool isParallel = stops.front().height != 0;
  if (std::ranges::any_of(stops, [&](const FileCamera &stop) { return (stop.height != 0) != isParallel; }))
    return Error::input(path + " should have cameras that all have a height, and so are orthographic, or "
                               "none, for a flight through them");
  Flight flight;
  flight.stops_ = std::move(stops);
  return flight;
}

FileCamera Flight::at(unsigned frame, unsigned frames) const {
  const std::size_t ways = stops_.size() - 1;
  const double time = frames < 2 ? 0 : double(frame) * double(ways) / double(frames - 1);
  const std::size_t begin = std::min(std::size_t(time), ways);
  const double part = time - double(begin);
  if (part == 0)
    return stops_[begin];
  std::array<double, kNumbers> around[4]; // Outside of the flight it rests.
  for (std::size_t i = 0; i < 4; ++i)
    around[i] = numbersOf(stops_[std::clamp(begin + i, std::size_t(1), ways + 1) - 1]);
  std::array<double, kNumbers> numbers;
  for (std::size_t i = 0; i < kNumbers; ++i)
    numbers[i] = between(around[0][i], around[1][i], around[2][i], around[3][i], part);
  return cameraOf(numbers, stops_[begin]);
}

} // namespace voxc::tool
