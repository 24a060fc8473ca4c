// Traces rays with the variant that the kernel picks on this processor, or on one of a lower level:
// variants LEVEL VOLUME RAYS HITS
#include "intersect.h"

#include <voxc/Trace/CpuKernel.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string_view>
#include <vector>

// What the kernel asks about the processor; libgcc's, whose bits 97 and 98 from the first of another word on are levels 3
// and 4 of x86-64.
extern "C" std::uint32_t __cpu_features2[];

// The variants and the one that is picked, which are not to be seen in the object as it is written.
extern "C" {
using Kernel = void(const std::uint32_t *, const float *, std::uint32_t *, unsigned long long, int, float);
Kernel baseline asm("voxc_intersect.x86_64");
Kernel level3 asm("voxc_intersect.x86_64_v3");
Kernel level4 asm("voxc_intersect.x86_64_v4");
extern Kernel *picked asm("_ZN4voxc12_GLOBAL__N_16kernelE");
}

namespace {

std::string_view nameOf(const Kernel *kernel) {
  return kernel == level4 ? "x86-64-v4" : kernel == level3 ? "x86-64-v3" : kernel == baseline ? "x86-64" : "none";
}

/// What is to be picked: asked of the compiler of this program, and in its words.
std::string_view expected(int level) {
  if (level >= 4 && __builtin_cpu_supports("x86-64-v4"))
    return "x86-64-v4";
  return level >= 3 && __builtin_cpu_supports("x86-64-v3") ? "x86-64-v3" : "x86-64";
}

std::vector<voxc::Ray> readRays(const char *file) {
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  std::vector<voxc::Ray> rays(static_cast<std::size_t>(stream.tellg()) / sizeof(voxc::Ray));
  stream.seekg(0).read(reinterpret_cast<char *>(rays.data()), std::streamsize(rays.size() * sizeof(voxc::Ray)));
  return rays;
}

} // namespace

int main(int, char **arguments) {
  const int level = std::atoi(arguments[1]);
  const auto volume = voxc::Volume::load(arguments[2]);
  const std::vector<voxc::Ray> rays = readRays(arguments[3]);
  const std::string_view best = expected(level);
  const bool isFirst = nameOf(picked) == "none";
  __cpu_features2[2] &= level == 4 ? ~0u : level == 3 ? ~4u : ~6u;

  const voxc::CpuKernel kernel{voxc_intersect, VOXC_INTERSECT_STORAGE_DIGEST, nullptr};
  const auto tracer = createCpuTracer(kernel, *volume);
  std::vector<voxc::Hit> hits(rays.size());
  if (!tracer || !(*tracer)->trace(rays, hits, {}))
    return 1;
  std::ofstream(arguments[4], std::ios::binary)
      .write(reinterpret_cast<const char *>(hits.data()), std::streamsize(hits.size() * sizeof(voxc::Hit)));
  std::printf("%s, of %s\n", nameOf(picked).data(), best.data());
  return isFirst && nameOf(picked) == best ? 0 : 1;
}
