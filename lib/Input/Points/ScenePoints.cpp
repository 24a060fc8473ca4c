// Points of .obj and glTF files.
#include "Input/Points/ScenePoints.h"

#include "Mesh/Voxelize/NearestPoint.h"
#include "Mesh/Voxelize/SurfaceColour.h"
#include "Mesh/Voxelize/TextureMeans.h"
#include "Mesh/Voxelize/TriangleCursor.h"
#include "Support/Text.h"

#include <algorithm>
#include <span>
#include <vector>

namespace voxc {

namespace {

constexpr std::uint64_t kPointsBetweenLooks = 1 << 12;

class ScenePoints final : public PointList {
public:
  explicit ScenePoints(const std::shared_ptr<WorkingMemory> &memory) : memory_(memory), points_(memory) {}

  std::uint64_t size() const override { return points_.size(); }
  bool hasColours() const override { return hasColours_; }
  std::string saysDropped(std::uint64_t count) const override {
    return countedAre(count, "point") + " left out, which a texture cuts out";
  }
  void read(std::uint64_t first, std::span<PlyPoint> points) const override {
    std::ranges::copy(points_.span().subspan(first, points.size()), points.begin());
  }

  Expected<void> fill(const TriangleScene &scene, const Progress &progress) {
    const TriangleNumbers numbers(scene);
    TriangleCursor cursor(scene, numbers);
    const SceneMeans none; // A point has no area to average over.
    SurfaceColour colour(scene, none);
    const glm::dvec3 corner(1, 0, 0);
    std::vector<std::uint32_t> words;
    for (std::uint64_t i = 0; i < numbers.size(); ++i) {
      if (i % kPointsBetweenLooks == 0) {
        if (progress.stopped())
          return Error::interrupted();
        memory_->relieve();
      }
      cursor.moveTo(i);
      colour.moveTo(cursor);
      colour.measure(NearestPoints(cursor.corners()));
      colour.at(std::span(&corner, 1), words);
      const glm::dvec3 place = cursor.corners()[0];
      VOXC_TRY(points_.push({{place.x, place.y, place.z}, words[0]}));
      hasColours_ = hasColours_ || words[0] != 0xffffffff;
    }
    return {};
  }

private:
  std::shared_ptr<WorkingMemory> memory_;
  ScratchArray<PlyPoint> points_;
  bool hasColours_ = false;
};

} // namespace

bool isOfPoints(const TriangleScene &scene) {
  return std::ranges::all_of(scene.instances, [&](const MeshInstance &instance) {
    const MeshPart &part = scene.parts[instance.part];
    return part.mode == PrimitiveMode::Points || part.triangles() == 0;
  });
}

Expected<std::unique_ptr<PointList>>
pointsOf(const TriangleScene &scene, const std::shared_ptr<WorkingMemory> &memory, const Progress &progress) {
  auto points = std::make_unique<ScenePoints>(memory);
  VOXC_TRY(points->fill(scene, progress));
  return std::unique_ptr<PointList>(std::move(points));
}

} // namespace voxc
