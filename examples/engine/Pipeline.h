// The pipeline: shaders in groups, and the table of records that says which group an instance is met by.
#pragma once

#include "Device.h"

#include <cstddef>
#include <cstdint>

/// Groups of shaders by their numbers in the pipeline. Those of hits have records, one or more each.
enum class Group : std::uint32_t { Camera, Sky, Mesh, Missing, Dag, Grid };

class Pipeline {
public:
  /// With so many records of hits.
  Pipeline(Device &device, std::uint32_t records);
  ~Pipeline();
  Pipeline(const Pipeline &) = delete;
  Pipeline &operator=(const Pipeline &) = delete;

  /// What the shaders see, as in shared.glsl.
  void bind(VkAccelerationStructureKHR world, const Buffer &rays, const Buffer &answers,
            const Buffer &wanted);
  /// Writes a record of hits: its group, and where the words of its volume lie, for voxc's shaders.
  void setRecord(std::uint32_t record, Group group, VkDeviceAddress words = 0);
  void trace(VkCommandBuffer commands, std::uint32_t rays) const;

private:
  void makeLayout();
  void makePipeline();
  void makeTable();
  std::byte *at(VkDeviceSize offset) const;
  void copyHandle(VkDeviceSize offset, Group group) const;

  Device &device_;
  std::uint32_t count_;
  VkDescriptorSetLayout setLayout_ = VK_NULL_HANDLE;
  VkDescriptorPool pool_ = VK_NULL_HANDLE;
  VkDescriptorSet set_ = VK_NULL_HANDLE;
  VkPipelineLayout layout_ = VK_NULL_HANDLE;
  VkPipeline pipeline_ = VK_NULL_HANDLE;
  Buffer table_{};
  VkDeviceSize begin_ = 0;  ///< In the buffer, as an address must be aligned.
  VkDeviceSize base_ = 0;   ///< From the record of the camera to that of the sky, and on to those of hits.
  VkDeviceSize stride_ = 0; ///< From a record of hits to the next.
};
