// Traces rays with the kernel, or with one of its variants, if the processor can execute it:
// variants VOLUME RAYS HITS [VARIANT]
#include "intersect.h"

#include <voxc/Trace/CpuKernel.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <string_view>
#include <vector>

// The variants and the one that was picked: in the object as voxc writes it, nobody sees them.
extern "C" {
using Kernel = void(const std::uint32_t *, const float *, std::uint32_t *, unsigned long long, int, float);
Kernel baseline asm("voxc_intersect.x86_64");
Kernel level3 asm("voxc_intersect.x86_64_v3");
Kernel level4 asm("voxc_intersect.x86_64_v4");
extern Kernel *picked asm("_ZN4voxc12_GLOBAL__N_16kernelE");
}

namespace {

struct Variant {
  std::string_view name;
  Kernel *kernel;
  bool runs; ///< In the words of this program's compiler.
};

const Variant kVariants[] = {
    {"x86-64-v4", level4, __builtin_cpu_supports("x86-64-v4") != 0},
    {"x86-64-v3", level3, __builtin_cpu_supports("x86-64-v3") != 0},
    {"x86-64", baseline, true},
};

std::vector<voxc::Ray> readRays(const char *file) {
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  std::vector<voxc::Ray> rays(static_cast<std::size_t>(stream.tellg()) / sizeof(voxc::Ray));
  stream.seekg(0).read(reinterpret_cast<char *>(rays.data()), std::streamsize(rays.size() * sizeof(voxc::Ray)));
  return rays;
}

bool trace(Kernel *function, char **files) {
  const auto volume = voxc::Volume::load(files[0]);
  const std::vector<voxc::Ray> rays = readRays(files[1]);
  const auto tracer = createCpuTracer({function, VOXC_INTERSECT_STORAGE_DIGEST, nullptr}, *volume);
  std::vector<voxc::Hit> hits(rays.size());
  if (!tracer || !(*tracer)->trace(rays, hits, {}))
    return false;
  std::ofstream(files[2], std::ios::binary)
      .write(reinterpret_cast<const char *>(hits.data()), std::streamsize(hits.size() * sizeof(voxc::Hit)));
  return true;
}

} // namespace

int main(int count, char **arguments) {
  if (count == 4) { // The kernel, which is to pick the first that runs.
    const Kernel *const before = picked;
    const Variant &best = *std::ranges::find_if(kVariants, &Variant::runs);
    if (!trace(voxc_intersect, arguments + 1) || before == best.kernel || picked != best.kernel)
      return 1;
    std::printf("picked %s\n", best.name.data());
    return 0;
  }
  const Variant &variant = *std::ranges::find(kVariants, std::string_view(arguments[4]), &Variant::name);
  return trace(variant.runs ? variant.kernel : baseline, arguments + 1) ? 0 : 1;
}
