// A kernel as Vulkan pipelines.
#include "TracePipeline.h"

#include "Commands.h"
#include "PipelineCache.h"

#include <cstddef>
#include <iterator>

namespace voxc {
namespace {

/// The most bindings that a kernel has.
constexpr std::uint32_t kMostBindings = std::tuple_size_v<KernelBuffers>;

constexpr std::size_t kWords = 2;
constexpr std::size_t kDeferred = 3;

constexpr VkSpecializationMapEntry kConstantEntries[] = {
    {0, offsetof(Constants, countLookups), sizeof(Constants::countLookups)},
    {1, offsetof(Constants, spread), sizeof(Constants::spread)},
    {2, offsetof(Constants, countWords), sizeof(Constants::countWords)},
    {3, offsetof(Constants, exactFallback), sizeof(Constants::exactFallback)},
    {6, offsetof(Constants, comesNear), sizeof(Constants::comesNear)},
    {4, offsetof(Constants, pages.log2PageWords), sizeof(PageShape::log2PageWords)},
    {5, offsetof(Constants, pages.pages), sizeof(PageShape::pages)},
};

template <typename T> std::string_view bytesOf(std::span<const T> values) {
  return {reinterpret_cast<const char *>(values.data()), values.size_bytes()};
}

std::uint32_t groupsOf(const RayTile &tile) { return (tile.rayCount + kWorkgroupSize - 1) / kWorkgroupSize; }

} // namespace

Expected<TracePipeline> TracePipeline::create(Device::State &device, const Kernel &kernel, PageShape pages) {
  TracePipeline pipeline(device, kernel, pages);
  pipeline.module_ = VOXC_TRY(createModule(device, kernel.spirv));
  std::array<VkDescriptorType, kMostBindings> types{};
  for (std::uint32_t index = 0; index < pipeline.bindings_; ++index)
    types[index] = pipeline.typeOf(index);
  pipeline.layout_ =
      VOXC_TRY(ComputeLayout::create(device, std::span(types).first(pipeline.bindings_), sizeof(RayTile)));
  return pipeline;
}

VkDescriptorType TracePipeline::typeOf(std::uint32_t binding) const {
  return binding == kWords && addressing_ == Addressing::Texels ? VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER
                                                                : VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
}

Expected<void> TracePipeline::viewTexels(const VkDescriptorBufferInfo &words, BoundBuffers &bound) const {
  VkBufferViewCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_VIEW_CREATE_INFO};
  info.buffer = words.buffer;
  info.format = VK_FORMAT_R32_UINT;
  info.offset = words.offset;
  // Room that a buffer has for edits may be more than a view shows.
  info.range = std::min(words.range, device_->info().maxTexelBufferBytes);
  bound.texels = VOXC_TRY(createObject<BufferViewHandle>(*device_, &VulkanFunctions::CreateBufferView, info,
                                                         "create a view of a volume's words"));
  return {};
}

Expected<BoundBuffers> TracePipeline::bind(const KernelBuffers &buffers) const {
  BoundBuffers bound{.deferred = buffers[kDeferred]};
  if (addressing_ == Addressing::Texels)
    VOXC_TRY(viewTexels(buffers[kWords], bound));
  bound.set = VOXC_TRY(layout_.bind(std::span(buffers).first(bindings_), bound.texels.get()));
  return bound;
}

Expected<void> TracePipeline::prepare(Counted counted, float spread, Origins origins, VkPipelineCache cache) {
  Constants constants{counted == Counted::Lookups,  spread, counted == Counted::Words, false,
                      origins == Origins::Anywhere, pages_};
  const bool isKept = cache == VK_NULL_HANDLE && !spirv_.empty();
  const PipelineCache kept(*device_, isKept ? device_->cache : nullptr, bytesOf<std::uint32_t>(spirv_),
                           bytesOf<Constants>({&constants, 1}));
  cache = isKept ? kept.get() : cache;
  auto defers = VOXC_TRY(createPipeline(constants, cache));
  constants.exactFallback = true;
  auto resolves = VOXC_TRY(createPipeline(constants, cache));
  kept.store();
  variants_[std::size_t(counted)] = {std::move(defers), std::move(resolves), spread, origins};
  return {};
}

Expected<PipelineHandle> TracePipeline::createPipeline(const Constants &constants, VkPipelineCache cache) {
  VkSpecializationInfo specialization{std::size(kConstantEntries), kConstantEntries, sizeof constants,
                                      &constants};
  return layout_.createPipeline(module_.get(), specialization, cache);
}

void TracePipeline::start(VkCommandBuffer commands, const PipelineHandle &pipeline,
                          const BoundBuffers &buffers, const RayTile &tile) const {
  layout_.start(commands, pipeline, buffers.set, std::as_bytes(std::span(&tile, 1)));
}

void TracePipeline::dispatch(VkCommandBuffer commands, const RayTile &tile, const GroupsThere &groups) const {
  if (groups.buffer == VK_NULL_HANDLE)
    device_->vk.CmdDispatch(commands, groupsOf(tile), 1, 1);
  else
    device_->vk.CmdDispatchIndirect(commands, groups.buffer, groups.offset);
}

void TracePipeline::recordDispatch(VkCommandBuffer commands, const BoundBuffers &buffers, Counted counted,
                                   const RayTile &tile, const GroupsThere &groups) const {
  start(commands, variants_[std::size_t(counted)].resolves, buffers, tile);
  dispatch(commands, tile, groups);
}

void TracePipeline::recordDispatches(VkCommandBuffer commands, const BoundBuffers &buffers, Counted counted,
                                     const RayTile &tile) const {
  recordBarrier(*device_, commands); // The tile before may still be reading its list.
  recordEmptyList(commands, buffers);
  recordBarrier(*device_, commands);
  recordLeaving(commands, buffers, counted, tile);
  recordBarrier(*device_, commands);
  recordDeferred(commands, buffers, counted, tile);
}

void TracePipeline::recordEmptyList(VkCommandBuffer commands, const BoundBuffers &buffers) const {
  // No group to start yet, and no ray on the list.
  constexpr std::array<std::uint32_t, 4> kEmptyList = {0, 1, 1, 0};
  device_->vk.CmdUpdateBuffer(commands, buffers.deferred.buffer, buffers.deferred.offset, sizeof kEmptyList,
                              kEmptyList.data());
}

void TracePipeline::recordLeaving(VkCommandBuffer commands, const BoundBuffers &buffers, Counted counted,
                                  const RayTile &tile, const GroupsThere &groups) const {
  start(commands, variants_[std::size_t(counted)].defers, buffers, tile);
  dispatch(commands, tile, groups);
}

void TracePipeline::recordDeferred(VkCommandBuffer commands, const BoundBuffers &buffers, Counted counted,
                                   const RayTile &tile) const {
  start(commands, variants_[std::size_t(counted)].resolves, buffers,
        {tile.first, tile.rayCount, Task::Deferred});
  device_->vk.CmdDispatchIndirect(commands, buffers.deferred.buffer, buffers.deferred.offset);
}

} // namespace voxc
