// Points of PLY files: voxel indices, or coordinates of a model.
#include "Source/PointSource.h"

#include "Mesh/ModelFrame.h"
#include "Source/BinnedVoxels.h"
#include "Source/GridExtent.h"
#include "Source/PointRows.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace voxc {

namespace {

struct Point {
  Float3 position;
  std::uint32_t word;
};

/// A voxel index.
struct IndexPoint {
  Int3 voxel;
  std::uint32_t word;
};

bool isInside(const std::array<double, 3> &index, Int3 extent) {
  return index[0] >= 0 && index[1] >= 0 && index[2] >= 0 && index[0] < extent.x && index[1] < extent.y &&
         index[2] < extent.z;
}

std::string listed(const std::array<double, 3> &index) {
  const auto text = [](double v) { return std::to_string(static_cast<std::int64_t>(v)); };
  return text(index[0]) + ", " + text(index[1]) + ", " + text(index[2]);
}

/// Reads the points of a file into memory, and makes a source of them.
class PointReader {
public:
  PointReader(PlyReader &reader, PointRows &rows, const InputOptions &options)
      : reader_(reader), rows_(rows), options_(options) {}

  std::uint64_t dropped() const { return dropped_; }

  Expected<std::unique_ptr<VoxelSource>> readIndices() {
    ScratchArray<IndexPoint> points(options_.memory);
    Int3 extent{1, 1, 1};
    auto read = rows_.read(
        [&](const PointRow &row) -> Expected<void> {
          if (isDropped(row))
            return {};
          if (!isInside(row.position, options_.formatExtent))
            return reader_.broken("vertex " + std::to_string(row.number) + " is the voxel " +
                                  listed(row.position) + ", but the format holds only " +
                                  toText(options_.formatExtent));
          const IndexPoint point{{static_cast<int>(row.position[0]), static_cast<int>(row.position[1]),
                                  static_cast<int>(row.position[2])},
                                 row.word};
          for (int axis = 0; axis < 3; ++axis)
            extent[axis] = std::max(extent[axis], point.voxel[axis] + 1);
          return points.push(point);
        },
        *options_.memory, options_.progress);
    if (!read)
      return read.error();
    return place(points, extent, {}, [](const IndexPoint &point) { return std::optional(point.voxel); });
  }

  Expected<std::unique_ptr<VoxelSource>> readPositions() {
    ScratchArray<Point> points(options_.memory);
    BoundsBuilder bounds;
    auto read = rows_.read(
        [&](const PointRow &row) -> Expected<void> {
          if (isDropped(row))
            return {};
          Point point{{}, row.word};
          for (std::size_t axis = 0; axis < 3; ++axis) {
            point.position[axis] = static_cast<float>(row.position[axis]);
            if (!std::isfinite(point.position[axis]))
              return reader_.broken("vertex " + std::to_string(row.number) +
                                    " has a coordinate that is not finite");
          }
          bounds.add(point.position);
          return points.push(point);
        },
        *options_.memory, options_.progress);
    if (!read)
      return read.error();
    const auto frame = ModelFrame::fit({chosen(bounds.bounds().value_or(Bounds{})), options_.resolution,
                                        options_.formatExtent, options_.zUp});
    if (!frame)
      return frame.error();
    return place(points, frame->extent(), frame->voxelToModel(), [&](const Point &point) {
      return voxelAt(frame->toVoxels(point.position), frame->extent());
    });
  }

private:
  bool isDropped(const PointRow &row) {
    dropped_ += row.word == 0;
    return row.word == 0;
  }

  Bounds chosen(const Bounds &found) const {
    if (!options_.bounds)
      return found;
    const std::array<double, 6> &b = *options_.bounds;
    return {{b[0], b[1], b[2]}, {b[3], b[4], b[5]}};
  }

  /// The voxel of a position within the frame; one on its far face belongs to the last voxel.
  static std::optional<Int3> voxelAt(const Double3 &position, Int3 extent) {
    Int3 voxel;
    for (int axis = 0; axis < 3; ++axis) {
      const double coordinate = position[static_cast<std::size_t>(axis)];
      if (!(coordinate >= 0 && coordinate <= extent[axis]))
        return std::nullopt;
      voxel[axis] = std::min(static_cast<int>(coordinate), extent[axis] - 1);
    }
    return voxel;
  }

  /// Sorts points into their chunks; `voxelOf` may say that one has no voxel.
  template <typename Stored, typename VoxelOf>
  Expected<std::unique_ptr<VoxelSource>> place(const ScratchArray<Stored> &points, Int3 extent,
                                               const Transform &voxelToModel, VoxelOf voxelOf) {
    auto voxels = BinnedVoxels::create(extent, options_.memory);
    if (!voxels)
      return voxels.error();
    for (const Stored &point : points.span())
      if (const std::optional<Int3> voxel = voxelOf(point))
        voxels->count(*voxel);
    if (auto allocated = voxels->allocate(); !allocated)
      return allocated.error();
    for (const Stored &point : points.span())
      if (const std::optional<Int3> voxel = voxelOf(point))
        voxels->place(*voxel, point.word);
    return std::move(*voxels).finish(voxelToModel);
  }

  PlyReader &reader_;
  PointRows &rows_;
  const InputOptions &options_;
  std::uint64_t dropped_ = 0;
};

} // namespace

Expected<PointVoxels> readPoints(PlyReader &reader, const InputOptions &options) {
  PointRows rows(reader);
  if (!rows.hasPositions())
    return reader.broken("its points need an element 'vertex' with the properties x, y and z");
  PointReader points(reader, rows, options);
  auto source = rows.areIndices() ? points.readIndices() : points.readPositions();
  if (!source)
    return source.error();
  PointVoxels voxels{std::move(*source), rows.areIndices(), {}};
  if (points.dropped() != 0)
    voxels.warnings.push_back(std::to_string(points.dropped()) +
                              " points are dropped: their colour is the word 0, which means empty");
  return voxels;
}

} // namespace voxc
