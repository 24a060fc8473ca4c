// Stamps.
#include "view/Brush.h"

#include "voxc/Construct/Constructor.h"
#include "voxc/Support/UserCache.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string_view>

namespace voxc::view {
namespace {

constexpr std::array<std::string_view, 5> kNames = {"", "add", "erase", "paint", "paste"};

bool isWithin(const Brush &brush, Int3 from) {
  return brush.isBox || from.x * from.x + from.y * from.y + from.z * from.z <= brush.radius * brush.radius;
}

} // namespace

void Brush::next() {
  const int kinds = copied ? 5 : 4;
  kind = static_cast<BrushKind>((static_cast<int>(kind) + 1) % kinds);
}

void Brush::resize(int by) { radius = std::clamp(radius + by, 0, kMostRadius); }

std::string describe(const Brush &brush) {
  if (brush.kind == BrushKind::None)
    return "";
  std::array<char, 80> text{};
  const std::string name(kNames[static_cast<std::size_t>(brush.kind)]);
  if (brush.kind == BrushKind::Paste)
    return name + " what was copied";
  std::snprintf(text.data(), text.size(), "%s a %s of %d voxels", name.c_str(),
                brush.isBox ? "box" : "sphere", brush.side());
  std::string what = text.data();
  if (brush.kind == BrushKind::Erase)
    return what;
  std::snprintf(text.data(), text.size(), ", #%02x%02x%02x", brush.colour & 255, brush.colour >> 8 & 255,
                brush.colour >> 16 & 255);
  return what + text.data();
}

std::unique_ptr<VoxelChange> stamp(const Brush &brush, Int3 at) {
  const Int3 size = {brush.side(), brush.side(), brush.side()};
  if (brush.kind == BrushKind::Paste) {
    const Int3 extent = brush.copied->info().extent;
    return makePasteChange(brush.copied, at - Int3{extent.x / 2, extent.y / 2, extent.z / 2});
  }
  if (brush.kind == BrushKind::Paint)
    return makeFunctionChange(brush.lowAt(at), size, [brush, at](Int3 voxel, std::uint32_t word) {
      return word != 0 && isWithin(brush, voxel - at) ? brush.colour : word;
    });
  const std::uint32_t word = brush.kind == BrushKind::Add ? brush.colour : 0;
  return brush.isBox ? makeBoxChange(brush.lowAt(at), size, word) : makeSphereChange(at, brush.radius, word);
}

Expected<std::shared_ptr<const Volume>> copyUnder(const Brush &brush, Int3 at, const Volume &volume) {
  const Int3 low = brush.lowAt(at);
  const auto source = makeFunctionSource({brush.side(), brush.side(), brush.side()}, [&](Int3 cell) {
    const Int3 voxel = low + cell;
    const bool isThere = contains(volume.info().extent, voxel) && isWithin(brush, voxel - at);
    return isThere ? volume.lookup(voxel).value : 0u;
  });
  int log2Side = 0;
  while (1 << log2Side < brush.side())
    ++log2Side;
  auto constructor =
      VOXC_TRY(Constructor::compile(*parseFormat("G(" + std::to_string(log2Side) + ")"), compileCache()));
  auto built = VOXC_TRY(constructor.build(*source));
  return built.report.voxels == 0 ? nullptr : std::make_shared<const Volume>(std::move(built.volume));
}

} // namespace voxc::view
