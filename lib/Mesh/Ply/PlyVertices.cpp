// Names of a vertex's properties, and its attributes.
#include "Mesh/Ply/PlyVertices.h"

#include "Mesh/KeptArray.h"

#include <limits>
#include <utility>

namespace voxc {

namespace {

using UvNames = std::array<std::string_view, 2>;

/// As Blender, MeshLab and others write them.
constexpr std::array<UvNames, 4> kUvNames{
    {{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}}};

constexpr std::uint32_t kOpaque = 0xff000000;

bool needsDouble(PlyType type) {
  return type == PlyType::Float64 || type == PlyType::Int32 || type == PlyType::Uint32;
}

} // namespace

PlyVertices::PlyVertices(const PlyHeader &header, const PlyElement &element,
                         const std::shared_ptr<WorkingMemory> &memory, Problem &problem)
    : element_(element), problem_(problem), colour_(element), positions_(memory), widePositions_(memory),
      uvs_(memory), colours_(memory) {
  position_ = {findNumber(element, "x"), findNumber(element, "y"), findNumber(element, "z")};
  for (const UvNames &names : kUvNames)
    if (!hasUvs() && !header.textures.empty())
      uv_ = {findNumber(element, names[0]), findNumber(element, names[1])};
  // Text has more digits than float32, whatever the header calls its numbers.
  isWide_ = header.encoding == PlyEncoding::Ascii;
  for (const auto &axis : position_)
    isWide_ = isWide_ || (axis && needsDouble(element.properties[*axis].type));
}

std::string PlyVertices::missing() const {
  for (const auto &axis : position_)
    if (!axis)
      return "its vertices need the properties x, y and z";
  return element_.count > std::numeric_limits<std::uint32_t>::max() ? "it has more than 2^32 vertices" : "";
}

void PlyVertices::add(const PlyRow &row) {
  PolygonCutter::Point position;
  for (std::size_t axis = 0; axis < 3; ++axis)
    position[axis] = row.values[*position_[axis]];
  if (isWide_)
    problem_.check(widePositions_.push(position));
  else
    problem_.check(positions_.push(
        {static_cast<float>(position[0]), static_cast<float>(position[1]), static_cast<float>(position[2])}));
  if (colour_) {
    const std::uint32_t word = colour_(row);
    alphas_ |= word & kOpaque;
    problem_.check(colours_.push(word));
  }
  // A .ply counts v from below, the scene from above.
  if (hasUvs())
    problem_.check(
        uvs_.push({static_cast<float>(row.values[*uv_[0]]), static_cast<float>(1 - row.values[*uv_[1]])}));
}

PolygonCutter::Point PlyVertices::positionOf(std::uint64_t vertex) const {
  if (vertex >= count())
    return {};
  if (isWide_)
    return widePositions_[vertex];
  const auto &[x, y, z] = positions_[vertex];
  return {x, y, z};
}

void PlyVertices::keepIn(TriangleScene &scene, MeshPart &part) {
  part.positions = isWide_ ? keep(std::move(widePositions_), kDoubleRows3, scene)
                           : keep(std::move(positions_), kFloatRows3, scene);
  if (areInvisible())
    for (std::uint32_t &word : colours_.span())
      word |= kOpaque;
  part.colours = keep(std::move(colours_), kColourRows, scene);
  part.uvs = keep(std::move(uvs_), kFloatRows2, scene);
}

void PlyVertices::take(PlyUse &use) const {
  for (const auto &axis : position_)
    use.take(element_, axis);
  for (const auto &axis : uv_)
    use.take(element_, hasUvs() ? axis : std::nullopt);
  colour_.take(use);
}

} // namespace voxc
