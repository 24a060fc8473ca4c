// An intersection kernel as a function on this processor: compiled in the process, or linked into the
// program.
#pragma once

#include "voxc/Support/Error.h"
#include "voxc/Trace/Tracer.h"

#include <cstdint>
#include <memory>

namespace voxc {

/// A kernel that needs no device. `compileCpuKernel` makes one; so does a program that links the
/// `intersect.o` of `voxc compile --emit=cpu`, from what `intersect.h` declares:
///
///     const voxc::CpuKernel kernel{voxc_intersect, VOXC_INTERSECT_STORAGE_DIGEST};
///
/// May be called from any number of threads at once.
struct CpuKernel {
  /// Traces `count` rays, six floats each (`Ray`; eight of a `BoundedRay`, if the kernel is `bounded`),
  /// through a volume's words into as many hits, six words each
  /// (`Hit`); counts lookups if `countLookups` is not 0, and if it is 2 what is left to exact arithmetic,
  /// as 65536 lookups each time; `spread` is that of `TraceOptions`. Trusts its arguments.
  using Function = void (*)(const std::uint32_t *words, const float *rays, std::uint32_t *hits,
                            unsigned long long count, int countLookups, float spread);

  Function function = nullptr;
  std::uint64_t storageDigest = 0;   ///< Of the formats that it fits: `storageDigest(format)`.
  std::shared_ptr<const void> owner; ///< Keeps the code, where it was compiled in the process.
  bool countsWords = false;          ///< It counts words read, always, and no lookups.
  bool isPaged = false;              ///< Its `words` lead to `CpuPages`.
  bool bounded = false;              ///< Its rays are `BoundedRay`s.
};

/// What a kernel of `Addressing::Paged` finds in place of words (docs/paging.md).
struct CpuPages {
  const std::uint32_t *slots = nullptr; ///< Of a page each; the first has zeros.
  std::uint32_t *table = nullptr;       ///< An entry for each page, and one more.
  std::uint32_t log2PageWords = 0;
  std::uint32_t pages = 0;
  std::uint32_t goesOn = 0; ///< With rays that wait, whose hits are -2 - cell; else all begin.
};

/// The first hit of one ray (in voxels), traced by `kernel` on the calling thread; any number of threads may
/// ask at once. For many rays `createCpuTracer` is faster. Error: the kernel was made for other storage
/// (`Input`), which two digests show, so that asking for every ray costs next to nothing.
Expected<Hit> intersect(const Volume &volume, const CpuKernel &kernel, const Ray &ray);
/// The same between two moments, of a kernel that is `bounded`; of another it is an error (`Usage`).
Expected<Hit> intersect(const Volume &volume, const CpuKernel &kernel, const BoundedRay &ray);

/// A tracer on this processor, with so many threads; 0: as many as it runs at once. `volume` must outlive it.
/// Error: the kernel was made for other storage (`Input`).
Expected<std::unique_ptr<Tracer>> createCpuTracer(const CpuKernel &kernel, const Volume &volume,
                                                  unsigned threads = 0);

/// What `createCpuTracer` traces on, as a device in a list beside others: its name is "cpu".
DeviceInfo cpuDeviceInfo();

} // namespace voxc
