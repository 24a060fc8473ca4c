// A tracer on a Vulkan device.
#include "VulkanTracer.h"

#include "Capabilities.h"
#include "RayOrigins.h"
#include "Trace/Kernel/KernelFit.h"
#include "Trace/Kernel/Nontermination.h"
#include "Trace/Rays/Clock.h"
#include "Trace/Rays/OrderedTracer.h"

#include <algorithm>

namespace voxc {
namespace {

constexpr std::uint64_t kMaxBatchRays = std::uint64_t{4} << 20;

/// Dispatches that may go on with rays which the device cut short. The longest traversal, 3 * 2^21 steps,
/// needs about a hundred where a device ends loops after 65535 turns and a step takes one; far more where
/// steps go down deep trees.
constexpr int kMaxResumes = 4096;

/// The rays whose buffers every limit of the device allows.
std::uint64_t batchRays(const DeviceInfo &device, std::uint64_t bytesOfOne) {
  std::uint64_t bytes = std::min(device.maxStorageBufferBytes, device.maxAllocationBytes);
  return std::min(kMaxBatchRays, bytes / bytesOfOne);
}

Counted countedBy(const TraceOptions &options) {
  if (options.countWords)
    return Counted::Words;
  return options.countSteps ? Counted::Lookups : Counted::Nothing;
}

} // namespace

/// What one call of `trace` carries along.
struct VulkanTracer::Work {
  const TraceOptions &options;
  TraceReport report;
  double totalRays = 0; ///< Over all repeats.
  double doneRays = 0;

  bool advance(std::uint32_t rays) {
    doneRays += rays;
    options.progress.at("trace", doneRays / totalRays, static_cast<std::uint64_t>(doneRays));
    return !options.progress.stopped();
  }
};

VulkanTracer::VulkanTracer(Device::State &device, std::uint64_t storageDigest, Transfer transfer,
                           VolumeWords words, TracePipeline pipeline, TileQueue tiles, bool bounded,
                           Int3 extent)
    : device_(&device), storageDigest_(storageDigest), transfer_(std::move(transfer)),
      words_(std::move(words)), pipeline_(std::move(pipeline)), tiles_(std::move(tiles)), bounded_(bounded),
      extent_(extent) {}

Expected<std::unique_ptr<Tracer>> VulkanTracer::create(Device::State &device, const Kernel &kernel,
                                                       const Volume &volume) {
  VOXC_TRY(checkFit(kernel.storageDigest, volume, "spirv"));
  if (kernel.addressing == Addressing::Paged)
    return Error::usage(
        "this kernel is for volumes that are on the device in pages: createPagedTracer takes it");
  VOXC_TRY(checkKernel(device.physical, kernel));
  auto transfer = VOXC_TRY(Transfer::create(device));
  auto words = VOXC_TRY(VolumeWords::upload(device, transfer, volume.words(), kernel.addressing));
  auto pipeline = VOXC_TRY(TracePipeline::create(device, kernel));
  auto tiles = VOXC_TRY(TileQueue::create(device));
  return std::unique_ptr<Tracer>(new VulkanTracer(device, kernel.storageDigest, std::move(transfer),
                                                  std::move(words), std::move(pipeline), std::move(tiles),
                                                  kernel.bounded, volume.info().extent));
}

Expected<TraceReport> VulkanTracer::trace(RaySpan given, std::span<Hit> hits, const TraceOptions &options) {
  const RaySpan rays = VOXC_TRY(fitting_.fit(given, bounded_));
  if (rays.size() != hits.size())
    return Error::usage("there are " + std::to_string(rays.size()) + " rays, but room for " +
                        std::to_string(hits.size()) + " hits");
  Work work{options, {}};
  work.report.repeats.resize(std::max(options.repeat, 1u));
  work.totalRays = static_cast<double>(rays.size()) * static_cast<double>(work.report.repeats.size());
  std::uint64_t batch = std::min<std::uint64_t>(batchRays(device_->info(), rays.bytesOfOne()), rays.size());
  VOXC_TRY(reserve(batch));
  for (std::uint64_t first = 0; first < rays.size(); first += batch) {
    std::uint64_t count = std::min(batch, rays.size() - first);
    VOXC_TRY(traceBatch(rays.subspan(first, count), hits.subspan(first, count), work));
  }
  return work.report;
}

Expected<void> VulkanTracer::reserve(std::uint64_t rays) {
  if (rays * sizeof(Hit) <= (batch_ ? batch_->hits.bytes() : 0))
    return {};
  auto batch = VOXC_TRY(RayBuffers::create(*device_, rays, bounded_, tiles_.tileRays()));
  VOXC_TRY(bind(batch));
  batch_.emplace(std::move(batch));
  return {};
}

Expected<void> VulkanTracer::bind(const RayBuffers &batch) {
  bound_ = VOXC_TRY(pipeline_.bind(
      {wholeOf(batch.rays), wholeOf(batch.hits), wholeOf(words_.binding()), wholeOf(batch.deferred)}));
  return {};
}

Expected<UpdateReport> VulkanTracer::update(const Volume &before, const Volume &after) {
  VOXC_TRY(checkFit(storageDigest_, after, "spirv"));
  if (before.words().size() != words_.count())
    return notTraced();
  const VkBuffer binding = words_.binding().get();
  return rebound(words_.update(transfer_, before.words(), after.words()), after, binding);
}

Expected<UpdateReport> VulkanTracer::follow(const Volume &after, std::span<const WordRange> changed) {
  VOXC_TRY(checkFit(storageDigest_, after, "spirv"));
  const VkBuffer binding = words_.binding().get();
  return rebound(words_.follow(transfer_, after.words(), changed), after, binding);
}

/// Ends an update: words may lie in another buffer than before.
Expected<UpdateReport> VulkanTracer::rebound(Expected<UpdateReport> report, const Volume &after,
                                             VkBuffer before) {
  if (report)
    extent_ = after.info().extent;
  if (!report || !batch_ || words_.binding().get() == before)
    return report;
  VOXC_TRY(bind(*batch_));
  return report;
}

Expected<void> VulkanTracer::traceBatch(const RaySpan &rays, std::span<Hit> hits, Work &work) {
  double uploadBegin = wallSeconds();
  VOXC_TRY(transfer_.upload(rays.bytes(), batch_->rays));
  work.report.transfer += wallSeconds() - uploadBegin;
  auto count = static_cast<std::uint32_t>(rays.size());
  VOXC_TRY(warmUp(rays, work));
  TilePass pass{
      .pipeline = &pipeline_, .buffers = &bound_, .counted = countedBy(work.options), .rays = count};
  pass.tileDone = [&work](std::uint32_t done) { return work.advance(done); };
  for (TraceTime &repeat : work.report.repeats) {
    auto time = VOXC_TRY(tiles_.run(pass));
    repeat.wall += time.wall;
    repeat.cpu += time.cpu;
    repeat.device += time.device;
  }
  VOXC_TRY(download(hits, work));
  return finishRays(hits, work);
}

Expected<void> VulkanTracer::download(std::span<Hit> hits, Work &work) {
  double begin = wallSeconds();
  auto downloaded = transfer_.download(batch_->hits, std::as_writable_bytes(hits));
  work.report.transfer += wallSeconds() - begin;
  return downloaded;
}

Expected<void> VulkanTracer::finishRays(std::span<Hit> hits, Work &work) {
  const auto isUnfinished = [](const Hit &hit) { return hit.voxel[0] < -1; };
  for (int pass = 0; std::ranges::any_of(hits, isUnfinished); ++pass) {
    VOXC_TRY(checkEnded(hits));
    if (pass == kMaxResumes)
      return Error::environment("the kernel left rays unfinished after " + std::to_string(pass) +
                                " dispatches");
    auto time = tiles_.run({.pipeline = &pipeline_,
                            .buffers = &bound_,
                            .counted = countedBy(work.options),
                            .rays = static_cast<std::uint32_t>(hits.size()),
                            .task = Task::CutOff,
                            .tileDone = [&work](std::uint32_t) { return !work.options.progress.stopped(); }});
    if (!time)
      return time.error();
    // Every repeat would have taken it.
    for (TraceTime &repeat : work.report.repeats) {
      repeat.wall += time->wall;
      repeat.cpu += time->cpu;
      repeat.device += time->device;
    }
    VOXC_TRY(download(hits, work));
  }
  return {};
}

Expected<void> VulkanTracer::warmUp(const RaySpan &rays, Work &work) {
  const Counted counted = countedBy(work.options);
  const float spread = work.options.spread;
  const Origins origins = originsOf(rays, extent_);
  if (pipeline_.isPrepared(counted, spread, origins))
    return {};
  // Some drivers compile when the pipeline is made, others at its first dispatch: one group of rays decides
  // both.
  double begin = wallSeconds();
  VOXC_TRY(pipeline_.prepare(counted, spread, origins));
  for (const bool resolvesAtOnce : {true, false})
    if (auto time = tiles_.run(
            {.pipeline = &pipeline_,
             .buffers = &bound_,
             .counted = counted,
             .rays = static_cast<std::uint32_t>(std::min<std::size_t>(rays.size(), kWorkgroupSize)),
             .resolvesAtOnce = resolvesAtOnce});
        !time)
      return time.error();
  work.report.firstDispatch = wallSeconds() - begin;
  return {};
}

Expected<std::unique_ptr<Tracer>> createTracer(Device &device, const Kernel &kernel, const Volume &volume,
                                               unsigned threads) {
  auto tracer = VOXC_TRY(VulkanTracer::create(device.state(), kernel, volume));
  // What orders rays is this processor; a device of its own traces them in less time.
  return inOrder(std::move(tracer), volume, threads, device.info().kind == "cpu");
}

} // namespace voxc
