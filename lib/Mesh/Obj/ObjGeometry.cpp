// Joining positions with texture coordinates, and cutting faces.
#include "Mesh/Obj/ObjGeometry.h"

#include <limits>
#include <string>

namespace voxc {

namespace {

constexpr std::uint32_t kWhite = 0xffffffff;
constexpr std::uint64_t kMostVertices = std::numeric_limits<std::uint32_t>::max();

} // namespace

ObjGeometry::ObjGeometry(const std::shared_ptr<WorkingMemory> &memory, Problem &problem)
    : problem_(problem), positions_(memory), uvs_(memory), colours_(memory), latest_(memory),
      vertexPositions_(memory), vertexUvs_(memory), vertexColours_(memory), indices_(memory) {}

void ObjGeometry::addPosition(const Position &position, std::optional<std::uint32_t> colour) {
  if (positions_.size() == kMostVertices)
    return problem_.set("there are more than 2^32 vertices");
  if (colour)
    while (!problem_ && colours_.size() < positions_.size())
      problem_.check(colours_.push(kWhite));
  if (colour || !colours_.empty())
    problem_.check(colours_.push(colour.value_or(kWhite)));
  problem_.check(positions_.push(position));
  problem_.check(latest_.push({}));
}

void ObjGeometry::add(PrimitiveMode mode, std::span<const ObjCorner> corners, std::uint32_t material) {
  vertices_.clear();
  for (const ObjCorner &corner : corners)
    vertices_.push_back(vertexOf(corner));
  if (problem_)
    return;
  beginRun(mode, material);
  if (mode == PrimitiveMode::Triangles)
    addFace();
  else if (mode == PrimitiveMode::Points)
    problem_.check(indices_.append(vertices_));
  else
    for (std::size_t i = 1; i < vertices_.size(); ++i)
      addIndices({vertices_[i - 1], vertices_[i]});
}

std::optional<std::uint64_t> ObjGeometry::resolve(std::int64_t number, std::uint64_t count,
                                                  const char *what) {
  const auto signedCount = static_cast<std::int64_t>(count);
  if (number > 0 && number <= signedCount)
    return static_cast<std::uint64_t>(number - 1);
  if (number < 0 && number >= -signedCount)
    return static_cast<std::uint64_t>(signedCount + number);
  problem_.set("it names the " + std::string(what) + " " + std::to_string(number) + ", but " +
               std::to_string(count) + " stand before it");
  return std::nullopt;
}

std::uint32_t ObjGeometry::vertexOf(const ObjCorner &corner) {
  const auto position = resolve(corner.position, positions_.size(), "vertex");
  const auto uv =
      corner.uv == 0 ? std::optional<std::uint64_t>() : resolve(corner.uv, uvs_.size(), "texture coordinate");
  if (!position || (corner.uv != 0 && !uv))
    return 0;
  const std::uint32_t uvNumber = uv ? static_cast<std::uint32_t>(*uv) + 1 : 0;
  Latest &latest = latest_[*position];
  if (!latest.isMade || latest.uv != uvNumber)
    latest = {uvNumber, makeVertex(*position, uvNumber), true};
  return latest.vertex;
}

std::uint32_t ObjGeometry::makeVertex(std::uint64_t position, std::uint32_t uv) {
  const std::uint64_t vertex = vertexPositions_.size();
  if (vertex == kMostVertices)
    problem_.set("its faces have more than 2^32 different corners");
  problem_.check(vertexPositions_.push(positions_[position]));
  problem_.check(vertexUvs_.push(uv == 0 ? Uv{} : uvs_[uv - 1]));
  if (!colours_.empty()) {
    while (!problem_ && vertexColours_.size() < vertex)
      problem_.check(vertexColours_.push(kWhite));
    problem_.check(vertexColours_.push(colours_[position]));
  }
  return static_cast<std::uint32_t>(vertex);
}

void ObjGeometry::beginRun(PrimitiveMode mode, std::uint32_t material) {
  if (runs_.empty() || runs_.back().mode != mode || runs_.back().material != material)
    runs_.push_back({mode, material, indices_.size()});
}

void ObjGeometry::addFace() {
  if (vertices_.size() < 3) {
    ++shortFaces_;
    return;
  }
  points_.clear();
  for (const std::uint32_t vertex : vertices_) {
    const Position &position = vertexPositions_[vertex];
    points_.push_back({position[0], position[1], position[2]});
  }
  for (const PolygonCutter::Corners &corners : cutter_.cut(points_))
    addIndices({vertices_[corners[0]], vertices_[corners[1]], vertices_[corners[2]]});
}

void ObjGeometry::addIndices(std::initializer_list<std::uint32_t> vertices) {
  problem_.check(indices_.append({vertices.begin(), vertices.size()}));
}

void ObjGeometry::finish(TriangleScene &scene) {
  MeshPart part;
  const bool hasUvs = !uvs_.empty();
  const std::uint64_t indexCount = indices_.size();
  part.positions = keep(std::move(vertexPositions_), kFloatRows3, scene);
  if (hasUvs)
    part.uvs = keep(std::move(vertexUvs_), kFloatRows2, scene);
  // Empty where no face came after the first colour.
  if (vertexColours_.size() == part.positions.count)
    part.colours = keep(std::move(vertexColours_), kColourRows, scene);
  const AttributeView indices = keep(std::move(indices_), kIndexRows, scene);
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    const std::uint64_t end = i + 1 < runs_.size() ? runs_[i + 1].begin : indexCount;
    if (end == runs_[i].begin)
      continue;
    part.mode = runs_[i].mode;
    part.material = runs_[i].material;
    part.indices = indices;
    part.indices.data += runs_[i].begin * sizeof(std::uint32_t);
    part.indices.count = end - runs_[i].begin;
    scene.instances.push_back({static_cast<std::uint32_t>(scene.parts.size()), {}});
    scene.parts.push_back(part);
  }
}

} // namespace voxc
