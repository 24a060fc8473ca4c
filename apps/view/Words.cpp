// Numbers in words.
#include "view/Words.h"

#include <algorithm>
#include <cstdio>
#include <iterator>

namespace voxc::view {
namespace {

std::string bytesText(double bytes) {
  constexpr const char *kUnits[] = {"B", "KiB", "MiB", "GiB", "TiB"};
  std::size_t unit = 0;
  for (; bytes >= 1024 && unit + 1 < std::size(kUnits); ++unit)
    bytes /= 1024;
  char text[48];
  std::snprintf(text, sizeof text, unit == 0 ? "%.0f %s" : "%.2f %s", bytes, kUnits[unit]);
  return text;
}

} // namespace

namespace {

std::string sizeText(Int3 extent, std::uint64_t voxels, std::uint64_t bytes) {
  return std::to_string(extent.x) + " x " + std::to_string(extent.y) + " x " + std::to_string(extent.z) +
         ", " + std::to_string(voxels) + " voxels, " + bytesText(double(bytes));
}

} // namespace

std::string sizeText(const Model &model) {
  const VolumeInfo &info = model.volume->info();
  return model.pagedBytes > 0 ? sizeText(info.extent, info.voxels, model.pagedBytes) + " in pages"
                              : sizeText(info.extent, info.voxels, model.volume->bytes());
}

std::string sizeText(const Model &model, const Carving &carving) {
  return sizeText(model.volume->info().extent, carving.voxels, carving.bytes);
}

std::string stepText(const Painting &painting) {
  const Picture &picture = *painting.picture;
  const int divisor = painting.step.divisor;
  char text[96];
  std::snprintf(text, sizeof text, "%dx%d, %u sample%s, %.0f ms", std::max(picture.width / divisor, 1),
                std::max(picture.height / divisor, 1), painting.step.samples,
                painting.step.samples == 1 ? "" : "s", 1e3 * painting.seconds);
  return text;
}

std::string pagesText(const Painting &painting) {
  if (!painting.paging)
    return {};
  return "; " + std::to_string(painting.paging->reads) + " pages so far, " +
         std::to_string(painting.paging->ahead) + " of them read ahead";
}

} // namespace voxc::view
