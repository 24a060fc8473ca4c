// From a volume to what traces rays through it.
#include "voxc/Kernel/OpenTracer.h"

#include "voxc/Kernel/Compile.h"
#include "voxc/Plan/Plan.h"
#include "voxc/Support/Stopwatch.h"

#include <utility>

namespace voxc {
namespace {

/// A tracer with the device that it was made on.
class OwningTracer final : public Tracer {
public:
  OwningTracer(std::unique_ptr<Device> device, std::unique_ptr<Tracer> tracer)
      : owned_(std::move(device)), tracer_(std::move(tracer)) {}

  Expected<TraceReport> trace(RaySpan rays, std::span<Hit> hits, const TraceOptions &options) override {
    return tracer_->trace(rays, hits, options);
  }
  Expected<UpdateReport> update(const Volume &before, const Volume &after) override {
    return tracer_->update(before, after);
  }
  Expected<UpdateReport> follow(const Volume &after, std::span<const WordRange> changed) override {
    return tracer_->follow(after, changed);
  }

private:
  std::unique_ptr<Device> owned_; // Outlives the tracer.
  std::unique_ptr<Tracer> tracer_;
};

const Format &formatOf(const Volume &volume, const TracerChoice &choice) {
  return choice.format ? *choice.format : volume.format();
}

Expected<CpuKernel> compileForCpu(const Format &format, Addressing addressing, const TracerChoice &choice) {
  return compileCpuKernel(format, {.countWords = choice.countWords,
                                   .cache = choice.cache,
                                   .addressing = addressing,
                                   .start = choice.start});
}

Expected<Kernel> compileFor(const DeviceInfo &device, const Format &format, Addressing addressing,
                            const TracerChoice &choice) {
  return compileKernel(format, {.addressing = addressing,
                                .loops = device.loops,
                                .arithmetic = choice.arithmetic.value_or(device.arithmetic),
                                .optimise = choice.optimise,
                                .cache = choice.cache});
}

/// Compiles by `compile`, makes a tracer of the kernel by `make`, and takes the times. `addressing` is that
/// of a device: this processor reads the volume where it lies, and pages come later, so neither has an
/// upload.
template <typename SomeTracer>
Expected<OpenedTracer<SomeTracer>> timed(std::optional<Addressing> addressing, const auto &compile,
                                         const auto &make) {
  OpenedTracer<SomeTracer> opened{.addressing = addressing};
  const Stopwatch compiling;
  const auto kernel = VOXC_TRY(compile());
  opened.kernelSeconds = compiling.seconds();
  const Stopwatch making;
  opened.tracer = VOXC_TRY(make(kernel));
  if (addressing && addressing != Addressing::Paged)
    opened.uploadSeconds = making.seconds();
  return opened;
}

} // namespace

Expected<OpenedTracer<Tracer>> openTracerOn(const Volume &volume, const TracerChoice &choice) {
  const Format &format = formatOf(volume, choice);
  Device *const device = choice.openDevice;
  if (!device)
    return timed<Tracer>(
        std::nullopt, [&] { return compileForCpu(format, Addressing::Buffer, choice); },
        [&](const CpuKernel &kernel) { return createCpuTracer(kernel, volume, choice.threads); });
  const Addressing addressing = device->addressingFor(volume);
  return timed<Tracer>(
      addressing, [&] { return compileFor(device->info(), format, addressing, choice); },
      [&](const Kernel &kernel) { return createTracer(*device, kernel, volume, choice.threads); });
}

Expected<OpenedTracer<PagedTracer>> openTracerOn(const PagedVolume &volume, const Format &format,
                                                 const TracerChoice &choice, const PagingOptions &options) {
  VOXC_TRY(checkPaging(format));
  Device *const device = choice.openDevice;
  constexpr Addressing kPaged = Addressing::Paged;
  if (!device)
    return timed<PagedTracer>(
        std::nullopt, [&] { return compileForCpu(format, kPaged, choice); },
        [&](const CpuKernel &kernel) { return createPagedCpuTracer(kernel, volume, options); });
  return timed<PagedTracer>(
      kPaged, [&] { return compileFor(device->info(), format, kPaged, choice); },
      [&](const Kernel &kernel) { return createPagedTracer(*device, kernel, volume, options); });
}

Expected<std::unique_ptr<Tracer>> openTracer(const Volume &volume, const TracerChoice &choice) {
  TracerChoice chosen = choice;
  std::unique_ptr<Device> device;
  if (!choice.openDevice && choice.device != cpuDeviceInfo().name) {
    Expected<Device> opened = Device::open(choice.device);
    if (!opened && !choice.device.empty())
      return opened.error();
    if (opened) {
      device = std::make_unique<Device>(std::move(*opened));
      device->useCache(choice.cache);
      chosen.openDevice = device.get();
    }
  }
  auto opened = VOXC_TRY(openTracerOn(volume, chosen));
  if (!device)
    return std::move(opened.tracer);
  return std::unique_ptr<Tracer>(new OwningTracer(std::move(device), std::move(opened.tracer)));
}

} // namespace voxc
