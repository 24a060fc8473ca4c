// The simple way to voxelize: each voxel of each triangle's box is held against the definition.
#include "Mesh/Solid/Facing.h"
#include "Mesh/Voxelize/MeshModel.h"
#include "Mesh/Voxelize/NearestPoint.h"
#include "Mesh/Voxelize/SurfaceColour.h"
#include "Mesh/Voxelize/VoxelMean.h"
#include "voxc/Source/Sources.h"

#include <algorithm>
#include <unordered_map>
#include <vector>

namespace voxc {

namespace {

__extension__ using Wide = __int128;
using Wide3 = std::array<Wide, 3>;

/// Triangles between two looks at the progress.
constexpr std::uint64_t kProgressStep = 1024;

Wide dot(const Wide3 &a, const Wide3 &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Wide3 cross(const Wide3 &a, const Wide3 &b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Wide3 difference(const Point64 &a, const Point64 &b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

/// A direction along which a triangle and a box with the axes of space may be apart, and from where to where
/// the triangle reaches along it.
struct SeparatingAxis {
  Wide3 direction;
  Wide low;
  Wide high;
};

/// All such directions.
std::vector<SeparatingAxis> separatingAxes(const SnappedTriangle &triangle) {
  const std::array<Wide3, 3> units{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const auto &[a, b, c] = triangle.corners;
  std::vector<SeparatingAxis> axes;
  const auto add = [&](const Wide3 &direction) {
    const std::array<Wide, 3> shadows{dot(direction, difference(a, {})), dot(direction, difference(b, {})),
                                      dot(direction, difference(c, {}))};
    const auto [low, high] = std::minmax_element(shadows.begin(), shadows.end());
    axes.push_back({direction, *low, *high});
  };
  for (const Wide3 &unit : units)
    add(unit);
  add(cross(difference(b, a), difference(c, a)));
  for (const Wide3 &edge : {difference(b, a), difference(c, b), difference(a, c)})
    for (const Wide3 &unit : units)
      add(cross(edge, unit));
  return axes;
}

/// Have the triangle of these axes and the closed box a point in common?
bool touches(const std::vector<SeparatingAxis> &axes, const Point64 &centre, const Point64 &half) {
  return std::ranges::all_of(axes, [&](const SeparatingAxis &axis) {
    const Wide3 &direction = axis.direction;
    Wide reach = 0;
    for (std::size_t i = 0; i < 3; ++i)
      reach += (direction[i] < 0 ? -direction[i] : direction[i]) * half[i];
    const Wide shadow = dot(direction, difference(centre, {}));
    return axis.low - shadow <= reach && shadow - axis.high <= reach;
  });
}

class Reference {
public:
  Reference(const TriangleScene &scene, const MeshModel &model, const SceneMeans &means, Coverage coverage,
            Facing facing)
      : model_(model), cursor_(scene, model.numbers), colour_(scene, means),
        side_(std::int64_t{1} << model.grid.bits()), isInner_(coverage == Coverage::Inner), facing_(facing) {
    const std::int64_t half = side_ / 2;
    cube_ = {half, half, half};
    if (coverage != Coverage::Thin && coverage != Coverage::Inner)
      boxes_ = {cube_};
    else
      boxes_ = {{half, 0, 0}, {0, half, 0}, {0, 0, half}};
  }

  void add(std::uint32_t number) {
    cursor_.moveTo(number);
    const std::array<glm::dvec3, 3> modelCorners = cursor_.corners();
    if (cursor_.isCollapsed(modelCorners))
      return;
    colour_.moveTo(cursor_);
    const SnappedTriangle triangle = model_.snapped(modelCorners);
    const std::vector<SeparatingAxis> axes = separatingAxes(triangle);
    corners_ = model_.inVoxels(triangle);
    const NearestPoints nearest(corners_);
    isFiner_ = colour_.measure(nearest);
    const auto [low, high] = voxelsOf(triangle);
    for (Int3 voxel = low; voxel.z <= high.z; ++voxel.z)
      for (voxel.y = low.y; voxel.y <= high.y; ++voxel.y)
        for (voxel.x = low.x; voxel.x <= high.x; ++voxel.x)
          if (isTaken(triangle, axes, voxel))
            propose(voxel, nearest);
  }

  /// The voxels in Morton order; none remains.
  std::vector<CodedVoxel> take() {
    std::vector<CodedVoxel> voxels;
    voxels.reserve(voxels_.size());
    for (const auto &[code, voxel] : voxels_)
      voxels.push_back({code, voxel.word});
    voxels_.clear();
    std::sort(voxels.begin(), voxels.end(),
              [](const CodedVoxel &a, const CodedVoxel &b) { return a.code < b.code; });
    return voxels;
  }

private:
  /// The first and the last voxel that the triangle's box may touch, on each axis.
  std::pair<Int3, Int3> voxelsOf(const SnappedTriangle &triangle) const {
    const Int3 extent = model_.extent();
    Int3 low;
    Int3 high;
    for (int axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      const std::int64_t last = extent[axis] - 1;
      // Division cuts towards 0, where the volume begins: a voxel more on each side makes up for it.
      low[axis] = static_cast<int>(std::clamp<std::int64_t>(triangle.low(i) / side_ - 1, 0, last + 1));
      high[axis] = static_cast<int>(std::clamp<std::int64_t>(triangle.high(i) / side_ + 1, -1, last));
    }
    return {low, high};
  }

  bool isTaken(const SnappedTriangle &triangle, const std::vector<SeparatingAxis> &axes, Int3 voxel) const {
    Point64 centre;
    for (int axis = 0; axis < 3; ++axis)
      centre[static_cast<std::size_t>(axis)] = voxel[axis] * side_ + side_ / 2;
    if (cursor_.part().isThin()) // The same by every rule.
      return touches(axes, centre, cube_);
    for (std::size_t box = 0; box < boxes_.size(); ++box)
      if (touches(axes, centre, boxes_[box]) && (!isInner_ || !isLeftOut(triangle, axes, box, voxel, centre)))
        return true;
    return false;
  }

  /// By the rule `Inner`: is the segment along an axis, which the triangle meets, met in an end that belongs
  /// to the next voxel, or not to be looked at?
  bool isLeftOut(const SnappedTriangle &triangle, const std::vector<SeparatingAxis> &axes, std::size_t axis,
                 Int3 voxel, const Point64 &centre) const {
    const Wide3 &normal = axes[3].direction;
    const bool isThin = normal == Wide3{};
    const Point64 low{triangle.low(0), triangle.low(1), triangle.low(2)};
    Point64 beyond{triangle.high(0), triangle.high(1), triangle.high(2)};
    beyond[axis] = low[axis];
    const bool isAlong = isThin && beyond == low && triangle.high(axis) != low[axis];
    if (isAlong || (!isThin && normal[axis] == 0))
      return true;
    const bool isSided = !isThin && facing_ != Facing::Unknown;
    bool isAtHigh = true;
    if (isSided)
      isAtHigh = (normal[axis] < 0) == ((facing_ == Facing::Outwards) != cursor_.isMirrored());
    else if (voxel[static_cast<int>(axis)] == model_.extent()[static_cast<int>(axis)] - 1)
      return false;
    Point64 end = centre;
    end[axis] += isAtHigh ? side_ / 2 : -side_ / 2;
    return touches(axes, end, Point64{});
  }

  void propose(Int3 voxel, const NearestPoints &nearest) {
    const NearestPoint point = nearest.to({voxel.x + 0.5, voxel.y + 0.5, voxel.z + 0.5});
    colour_.at({&point.weights, 1}, words_);
    if (words_[0] == 0)
      return;
    const std::uint32_t distance = comparedDistance(point.distanceSquared);
    Shown &shown = voxels_[mortonCode(voxel)];
    const bool isNearer = distance < shown.distance;
    if (isFiner_)
      shown.word =
          shown.mean.add({cursor_.part().material, nearest.normal()}, isNearer,
                         VoxelAreas(corners_, nearest).in({voxel.x, voxel.y, voxel.z}, point.weights),
                         words_[0], shown.word);
    else if (isNearer)
      shown = {distance, words_[0], {}};
    shown.distance = std::min(shown.distance, distance);
  }

  /// What a voxel shows of the triangles so far.
  struct Shown {
    std::uint32_t distance = ~std::uint32_t{0};
    std::uint32_t word = 0;
    VoxelMean mean;
  };

  const MeshModel &model_;
  TriangleCursor cursor_;
  SurfaceColour colour_;
  std::int64_t side_; ///< Of a voxel, in steps of the grid.
  Point64 cube_;
  std::vector<Point64> boxes_;
  bool isInner_;
  Facing facing_;
  std::array<glm::dvec3, 3> corners_{}; ///< Of the triangle in work, in voxels.
  bool isFiner_ = false;                ///< Its texels are finer than voxels.
  std::vector<std::uint32_t> words_;    ///< Of the voxel in work.
  std::unordered_map<std::uint64_t, Shown> voxels_;
};

} // namespace

Expected<std::unique_ptr<VoxelSource>> makeReferenceMeshSource(const TriangleScene &scene,
                                                               const VoxelizeOptions &options) {
  const auto model = VOXC_TRY(MeshModel::open(scene, options, nullptr));
  SceneMeans means;
  if (options.colour == ColourRule::Mean)
    means = VOXC_TRY(SceneMeans::of(scene, WorkingMemory::createDefault(), options.progress));
  Facing facing = Facing::Unknown;
  if (options.coverage == Coverage::Inner)
    facing = VOXC_TRY(facingOf(scene, model, WorkingMemory::createDefault(), options.progress));
  Reference reference(scene, model, means, options.coverage, facing);
  const std::uint64_t count = model.numbers.size();
  for (std::uint64_t number = 0; number < count; ++number) {
    if (number % kProgressStep == 0) {
      VOXC_TRY(options.progress.check());
      options.progress.at("voxelize", static_cast<double>(number) / static_cast<double>(count));
    }
    reference.add(static_cast<std::uint32_t>(number));
  }
  return makeSortedSource(model.extent(), reference.take(), model.grid.frame().voxelToModel());
}

} // namespace voxc
