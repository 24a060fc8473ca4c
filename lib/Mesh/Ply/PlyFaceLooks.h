// How faces look by what they say themselves, and not their vertices: colours, textures and their
// coordinates.
#pragma once

#include "Mesh/Ply/PlyColour.h"
#include "Mesh/Ply/PlyNames.h"
#include "Support/Problem.h"
#include "voxc/Support/WorkingMemory.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace voxc {

using PlyUv = std::array<float, 2>; ///< From the top, as the scene has it.

/// What faces say, gathered for the triangles that they become.
class PlyFaceLooks {
public:
  /// A triangle's look.
  struct Look {
    std::uint32_t colour = 0xffffffff;
    std::int32_t texture = -1;  ///< Index into the header's textures, or -1.
    std::array<PlyUv, 3> uvs{}; ///< If faces have texture coordinates.
  };

  /// `hasVertexUvs`: vertices have texture coordinates. The header and problem must outlive this.
  PlyFaceLooks(const PlyHeader &header, const PlyElement &faces, bool hasVertexUvs,
               const std::shared_ptr<WorkingMemory> &memory, Problem &problem);

  /// True if faces say something; then `add` is to be called for each triangle.
  bool isUsed() const { return colour_ || uvs_ || number_; }
  bool hasColours() const { return bool(colour_); }
  /// True if the corners of faces have texture coordinates of their own.
  bool hasUvs() const { return uvs_.has_value(); }
  /// To be shown all rows before the first face.
  PlyColour &colour() { return colour_; }

  /// Goes to the next face, which has so many corners.
  void read(const PlyRow &row, std::size_t corners);
  /// A triangle of that face; `places` are those of its corners in the face.
  void add(const std::array<std::uint32_t, 3> &places);
  /// A triangle of no face.
  void addPlain();

  /// Makes triangles opaque that all are wholly transparent; to be called when all are there.
  void showInvisible();
  std::span<const Look> triangles() const { return triangles_.span(); }
  /// Faces whose texture or coordinates could not be used.
  std::uint64_t badFaces() const { return badFaces_; }
  /// True if all faces have an alpha of 0.
  bool areInvisible() const { return colour_.hasAlpha() && alphas_ == 0; }
  void take(PlyUse &use) const;

private:
  const PlyElement &faces_;
  Problem &problem_;
  std::size_t textures_;
  PlyColour colour_;
  std::optional<std::size_t> uvs_;    ///< The list of texture coordinates.
  std::optional<std::size_t> number_; ///< The property that numbers textures.
  ScratchArray<Look> triangles_;
  Look face_;
  std::vector<PlyUv> faceUvs_;
  std::uint64_t badFaces_ = 0;
  std::uint32_t alphas_ = 0; ///< All bits of all colours.
};

} // namespace voxc
