// Vertices of PLY files.
#pragma once

#include "Mesh/Ply/PlyColour.h"
#include "Mesh/Ply/PlyFaceLooks.h"
#include "Mesh/Polygon.h"
#include "voxc/Mesh/TriangleScene.h"

namespace voxc {

/// Gathers positions, colours and texture coordinates.
class PlyVertices {
public:
  /// The header and problem must outlive this.
  PlyVertices(const PlyHeader &header, const PlyElement &element,
              const std::shared_ptr<WorkingMemory> &memory, Problem &problem);

  /// What the header lacks, or nothing.
  std::string missing() const;

  const PlyElement &element() const { return element_; }
  bool hasUvs() const { return uv_[0] && uv_[1]; }
  /// To be shown all rows before the first vertex.
  PlyColour &colour() { return colour_; }

  void add(const PlyRow &row);
  std::uint64_t count() const { return isWide_ ? widePositions_.size() : positions_.size(); }
  /// Of a vertex that is there; of one that is still to come the origin.
  PolygonCutter::Point positionOf(std::uint64_t vertex) const;

  /// Gives all to the scene, as the attributes of a part.
  void keepIn(TriangleScene &scene, MeshPart &part);
  /// True if all vertices have an alpha of 0, which is then not kept: what nobody could see is meant to be
  /// seen.
  bool areInvisible() const { return colour_.hasAlpha() && alphas_ == 0; }
  void take(PlyUse &use) const;

private:
  const PlyElement &element_;
  Problem &problem_;
  std::array<std::optional<std::size_t>, 3> position_;
  std::array<std::optional<std::size_t>, 2> uv_;
  PlyColour colour_;
  bool isWide_ = false; ///< Coordinates that a float cannot hold.
  ScratchArray<std::array<float, 3>> positions_;
  ScratchArray<PolygonCutter::Point> widePositions_;
  ScratchArray<PlyUv> uvs_;
  ScratchArray<std::uint32_t> colours_;
  std::uint32_t alphas_ = 0; ///< All bits of all words.
};

} // namespace voxc
