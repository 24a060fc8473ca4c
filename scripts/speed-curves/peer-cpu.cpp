// Runs a tracer of a folder of hand-written ones, which is not part of voxc, natively on the scene of that folder and on the rays of
// files: its 64-tree, or with OCTANTS its octant distances. Prints, a line for each file, million rays a CPU second, the best of three
// passes, and how many hit.
#define main peerMain
#ifdef OCTANTS
#include "t_aadf.cpp"
#else
#include "t_own.cpp"
#endif
#undef main

namespace {

std::vector<Ray> raysOf(const char *path) {
  FILE *const file = std::fopen(path, "rb");
  std::vector<Ray> rays;
  for (Ray ray; file != nullptr && std::fread(&ray, sizeof ray, 1, file) == 1;)
    rays.push_back(ray);
  return rays;
}

double cpuSeconds() {
  timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

} // namespace

int main(int count, char **arguments) {
  const Scene scene(std::atoi(arguments[1]));
#ifdef OCTANTS
  AADF grid(scene);
  const auto trace = [&](const Ray &ray, int *voxel, std::uint64_t &steps) { return tr(grid, ray, voxel, steps); };
#else
  Bits bits(scene.N);
  scene.each([&](int x, int y, int z) { bits.set(x, y, z); });
  const T64 tree(bits, scene);
  std::uint32_t colour = 0;
  const auto trace = [&](const Ray &ray, int *voxel, std::uint64_t &steps) {
    return trace64(tree, ray, voxel, steps, colour);
  };
#endif
  for (int i = 2; i < count; ++i) {
    const std::vector<Ray> rays = raysOf(arguments[i]);
    double best = 1e30;
    std::uint64_t hits = 0;
    for (int pass = 0; pass < 3; ++pass) {
      const double begin = cpuSeconds();
      hits = 0;
      for (const Ray &ray : rays) {
        int voxel[3];
        std::uint64_t steps = 0;
        hits += trace(ray, voxel, steps);
      }
      best = std::min(best, cpuSeconds() - begin);
    }
    std::printf("%g %llu\n", 1e-6 * static_cast<double>(rays.size()) / best, static_cast<unsigned long long>(hits));
  }
}
