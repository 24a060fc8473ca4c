// Rays through single pixels.
#include "view/Pick.h"

#include <cstdio>

namespace voxc::view {

Expected<Pick> pick(const Shot &shot, int column, int row) {
  const std::vector<Ray> rays = cameraRays(shot.camera, row, 1, {0.5, 0.5});
  const Ray ray = rays[std::size_t(column)];
  const Clip &clip = shot.look.clip;
  Pick pick{shot, bounded(ray, clip.cutsNothing() ? RayBounds() : clip.boundsOf(ray)), {}};
  const Expected<TraceReport> report = traceClipped(*shot.scene, clip, std::span(&ray, 1), {&pick.hit, 1});
  return report ? Expected<Pick>(std::move(pick)) : report.error();
}

std::string describe(const Hit &hit) {
  if (!hit.isHit())
    return "no voxel";
  char text[160];
  std::snprintf(text, sizeof text, "voxel %d,%d,%d, colour #%02x%02x%02x, t %.9g", hit.voxel[0], hit.voxel[1],
                hit.voxel[2], hit.rgba & 255, hit.rgba >> 8 & 255, hit.rgba >> 16 & 255, double(hit.t));
  return text;
}

} // namespace voxc::view
