// touched VOLUME.hvx RAYS EVERY: words and different cache lines that a ray of a file reads, the mean of
// every EVERY-th ray. Built around a kernel, of which `voxc_intersect` is the function; touched.h counts for
// it.
#include "touched.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <vector>

extern "C" void voxc_intersect(const std::uint32_t *words, const float *rays, std::uint32_t *hits,
                               unsigned long long count, int countLookups, float spread);

namespace {

// docs/hvx.md: where the first stream begins stands in the first row of the table of streams.
constexpr std::size_t kFirstStreamAt = 168 + 48;
constexpr std::size_t kRayFloats = 6, kHitWords = 6, kLookups = 5;

template <typename T> std::vector<T> read(const char *path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) {
    std::fprintf(stderr, "cannot read '%s'\n", path);
    std::exit(1);
  }
  std::vector<T> data(static_cast<std::size_t>(file.tellg()) / sizeof(T));
  file.seekg(0);
  file.read(reinterpret_cast<char *>(data.data()), static_cast<std::streamsize>(data.size() * sizeof(T)));
  return data;
}

} // namespace

int main(int argc, char **argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: touched VOLUME.hvx RAYS EVERY\n");
    return 2;
  }
  const auto volume = read<std::uint32_t>(argv[1]);
  const auto rays = read<float>(argv[2]);
  const std::size_t every = std::strtoull(argv[3], nullptr, 10);
  const std::uint32_t *words = volume.data() + volume[kFirstStreamAt / 4] / 4;
  std::uint64_t count = 0, lookups = 0, lines = 0;
  for (std::size_t i = 0; i + kRayFloats <= rays.size(); i += kRayFloats * every, ++count) {
    std::uint32_t hit[kHitWords];
    linesRead.clear();
    voxc_intersect(words, &rays[i], hit, 1, 1, 0);
    lookups += hit[kLookups];
    lines += linesRead.size();
  }
  const double n = static_cast<double>(count);
  std::printf("%.2f %.2f %.2f\n", double(lookups) / n, double(wordsRead) / n, double(lines) / n);
}
