// Traces the rays of files by the functions of a header, voxc_scene.hpp, natively and one after another. Prints, a line for each file,
// million rays a CPU second, the best of three passes, and how many differ from the hits that stand beside it.
//   header-cpu WORDS RAYS HITS [RAYS HITS...]
#include "voxc_scene.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <fstream>
#include <iterator>
#include <limits>
#include <vector>

namespace {

template <typename T> std::vector<T> read(const char *path) {
  std::ifstream file(path, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  std::vector<T> items(bytes.size() / sizeof(T));
  std::memcpy(items.data(), bytes.data(), items.size() * sizeof(T));
  return items;
}

struct Ray {
  float origin[3], direction[3];
};

struct Hit {
  std::int32_t voxel[3];
  std::uint32_t rgba;
  float t;
  std::uint32_t steps;
};

double cpuSeconds() {
  timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

Hit trace(const std::vector<std::uint32_t> &words, const Ray &ray) {
  const auto &[from, step] = ray;
  voxc_scene_Hit hit;
  if (!voxc_scene_closest(words.data(), {from[0], from[1], from[2]}, {step[0], step[1], step[2]}, 0,
                          std::numeric_limits<float>::infinity(), hit))
    return {{-1, -1, -1}, 0, 0, 0};
  return {{hit.voxel.x, hit.voxel.y, hit.voxel.z}, hit.colour, hit.t, 0};
}

bool differ(const Hit &a, const Hit &b) {
  if (a.voxel[0] < 0 || b.voxel[0] < 0)
    return a.voxel[0] != b.voxel[0];
  return !std::equal(a.voxel, a.voxel + 3, b.voxel) || a.rgba != b.rgba || a.t != b.t;
}

} // namespace

int main(int count, char **arguments) {
  const auto words = read<std::uint32_t>(arguments[1]);
  for (int i = 2; i + 1 < count; i += 2) {
    const auto rays = read<Ray>(arguments[i]);
    const auto expected = read<Hit>(arguments[i + 1]);
    std::vector<Hit> hits(rays.size());
    double best = std::numeric_limits<double>::infinity();
    for (int pass = 0; pass < 3; ++pass) {
      const double begin = cpuSeconds();
      for (std::size_t ray = 0; ray < rays.size(); ++ray)
        hits[ray] = trace(words, rays[ray]);
      best = std::min(best, cpuSeconds() - begin);
    }
    std::size_t wrong = 0;
    for (std::size_t ray = 0; ray < rays.size(); ++ray)
      wrong += differ(hits[ray], expected[ray]);
    std::printf("%g %zu\n", 1e-6 * static_cast<double>(rays.size()) / best, wrong);
  }
}
