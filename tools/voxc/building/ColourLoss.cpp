// Errors of colours as text, and palettes that stand for more colours than they have.
#include "building/ColourLoss.h"

#include "voxc/Layout/Layout.h"
#include "voxc/Layout/Values.h"

#include <cstdio>

namespace voxc::tool {

std::string errorText(const ColourError &error) {
  char text[256];
  std::snprintf(text, sizeof text,
                "largest error of R, G, B and alpha %d, %d, %d and %d of 255, mean %.3f, %.3f, %.3f and "
                "%.3f, root of the mean square %.3f, %.3f, %.3f and %.3f",
                error.largest[0], error.largest[1], error.largest[2], error.largest[3], error.mean[0],
                error.mean[1], error.mean[2], error.mean[3], error.rms[0], error.rms[1], error.rms[2],
                error.rms[3]);
  return text;
}

Json errorFigures(const ColourError &error) {
  return {{"largest", error.largest}, {"mean", error.mean}, {"rms", error.rms}};
}

Expected<std::unique_ptr<RoundedSource>> reduceToPalette(VoxelSource &source, const Format &format,
                                                         const Progress &progress) {
  const Layout layout = layoutOf(format);
  if (layout.hasLabels() || layout.payloadBits == 0)
    return Error::usage("--lossy chooses the colours of a palette; give --palette=N as well");
  const std::unique_ptr<VoxelSource> view = source.view();
  auto rounding =
      VOXC_TRY(reduceColours(view ? *view : source, std::size_t{1} << layout.payloadBits, progress));
  return rounding ? std::make_unique<RoundedSource>(source, rounding) : nullptr;
}

Expected<std::unique_ptr<RoundedSource>> asKept(const Volume &volume, VoxelSource &source,
                                                const Progress &progress) {
  if (kindOf(volume.layout().payload).isShapeAlone())
    return std::make_unique<RoundedSource>(source, [](std::uint32_t word) { return word ? kOccupied : 0; });
  if (const Rounding rounding = roundingOf(volume.layout().payload))
    return std::make_unique<RoundedSource>(source, rounding);
  if (volume.info().provenance.find(std::string("colours=") + kReducedColours) != std::string::npos)
    return reduceToPalette(source, volume.format(), progress);
  return std::unique_ptr<RoundedSource>();
}

} // namespace voxc::tool
