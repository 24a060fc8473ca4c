// Fuzzes flights through files of cameras: every frame lies between the cameras, and the ends are cameras of
// the file.
#include "Expect.h"
#include "FuzzedFile.h"

#include "common/Flight.h"

#include <algorithm>
#include <vector>

namespace {

using namespace voxc::tool;
using voxc::fuzz::expect;

/// What goes from one camera to the next.
using Number = double (*)(const FileCamera &);
constexpr Number kNumbers[] = {
    [](const FileCamera &camera) { return camera.position.x; },
    [](const FileCamera &camera) { return camera.position.y; },
    [](const FileCamera &camera) { return camera.position.z; },
    [](const FileCamera &camera) { return camera.pitch; },
    [](const FileCamera &camera) { return camera.yaw; },
    [](const FileCamera &camera) { return camera.fov; },
};

void expectBetween(const Flight &flight, const std::vector<FileCamera> &cameras, Number number) {
  const auto [least, greatest] = std::ranges::minmax(cameras, {}, number);
  for (const unsigned frames : {1u, 2u, 7u, 1000000u})
    for (const unsigned frame : {0u, frames / 3, frames / 2, frames - 1}) {
      const double found = number(flight.at(frame, frames));
      expect(found >= number(least) && found <= number(greatest));
    }
  expect(number(flight.at(0, 9)) == number(cameras.front()) &&
         number(flight.at(8, 9)) == number(cameras.back()));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  const std::string path = voxc::fuzz::folder().write("cameras.json", voxc::fuzz::textOf(data, size));
  const auto flight = Flight::through(path);
  const auto cameras = readCameras(path);
  expect(static_cast<bool>(flight) == (cameras && cameras->size() >= 2));
  if (!flight)
    return 0;
  for (const Number number : kNumbers)
    expectBetween(*flight, *cameras, number);
  return 0;
}
