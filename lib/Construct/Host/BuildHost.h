// What generated construction code talks to, as a class.
#pragma once

#include "Construct/Nodes/NodeStore.h"

#include "voxc/Support/Geometry.h"

// The same header that the generated code includes: one definition of the interface between the two.
#include "voxc_host.h"

#include <cstdint>

namespace voxc {

/// Serves one run of generated code. After a failure every cube is "empty", so that the code ends by itself.
class BuildHost {
public:
  explicit BuildHost(NodeStore &store);
  virtual ~BuildHost() = default;

  BuildHost(const BuildHost &) = delete;
  BuildHost &operator=(const BuildHost &) = delete;

  /// The table of functions that the generated code calls; it lives as long as the host.
  const construct::Host &interface();

  NodeStore &store() { return store_; }

protected:
  /// True only if the cube holds nothing.
  virtual bool isEmpty(const Cube &cube) = 0;
  virtual void readBrick(Int3 low, construct::Brick &brick) = 0;

  /// The value of the next voxel, of a layout with values apart.
  virtual void putValue(std::uint32_t) {}

  /// Cubes of this size were built apart, from now on.
  void setPartSide(int log2Side) { table_.log2_part = log2Side; }
  /// What became of one; the cells live until the next call.
  virtual construct::Part takePart(Int3) { return {}; }
  /// The result of building a part.
  virtual void finishNode(const construct::Node &) {}
  virtual void finishCell(const construct::PlacedCell &) {}

private:
  NodeStore &store_;
  construct::Host table_{};
};

} // namespace voxc
