// Vertices and primitives of an .obj.
#pragma once

#include "Mesh/ColourScale.h"
#include "Mesh/KeptArray.h"
#include "Mesh/Polygon.h"
#include "Support/Problem.h"

#include <array>
#include <optional>
#include <tuple>
#include <vector>

namespace voxc {

/// Numbers of an .obj's vertex and texture coordinate as it writes them: from 1, or backwards from -1; 0 is
/// none.
struct ObjCorner {
  std::int64_t position = 0;
  std::int64_t uv = 0;
};

/// Collects what the lines of an .obj say, as vertices that have all their attributes together.
class ObjGeometry {
public:
  ObjGeometry(const std::shared_ptr<WorkingMemory> &memory, Problem &problem);

  using Position = PolygonCutter::Point; ///< Text has more digits than float32 where models lie in maps.
  using Uv = std::array<float, 2>;
  using Colour = std::array<float, 3>;

  void addPosition(const Position &position, const std::optional<Colour> &colour);
  /// Paints the next position that is not painted yet, as ZBrush does it behind all of them. A painted file
  /// has its faces behind that.
  void paint(const Colour &colour);
  void addUv(const Uv &uv) { problem_.check(uvs_.push(uv)); }

  /// Adds a face, a polyline or points. A texture coordinate that does not exist is none, and what lacks one
  /// of them has none. Problems: a vertex that does not exist.
  void add(PrimitiveMode mode, std::span<const ObjCorner> corners, std::uint32_t material);

  /// True if there are vertices, and nothing that uses one.
  bool isBare() const { return runs_.empty() && !positions_.empty(); }
  /// Makes each vertex a point.
  void addAllAsPoints(std::uint32_t material);

  /// Moves everything to the scene. Faces stay in their order, but for a file that changes the material more
  /// than 65536 times: there those of one material come together.
  void finish(TriangleScene &scene);

  /// Vertices that nothing uses.
  std::uint64_t unusedPositions() const;
  std::uint64_t shortFaces() const { return shortFaces_; }
  std::uint64_t badFans() const { return cutter_.badFans(); }
  std::uint64_t positions() const { return positions_.size(); }
  /// Corners whose texture coordinate does not exist.
  std::uint64_t badUvs() const { return badUvs_; }
  bool isPaintLate() const { return isPaintLate_; }
  /// To what the colours count.
  const ColourScale &colourScale() const { return scale_; }

private:
  /// The vertex that was made last of a position: most often the next face asks for the same.
  struct Latest {
    std::uint32_t uv = 0; ///< Number of the texture coordinate from 1; 0: none.
    std::uint32_t vertex = 0;
    bool isMade = false;
  };

  /// Primitives of one kind and material that stand together; all have texture coordinates, or none has.
  struct Run {
    PrimitiveMode mode;
    std::uint32_t material;
    bool hasUvs;
    std::uint64_t begin; ///< The first of `indices_`.

    auto kind() const { return std::tuple(material, mode, hasUvs); }
  };

  void keepColours(MeshPart &part, TriangleScene &scene);
  std::uint32_t vertexOf(const ObjCorner &corner);
  std::uint32_t makeVertex(std::uint64_t position, std::uint32_t uv);
  void beginRun(PrimitiveMode mode, std::uint32_t material);
  void addFace();
  void groupRuns();
  std::uint64_t endOf(std::size_t run) const;
  void addIndices(std::initializer_list<std::uint32_t> vertices);

  std::shared_ptr<WorkingMemory> memory_;
  Problem &problem_;
  ScratchArray<Position> positions_;
  ScratchArray<Uv> uvs_;
  ScratchArray<Colour> colours_; ///< One a position from the first on that has a colour; else none.
  std::uint64_t painted_ = 0;
  ScratchArray<Latest> latest_;

  ScratchArray<Position> vertexPositions_;
  ScratchArray<Uv> vertexUvs_;
  ScratchArray<Colour> vertexColours_;
  ScratchArray<std::uint32_t> indices_;
  std::vector<Run> runs_;

  std::vector<std::uint32_t> vertices_; ///< Of the primitive that is being added.
  bool hasUvs_ = false;                 ///< It, for all its corners.
  std::vector<PolygonCutter::Point> points_;
  PolygonCutter cutter_;
  std::uint64_t shortFaces_ = 0;
  std::uint64_t badUvs_ = 0;
  bool isPaintLate_ = false; ///< There was paint for no vertex, or behind faces.
  ColourScale scale_;
};

} // namespace voxc
