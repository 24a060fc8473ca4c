// From a volume to hits: what every command that traces shares.
#pragma once

#include "common/Command.h"
#include "common/CommandLine.h"
#include "common/Json.h"
#include "voxc/IR/Format.h"
#include "voxc/Kernel/OpenTracer.h"
#include "voxc/Support/UserCache.h"

#include <memory>
#include <optional>
#include <span>
#include <string>

namespace voxc::tool {

/// Adds what it took to make a tracer.
template <typename SomeTracer> void addSetupFigures(Json &figures, const OpenedTracer<SomeTracer> &opened) {
  figures["kernel_seconds"] = opened.kernelSeconds;
  if (opened.addressing)
    figures["addressing"] = toString(*opened.addressing);
  if (opened.uploadSeconds)
    figures["upload_seconds"] = *opened.uploadSeconds;
}

/// Has devices of Vulkan's that are this processor compute by so many threads; 0: as they choose. Before the
/// first is opened.
void limitDeviceThreads(unsigned threads);

class TraceSession {
public:
  /// Adds --device, --threads, --order, --arithmetic and --spirv-opt to a command.
  void declare(const CommandLine &command);

  /// Chooses as --device and --threads do, in a command that has several of these.
  void choose(const std::string &device, unsigned threads);

  /// Looks for kernels among those that were compiled before: for commands that do not measure compiling.
  /// Asked before the device is opened.
  void useCache() { cache_ = compileCache(); }

  /// Tells how many rays will be traced, where that is known and nothing is timed: for few a kernel on this
  /// processor is compiled in part. Asked before it is compiled.
  void expectRays(std::uint64_t rays);

  /// Opens the device; asked first, so that its absence is told before long work. Where no device was named
  /// and there is none of Vulkan's, it is this processor, and a note says so.
  Expected<void> openDevice(const CommonOptions &common);
  /// Compiles the kernel that traverses `volume` as `format` says, and uploads the volume. Its figures are
  /// added.
  Expected<void> prepare(const Volume &volume, const Format &format, Json &figures);
  /// The same for a page file, which must stay; threads are those of --threads.
  Expected<void> preparePages(const PagedVolume &volume, const Format &format, PagingOptions options,
                              Json &figures);
  /// What paging has done so far, if that is how rays are traced.
  std::optional<PagingReport> paging() const;
  /// Adds what paging has done so far, if that is how rays are traced.
  void addPagingFigures(Json &figures) const;
  /// Traces rays through the prepared volume. The trace's figures are added.
  Expected<void> trace(const RaySpan &rays, std::span<Hit> hits, const TraceOptions &options, Json &figures);

  /// The same without figures.
  Expected<TraceReport> trace(const RaySpan &rays, std::span<Hit> hits, const TraceOptions &options);

  /// As `Tracer::follow`.
  Expected<UpdateReport> follow(const Volume &after, std::span<const WordRange> changed) {
    return tracer_->follow(after, changed);
  }

  /// The open device.
  DeviceInfo deviceInfo() const { return device_ ? device_->info() : cpuDeviceInfo(); }

  /// What --threads says; 0: nothing.
  unsigned threads() const { return threads_; }

private:
  /// The open device, and what the options say of the kernel.
  TracerChoice choice() const;

  std::string deviceName_;
  unsigned threads_ = 0; ///< 0: the device's own choice.
  std::string arithmetic_;
  bool optimise_ = false;
  const CompileCache *cache_ = nullptr;
  CpuStart start_ = CpuStart::Whole;
  std::string order_ = "auto";
  std::unique_ptr<Device> device_; // Outlives the tracer; null: this processor.
  std::unique_ptr<Tracer> tracer_;
  const PagedTracer *paged_ = nullptr; // The tracer, where it is one.
};

} // namespace voxc::tool
