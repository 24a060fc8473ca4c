// dispatch.cpp: the one function of intersect.o that can be seen from outside. It goes to the variant of the kernel that suits
// the processor it runs on. A variant is intersect.cpp, compiled for a level of x86-64; its functions bear the level's name.
namespace voxc {

using uint = unsigned int;

using Kernel = void(const uint *words, const float *rays, uint *hits, unsigned long long count, int count_lookups, float spread);

extern "C" Kernel trace_16_rays asm("${symbol}.x86_64_v4");
extern "C" Kernel trace_8_rays asm("${symbol}.x86_64_v3");
extern "C" Kernel trace_single_rays asm("${symbol}.x86_64");

namespace {

Kernel *best_kernel() {
  __builtin_cpu_init(); // Who calls may be a constructor, before others.
  if (__builtin_cpu_supports("x86-64-v4"))
    return trace_16_rays;
  return __builtin_cpu_supports("x86-64-v3") ? trace_8_rays : trace_single_rays;
}

Kernel trace_first_rays;

// The variant, once there have been rays. Threads that come at the same time find the same.
Kernel *kernel = trace_first_rays;

void trace_first_rays(const uint *words, const float *rays, uint *hits, unsigned long long count, int count_lookups,
                      float spread) {
  Kernel *const best = best_kernel();
  __atomic_store_n(&kernel, best, __ATOMIC_RELAXED);
  best(words, rays, hits, count, count_lookups, spread);
}

} // namespace
} // namespace voxc

extern "C" void ${symbol}(const unsigned int *words, const float *rays, unsigned int *hits, unsigned long long count,
                          int count_lookups, float spread) {
  __atomic_load_n(&voxc::kernel, __ATOMIC_RELAXED)(words, rays, hits, count, count_lookups, spread);
}
