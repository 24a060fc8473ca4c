// When a stretch of commands began and ended, by the device's own clock.
#include "Timestamps.h"

namespace voxc {
namespace {

constexpr std::uint32_t kBegin = 0;
constexpr std::uint32_t kEnd = 1;
constexpr std::uint32_t kQueries = 2;

} // namespace

Expected<Timestamps> Timestamps::create(Device::State &device) {
  if (device.physical.timestampBits == 0)
    return Timestamps(device, {});
  VkQueryPoolCreateInfo info{VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO};
  info.queryType = VK_QUERY_TYPE_TIMESTAMP;
  info.queryCount = kQueries;
  auto queries = VOXC_TRY(
      createObject<QueryPoolHandle>(device, &VulkanFunctions::CreateQueryPool, info, "create timestamps"));
  return Timestamps(device, std::move(queries));
}

void Timestamps::recordBegin(VkCommandBuffer commands) const {
  if (!queries_)
    return;
  device_->vk.CmdResetQueryPool(commands, queries_.get(), 0, kQueries);
  device_->vk.CmdWriteTimestamp(commands, VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT, queries_.get(), kBegin);
}

void Timestamps::recordEnd(VkCommandBuffer commands) const {
  if (queries_)
    device_->vk.CmdWriteTimestamp(commands, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, queries_.get(), kEnd);
}

Expected<Timestamps::Ticks> Timestamps::read() const {
  if (!queries_)
    return Ticks{};
  std::uint64_t ticks[kQueries] = {};
  VkResult result =
      device_->vk.GetQueryPoolResults(device_->device, queries_.get(), 0, kQueries, sizeof ticks, ticks,
                                      sizeof ticks[0], VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT);
  if (result != VK_SUCCESS)
    return vulkanError("read its timestamps", result);
  return Ticks{ticks[kBegin], ticks[kEnd]};
}

double Timestamps::seconds(const Device::State &device, std::uint64_t begin, std::uint64_t end) {
  std::uint32_t bits = device.physical.timestampBits;
  std::uint64_t mask = bits >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
  return static_cast<double>((end - begin) & mask) * device.physical.limits.timestampPeriod * 1e-9;
}

} // namespace voxc
