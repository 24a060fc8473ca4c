// Devices, kernels and tracers for the driver.
#include "tracing/TraceSession.h"

#include "common/OrderOption.h"
#include "common/Statistics.h"

#include <cstdlib>

namespace voxc::tool {
namespace {

/// Fewer are traced one by one in less time than packets take to compile.
constexpr std::uint64_t kManyRays = 1 << 18;

} // namespace

void limitDeviceThreads(unsigned threads) {
  // Lavapipe takes its number of threads from here alone, once, when it is loaded.
  if (threads > 0)
    ::setenv("LP_NUM_THREADS", std::to_string(threads).c_str(), 1);
}

void TraceSession::declare(const CommandLine &command) {
  const OptionGroup group(command, "Device");
  command
      .add("--device", deviceName_,
           "Trace on the device whose name contains this, or which has this number or UUID in 'voxc "
           "devices', or on cpu: this processor, without Vulkan")
      .takes("NAME")
      .suggests({"cpu", "llvmpipe"});
  command
      .add("--threads", threads_,
           "Threads that compute, also of a device that is this processor (cpu, lavapipe); default: all")
      .takes("N")
      .between(1u, 1024u);
  addOrderArgument(command, order_);
  command
      .add("--arithmetic", arithmetic_,
           "What kernels for a Vulkan device rely on, as of voxc compile; default: all that is known of it")
      .takes("any|nearest|ieee")
      .oneOf({kEnumNames<Arithmetic>.begin(), kEnumNames<Arithmetic>.end()});
  command.addFlag("--spirv-opt", optimise_, "Optimise the kernel with spirv-opt");
}

void TraceSession::choose(const std::string &device, unsigned threads) {
  deviceName_ = device;
  threads_ = threads;
}

Expected<void> TraceSession::openDevice(const CommonOptions &common) {
  if (deviceName_ == cpuDeviceInfo().name)
    return {};
  limitDeviceThreads(threads_);
  Expected<Device> device = Device::open(deviceName_);
  if (!device && deviceName_.empty()) {
    if (!common.quiet)
      printNote(device.error().message + "; tracing on the cpu instead");
    return {};
  }
  if (!device)
    return Error{device.error().kind, device.error().message + "; and cpu, this processor"};
  device_ = std::make_unique<Device>(std::move(*device));
  device_->useCache(cache_);
  return {};
}

void TraceSession::expectRays(std::uint64_t rays) {
  start_ = rays < kManyRays ? CpuStart::Soon : CpuStart::Fast;
}

TracerChoice TraceSession::choice() const {
  TracerChoice choice{.openDevice = device_.get(),
                      .threads = threads_,
                      .cache = cache_,
                      .optimise = optimise_,
                      .start = start_};
  if (!arithmetic_.empty())
    choice.arithmetic = fromString<Arithmetic>(arithmetic_);
  return choice;
}

Expected<void> TraceSession::prepare(const Volume &volume, const Format &format, Json &figures) {
  TracerChoice choice = this->choice();
  choice.format = format;
  auto opened = VOXC_TRY(openTracerOn(volume, choice));
  addSetupFigures(figures, opened);
  tracer_ = std::move(opened.tracer);
  return {};
}

Expected<TraceReport> TraceSession::trace(const RaySpan &rays, std::span<Hit> hits,
                                          const TraceOptions &options) {
  TraceOptions ordered = options;
  ordered.order = rayOrderFrom(order_);
  return tracer_->trace(rays, hits, ordered);
}

Expected<void> TraceSession::trace(const RaySpan &rays, std::span<Hit> hits, const TraceOptions &options,
                                   Json &figures) {
  auto report = VOXC_TRY(trace(rays, hits, options));
  addTraceFigures(figures, report, countsOf(hits), deviceInfo().name, options.countSteps);
  addPagingFigures(figures);
  return {};
}

} // namespace voxc::tool
