// The marks that rays leave in a table of pages of which none is absent.
#include "page/FirstPages.h"

#include "voxc/IR/Attribute.h"
#include "voxc/IR/Query.h"
#include "voxc/Kernel/CompileCpu.h"
#include "voxc/Trace/CpuKernel.h"

#include <glm/geometric.hpp>

#include <bit>
#include <numeric>

namespace voxc::page {
namespace {

// As in shaders-runtime/paging.glsl.
constexpr std::uint32_t kTouched = 0x80000000u;

/// Pixels of a picture's height, step by step.
constexpr int kSteps[] = {12, 25, 50, 100};
constexpr double kAspect = 16.0 / 9; ///< As wide as windows are.

/// Rays through the middles of pixels, which are square: a narrower picture of that height has some of them.
std::vector<Ray> raysOf(const PictureView &view, int height) {
  const double aspect = glm::length(view.right) / glm::length(view.up);
  const int width = 2 * static_cast<int>(height * kAspect / 2);
  std::vector<Ray> rays;
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      const double across = (2 * column + 1 - width) / (height * aspect),
                   above = 1 - (row + 0.5) / height * 2;
      rays.push_back(rayAt(view, across, above));
    }
  return rays;
}

} // namespace

Expected<std::vector<std::uint32_t>> firstPages(const Volume &volume, const PictureView &view,
                                                const Clip &clip, std::uint32_t pageBytes) {
  Format format = volume.format();
  askForBounds(format);
  const auto kernel = VOXC_TRY(compileCpuKernel(format, {.addressing = Addressing::Paged}));
  const std::uint32_t pageWords = pageBytes / sizeof(std::uint32_t);
  CpuPages pages;
  pages.slots = volume.words().data();
  pages.log2PageWords = static_cast<std::uint32_t>(std::countr_zero(pageWords));
  pages.pages = static_cast<std::uint32_t>((volume.words().size() + pageWords - 1) / pageWords);
  // Each page lies in the slot of its own number.
  std::vector<std::uint32_t> table(pages.pages + 1);
  std::iota(table.begin(), table.end(), 0u);
  table.back() = kTouched;
  pages.table = table.data();
  std::vector<std::uint32_t> found;
  std::vector<bool> isFound(pages.pages);
  for (const int height : kSteps) {
    const std::vector<BoundedRay> rays = clip.bounded(raysOf(view, height), 0);
    std::vector<Hit> hits(rays.size());
    kernel.function(reinterpret_cast<const std::uint32_t *>(&pages),
                    reinterpret_cast<const float *>(rays.data()),
                    reinterpret_cast<std::uint32_t *>(hits.data()), rays.size(), 0, 0);
    for (std::uint32_t page = 0; page < pages.pages; ++page)
      if ((table[page] & kTouched) != 0 && !isFound[page]) {
        found.push_back(page);
        isFound[page] = true;
      }
  }
  return found;
}

} // namespace voxc::page
