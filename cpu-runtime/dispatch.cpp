// dispatch.cpp: the one function of intersect.o that can be seen from outside. It goes to the variant of the kernel that suits
// the processor it runs on. A variant is intersect.cpp, compiled for a level of x86-64; its functions bear the level's name.
// The processor is asked here, and not by a compiler's library, since older ones do not know of levels.
namespace voxc {

using uint = unsigned int;

using Kernel = void(const uint *words, const float *rays, uint *hits, unsigned long long count, int count_lookups, float spread);

extern "C" Kernel trace_16_rays asm("voxc_kernel.x86_64_v4");
extern "C" Kernel trace_8_rays asm("voxc_kernel.x86_64_v3");
extern "C" Kernel trace_single_rays asm("voxc_kernel.x86_64");

namespace {

// What a processor and its system tell of what they can; a bit is a feature.
struct Features {
  uint basic;    // cpuid 1, ecx.
  uint extended; // cpuid 7, ebx.
  uint more;     // cpuid 0x80000001, ecx.
  uint kept;     // xgetbv 0: the registers that the system keeps for each thread.
};

constexpr uint bits(auto... numbers) { return ((1u << numbers) | ...); }

constexpr uint OSXSAVE = bits(27); // There is an xgetbv.

// The levels are those of the System V ABI for x86-64; each has what those below it have.
constexpr Features LEVEL_3 = {
    bits(0, 9, 12, 13, 19, 20, 22, 23, 28, 29) | OSXSAVE, // SSE3, SSSE3, FMA, CMPXCHG16B, SSE4.1, SSE4.2, MOVBE, POPCNT, AVX, F16C.
    bits(3, 5, 8),                                        // BMI1, AVX2, BMI2.
    bits(0, 5),                                           // LAHF, LZCNT.
    bits(1, 2),                                           // xmm, ymm.
};
constexpr Features LEVEL_4 = {
    LEVEL_3.basic,
    LEVEL_3.extended | bits(16, 17, 28, 30, 31), // AVX512F, DQ, CD, BW, VL.
    LEVEL_3.more,
    LEVEL_3.kept | bits(5, 6, 7), // Masks, the upper halves of zmm0 to zmm15, zmm16 to zmm31.
};

bool has(const Features &features, const Features &level) {
  return (level.basic & ~features.basic) == 0 && (level.extended & ~features.extended) == 0 &&
         (level.more & ~features.more) == 0 && (level.kept & ~features.kept) == 0;
}

struct Registers {
  uint eax, ebx, ecx, edx;
};

Registers cpuid(uint leaf) {
  Registers registers;
  asm volatile("cpuid"
               : "=a"(registers.eax), "=b"(registers.ebx), "=c"(registers.ecx), "=d"(registers.edx)
               : "a"(leaf), "c"(0));
  return registers;
}

uint kept_registers() {
  uint low, high;
  asm volatile("xgetbv" : "=a"(low), "=d"(high) : "c"(0));
  return low;
}

Features features() {
  if (cpuid(0).eax < 7 || cpuid(0x80000000).eax < 0x80000001)
    return {};
  const uint basic = cpuid(1).ecx;
  return {basic, cpuid(7).ebx, cpuid(0x80000001).ecx, basic & OSXSAVE ? kept_registers() : 0};
}

Kernel *best_kernel(const Features &features) {
  if (has(features, LEVEL_4))
    return trace_16_rays;
  return has(features, LEVEL_3) ? trace_8_rays : trace_single_rays;
}

Kernel trace_first_rays;

// The variant, once there have been rays. Threads that come at the same time find the same.
Kernel *kernel = trace_first_rays;

void trace_first_rays(const uint *words, const float *rays, uint *hits, unsigned long long count, int count_lookups,
                      float spread) {
  Kernel *const best = best_kernel(features());
  __atomic_store_n(&kernel, best, __ATOMIC_RELAXED);
  best(words, rays, hits, count, count_lookups, spread);
}

} // namespace
} // namespace voxc

// The pointer is read anew by each call: once there have been rays, that is all it costs.
extern "C" void voxc_kernel(const unsigned int *words, const float *rays, unsigned int *hits, unsigned long long count,
                          int count_lookups, float spread) {
  __atomic_load_n(&voxc::kernel, __ATOMIC_RELAXED)(words, rays, hits, count, count_lookups, spread);
}
