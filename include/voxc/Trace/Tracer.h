// Tracing rays through a volume: the devices there are, and a tracer bound to one device, kernel and volume.
#pragma once

#include "voxc/Support/Error.h"
#include "voxc/Support/Progress.h"
#include "voxc/Trace/BoundedRay.h"
#include "voxc/Trace/Kernel.h"
#include "voxc/Trace/RayOrder.h"
#include "voxc/Volume/Volume.h"
#include "voxc/Volume/WordRange.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace voxc {

class CompileCache;

/// A device that can trace, and what bears on which kernel it takes.
struct DeviceInfo {
  std::string name;
  std::string driver;            ///< Name and version of the driver.
  std::string apiVersion;        ///< Of Vulkan: "1.3.230".
  std::string uuid;              ///< Of the device, 32 hexadecimal digits; "" where it has none.
  std::string kind;              ///< "discrete gpu", "integrated gpu", "virtual gpu", "cpu" or "other".
  std::uint64_t memoryBytes = 0; ///< Of its largest heap.
  std::uint64_t maxStorageBufferBytes = 0; ///< Volumes above this need `Addressing::Segments`.
  std::uint64_t maxTexelBufferBytes = 0;   ///< Volumes above this take no `Addressing::Texels`.
  std::uint64_t maxAllocationBytes = 0;
  bool usable = false; ///< Vulkan 1.2 with a compute queue.
  bool deviceAddresses = false;
  bool fastTexels =
      false; ///< Texels are read for many rays at once, the words of buffers for one after another.
  Loops loops = Loops::Whole;              ///< What its kernels must be ready for.
  Arithmetic arithmetic = Arithmetic::Any; ///< What its kernels may rely on.
};

/// Every Vulkan device of this machine; empty if there is none or no loader.
std::vector<DeviceInfo> listDevices();

/// A device opened for tracing. Destroy after every tracer made on it.
class Device {
public:
  /// Opens the first usable device whose name contains `name` (any case), best kind first; "" takes the best.
  /// A number is a place in `listDevices`, from 0; 32 hexadecimal digits, with dashes or without, are a UUID.
  /// Error: `Environment`, naming the devices there are.
  static Expected<Device> open(std::string_view name = {});
  ~Device();
  Device(Device &&) noexcept;
  Device &operator=(Device &&) noexcept;

  const DeviceInfo &info() const;
  /// The addressing that a volume of so many words needs here: `Buffer` or `Segments`.
  Addressing addressingFor(std::uint64_t words) const;
  /// The addressing by which a volume is traced fastest here. `Texels` too, which a `Tracer` takes, and a
  /// `TraceRecorder` does not.
  Addressing addressingFor(const Volume &volume) const;

  /// Kernels that are made ready on it from now on are looked for in `cache` as the driver compiled them, and
  /// put there. The cache must outlive the device; null: none.
  void useCache(const CompileCache *cache);

  struct State;
  State &state() { return *state_; }
  explicit Device(std::unique_ptr<State> state);

private:
  std::unique_ptr<State> state_;
};

/// Where small things are looked at from, and how small they have to be (docs/paging.md).
struct CoarseView {
  float from[3] = {};
  /// A block of voxels may stand in for its pages where its side is less than this times its distance from
  /// there. 0: nowhere, and all hits are those of the volume.
  float spread = 0;
};

struct TraceOptions {
  bool countSteps = false; ///< Lookups into `Hit::steps`.
  /// Words read into `Hit::steps`, in place of lookups. On this processor that takes a kernel of its own
  /// (`CpuKernel::countsWords`).
  bool countWords = false;
  unsigned repeat = 1; ///< Traces the rays so often; times of every repeat are kept.
  /// Kernels of `detail=cone` stop at what is narrower than `spread` times its distance from the ray's
  /// origin.
  float spread = 0;
  /// Of a paged tracer with coarse blocks (`PagingOptions::coarse`): which of them may answer rays. Other
  /// tracers have all that they trace through.
  CoarseView coarse;
  RayOrder order = RayOrder::Auto; ///< In which rays are taken; hits are the same.
  Progress progress;
};

/// Seconds of one repeat over all rays, from submission to the end of waiting; uploads are apart.
struct TraceTime {
  double wall = 0;
  double cpu = 0;    ///< Of the whole process.
  double device = 0; ///< By the device's timestamps; 0 where it has none.
};

struct TraceReport {
  std::vector<TraceTime> repeats;
  double firstDispatch =
      0;               ///< Wall seconds of the first dispatch on this tracer, which may compile; 0 later.
  double transfer = 0; ///< Wall seconds of copying rays in and hits out.
  std::uint64_t coarse = 0; ///< Rays of the last repeat that coarse blocks have answered.
  bool binned = false;      ///< Rays were taken bin by bin (`RayOrder::Binned`), which is in the times.
  /// Wall seconds of measuring which order is faster, beside the times; 0 where that was asked for or known.
  double choosing = 0;
};

/// What `Tracer::update` brought to the device.
struct UpdateReport {
  std::uint64_t copiedBytes = 0; ///< 0 on this processor, which reads the volume itself.
};

/// Traces rays through one volume. A back end implements this; Vulkan is the first.
class Tracer {
public:
  virtual ~Tracer() = default;
  /// Traces rays[i] into hits[i]; both have the same size. A kernel with bounds takes rays without as those
  /// of [0, +inf]. Errors: rays have bounds, but the kernel has none (`Usage`); `Environment` from the
  /// device.
  virtual Expected<TraceReport> trace(RaySpan rays, std::span<Hit> hits,
                                      const TraceOptions &options = {}) = 0;

  /// Takes `after` in place of `before`, the volume that it traces now: from then on hits are those of a
  /// tracer that was made with it. Of the words, which are compared, only the blocks that differ are copied
  /// to a device, and its memory grows where there are more than before. So those of `before` must be as they
  /// were when it was taken: a volume that edits change (`EditableVolume::volume`) gives way to another by
  /// `follow`, with all words of that as changed. `after` must live as the tracer's first volume had to;
  /// `before` is not needed any more. Errors: a volume of other storage (`Input`); `before` is not the volume
  /// that it traces, or the tracer is of a kind that cannot do this (`Usage`), which leave it unchanged; the
  /// device has no room or fails (`Environment`), after which it must not be used.
  virtual Expected<UpdateReport> update(const Volume & /*before*/, const Volume & /*after*/) {
    return Error::usage("this tracer traces one volume and takes no other");
  }

  /// The same where it is known which words of `after` are others than those of the volume that it traces
  /// now, as `EditableVolume::takeChanges` says: nothing is compared, and no other word is copied. A tracer
  /// of this processor reads the words where they lie, so it must not trace while an edit changes them;
  /// meanwhile others may trace an `EditableVolume::view`.
  virtual Expected<UpdateReport> follow(const Volume & /*after*/, std::span<const WordRange> /*changed*/) {
    return Error::usage("this tracer traces one volume and takes no other");
  }
};

/// Uploads `volume` and prepares `kernel` on `device`. Errors: the kernel was made for other storage
/// (`Input`), the volume does not fit the device or a feature is missing (`Environment`). Rays are brought in
/// order by so many threads of this processor; 0: as many as it runs at once.
Expected<std::unique_ptr<Tracer>> createTracer(Device &device, const Kernel &kernel, const Volume &volume,
                                               unsigned threads = 0);

} // namespace voxc
