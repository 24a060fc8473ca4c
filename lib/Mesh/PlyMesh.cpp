// Vertices and faces of PLY files.
#include "Mesh/PlyMesh.h"

#include "Mesh/Ply/PlyColour.h"

#include <utility>

namespace voxc {

namespace {

const PlyElement kNoElement;

class MeshBuilder {
public:
  explicit MeshBuilder(const PlyHeader &header)
      : vertices_(header.find("vertex") ? *header.find("vertex") : kNoElement),
        faces_(header.find("face") ? *header.find("face") : kNoElement), colour_(vertices_) {
    position_ = {vertices_.find("x"), vertices_.find("y"), vertices_.find("z")};
    corners_ = faces_.find("vertex_indices");
    if (!corners_)
      corners_ = faces_.find("vertex_index");
  }

  /// What the header lacks, or nothing.
  std::string missing() const {
    if (!position_[0] || !position_[1] || !position_[2])
      return "its vertices need the properties x, y and z";
    if (!corners_ || !faces_.properties[*corners_].countType)
      return "its faces need the list vertex_indices";
    return {};
  }

  /// Adds a row; the answer says what is wrong with it, if anything.
  std::string add(const PlyElement &element, std::uint64_t index, const PlyRow &row) {
    if (&element == &vertices_)
      addVertex(row);
    else if (&element == &faces_)
      return addFace(index, row.lists[*corners_]);
    return {};
  }

  TriangleMesh take() {
    mesh_.materials.emplace_back();
    return std::move(mesh_);
  }

private:
  void addVertex(const PlyRow &row) {
    Float3 position;
    for (std::size_t axis = 0; axis < 3; ++axis)
      position[axis] = static_cast<float>(row.values[*position_[axis]]);
    mesh_.positions.push_back(position);
    if (colour_)
      mesh_.colours.push_back(colour_(row));
  }

  std::string addFace(std::uint64_t index, const std::vector<double> &corners) {
    for (double corner : corners)
      if (!(corner >= 0 && corner < static_cast<double>(vertices_.count)))
        return "face " + std::to_string(index) + " names vertex " +
               std::to_string(static_cast<std::int64_t>(corner)) + ", but there are " +
               std::to_string(vertices_.count);
    const auto vertex = [&](std::size_t i) { return static_cast<std::uint32_t>(corners[i]); };
    for (std::size_t i = 2; i < corners.size(); ++i)
      mesh_.triangles.push_back({{vertex(0), vertex(i - 1), vertex(i)}, 0});
    return {};
  }

  const PlyElement &vertices_;
  const PlyElement &faces_;
  PlyColour colour_;
  std::array<std::optional<std::size_t>, 3> position_;
  std::optional<std::size_t> corners_;
  TriangleMesh mesh_;
};

} // namespace

Expected<TriangleMesh> readPlyMesh(PlyReader &reader) {
  if (reader.header().find("tristrips"))
    return reader.broken("it holds triangle strips; store faces instead");
  MeshBuilder builder(reader.header());
  if (std::string missing = builder.missing(); !missing.empty())
    return reader.broken(missing);
  auto read = reader.readRows(
      [&](const PlyElement &element, std::uint64_t index, const PlyRow &row) -> Expected<void> {
        if (std::string wrong = builder.add(element, index, row); !wrong.empty())
          return reader.broken(wrong);
        return {};
      });
  if (!read)
    return read.error();
  return builder.take();
}

} // namespace voxc
