// Choosing a rule, and adding the parts that close holes.
#include "Mesh/Solid/ClosedMesh.h"

#include "Mesh/KeptArray.h"
#include "Mesh/Solid/Facing.h"
#include "Mesh/Solid/HoleCaps.h"
#include "Mesh/Solid/TwinQuads.h"
#include "Mesh/Solid/TwinTriangles.h"

#include <utility>

namespace voxc {

namespace {

/// The scene without colours: nothing of it is cut out, and voxels are made faster.
TriangleScene shapeOf(const TriangleScene &scene) {
  TriangleScene shape = scene;
  shape.materials = {Material{}};
  shape.textures.clear();
  for (MeshPart &part : shape.parts) {
    part.uvs = {};
    part.emissionUvs = {};
    part.metalUvs = {};
    part.colours = {};
    part.material = 0;
  }
  return shape;
}

class Closer {
public:
  Closer(ClosedMesh &mesh, const TriangleScene &scene, const std::shared_ptr<WorkingMemory> &memory,
         const Progress &progress)
      : mesh_(mesh), scene_(scene), memory_(memory), progress_(progress), shape_(shapeOf(scene)) {}

  Expected<void> close() {
    mesh_.caps = mesh_.twinCaps = mesh_.model.numbers.size();
    VOXC_TRY(closeAll());
    VOXC_TRY(closeTwins());
    mesh_.model.numbers = TriangleNumbers(shape_);
    mesh_.scene = std::make_shared<TriangleScene>(std::move(shape_));
    return {};
  }

private:
  /// Of all triangles: by the way that they turn, if that leaves small holes, else whichever way.
  Expected<void> closeAll() {
    const auto balance = VOXC_TRY(EdgeBalance::of(scene_, mesh_.model, memory_, progress_));
    mesh_.rule = balance.rule;
    mesh_.open = balance.open;
    if (balance.rule != SolidRule::Enclosure || !balance.areRimsAll)
      return {};
    const auto area = VOXC_TRY(areaOf(scene_, mesh_.model, nullptr, *memory_, progress_));
    for (const bool isEither : {false, true}) {
      const HoleCaps caps = HoleCaps::of(balance.rims, isEither, mesh_.model);
      if (!caps.isSmall(area))
        continue;
      mesh_.rule = isEither ? SolidRule::Parity : SolidRule::Winding;
      return add(caps, area, mesh_.twinCaps);
    }
    return {};
  }

  /// Of triangles that lie on others, which wind around nothing, or, if these are not closed, of such quads.
  Expected<void> closeTwins() {
    mesh_.twins = VOXC_TRY(findTwins(scene_, mesh_.model, memory_, progress_));
    if (auto closed = closeSetOfTwins(); !closed || mesh_.hasTwins)
      return closed;
    const auto isLittle = VOXC_TRY(hasLittleVolume(scene_, mesh_.model, *memory_, progress_));
    if (!isLittle)
      return {};
    const auto hasMore = VOXC_TRY(addTwinQuads(mesh_.twins, scene_, mesh_.model, memory_, progress_));
    return hasMore ? closeSetOfTwins() : Expected<void>();
  }

  Expected<void> closeSetOfTwins() {
    if (mesh_.twins.empty())
      return {};
    const auto balance =
        VOXC_TRY(EdgeBalance::ofEither(mesh_.twins, scene_, mesh_.model, memory_, progress_));
    mesh_.hasTwins = balance.rule == SolidRule::Parity;
    if (mesh_.hasTwins || !balance.areRimsAll)
      return {};
    const auto area = VOXC_TRY(areaOf(scene_, mesh_.model, &mesh_.twins, *memory_, progress_));
    const HoleCaps caps = HoleCaps::of(balance.rims, true, mesh_.model);
    if (!caps.isSmall(area))
      return {};
    mesh_.hasTwins = true;
    if (mesh_.open.count == 0)
      mesh_.open = balance.open;
    std::uint64_t end = 0;
    return add(caps, area, end);
  }

  /// Adds a part, and sets `end` to the number of the triangle after its last one.
  Expected<void> add(const HoleCaps &caps, double area, std::uint64_t &end) {
    ScratchArray<std::array<double, 3>> corners(memory_);
    VOXC_TRY(corners.append(caps.corners));
    MeshPart part;
    part.positions = keep(std::move(corners), kDoubleRows3, shape_);
    shape_.instances.push_back({static_cast<std::uint32_t>(shape_.parts.size()), {}});
    shape_.parts.push_back(part);
    end = triangleCount(shape_);
    mesh_.holes += caps.holes;
    mesh_.holeShare = std::max(mesh_.holeShare, area > 0 ? caps.area / area : 0);
    return {};
  }

  ClosedMesh &mesh_;
  const TriangleScene &scene_;
  std::shared_ptr<WorkingMemory> memory_;
  const Progress &progress_;
  TriangleScene shape_;
};

} // namespace

Expected<ClosedMesh> ClosedMesh::of(const TriangleScene &scene, const MeshModel &model,
                                    const std::shared_ptr<WorkingMemory> &memory, const Progress &progress) {
  ClosedMesh mesh{nullptr, model, SolidRule::Enclosure, false, TriangleSet(memory), 0, 0, 0, 0, {}};
  VOXC_TRY(Closer(mesh, scene, memory, progress).close());
  return mesh;
}

} // namespace voxc
