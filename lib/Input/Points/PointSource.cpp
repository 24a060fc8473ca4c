// Points of PLY files: voxel indices, or coordinates of a model.
#include "Input/Points/PointSource.h"

#include "Input/Openers/InputText.h"
#include "Input/Points/PointList.h"
#include "Mesh/ModelFrame.h"
#include "Source/BinnedVoxels.h"
#include "Source/GridExtent.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

namespace voxc {

namespace {

using Position = std::array<double, 3>;

bool isInside(const Position &index, Int3 extent) {
  return index[0] >= 0 && index[1] >= 0 && index[2] >= 0 && index[0] < extent.x && index[1] < extent.y &&
         index[2] < extent.z;
}

std::string listed(const Position &index) {
  const auto text = [](double v) { return std::to_string(static_cast<std::int64_t>(v)); };
  return text(index[0]) + ", " + text(index[1]) + ", " + text(index[2]);
}

Int3 cellAt(const Position &position) {
  return {static_cast<int>(position[0]), static_cast<int>(position[1]), static_cast<int>(position[2])};
}

glm::dvec3 vectorOf(const Position &position) { return {position[0], position[1], position[2]}; }

/// The voxel of a position if that lies in the closed box. The model's numbers say so, and not those of
/// voxels, whose rounding could put a point on a face outside: it belongs to the voxel there.
std::optional<Int3> voxelAt(const glm::dvec3 &position, const Bounds &box, const ModelFrame &frame) {
  if (!glm::all(glm::greaterThanEqual(position, box.low)) ||
      !glm::all(glm::lessThanEqual(position, box.high)))
    return std::nullopt;
  const glm::dvec3 place = frame.toVoxels(position);
  Int3 voxel;
  for (int axis = 0; axis < 3; ++axis)
    voxel[axis] = std::clamp(static_cast<int>(place[axis]), 0, frame.extent()[axis] - 1);
  return voxel;
}

/// Goes through the points of a file as often as it takes to know their box, to count them and to place them.
class PointPlacer {
public:
  using Broken = std::function<Error(const std::string &)>;

  PointPlacer(const PointList &points, const InputOptions &options, const Broken &broken)
      : points_(points), options_(options), broken_(broken) {}

  std::uint64_t dropped() const { return dropped_; }

  Expected<std::unique_ptr<VoxelSource>> placeIndices() {
    Int3 extent{1, 1, 1};
    std::optional<Error> problem;
    auto passed = pass([&](const PlyPoint &point, std::uint64_t number) {
      if (!isInside(point.position, options_.mostExtent())) {
        const bool isBelow = std::ranges::min(point.position) < 0;
        problem = broken_("point " + std::to_string(number) + " is the voxel " + listed(point.position) +
                          (isBelow ? ", but whole numbers are voxels from 0 on; move the points, or declare "
                                     "their coordinates as float"
                                   : ", but the format holds only " + extentText(options_.mostExtent())));
        return false;
      }
      const Int3 voxel = cellAt(point.position);
      for (int axis = 0; axis < 3; ++axis)
        extent[axis] = std::max(extent[axis], voxel[axis] + 1);
      return true;
    });
    if (!passed)
      return passed.error();
    if (problem)
      return *problem;
    return place(extent, {}, [](const Position &position) { return std::optional(cellAt(position)); });
  }

  Expected<std::unique_ptr<VoxelSource>> placePositions() {
    BoundsBuilder bounds;
    std::optional<Error> problem;
    auto passed = pass([&](const PlyPoint &point, std::uint64_t number) {
      const glm::dvec3 position = vectorOf(point.position);
      if (glm::any(glm::isnan(position)) || glm::any(glm::isinf(position))) {
        problem = broken_("point " + std::to_string(number) + " has a coordinate that is not finite");
        return false;
      }
      bounds.add(position);
      return true;
    });
    if (!passed)
      return passed.error();
    if (problem)
      return *problem;
    const Bounds box = chosen(bounds.bounds().value_or(Bounds{}));
    const auto side = VOXC_TRY(voxelSide(options_, 0));
    FrameOptions choice{box, options_.resolution, modelExtent(options_), options_.zUp, side, {}};
    if (options_.align)
      choice.align = glm::dvec3((*options_.align)[0], (*options_.align)[1], (*options_.align)[2]);
    const auto frame = VOXC_TRY(ModelFrame::fit(choice));
    return place(frame.extent(), frame.voxelToModel(),
                 [&](const Position &position) { return voxelAt(vectorOf(position), box, frame); });
  }

private:
  /// Calls `visit(point, number)` for all points that have a colour, until it returns false.
  template <typename Visit> Expected<void> pass(Visit visit) {
    constexpr std::uint64_t kBatch = 1 << 10;
    std::array<PlyPoint, kBatch> batch;
    dropped_ = 0;
    for (std::uint64_t first = 0; first < points_.size(); first += kBatch) {
      VOXC_TRY(options_.progress.check());
      options_.memory->relieve();
      const std::span<PlyPoint> points = std::span(batch).first(std::min(kBatch, points_.size() - first));
      points_.read(first, points);
      for (std::uint64_t i = 0; i < points.size(); ++i) {
        if (points[i].word == 0)
          ++dropped_;
        else if (!visit(points[i], first + i))
          return {};
      }
    }
    return {};
  }

  /// Sorts the points into their chunks; `voxelOf` may say that one has no voxel.
  template <typename VoxelOf>
  Expected<std::unique_ptr<VoxelSource>> place(Int3 extent, const Transform &voxelToModel, VoxelOf voxelOf) {
    auto voxels = VOXC_TRY(BinnedVoxels::create(extent, options_.memory));
    const auto count = [&](const PlyPoint &point, std::uint64_t) {
      if (const std::optional<Int3> voxel = voxelOf(point.position))
        voxels.count(*voxel);
      return true;
    };
    const auto add = [&](const PlyPoint &point, std::uint64_t) {
      if (const std::optional<Int3> voxel = voxelOf(point.position))
        voxels.place(*voxel, point.word);
      return true;
    };
    VOXC_TRY(pass(count));
    VOXC_TRY(voxels.allocate());
    VOXC_TRY(pass(add));
    return std::move(voxels).finish(voxelToModel);
  }

  Bounds chosen(const Bounds &found) const {
    if (!options_.bounds)
      return found;
    const std::array<double, 6> &b = *options_.bounds;
    return {{b[0], b[1], b[2]}, {b[3], b[4], b[5]}};
  }

  const PointList &points_;
  const InputOptions &options_;
  const Broken &broken_;
  std::uint64_t dropped_ = 0;
};

InputFact boxOf(const PointList &points) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Position low{kFar, kFar, kFar}, high{-kFar, -kFar, -kFar};
  std::array<PlyPoint, 1 << 10> batch;
  for (std::uint64_t first = 0; first < points.size(); first += batch.size()) {
    const std::uint64_t count = std::min<std::uint64_t>(batch.size(), points.size() - first);
    const std::span<PlyPoint> some = std::span(batch).first(count);
    points.read(first, some);
    for (const PlyPoint &point : some)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], point.position[axis]);
        high[axis] = std::max(high[axis], point.position[axis]);
      }
  }
  return boxFact("box", low, high);
}

} // namespace

Expected<PointVoxels> placePoints(const PointList &points, bool areIndices, const InputOptions &options,
                                  const std::function<Error(const std::string &)> &broken) {
  if (options.coverage != Coverage::Conservative)
    return Error::usage("--coverage is for meshes, and would do nothing for points; leave it out");
  if (options.colour != ColourRule::Mean)
    return Error::usage("--colour is for meshes, and would do nothing for points; leave it out");
  if (areIndices && (options.voxelSize.value > 0 || options.align))
    return Error::usage(
        "--voxel-size and --align would do nothing for points whose coordinates are voxels; leave them out");
  PointPlacer placer(points, options, broken);
  auto source = VOXC_TRY(areIndices ? placer.placeIndices() : placer.placePositions());
  PointVoxels voxels{std::move(source), areIndices, {}, {}};
  if (options.describe)
    voxels.facts = {countFact("points", points.size()),
                    {"coordinates", areIndices ? "whole numbers, which are voxels" : "of a model", {}},
                    {"colours", points.hasColours() ? "one a point" : "none; they are white", {}},
                    boxOf(points)};
  if (placer.dropped() != 0)
    voxels.warnings.push_back(points.saysDropped(placer.dropped()));
  return voxels;
}

Expected<PointVoxels> readPoints(PlyReader &reader, const InputOptions &options) {
  if (const PlyElement *vertices = reader.header().find("vertex");
      vertices && vertices->find("packed_position"))
    return reader.broken("it holds compressed Gaussian splats, which are not read; save it as a plain .ply");
  if (!hasPoints(reader.header()))
    return reader.broken("its points need an element 'vertex' with the properties x, y and z");
  options.memory->watch(reader.bytes());
  const auto points = readPointList(reader, options.memory, options.progress);
  auto voxels = points ? placePoints(**points, areIndices(reader.header()), options,
                                     [&](const std::string &what) { return reader.broken(what); })
                       : Expected<PointVoxels>(points.error());
  options.memory->unwatch(reader.bytes());
  if (voxels && points)
    for (const std::string &warning : (*points)->warnings())
      voxels->warnings.push_back(warning);
  return voxels;
}

} // namespace voxc
