// Paged tracing on a Vulkan device.
#include "PagedRounds.h"
#include "Trace/Rays/Clock.h"
#include "Trace/Vulkan/Capabilities.h"
#include "Trace/Vulkan/RayBuffers.h"
#include "Trace/Vulkan/TileQueue.h"
#include "Trace/Vulkan/Transfer.h"

#include <algorithm>
#include <optional>

namespace voxc {
namespace {

constexpr std::uint64_t kMostRays = std::uint64_t{1} << 22;

Counted countedBy(const TraceOptions &options) {
  if (options.countWords)
    return Counted::Words;
  return options.countSteps ? Counted::Lookups : Counted::Nothing;
}

class VulkanPaging final : public PagedBackEnd {
public:
  static Expected<std::unique_ptr<PagedBackEnd>> create(Device::State &device, const Kernel &kernel,
                                                        PageCache &cache);

  std::uint64_t mostRays() const override {
    const DeviceInfo &info = device_->info();
    return std::min(kMostRays,
                    std::min(info.maxStorageBufferBytes, info.maxAllocationBytes) / sizeof(BoundedRay));
  }
  Expected<void> place(std::uint32_t slot, std::uint64_t offset, std::span<const std::byte> bytes) override {
    return transfer_.upload(bytes, slots_, slot * slotBytes_ + offset);
  }
  Expected<void> take(RaySpan rays, std::span<Hit> hits, const TraceOptions &options,
                      TraceReport &report) override;
  Expected<TraceTime> trace(RayGroup group, bool goesOn, std::span<std::uint32_t> table,
                            const TraceOptions &options) override;
  Expected<void> fetch(TraceReport &report) override;
  Expected<void> put(TraceReport &report) override;

private:
  VulkanPaging(Device::State &device, Transfer transfer, TracePipeline pipeline, TileQueue tiles,
               Buffer slots, Buffer table, std::uint64_t slotBytes, bool bounded)
      : device_(&device), transfer_(std::move(transfer)), slots_(std::move(slots)), table_(std::move(table)),
        pipeline_(std::move(pipeline)), tiles_(std::move(tiles)), slotBytes_(slotBytes), bounded_(bounded) {}
  Expected<void> reserve(std::uint64_t rays);

  Device::State *device_;
  Transfer transfer_;
  Buffer slots_;
  Buffer table_;
  std::optional<RayBuffers> batch_; ///< Made when first needed.
  TracePipeline pipeline_;
  BoundBuffers bound_;
  TileQueue tiles_;
  std::uint64_t slotBytes_;
  bool bounded_;        ///< Rays have bounds.
  std::span<Hit> room_; ///< Where the hits go.
};

Expected<std::unique_ptr<PagedBackEnd>> VulkanPaging::create(Device::State &device, const Kernel &kernel,
                                                             PageCache &cache) {
  auto transfer = VOXC_TRY(Transfer::create(device));
  auto pipeline = VOXC_TRY(TracePipeline::create(device, kernel, {cache.log2PageWords(), cache.pages()}));
  auto tiles = VOXC_TRY(TileQueue::create(device));
  auto slots =
      VOXC_TRY(Buffer::create(device, {.what = "pages", .bytes = cache.slots() * cache.slotBytes()}));
  auto table =
      VOXC_TRY(Buffer::create(device, {.what = "a table of pages", .bytes = cache.table().size_bytes()}));
  return std::unique_ptr<PagedBackEnd>(new VulkanPaging(device, std::move(transfer), std::move(pipeline),
                                                        std::move(tiles), std::move(slots), std::move(table),
                                                        cache.slotBytes(), kernel.bounded));
}

Expected<void> VulkanPaging::reserve(std::uint64_t rays) {
  if (rays * sizeof(Hit) <= (batch_ ? batch_->hits.bytes() : 0))
    return {};
  auto batch = VOXC_TRY(RayBuffers::create(*device_, rays, bounded_, tiles_.tileRays()));
  bound_ = VOXC_TRY(pipeline_.bind(
      {wholeOf(batch.rays), wholeOf(batch.hits), wholeOf(slots_), wholeOf(batch.deferred), wholeOf(table_)}));
  batch_.emplace(std::move(batch));
  return {};
}

Expected<void> VulkanPaging::take(RaySpan rays, std::span<Hit> hits, const TraceOptions &options,
                                  TraceReport &report) {
  VOXC_TRY(reserve(rays.size()));
  room_ = hits;
  const double begin = wallSeconds();
  VOXC_TRY(transfer_.upload(rays.bytes(), batch_->rays));
  report.transfer += wallSeconds() - begin;
  const Counted counted = countedBy(options);
  if (pipeline_.isPrepared(counted, options.spread, Origins::Anywhere))
    return {};
  const double compiles = wallSeconds();
  VOXC_TRY(pipeline_.prepare(counted, options.spread));
  report.firstDispatch = wallSeconds() - compiles;
  return {};
}

Expected<TraceTime> VulkanPaging::trace(RayGroup group, bool goesOn, std::span<std::uint32_t> table,
                                        const TraceOptions &options) {
  VOXC_TRY(transfer_.upload(std::as_bytes(table), table_));
  auto time = tiles_.run({.pipeline = &pipeline_,
                          .buffers = &bound_,
                          .counted = countedBy(options),
                          .rays = static_cast<std::uint32_t>(group.count),
                          .first = static_cast<std::uint32_t>(group.first),
                          .task = goesOn ? Task::CutOff : Task::All,
                          .tileDone = [&](std::uint32_t) { return !options.progress.stopped(); }});
  if (!time)
    return time;
  VOXC_TRY(transfer_.download(table_, std::as_writable_bytes(table)));
  return time;
}

Expected<void> VulkanPaging::fetch(TraceReport &report) {
  const double begin = wallSeconds();
  auto downloaded = transfer_.download(batch_->hits, std::as_writable_bytes(room_));
  report.transfer += wallSeconds() - begin;
  return downloaded;
}

Expected<void> VulkanPaging::put(TraceReport &report) {
  const double begin = wallSeconds();
  auto uploaded = transfer_.upload(std::as_bytes(room_), batch_->hits);
  report.transfer += wallSeconds() - begin;
  return uploaded;
}

} // namespace

Expected<std::unique_ptr<PagedTracer>> createPagedTracer(Device &device, const Kernel &kernel,
                                                         const PagedVolume &volume,
                                                         const PagingOptions &options) {
  Device::State &state = device.state();
  if (kernel.addressing != Addressing::Paged)
    return Error::input(
        "this kernel is for volumes that are loaded as a whole: compile one with addressing=paged");
  VOXC_TRY(checkPagedFit(kernel.storageDigest, volume, "spirv"));
  VOXC_TRY(checkKernel(state.physical, kernel));
  auto cache = VOXC_TRY(PageCache::create(
      volume, options, std::min(device.info().maxStorageBufferBytes, device.info().maxAllocationBytes)));
  auto standIn = VOXC_TRY(readStandIn(volume, options, kernel.bounded));
  auto backEnd = VOXC_TRY(VulkanPaging::create(state, kernel, cache));
  return drivePages(std::move(backEnd), std::move(cache), std::move(standIn), kernel.bounded);
}

} // namespace voxc
