// The triangles of a scene by their numbers, which run through instance after instance.
#pragma once

#include "Mesh/ModelFrame.h"
#include "voxc/Mesh/TriangleScene.h"

#include <array>
#include <cstdint>
#include <vector>

namespace voxc {

/// The number of the first triangle of each instance.
class TriangleNumbers {
public:
  explicit TriangleNumbers(const TriangleScene &scene);

  /// All triangles; no more than 2^33, however many there are.
  std::uint64_t size() const { return firsts_.back(); }
  std::uint64_t first(std::size_t instance) const { return firsts_[instance]; }
  /// The instance of a triangle.
  std::size_t instanceOf(std::uint64_t triangle) const;

private:
  std::vector<std::uint64_t> firsts_; ///< And behind the last.
};

/// Stands on one triangle after the other; quick where the next one belongs to the same instance.
class TriangleCursor {
public:
  /// Both must outlive the cursor.
  TriangleCursor(const TriangleScene &scene, const TriangleNumbers &numbers)
      : scene_(scene), numbers_(numbers) {}

  void moveTo(std::uint64_t triangle);

  std::uint32_t partIndex() const { return instance_->part; }
  /// Does the instance's place turn triangles around, as a mirror does?
  bool isMirrored() const { return isMirrored_; }
  const MeshPart &part() const { return *part_; }
  const std::array<std::uint32_t, 3> &vertices() const { return vertices_; }
  /// The corners, at the instance's place in the model. The vertices must exist.
  std::array<glm::dvec3, 3> corners() const;
  /// Has a triangle with these corners nothing to show? Only points and lines are without an area: of a
  /// triangle with two corners in one place, as strips have them between parts of theirs, nothing is seen.
  bool isCollapsed(const std::array<glm::dvec3, 3> &corners) const;

private:
  void enter(std::size_t instance);
  glm::dvec3 corner(std::uint32_t vertex) const;

  const TriangleScene &scene_;
  const TriangleNumbers &numbers_;
  std::uint64_t first_ = 0; ///< Of the instance's triangles.
  std::uint64_t end_ = 0;
  const MeshInstance *instance_ = nullptr;
  const MeshPart *part_ = nullptr;
  bool isMoved_ = false; ///< The instance is at another place than its part.
  bool isMirrored_ = false;
  const std::byte *indexRows_ = nullptr;    ///< Of uint32 or uint16 for plain triangles, else null.
  const std::byte *positionRows_ = nullptr; ///< Of three floats or doubles, else null.
  bool areDoubles_ = false;
  std::array<std::uint32_t, 3> vertices_{};
};

} // namespace voxc
