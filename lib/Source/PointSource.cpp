// Points of PLY files: voxel indices, or coordinates of a model.
#include "Source/PointSource.h"

#include "Mesh/ModelFrame.h"
#include "Mesh/Ply/PlyColour.h"
#include "voxc/Source/Sources.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace voxc {

namespace {

struct Point {
  Float3 position;
  std::uint32_t word;
};

/// The rows of the element `vertex` that have a colour, one after the other.
class VertexRows {
public:
  using Visit =
      std::function<Expected<void>(const Double3 &position, std::uint64_t index, std::uint32_t word)>;

  explicit VertexRows(PlyReader &reader)
      : reader_(reader), vertices_(reader.header().find("vertex")),
        colour_(vertices_ ? *vertices_ : PlyElement()) {
    for (std::size_t axis = 0; vertices_ && axis < 3; ++axis)
      axes_[axis] = vertices_->find(kAxes[axis]);
  }

  bool hasPositions() const { return axes_[0] && axes_[1] && axes_[2]; }
  bool areIndices() const {
    return std::all_of(axes_.begin(), axes_.end(),
                       [&](const auto &axis) { return isInteger(vertices_->properties[*axis].type); });
  }
  std::uint64_t dropped() const { return dropped_; }

  Expected<void> read(const Visit &visit) {
    return reader_.readRows(
        [&](const PlyElement &element, std::uint64_t index, const PlyRow &row) -> Expected<void> {
          if (&element != vertices_)
            return {};
          const std::uint32_t word = colour_(row);
          if (word == 0) {
            ++dropped_;
            return {};
          }
          return visit({row.values[*axes_[0]], row.values[*axes_[1]], row.values[*axes_[2]]}, index, word);
        });
  }

private:
  static constexpr std::array<std::string_view, 3> kAxes{"x", "y", "z"};

  PlyReader &reader_;
  const PlyElement *vertices_;
  PlyColour colour_;
  std::array<std::optional<std::size_t>, 3> axes_;
  std::uint64_t dropped_ = 0;
};

/// Sorts, and keeps the first voxel of each code.
void sortAndUnite(std::vector<CodedVoxel> &voxels) {
  std::stable_sort(voxels.begin(), voxels.end(),
                   [](const CodedVoxel &a, const CodedVoxel &b) { return a.code < b.code; });
  const auto same = [](const CodedVoxel &a, const CodedVoxel &b) { return a.code == b.code; };
  voxels.erase(std::unique(voxels.begin(), voxels.end(), same), voxels.end());
}

bool isInside(const Double3 &index, Int3 extent) {
  return index[0] >= 0 && index[1] >= 0 && index[2] >= 0 && index[0] < extent.x && index[1] < extent.y &&
         index[2] < extent.z;
}

std::string toText(const Double3 &index) {
  const auto text = [](double v) { return std::to_string(static_cast<std::int64_t>(v)); };
  return text(index[0]) + ", " + text(index[1]) + ", " + text(index[2]);
}

Expected<std::unique_ptr<VoxelSource>> readIndices(VertexRows &rows, const PlyReader &reader, Int3 holds) {
  std::vector<CodedVoxel> voxels;
  Int3 extent{1, 1, 1};
  auto read = rows.read([&](const Double3 &index, std::uint64_t row, std::uint32_t word) -> Expected<void> {
    if (!isInside(index, holds))
      return reader.broken("vertex " + std::to_string(row) + " is the voxel " + toText(index) +
                           ", but the format holds only " + std::to_string(holds.x) + "x" +
                           std::to_string(holds.y) + "x" + std::to_string(holds.z));
    const Int3 voxel{static_cast<int>(index[0]), static_cast<int>(index[1]), static_cast<int>(index[2])};
    for (int axis = 0; axis < 3; ++axis)
      extent[axis] = std::max(extent[axis], voxel[axis] + 1);
    voxels.push_back({mortonCode(voxel), word});
    return {};
  });
  if (!read)
    return read.error();
  sortAndUnite(voxels);
  return makeSortedSource(extent, std::move(voxels));
}

Expected<std::vector<Point>> readPositions(VertexRows &rows, const PlyReader &reader) {
  std::vector<Point> points;
  auto read =
      rows.read([&](const Double3 &position, std::uint64_t row, std::uint32_t word) -> Expected<void> {
        Point point{{}, word};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          point.position[axis] = static_cast<float>(position[axis]);
          if (!std::isfinite(point.position[axis]))
            return reader.broken("vertex " + std::to_string(row) + " has a coordinate that is not finite");
        }
        points.push_back(point);
        return {};
      });
  if (!read)
    return read.error();
  return points;
}

Bounds boundsOf(const std::vector<Point> &points, const InputOptions &options) {
  if (options.bounds) {
    const std::array<double, 6> &b = *options.bounds;
    return {{b[0], b[1], b[2]}, {b[3], b[4], b[5]}};
  }
  BoundsBuilder builder;
  for (const Point &point : points)
    builder.add(point.position);
  return builder.bounds().value_or(Bounds{});
}

/// The voxel of a position within the frame; one on its far face belongs to the last voxel.
std::optional<Int3> voxelAt(const Double3 &position, Int3 extent) {
  Int3 voxel;
  for (int axis = 0; axis < 3; ++axis) {
    const double coordinate = position[static_cast<std::size_t>(axis)];
    if (!(coordinate >= 0 && coordinate <= extent[axis]))
      return std::nullopt;
    voxel[axis] = std::min(static_cast<int>(coordinate), extent[axis] - 1);
  }
  return voxel;
}

Expected<std::unique_ptr<VoxelSource>> voxelizePoints(VertexRows &rows, const PlyReader &reader,
                                                      const InputOptions &options) {
  const auto points = readPositions(rows, reader);
  if (!points)
    return points.error();
  const auto frame =
      ModelFrame::fit({boundsOf(*points, options), options.resolution, options.formatExtent, options.zUp});
  if (!frame)
    return frame.error();
  std::vector<CodedVoxel> voxels;
  for (const Point &point : *points)
    if (const auto voxel = voxelAt(frame->toVoxels(point.position), frame->extent()))
      voxels.push_back({mortonCode(*voxel), point.word});
  sortAndUnite(voxels);
  return makeSortedSource(frame->extent(), std::move(voxels), frame->voxelToModel());
}

} // namespace

Expected<PointVoxels> readPoints(PlyReader &reader, const InputOptions &options) {
  VertexRows rows(reader);
  if (!rows.hasPositions())
    return reader.broken("its points need an element 'vertex' with the properties x, y and z");
  PointVoxels points;
  points.areIndices = rows.areIndices();
  auto source = points.areIndices ? readIndices(rows, reader, options.formatExtent)
                                  : voxelizePoints(rows, reader, options);
  if (!source)
    return source.error();
  points.source = std::move(*source);
  if (rows.dropped() != 0)
    points.warnings.push_back(std::to_string(rows.dropped()) +
                              " points are dropped: their colour is the word 0, which means empty");
  return points;
}

} // namespace voxc
