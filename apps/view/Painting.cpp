// Pictures of scenes.
#include "view/Painting.h"

#include <algorithm>

namespace voxc::view {
namespace {

/// Which of `small` places the place `i` of `large` shows.
std::size_t smaller(int i, int small, int large) { return std::size_t(std::int64_t(i) * small / large); }

/// The element of the small picture that each pixel of the large one shows.
template <typename Value, typename At>
std::vector<Value> enlarge(const Camera &small, const Camera &large, const At &at) {
  std::vector<Value> values(std::size_t(large.width) * std::size_t(large.height));
  for (int row = 0; row < large.height; ++row) {
    const std::size_t first = smaller(row, small.height, large.height) * std::size_t(small.width);
    Value *const out = &values[std::size_t(row) * std::size_t(large.width)];
    for (int column = 0; column < large.width; ++column)
      out[column] = at(first + smaller(column, small.width, large.width));
  }
  return values;
}

} // namespace

Expected<TraceReport> traceClipped(const Scene &scene, const Clip &clip, std::span<const Ray> rays,
                                   std::span<Hit> hits, const TraceOptions &options) {
  return clip.cutsNothing() ? scene.tracer->trace(rays, hits, options)
                            : scene.tracer->trace(clip.bounded(rays, scene.threads), hits, options);
}

Expected<Picture> paint(const Shot &shot, const RefinementStep &step, const Progress &progress) {
  const auto &[scene, camera, look] = shot;
  Camera small = camera;
  small.width = std::max(camera.width / step.divisor, 1);
  small.height = std::max(camera.height / step.divisor, 1);
  const auto trace = [&shot](std::span<const Ray> rays, std::span<Hit> hits,
                             const TraceOptions &options) -> Expected<void> {
    const Expected<TraceReport> report = traceClipped(*shot.scene, shot.look.clip, rays, hits, options);
    return report ? Expected<void>() : report.error();
  };
  RenderOptions options{.style = look.style, .samples = step.samples, .isSmooth = look.isSmooth};
  options.sun = look.sun;
  options.coarse = look.coarse; // Of a draft, which has larger pixels, more.
  options.normals = scene->normals.get();
  options.isDraft = step.isDraft;
  options.threads = scene->threads;
  options.clip = look.clip.cutsNothing() ? nullptr : &look.clip;
  options.progress = progress;
  auto rendering = VOXC_TRY(render(*scene->volume(), small, {trace, trace}, options));
  const StyleKind &kind = kindOf(look.style);
  if (!kind.unit.empty()) {
    const auto values = enlarge<float>(small, camera, [&](std::size_t i) { return rendering.light[4 * i]; });
    return mapPicture(values, camera.width, camera.height, kind.unit, look.style == Style::Depth);
  }
  if (step.divisor == 1)
    return std::move(rendering.picture);
  auto pixels =
      enlarge<std::uint32_t>(small, camera, [&](std::size_t i) { return rendering.picture.pixels[i]; });
  return Picture{camera.width, camera.height, std::move(pixels)};
}

} // namespace voxc::view
