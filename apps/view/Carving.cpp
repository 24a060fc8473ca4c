// Deeds, one after the other.
#include "view/Carving.h"

#include "view/Pick.h"

#include <optional>

namespace voxc::view {
namespace {

/// A stamp, and where it goes.
struct Aimed {
  Stroke stroke;
  Hit hit;
};

/// Rays of all stamps, before the first of them changes what they hit.
Expected<std::vector<Aimed>> aim(const Shot &shot, const std::vector<Deed> &deeds) {
  std::vector<Aimed> aimed;
  for (const Deed &deed : deeds) {
    const Stroke *const stroke = std::get_if<Stroke>(&deed);
    if (!stroke)
      continue;
    const bool isInside = stroke->column < shot.camera.width && stroke->row < shot.camera.height;
    aimed.push_back({*stroke, {{-1, -1, -1}, 0, 0, 0}});
    if (!isInside)
      continue;
    const auto picked = VOXC_TRY(pick(shot, stroke->column, stroke->row));
    aimed.back().hit = picked.hit;
  }
  return aimed;
}

/// A stroke that nothing of the volume meets changes nothing, and is nothing to undo.
Expected<void> press(Sculpture &sculpture, const Aimed &aimed, Carving &carving) {
  if (aimed.stroke.isFirst)
    sculpture.begin();
  if (!aimed.hit.isHit())
    return {};
  const auto change = stamp(aimed.stroke.brush, {aimed.hit.voxel[0], aimed.hit.voxel[1], aimed.hit.voxel[2]});
  carving.isChanged = true;
  ++carving.stamps;
  return sculpture.apply(*change);
}

} // namespace

Expected<Carving> carve(Scene &scene, const Shot &shot) {
  if (scene.model.pagedBytes > 0)
    return Error::usage("a volume in pages cannot be edited; open it without --device-memory");
  Sculpture &sculpture = *scene.sculpture;
  const std::vector<Deed> deeds = sculpture.takeDeeds();
  VOXC_TRY(sculpture.prepare());
  const auto aimed = VOXC_TRY(aim(shot, deeds));
  Carving carving;
  std::optional<Error> failure;
  auto next = aimed.begin();
  for (const Deed &deed : deeds) {
    if (std::holds_alternative<Undo>(deed))
      carving.isChanged |= sculpture.undo();
    else if (std::holds_alternative<Redo>(deed))
      carving.isChanged |= sculpture.redo();
    else if (const ShowFrame *const frame = std::get_if<ShowFrame>(&deed))
      carving.isChanged |= sculpture.showFrame(frame->index);
    else if (std::holds_alternative<Stroke>(deed))
      if (auto pressed = press(sculpture, *next++, carving); !pressed && !failure)
        failure = pressed.error();
  }
  const auto shown = VOXC_TRY(sculpture.show(*scene.tracer));
  if (carving.isChanged)
    scene.normals = std::make_unique<SurfaceNormals>(*sculpture.volume(), scene.threads);
  if (failure)
    return *failure;
  carving.copiedBytes = shown.copiedBytes;
  carving.voxels = sculpture.volume()->info().voxels;
  carving.bytes = sculpture.volume()->bytes();
  return carving;
}

} // namespace voxc::view
