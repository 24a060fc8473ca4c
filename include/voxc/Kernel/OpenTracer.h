// From a volume to what traces rays through it, in one call: on a Vulkan device or on this processor.
#pragma once

#include "voxc/IR/Format.h"
#include "voxc/Kernel/CompileCpu.h"
#include "voxc/Trace/PagedTracer.h"
#include "voxc/Trace/Tracer.h"

#include <memory>
#include <optional>
#include <string>

namespace voxc {

/// What to trace on, and with what kernel. The defaults are those of the command line.
struct TracerChoice {
  /// As `Device::open` takes it, or "cpu": this processor, without Vulkan. "" is the best Vulkan device that
  /// there is, and where there is none this processor.
  std::string device;
  /// An open device in place of `device`, which must outlive the tracer.
  Device *openDevice = nullptr;
  unsigned threads = 0; ///< Of this processor; 0: all.
  /// Attributes of the traversal and of what is asked, where they are not those that the volume was built
  /// with; of the same storage.
  std::optional<Format> format;
  /// Where kernels are looked for first, and also pipelines where no device is given: the next start compiles
  /// nothing. It must outlive the tracer. Null: none.
  const CompileCache *cache = nullptr;
  /// What a kernel for a Vulkan device relies on; none: all that is known of the device.
  std::optional<Arithmetic> arithmetic;
  bool optimise = false;           ///< As in `KernelOptions`.
  bool countWords = false;         ///< A tracer for `TraceOptions::countWords` and nothing else.
  CpuStart start = CpuStart::Soon; ///< How much is compiled before the first ray, on this processor.
};

/// Compiles the kernel of a volume and makes a tracer with it, which owns whatever it opens. `volume` must
/// outlive it. Errors: the format is of other storage (`Input`); the device is not there, lacks what the
/// kernel needs, or has no room for the volume (`Environment`).
Expected<std::unique_ptr<Tracer>> openTracer(const Volume &volume, const TracerChoice &choice = {});

/// A tracer, and what it took to make it.
template <typename SomeTracer> struct OpenedTracer {
  std::unique_ptr<SomeTracer> tracer;
  double kernelSeconds = 0;             ///< Of compiling, or of finding the kernel in the cache.
  std::optional<double> uploadSeconds;  ///< Of copying a volume to a Vulkan device.
  std::optional<Addressing> addressing; ///< Of a volume on a Vulkan device.
};

/// The same on `choice.openDevice`, where null is this processor whatever `choice.device` says, with the
/// times.
Expected<OpenedTracer<Tracer>> openTracerOn(const Volume &volume, const TracerChoice &choice);
/// The same of a compressed volume, of which only pages that rays need are read; `options` has the threads.
/// Errors also: a format without pages (`Usage`).
Expected<OpenedTracer<PagedTracer>> openTracerOn(const PagedVolume &volume, const Format &format,
                                                 const TracerChoice &choice, const PagingOptions &options);

} // namespace voxc
