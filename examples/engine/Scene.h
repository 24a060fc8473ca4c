// What rays meet: a mesh of triangles and chunks of voxels, as instances of one structure.
#pragma once

#include "Device.h"

#include <cstdint>
#include <span>

/// Voxels along each edge of a chunk, and how much larger its box is: as in shared.glsl.
constexpr float kChunk = 32, kMargin = 0.03f;

/// Where the octahedron stands, in voxels, and how far its corners are from its middle.
constexpr float kMiddle[3] = {60, 84, 52}, kReach = 30;

/// Where a chunk begins, in chunks.
struct Place {
  int x, y, z;
};

class Scene {
public:
  /// Instance 0 is the mesh, with record 0; those behind it are the chunks, all with record 1.
  Scene(Device &device, std::span<const Place> chunks);
  ~Scene();
  Scene(const Scene &) = delete;
  Scene &operator=(const Scene &) = delete;

  /// Gives a chunk a record of hits, for the next build.
  void setRecord(std::size_t chunk, std::uint32_t record);
  /// Records the building of the structure over all instances, which rays that are recorded after it go
  /// through.
  void build(VkCommandBuffer commands) const;
  VkAccelerationStructureKHR structure() const { return top_.handle; }

private:
  struct Structure {
    VkAccelerationStructureKHR handle;
    VkDeviceAddress address, scratch;
  };
  Structure make(const VkAccelerationStructureGeometryKHR &geometry, std::uint32_t count,
                 VkAccelerationStructureTypeKHR type);
  void build(VkCommandBuffer commands, const Structure &structure,
             const VkAccelerationStructureGeometryKHR &geometry, std::uint32_t count,
             VkAccelerationStructureTypeKHR type) const;
  Structure makeMesh();
  Structure makeBox();

  Device &device_;
  std::uint32_t count_;
  Buffer instances_;
  VkAccelerationStructureGeometryKHR geometry_;
  Structure mesh_, box_, top_;
};
