// Joining positions with texture coordinates, and cutting faces.
#include "Mesh/Obj/ObjGeometry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

namespace voxc {

namespace {

/// Stands for the colour of a vertex that has none: no file has this number.
constexpr float kNoChannel = std::numeric_limits<float>::lowest();
constexpr ObjGeometry::Colour kNoColour{kNoChannel, kNoChannel, kNoChannel};

constexpr std::uint64_t kMostVertices = std::numeric_limits<std::uint32_t>::max();

/// Each becomes a part, which takes two hundred bytes beside the bound.
constexpr std::size_t kMostRuns = std::size_t{1} << 16;

std::uint32_t packed(const ObjGeometry::Colour &colour, double whole) {
  if (colour == kNoColour)
    return 0xffffffff;
  std::uint32_t word = 0xff000000;
  for (std::size_t i = 0; i < colour.size(); ++i) {
    const double share = colour[i] / whole;
    // Written so that NaN becomes 0.
    const double bounded = share > 0 ? std::fmin(share, 1) : 0;
    word |= static_cast<std::uint32_t>(std::lround(bounded * 255)) << 8 * i;
  }
  return word;
}

/// The index that a number counted from 1, or backwards from -1, means.
std::optional<std::uint64_t> resolve(std::int64_t number, std::uint64_t count) {
  const auto signedCount = static_cast<std::int64_t>(count);
  if (number > 0 && number <= signedCount)
    return static_cast<std::uint64_t>(number - 1);
  if (number < 0 && number >= -signedCount)
    return static_cast<std::uint64_t>(signedCount + number);
  return std::nullopt;
}

} // namespace

ObjGeometry::ObjGeometry(const std::shared_ptr<WorkingMemory> &memory, Problem &problem)
    : memory_(memory), problem_(problem), positions_(memory), uvs_(memory), colours_(memory), latest_(memory),
      vertexPositions_(memory), vertexUvs_(memory), vertexColours_(memory), indices_(memory) {}

void ObjGeometry::addPosition(const Position &position, const std::optional<Colour> &colour) {
  if (positions_.size() == kMostVertices)
    return problem_.set("there are more than 2^32 vertices");
  if (colour)
    while (!problem_ && colours_.size() < positions_.size())
      problem_.check(colours_.push(kNoColour));
  if (colour || !colours_.empty())
    problem_.check(colours_.push(colour.value_or(kNoColour)));
  if (colour)
    for (const float channel : *colour)
      scale_.add(channel);
  problem_.check(positions_.push(position));
  problem_.check(latest_.push({}));
}

void ObjGeometry::paint(const Colour &colour) {
  isPaintLate_ = isPaintLate_ || painted_ >= positions_.size() || !runs_.empty();
  if (isPaintLate_)
    return;
  while (!problem_ && colours_.size() < positions_.size())
    problem_.check(colours_.push(kNoColour));
  if (!problem_)
    colours_[painted_++] = colour;
}

void ObjGeometry::add(PrimitiveMode mode, std::span<const ObjCorner> corners, std::uint32_t material) {
  vertices_.clear();
  hasUvs_ = true;
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

void ObjGeometry::addAllAsPoints(std::uint32_t material) {
  const auto count = static_cast<std::int64_t>(positions_.size());
  for (std::int64_t number = 1; number <= count && !problem_; ++number)
    add(PrimitiveMode::Points, std::array{ObjCorner{number, 0}}, material);
}

std::uint64_t ObjGeometry::unusedPositions() const {
  return static_cast<std::uint64_t>(std::ranges::count(latest_.span(), false, &Latest::isMade));
}

std::uint32_t ObjGeometry::vertexOf(const ObjCorner &corner) {
  const auto position = resolve(corner.position, positions_.size());
  const auto uv = resolve(corner.uv, uvs_.size());
  if (!position)
    problem_.set("it names the vertex " + std::to_string(corner.position) + ", but " +
                 std::to_string(positions_.size()) + " stand before it");
  if (!position)
    return 0;
  badUvs_ += !uv && corner.uv != 0;
  hasUvs_ = hasUvs_ && uv.has_value();
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
      problem_.check(vertexColours_.push(kNoColour));
    problem_.check(vertexColours_.push(colours_[position]));
  }
  return static_cast<std::uint32_t>(vertex);
}

void ObjGeometry::beginRun(PrimitiveMode mode, std::uint32_t material) {
  const Run run{mode, material, hasUvs_, indices_.size()};
  if (runs_.empty() || runs_.back().kind() != run.kind())
    runs_.push_back(run);
}

void ObjGeometry::addFace() {
  if (vertices_.size() < 3) {
    ++shortFaces_;
    return;
  }
  points_.clear();
  for (const std::uint32_t vertex : vertices_)
    points_.push_back(vertexPositions_[vertex]);
  for (const PolygonCutter::Corners &corners : cutter_.cut(points_))
    addIndices({vertices_[corners[0]], vertices_[corners[1]], vertices_[corners[2]]});
}

void ObjGeometry::addIndices(std::initializer_list<std::uint32_t> vertices) {
  problem_.check(indices_.append({vertices.begin(), vertices.size()}));
}

std::uint64_t ObjGeometry::endOf(std::size_t run) const {
  return run + 1 < runs_.size() ? runs_[run + 1].begin : indices_.size();
}

void ObjGeometry::groupRuns() {
  std::vector<std::size_t> order(runs_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t run) { return runs_[run].kind(); });
  ScratchArray<std::uint32_t> grouped(memory_);
  std::vector<Run> groups;
  for (const std::size_t run : order) {
    const Run &from = runs_[run];
    if (groups.empty() || groups.back().kind() != from.kind())
      groups.push_back({from.mode, from.material, from.hasUvs, grouped.size()});
    problem_.check(grouped.append(indices_.span().subspan(from.begin, endOf(run) - from.begin)));
  }
  runs_ = std::move(groups);
  indices_ = std::move(grouped);
}

/// To what colours count is known when all were seen.
void ObjGeometry::keepColours(MeshPart &part, TriangleScene &scene) {
  // Empty where no face came after the first colour.
  if (vertexColours_.empty() || vertexColours_.size() != part.positions.count)
    return;
  ScratchArray<std::uint32_t> words(memory_);
  const double whole = scale_.whole();
  for (const Colour &colour : vertexColours_.span())
    problem_.check(words.push(packed(colour, whole)));
  part.colours = keep(std::move(words), kColourRows, scene);
}

void ObjGeometry::finish(TriangleScene &scene) {
  if (runs_.size() > kMostRuns)
    groupRuns();
  MeshPart part;
  AttributeView uvs;
  std::vector<std::uint64_t> ends;
  ends.reserve(runs_.size());
  for (std::size_t i = 0; i < runs_.size(); ++i)
    ends.push_back(endOf(i));
  part.positions = keep(std::move(vertexPositions_), kDoubleRows3, scene);
  if (!uvs_.empty())
    uvs = keep(std::move(vertexUvs_), kFloatRows2, scene);
  keepColours(part, scene);
  const AttributeView indices = keep(std::move(indices_), kIndexRows, scene);
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    if (ends[i] == runs_[i].begin)
      continue;
    part.mode = runs_[i].mode;
    part.material = runs_[i].material;
    part.uvs = runs_[i].hasUvs ? uvs : AttributeView();
    part.indices = indices;
    part.indices.data += runs_[i].begin * sizeof(std::uint32_t);
    part.indices.count = ends[i] - runs_[i].begin;
    scene.instances.push_back({static_cast<std::uint32_t>(scene.parts.size()), {}});
    scene.parts.push_back(part);
  }
}

} // namespace voxc
