// Where voxel space lies in a model: the turn, the scale and the low corner that meshes and points share.
#pragma once

#include "voxc/Support/Error.h"
#include "voxc/Support/Geometry.h"
#include "voxc/Support/Transform.h"

#include <glm/vec3.hpp>

#include <array>
#include <optional>

namespace voxc {

/// A box of points, in model units.
struct Bounds {
  glm::dvec3 low{};
  glm::dvec3 high{};
};

/// Grows box by box and point by point.
class BoundsBuilder {
public:
  void add(const glm::dvec3 &point);
  /// Nothing if no point was added.
  const std::optional<Bounds> &bounds() const { return bounds_; }

private:
  std::optional<Bounds> bounds_;
};

/// How a box of a model is laid out in voxels.
struct FrameOptions {
  Bounds bounds;      ///< In the model's own axes.
  int resolution = 0; ///< Voxels on the longest axis; 0: as many as fit into `maxExtent`.
  Int3 maxExtent;
  bool zUp = false; ///< Turns the model's +z to +y.
  double voxelSize =
      0; ///< The side of a voxel in model units, in place of a resolution; 0: by the resolution.
  /// A point of the model, in its own axes, that planes between voxels go through on each axis.
  std::optional<glm::dvec3> align;
};

/// Maps model coordinates to voxels: the low corner of the turned bounds goes to (0, 0, 0), and their longest
/// axis takes `resolution` voxels. Other axes take as many as they touch, at least one. By `align` the low
/// corner of the voxels is as far below the bounds as it must be.
class ModelFrame {
public:
  /// Errors: bounds that are inverted or not finite; more voxels than `maxExtent` on an axis.
  static Expected<ModelFrame> fit(const FrameOptions &options);

  Int3 extent() const { return extent_; }
  /// Voxels a model unit.
  double scale() const { return scale_; }
  /// A point in voxels. Its error is below 2^-50 of its largest coordinate.
  glm::dvec3 toVoxels(const glm::dvec3 &point) const;
  /// The inverse map, of points in voxels to model units.
  Transform voxelToModel() const;

private:
  Expected<void> place(const FrameOptions &options, const glm::dvec3 &low, const glm::dvec3 &high);

  bool zUp_ = false;
  glm::dvec3 origin_{}; ///< In turned model units.
  double scale_ = 1;
  Int3 extent_;
};

} // namespace voxc
