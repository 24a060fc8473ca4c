// From a volume to what traces rays through it.
#include "voxc/Kernel/OpenTracer.h"

#include "voxc/Kernel/Compile.h"
#include "voxc/Kernel/CompileCpu.h"

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

Expected<std::unique_ptr<Tracer>> openOnCpu(const Volume &volume, const Format &format,
                                            const TracerChoice &choice) {
  const Expected<CpuKernel> kernel = compileCpuKernel(
      format, {.countWords = choice.countWords, .cache = choice.cache, .start = choice.start});
  if (!kernel)
    return kernel.error();
  return createCpuTracer(*kernel, volume, choice.threads);
}

Expected<std::unique_ptr<Tracer>> openOn(Device &device, const Volume &volume, const Format &format,
                                         const TracerChoice &choice) {
  const Expected<Kernel> kernel = compileKernel(format, {.addressing = device.addressingFor(volume),
                                                         .loops = device.info().loops,
                                                         .arithmetic = device.info().arithmetic,
                                                         .optimise = choice.optimise,
                                                         .cache = choice.cache});
  if (!kernel)
    return kernel.error();
  return createTracer(device, *kernel, volume, choice.threads);
}

} // namespace

Expected<std::unique_ptr<Tracer>> openTracer(const Volume &volume, const TracerChoice &choice) {
  const Format &format = choice.format ? *choice.format : volume.format();
  if (choice.openDevice)
    return openOn(*choice.openDevice, volume, format, choice);
  if (choice.device == cpuDeviceInfo().name)
    return openOnCpu(volume, format, choice);
  Expected<Device> opened = Device::open(choice.device);
  if (!opened && choice.device.empty())
    return openOnCpu(volume, format, choice);
  if (!opened)
    return opened.error();
  auto device = std::make_unique<Device>(std::move(*opened));
  device->useCache(choice.cache);
  auto tracer = openOn(*device, volume, format, choice);
  if (!tracer)
    return tracer;
  return std::unique_ptr<Tracer>(new OwningTracer(std::move(device), std::move(*tracer)));
}

} // namespace voxc
