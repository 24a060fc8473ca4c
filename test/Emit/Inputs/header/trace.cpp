// Rays from a file through words from a file, to hits as `voxc trace` writes them.
#include "voxc_r2_2_2_g3.h"

#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <vector>

template <typename T> std::vector<T> read(const char *path) {
  std::ifstream file(path, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  std::vector<T> items(bytes.size() / sizeof(T));
  std::memcpy(items.data(), bytes.data(), items.size() * sizeof(T));
  return items;
}

struct Record {
  int voxel[3];
  unsigned int colour;
  float t;
  unsigned int face;
};

int main(int, char **arguments) {
  const auto words = read<unsigned int>(arguments[1]);
  const auto rays = read<float>(arguments[2]);
  for (std::size_t i = 0; i < rays.size(); i += 6) {
    const float *r = &rays[i];
    voxc_r2_2_2_g3_Hit hit;
    const bool found = voxc_r2_2_2_g3_closest(words.data(), {r[0], r[1], r[2]}, {r[3], r[4], r[5]}, 0,
                                              std::numeric_limits<float>::infinity(), hit);
    const unsigned int face = !found ? 0 : hit.axis < 0 ? 6 : unsigned(2 * hit.axis + (hit.side > 0));
    const Record record{{hit.voxel.x, hit.voxel.y, hit.voxel.z}, hit.colour, hit.t, face};
    std::fwrite(&record, sizeof record, 1, stdout);
  }
}
