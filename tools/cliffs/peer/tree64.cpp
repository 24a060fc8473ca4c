// Runs the 64-tree of a folder of hand-written tracers, which is not part of voxc, on a scene and rays of a
// file: whole numbers of 32 bits (edge, voxels, x y z of each), then of 64 bits the number of rays, and the
// rays. Prints the nanoseconds of CPU time a ray, the least of some passes, and how many rays hit. Built by
// Peer.cpp.
#define main peerMain
#include VOXC_PEER
#undef main

int main(int, char **arguments) {
  FILE *const file = std::fopen(arguments[1], "rb");
  const auto read = [file](void *to, std::size_t bytes) {
    if (std::fread(to, 1, bytes, file) != bytes)
      std::exit(1);
  };
  int head[2];
  read(head, sizeof head);
  Bits bits(head[0]);
  for (int i = 0; i < head[1]; ++i) {
    int at[3];
    read(at, sizeof at);
    bits.set(at[0], at[1], at[2]);
  }
  std::uint64_t count = 0;
  read(&count, sizeof count);
  std::vector<Ray> rays(count);
  read(rays.data(), count * sizeof(Ray));
  const T64 tree(bits, Scene(8));
  double best = 1e30;
  std::uint64_t hits = 0;
  for (int pass = 0; pass < 3; ++pass) {
    const double begin = tcpu();
    hits = 0;
    for (const Ray &ray : rays) {
      int voxel[3];
      std::uint64_t steps = 0;
      std::uint32_t colour = 0;
      hits += trace64(tree, ray, voxel, steps, colour);
    }
    best = std::min(best, tcpu() - begin);
  }
  std::printf("%g %llu\n", 1e9 * best / static_cast<double>(count), static_cast<unsigned long long>(hits));
}
