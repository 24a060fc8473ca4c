// Acceleration structures over a mesh and chunks.
#include "Scene.h"

#include <cstring>
#include <initializer_list>

namespace {

constexpr VkBufferUsageFlags kInput = VK_BUFFER_USAGE_ACCELERATION_STRUCTURE_BUILD_INPUT_READ_ONLY_BIT_KHR;

VkAccelerationStructureBuildGeometryInfoKHR buildInfo(const VkAccelerationStructureGeometryKHR &geometry,
                                                      VkAccelerationStructureTypeKHR type) {
  return {.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_BUILD_GEOMETRY_INFO_KHR,
          .type = type,
          .flags = VK_BUILD_ACCELERATION_STRUCTURE_PREFER_FAST_TRACE_BIT_KHR,
          .mode = VK_BUILD_ACCELERATION_STRUCTURE_MODE_BUILD_KHR,
          .geometryCount = 1,
          .pGeometries = &geometry};
}

VkAccelerationStructureInstanceKHR instance(float x, float y, float z, std::uint32_t number,
                                            std::uint32_t record, VkDeviceAddress structure) {
  return {.transform = {{{1, 0, 0, x}, {0, 1, 0, y}, {0, 0, 1, z}}},
          .instanceCustomIndex = number,
          .mask = 0xff,
          .instanceShaderBindingTableRecordOffset = record,
          .flags = VK_GEOMETRY_INSTANCE_TRIANGLE_FACING_CULL_DISABLE_BIT_KHR,
          .accelerationStructureReference = structure};
}

} // namespace

Scene::Scene(Device &device, std::span<const Place> chunks)
    : device_(device), count_(static_cast<std::uint32_t>(chunks.size()) + 1),
      instances_(device.makeBuffer(count_ * sizeof(VkAccelerationStructureInstanceKHR), kInput)),
      geometry_{.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_KHR,
                .geometryType = VK_GEOMETRY_TYPE_INSTANCES_KHR} {
  mesh_ = makeMesh();
  box_ = makeBox();
  auto *written = static_cast<VkAccelerationStructureInstanceKHR *>(instances_.mapped);
  written[0] = instance(kMiddle[0], kMiddle[1], kMiddle[2], 0, 0, mesh_.address);
  for (std::uint32_t i = 0; i + 1 < count_; ++i) {
    const auto &[x, y, z] = chunks[i];
    written[i + 1] = instance(kChunk * float(x), kChunk * float(y), kChunk * float(z), i, 1, box_.address);
  }
  geometry_.geometry.instances = {.sType =
                                      VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_INSTANCES_DATA_KHR,
                                  .data = {.deviceAddress = instances_.address}};
  top_ = make(geometry_, count_, VK_ACCELERATION_STRUCTURE_TYPE_TOP_LEVEL_KHR);
}

Scene::~Scene() {
  const auto destroy =
      device_.function<PFN_vkDestroyAccelerationStructureKHR>("vkDestroyAccelerationStructureKHR");
  for (const Structure &structure : {mesh_, box_, top_})
    destroy(device_.handle(), structure.handle, nullptr);
}

Scene::Structure Scene::make(const VkAccelerationStructureGeometryKHR &geometry, std::uint32_t count,
                             VkAccelerationStructureTypeKHR type) {
  const auto info = buildInfo(geometry, type);
  VkAccelerationStructureBuildSizesInfoKHR sizes{
      .sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_BUILD_SIZES_INFO_KHR};
  device_.function<PFN_vkGetAccelerationStructureBuildSizesKHR>("vkGetAccelerationStructureBuildSizesKHR")(
      device_.handle(), VK_ACCELERATION_STRUCTURE_BUILD_TYPE_DEVICE_KHR, &info, &count, &sizes);
  const Buffer memory = device_.makeBuffer(sizes.accelerationStructureSize,
                                           VK_BUFFER_USAGE_ACCELERATION_STRUCTURE_STORAGE_BIT_KHR);
  const VkDeviceSize step = device_.structures().minAccelerationStructureScratchOffsetAlignment;
  const Buffer scratch = device_.makeBuffer(sizes.buildScratchSize + step);
  const VkAccelerationStructureCreateInfoKHR create{
      .sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_CREATE_INFO_KHR,
      .buffer = memory.buffer,
      .size = sizes.accelerationStructureSize,
      .type = type};
  Structure made{.scratch = (scratch.address + step - 1) / step * step};
  check(device_.function<PFN_vkCreateAccelerationStructureKHR>("vkCreateAccelerationStructureKHR")(
            device_.handle(), &create, nullptr, &made.handle),
        "vkCreateAccelerationStructureKHR");
  const VkAccelerationStructureDeviceAddressInfoKHR address{
      .sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_DEVICE_ADDRESS_INFO_KHR,
      .accelerationStructure = made.handle};
  made.address = device_.function<PFN_vkGetAccelerationStructureDeviceAddressKHR>(
      "vkGetAccelerationStructureDeviceAddressKHR")(device_.handle(), &address);
  return made;
}

void Scene::build(VkCommandBuffer commands, const Structure &structure,
                  const VkAccelerationStructureGeometryKHR &geometry, std::uint32_t count,
                  VkAccelerationStructureTypeKHR type) const {
  auto info = buildInfo(geometry, type);
  info.dstAccelerationStructure = structure.handle;
  info.scratchData.deviceAddress = structure.scratch;
  const VkAccelerationStructureBuildRangeInfoKHR range{.primitiveCount = count};
  const VkAccelerationStructureBuildRangeInfoKHR *ranges = &range;
  device_.function<PFN_vkCmdBuildAccelerationStructuresKHR>("vkCmdBuildAccelerationStructuresKHR")(
      commands, 1, &info, &ranges);
  const VkMemoryBarrier barrier{.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER,
                                .srcAccessMask = VK_ACCESS_ACCELERATION_STRUCTURE_WRITE_BIT_KHR,
                                .dstAccessMask = VK_ACCESS_ACCELERATION_STRUCTURE_READ_BIT_KHR};
  vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ACCELERATION_STRUCTURE_BUILD_BIT_KHR,
                       VK_PIPELINE_STAGE_RAY_TRACING_SHADER_BIT_KHR |
                           VK_PIPELINE_STAGE_ACCELERATION_STRUCTURE_BUILD_BIT_KHR,
                       0, 1, &barrier, 0, nullptr, 0, nullptr);
}

Scene::Structure Scene::makeMesh() {
  // Three corners of each octant; the bits of its number are the signs of x, y and z (mesh.rchit).
  float corners[8][3][3]{};
  for (int octant = 0; octant < 8; ++octant)
    for (int axis = 0; axis < 3; ++axis)
      corners[octant][axis][axis] = (octant >> axis & 1) != 0 ? kReach : -kReach;
  const Buffer vertices = device_.makeBuffer(sizeof corners, kInput);
  std::memcpy(vertices.mapped, corners, sizeof corners);
  VkAccelerationStructureGeometryKHR geometry{.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_KHR,
                                              .geometryType = VK_GEOMETRY_TYPE_TRIANGLES_KHR,
                                              .flags = VK_GEOMETRY_OPAQUE_BIT_KHR};
  geometry.geometry.triangles = {.sType =
                                     VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_TRIANGLES_DATA_KHR,
                                 .vertexFormat = VK_FORMAT_R32G32B32_SFLOAT,
                                 .vertexData = {.deviceAddress = vertices.address},
                                 .vertexStride = sizeof corners[0][0],
                                 .maxVertex = 23,
                                 .indexType = VK_INDEX_TYPE_NONE_KHR};
  constexpr auto kType = VK_ACCELERATION_STRUCTURE_TYPE_BOTTOM_LEVEL_KHR;
  const Structure made = make(geometry, 8, kType);
  device_.run([&](VkCommandBuffer commands) { build(commands, made, geometry, 8, kType); });
  return made;
}

Scene::Structure Scene::makeBox() {
  const VkAabbPositionsKHR box{-kMargin,         -kMargin,         -kMargin,
                               kChunk + kMargin, kChunk + kMargin, kChunk + kMargin};
  const Buffer boxes = device_.makeBuffer(sizeof box, kInput);
  std::memcpy(boxes.mapped, &box, sizeof box);
  VkAccelerationStructureGeometryKHR geometry{.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_KHR,
                                              .geometryType = VK_GEOMETRY_TYPE_AABBS_KHR,
                                              .flags = VK_GEOMETRY_OPAQUE_BIT_KHR};
  geometry.geometry.aabbs = {.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_AABBS_DATA_KHR,
                             .data = {.deviceAddress = boxes.address},
                             .stride = sizeof box};
  constexpr auto kType = VK_ACCELERATION_STRUCTURE_TYPE_BOTTOM_LEVEL_KHR;
  const Structure made = make(geometry, 1, kType);
  device_.run([&](VkCommandBuffer commands) { build(commands, made, geometry, 1, kType); });
  return made;
}

void Scene::setRecord(std::size_t chunk, std::uint32_t record) {
  auto *written = static_cast<VkAccelerationStructureInstanceKHR *>(instances_.mapped);
  written[chunk + 1].instanceShaderBindingTableRecordOffset = record;
}

void Scene::build(VkCommandBuffer commands) const {
  build(commands, top_, geometry_, count_, VK_ACCELERATION_STRUCTURE_TYPE_TOP_LEVEL_KHR);
}
