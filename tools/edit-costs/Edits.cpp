// The table of edits.
#include "Edits.h"

#include <algorithm>
#include <random>

namespace voxc::edits {
namespace {

constexpr EditKind kKinds[] = {
    {"set one voxel", Edit::Voxel, 0, rgba(255, 0, 0), 2000},
    {"clear one voxel", Edit::Voxel, 0, 0, 2000},
    {"set a sphere of 16^3", Edit::Sphere, 8, rgba(0, 255, 0), 400},
    {"clear a sphere of 16^3", Edit::Sphere, 8, 0, 400},
    {"set a sphere of 64^3", Edit::Sphere, 32, rgba(0, 0, 255), 60},
    {"clear a sphere of 64^3", Edit::Sphere, 32, 0, 60},
    {"paste a volume", Edit::Paste, 0, 0, 20},
};

} // namespace

std::span<const EditKind> editKinds() { return kKinds; }

std::vector<Edit> editsOf(const EditKind &kind, std::span<const Int3> places) {
  std::mt19937 random(1);
  std::vector<Edit> edits;
  edits.reserve(static_cast<std::size_t>(kind.count));
  for (int i = 0; i < kind.count; ++i)
    edits.push_back({kind.shape, places[random() % places.size()], kind.radius, kind.word});
  return edits;
}

std::unique_ptr<VoxelChange> changeOf(const Edit &edit, const std::shared_ptr<const Volume> &pasted) {
  switch (edit.shape) {
  case Edit::Voxel:
    return makeBoxChange(edit.at, {1, 1, 1}, edit.word);
  case Edit::Sphere:
    return makeSphereChange(edit.at, edit.radius, edit.word);
  case Edit::Paste:
    break;
  }
  return makePasteChange(pasted, edit.at);
}

std::vector<Int3> placesOn(const Volume &volume, std::size_t most) {
  const std::uint64_t step = std::max<std::uint64_t>(volume.info().voxels / most, 1);
  std::vector<Int3> places;
  std::uint64_t cubes = 0;
  static_cast<void>(decode(volume, [&](const Cube &cube, std::uint32_t) {
    if (cubes++ % step == 0)
      places.push_back(cube.low);
    return places.size() < most;
  }));
  return places;
}

} // namespace voxc::edits
