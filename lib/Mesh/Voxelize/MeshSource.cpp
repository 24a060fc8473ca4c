// The voxels of a scene, made chunk by chunk when they are asked for.
#include "Mesh/Voxelize/ChunkVoxels.h"
#include "Mesh/Voxelize/MeshVoxels.h"
#include "Mesh/Voxelize/NearestPoint.h"
#include "Mesh/Voxelize/SurfaceColour.h"
#include "Source/CubeTools.h"

#include <ctime>
#include <span>
#include <utility>
#include <vector>

namespace voxc {

namespace {

/// Triangles between two looks at memory and at whether to stop.
constexpr std::size_t kStep = 64;

/// Stands for no chunk and no cube.
constexpr Int3 kNowhere{-1, -1, -1};

/// Adds the time that this thread computes while it lives.
class ThreadTimer {
public:
  explicit ThreadTimer(std::atomic<std::uint64_t> &nanoseconds) : nanoseconds_(nanoseconds), begin_(now()) {}
  ~ThreadTimer() { nanoseconds_.fetch_add(now() - begin_, std::memory_order_relaxed); }
  ThreadTimer(const ThreadTimer &) = delete;
  ThreadTimer &operator=(const ThreadTimer &) = delete;

private:
  static std::uint64_t now() {
    timespec time{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<std::uint64_t>(time.tv_sec) * 1'000'000'000 + static_cast<std::uint64_t>(time.tv_nsec);
  }

  std::atomic<std::uint64_t> &nanoseconds_;
  std::uint64_t begin_;
};

/// One reader: it holds the chunk asked for last, and where bins are larger than chunks, the triangles of the
/// cubes around it.
class MeshSource final : public VoxelSource {
public:
  explicit MeshSource(std::shared_ptr<const MeshVoxels> mesh)
      : mesh_(std::move(mesh)), cursor_(*mesh_->scene, mesh_->model.numbers),
        colour_(*mesh_->scene, mesh_->means), voxels_(mesh_->log2Chunk) {
    for (int log2Side = mesh_->log2Chunk; log2Side < mesh_->bins.log2Chunk(); ++log2Side)
      lists_.push_back({kNowhere, ScratchArray<std::uint32_t>(mesh_->memory)});
  }

  Int3 extent() const override { return mesh_->model.extent(); }
  int log2Chunk() const override { return mesh_->log2Chunk; }
  double readSeconds() const override { return 1e-9 * static_cast<double>(mesh_->nanoseconds); }
  Transform voxelToModel() const override { return mesh_->model.grid.frame().voxelToModel(); }
  std::uint64_t records(const Cube &cube) const override {
    const int missing = std::max(mesh_->bins.log2Chunk() - cube.log2Side, 0);
    const Cube bin = {cube.low, cube.log2Side + missing};
    return isOutside(cube, extent()) ? 0 : mesh_->bins.sizeOf(bin) >> 3 * missing;
  }
  std::unique_ptr<VoxelSource> view() const override { return std::make_unique<MeshSource>(mesh_); }

  bool empty(const Cube &cube) override {
    if (isOutside(cube, extent()))
      return true;
    if (cube.log2Side >= mesh_->bins.log2Chunk())
      return mesh_->bins.empty(cube);
    if (cube.log2Side >= mesh_->log2Chunk)
      return hasNone(trianglesOf(cube.low >> cube.log2Side, cube.log2Side));
    return moveTo(cube.low) && voxels_.empty(cube);
  }

  Expected<void> read(const Cube &cube, std::uint32_t *words) override {
    if (isOutside(cube, extent())) {
      std::fill_n(words, cellCount(cube.log2Side), 0u);
      return {};
    }
    VOXC_TRY(moveTo(cube.low));
    voxels_.read(cube, words);
    return {};
  }

private:
  using Triangles = Expected<std::span<const std::uint32_t>>;
  static bool hasNone(const Triangles &triangles) { return triangles && triangles->empty(); }

  /// The triangles of a cube of a size below the bins'.
  struct List {
    Int3 cube; ///< In cubes of this size, or kNowhere.
    ScratchArray<std::uint32_t> triangles;
  };

  /// A voxel of the chunk, and how near a triangle is.
  struct Place {
    std::uint32_t code;
    std::uint32_t distance;
    Int3 voxel;
    bool isNearer; ///< Than all triangles before it.
  };

  SnappedTriangle triangle(std::uint32_t number) {
    cursor_.moveTo(number);
    return mesh_->model.snapped(cursor_);
  }

  /// Looks now and then, after so many triangles, whether to stop. Error: interrupted.
  Expected<void> lookUp(std::size_t triangles) {
    if (triangles % kStep != 0)
      return {};
    mesh_->memory->relieve();
    return mesh_->progress.stopped() ? Expected<void>(Error::interrupted()) : Expected<void>();
  }

  Triangles trianglesOf(Int3 cube, int log2Side) {
    if (log2Side == mesh_->bins.log2Chunk())
      return mesh_->bins.at(cube);
    List &list = lists_[static_cast<std::size_t>(log2Side - mesh_->log2Chunk)];
    if (list.cube != cube) {
      auto around = VOXC_TRY(trianglesOf(cube >> 1, log2Side + 1));
      const ThreadTimer timer(mesh_->nanoseconds);
      list.cube = kNowhere;
      VOXC_TRY(select(around, cube, log2Side, list.triangles));
      list.cube = cube;
    }
    return std::as_const(list.triangles).span();
  }

  /// Sets `selected` to those of `triangles` that touch a cube.
  Expected<void> select(std::span<const std::uint32_t> triangles, Int3 cube, int log2Side,
                        ScratchArray<std::uint32_t> &selected) {
    const CellShape shape = CellShape::cube(mesh_->model.grid.bits() + log2Side);
    VOXC_TRY(selected.resize(0));
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      VOXC_TRY(lookUp(i));
      coverCells(triangle(triangles[i]), shape, {cube, cube + Int3{1, 1, 1}}, masks_);
      if (masks_.empty() || masks_[0].slices[0] == 0)
        continue;
      VOXC_TRY(selected.push(triangles[i]));
    }
    return {};
  }

  /// Makes `voxels_` those of the chunk around a voxel.
  Expected<void> moveTo(Int3 voxel) {
    const Int3 chunk = voxel >> mesh_->log2Chunk;
    if (chunk_ == chunk)
      return {};
    const Triangles triangles = trianglesOf(chunk, mesh_->log2Chunk);
    if (!triangles)
      return triangles.error();
    const ThreadTimer timer(mesh_->nanoseconds);
    chunk_ = kNowhere;
    VOXC_TRY(rasterize(*triangles, chunk * (1 << mesh_->log2Chunk)));
    chunk_ = chunk;
    return {};
  }

  Expected<void> rasterize(std::span<const std::uint32_t> triangles, Int3 low) {
    const int side = 1 << mesh_->log2Chunk;
    const Int3 extent = mesh_->model.extent();
    const CellRange within{low,
                           {std::min(low.x + side, extent.x), std::min(low.y + side, extent.y),
                            std::min(low.z + side, extent.z)}};
    voxels_.clear(low);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      VOXC_TRY(lookUp(i));
      propose(triangle(triangles[i]), within);
    }
    return {};
  }

  void propose(const SnappedTriangle &triangle, const CellRange &within) {
    mesh_->rule.cover(triangle, {cursor_.isMirrored(), cursor_.part().isThin()}, within, masks_);
    if (masks_.empty())
      return;
    colour_.moveTo(cursor_);
    const std::array<glm::dvec3, 3> corners = mesh_->model.inVoxels(triangle);
    const NearestPoints nearest(corners);
    if (colour_.measure(nearest))
      return proposeToMeans(corners, nearest);
    listVoxels(nearest, false);
    colour_.at(weights_, words_);
    for (std::size_t i = 0; i < words_.size(); ++i)
      if (words_[i] != 0) {
        voxels_.set(places_[i].code, places_[i].distance, words_[i]);
        voxels_.clearMean(places_[i].code);
      }
  }

  /// The same where texels are finer than voxels, so that voxels of other triangles show this one, too.
  void proposeToMeans(const std::array<glm::dvec3, 3> &corners, const NearestPoints &nearest) {
    listVoxels(nearest, true);
    colour_.at(weights_, words_);
    const VoxelAreas areas(corners, nearest);
    const SurfaceSide side{cursor_.part().material, nearest.normal()};
    for (std::size_t i = 0; i < words_.size(); ++i) {
      const Place &place = places_[i];
      if (words_[i] == 0)
        continue;
      if (place.isNearer)
        voxels_.set(place.code, place.distance, words_[i]);
      const double area = areas.in({place.voxel.x, place.voxel.y, place.voxel.z}, weights_[i]);
      voxels_.setWord(
          place.code,
          voxels_.meanAt(place.code).add(side, place.isNearer, area, words_[i], voxels_.wordAt(place.code)));
    }
  }

  /// Lists the voxels of `masks_` to which no earlier triangle is as near, or all.
  void listVoxels(const NearestPoints &nearest, bool all) {
    places_.clear();
    weights_.clear();
    for (const CellMask &mask : masks_)
      forEachCell(mask, [&](Int3 voxel) {
        const NearestPoint point = nearest.to({voxel.x + 0.5, voxel.y + 0.5, voxel.z + 0.5});
        const std::uint32_t code = voxels_.codeOf(voxel);
        const std::uint32_t distance = comparedDistance(point.distanceSquared);
        const bool isNearer = voxels_.isNearer(code, distance);
        if (!isNearer && !all)
          return;
        places_.push_back({code, distance, voxel, isNearer});
        weights_.push_back(point.weights);
      });
  }

  std::shared_ptr<const MeshVoxels> mesh_;
  TriangleCursor cursor_;
  SurfaceColour colour_;
  ChunkVoxels voxels_;
  Int3 chunk_ = kNowhere; ///< Whose voxels these are.
  std::vector<List> lists_;
  // Of the triangle in work.
  std::vector<CellMask> masks_;
  std::vector<Place> places_;
  std::vector<glm::dvec3> weights_;
  std::vector<std::uint32_t> words_;
};

} // namespace

Expected<std::unique_ptr<VoxelSource>> makeMeshSource(std::shared_ptr<const TriangleScene> scene,
                                                      const VoxelizeOptions &options,
                                                      const std::shared_ptr<WorkingMemory> &memory,
                                                      const MeshTuning &tuning) {
  auto mesh = VOXC_TRY(MeshVoxels::open(std::move(scene), options, memory, tuning));
  return std::unique_ptr<VoxelSource>(std::make_unique<MeshSource>(std::move(mesh)));
}

Expected<std::unique_ptr<VoxelSource>> makeMeshSource(std::shared_ptr<const TriangleScene> scene,
                                                      const VoxelizeOptions &options,
                                                      const std::shared_ptr<WorkingMemory> &memory) {
  return makeMeshSource(std::move(scene), options, memory, {});
}

} // namespace voxc
