// Fuzzes flights through files of cameras: every frame lies between the cameras, and the ends are cameras of
// the file.
#include "Expect.h"
#include "FuzzedFile.h"

#include "common/Flight.h"

#include <algorithm>
#include <cmath>

namespace {

using namespace voxc::tool;
using voxc::fuzz::expect;

/// The least and the greatest of a number over all cameras.
struct Bounds {
  double least, greatest;
  void require(double number) const {
    expect(std::isfinite(number) && number >= least && number <= greatest);
  }
};

template <typename Number> Bounds boundsOf(const std::vector<FileCamera> &cameras, const Number &number) {
  const auto [least, greatest] = std::ranges::minmax(cameras, {}, number);
  return {number(least), number(greatest)};
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  const std::string path = voxc::fuzz::folder().write("cameras.json", voxc::fuzz::textOf(data, size));
  const auto flight = Flight::through(path);
  const auto cameras = readCameras(path);
  expect(static_cast<bool>(flight) == (cameras && cameras->size() >= 2));
  if (!flight)
    return 0;
  constexpr auto kX = [](const FileCamera &camera) { return camera.position.x; };
  constexpr auto kPitch = [](const FileCamera &camera) { return camera.pitch; };
  constexpr auto kFov = [](const FileCamera &camera) { return camera.fov; };
  const Bounds x = boundsOf(*cameras, kX), pitch = boundsOf(*cameras, kPitch), fov = boundsOf(*cameras, kFov);
  for (const unsigned frames : {1u, 2u, 7u, 1000000u})
    for (const unsigned frame : {0u, frames / 3, frames - 1}) {
      const FileCamera camera = flight->at(frame, frames);
      x.require(kX(camera)), pitch.require(kPitch(camera)), fov.require(kFov(camera));
    }
  expect(kX(flight->at(0, 9)) == kX(cameras->front()) && kX(flight->at(8, 9)) == kX(cameras->back()));
  return 0;
}
