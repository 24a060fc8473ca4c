// Runs a hand-written kernel of a folder of tracers, which is not part of voxc, on the rays of a file in place of those of its three
// cameras: $RAYS is the file, whose rays are repeated until there are as many as the tracer asks for.
#include "scene.h"

#include <cstdlib>

namespace {

void raysOfFile(int, int, int width, int height, std::vector<Ray> &rays) {
  FILE *const file = std::fopen(std::getenv("RAYS"), "rb");
  for (Ray ray; file != nullptr && std::fread(&ray, sizeof ray, 1, file) == 1;)
    rays.push_back(ray);
  const std::size_t count = rays.size();
  if (count == 0)
    std::exit(1);
  rays.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (std::size_t i = count; i < rays.size(); ++i)
    rays[i] = rays[i - count];
}

} // namespace

#define make_rays raysOfFile
#include "vkbench.cpp"
