// Vertices, faces and triangle strips of PLY files.
#include "Mesh/Ply/PlyScene.h"

#include "Mesh/KeptArray.h"
#include "Mesh/Ply/PlyColour.h"
#include "Mesh/Ply/PlyReader.h"
#include "Mesh/Polygon.h"
#include "Support/Problem.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace voxc {

namespace {

const PlyElement kNoElement;
constexpr std::uint64_t kRowsBetweenLooks = 1024;

const PlyElement &elementOf(const PlyHeader &header, std::string_view name) {
  const PlyElement *found = header.find(name);
  return found ? *found : kNoElement;
}

/// The list of corners of a face or strip.
std::optional<std::size_t> findCorners(const PlyElement &element) {
  for (const std::string_view name : {"vertex_indices", "vertex_index"})
    if (const auto found = element.find(name); found && element.properties[*found].countType)
      return found;
  return std::nullopt;
}

bool needsDouble(PlyType type) {
  return type == PlyType::Float64 || type == PlyType::Int32 || type == PlyType::Uint32;
}

/// Has the pages of a mapped file watched while it is read.
class Watch {
public:
  Watch(std::span<const std::byte> bytes, WorkingMemory &memory) : bytes_(bytes), memory_(memory) {
    memory_.watch(bytes_);
  }
  ~Watch() { memory_.unwatch(bytes_); }
  Watch(const Watch &) = delete;
  Watch &operator=(const Watch &) = delete;

private:
  std::span<const std::byte> bytes_;
  WorkingMemory &memory_;
};

class SceneBuilder {
public:
  SceneBuilder(const PlyHeader &header, const MeshInput &input)
      : input_(input), vertices_(elementOf(header, "vertex")), faces_(elementOf(header, "face")),
        strips_(elementOf(header, "tristrips")), colour_(vertices_), faceCorners_(findCorners(faces_)),
        stripCorners_(findCorners(strips_)), positions_(input.memory), widePositions_(input.memory),
        colours_(input.memory), indices_(input.memory) {
    // Text has more digits than float32, whatever the header calls its numbers.
    isWide_ = header.encoding == PlyEncoding::Ascii;
    position_ = {vertices_.find("x"), vertices_.find("y"), vertices_.find("z")};
    for (const auto &axis : position_)
      isWide_ = isWide_ || (axis && needsDouble(vertices_.properties[*axis].type));
  }

  /// What the header lacks, or nothing.
  std::string missing() const {
    for (const auto &axis : position_)
      if (!axis || vertices_.properties[*axis].countType)
        return "its vertices need the properties x, y and z";
    if (vertices_.count > std::numeric_limits<std::uint32_t>::max())
      return "it has more than 2^32 vertices";
    if (faces_.count != 0 && !faceCorners_)
      return "its faces need the list vertex_indices";
    if (strips_.count != 0 && !stripCorners_)
      return "its triangle strips need the list vertex_indices";
    return {};
  }

  /// Adds a row.
  void add(const PlyElement &element, std::uint64_t index, const PlyRow &row) {
    if (index % kRowsBetweenLooks == 0 && !input_.at(index, element.count))
      problem_.set(Error::interrupted());
    if (&element == &vertices_)
      addVertex(row);
    else if (&element == &faces_)
      addFace(index, row.lists[*faceCorners_]);
    else if (&element == &strips_)
      addStrips(index, row.lists[*stripCorners_]);
  }

  const Problem &problem() const { return problem_; }

  TriangleScene take() {
    TriangleScene scene;
    MeshPart part;
    part.positions = isWide_ ? keep(std::move(widePositions_), kDoubleRows3, scene)
                             : keep(std::move(positions_), kFloatRows3, scene);
    part.colours = keep(std::move(colours_), kColourRows, scene);
    part.indices = keep(std::move(indices_), kIndexRows, scene);
    scene.materials.emplace_back();
    if (part.positions && part.indices) {
      scene.parts.push_back(part);
      scene.instances.push_back({});
    }
    if (cutter_.badFans() != 0)
      scene.warnings.push_back(
          std::to_string(cutter_.badFans()) +
          " faces of more than 128 corners are not convex and are cut into fans all the same");
    return scene;
  }

private:
  void addVertex(const PlyRow &row) {
    PolygonCutter::Point position;
    for (std::size_t axis = 0; axis < 3; ++axis)
      position[axis] = row.values[*position_[axis]];
    if (isWide_)
      problem_.check(widePositions_.push(position));
    else
      problem_.check(positions_.push({static_cast<float>(position[0]), static_cast<float>(position[1]),
                                      static_cast<float>(position[2])}));
    if (colour_)
      problem_.check(colours_.push(colour_(row)));
  }

  bool isVertex(double corner) const { return corner >= 0 && corner < static_cast<double>(vertices_.count); }

  void noVertex(const char *what, std::uint64_t index, double corner) {
    problem_.set(std::string(what) + " " + std::to_string(index) + " names vertex " +
                 std::to_string(static_cast<std::int64_t>(std::clamp(corner, -0x1p53, 0x1p53))) +
                 ", but there are " + std::to_string(vertices_.count));
  }

  void addFace(std::uint64_t index, const std::vector<double> &corners) {
    for (const double corner : corners)
      if (!isVertex(corner))
        return noVertex("face", index, corner);
    if (corners.size() == 3)
      return addTriangle(corners[0], corners[1], corners[2]);
    if (corners.size() < 3)
      return;
    points_.clear();
    for (const double corner : corners)
      points_.push_back(positionOf(static_cast<std::uint64_t>(corner)));
    for (const auto &[a, b, c] : cutter_.cut(points_))
      addTriangle(corners[a], corners[b], corners[c]);
  }

  /// A file may name its faces before its vertices; their shape is not known then, and they become fans.
  PolygonCutter::Point positionOf(std::uint64_t vertex) const {
    if (isWide_)
      return vertex < widePositions_.size() ? widePositions_[vertex] : PolygonCutter::Point{};
    if (vertex >= positions_.size())
      return {};
    const auto &[x, y, z] = positions_[vertex];
    return {x, y, z};
  }

  /// Several strips, with -1 between them.
  void addStrips(std::uint64_t index, const std::vector<double> &corners) {
    std::size_t begin = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (corners[i] == -1)
        begin = i + 1;
      else if (!isVertex(corners[i]))
        return noVertex("strip", index, corners[i]);
      else if (i >= begin + 2)
        addTriangle(corners[i - 2], corners[i - 1], corners[i]);
    }
  }

  void addTriangle(double a, double b, double c) {
    const std::array<std::uint32_t, 3> corners{static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b),
                                               static_cast<std::uint32_t>(c)};
    problem_.check(indices_.append(corners));
  }

  const MeshInput &input_;
  const PlyElement &vertices_;
  const PlyElement &faces_;
  const PlyElement &strips_;
  PlyColour colour_;
  std::array<std::optional<std::size_t>, 3> position_;
  std::optional<std::size_t> faceCorners_;
  std::optional<std::size_t> stripCorners_;
  bool isWide_ = false; ///< Coordinates that a float cannot hold.
  ScratchArray<std::array<float, 3>> positions_;
  ScratchArray<PolygonCutter::Point> widePositions_;
  ScratchArray<std::uint32_t> colours_;
  ScratchArray<std::uint32_t> indices_;
  std::vector<PolygonCutter::Point> points_;
  PolygonCutter cutter_;
  Problem problem_;
};

} // namespace

Expected<TriangleScene> readPlyScene(const MeshInput &input) {
  auto reader = PlyReader::open(input.path);
  if (!reader)
    return reader.error();
  SceneBuilder builder(reader->header(), input);
  if (std::string missing = builder.missing(); !missing.empty())
    return reader->broken(missing);
  const Watch watch(reader->bytes(), *input.memory);
  auto read = reader->readRows(
      [&](const PlyElement &element, std::uint64_t index, const PlyRow &row) -> Expected<void> {
        builder.add(element, index, row);
        return builder.problem() ? Expected<void>(builder.problem().error()) : Expected<void>();
      });
  if (builder.problem() && builder.problem().error().kind == ErrorKind::Input)
    return reader->broken(builder.problem().error().message);
  if (!read)
    return read.error();
  return builder.take();
}

} // namespace voxc
