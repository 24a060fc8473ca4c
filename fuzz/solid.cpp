// Fuzzes voxelizers and solids with triangles whose corners lie on a coarse lattice, where all that can be
// undecided is. The first byte chooses a coverage, and what must hold: both voxelizers agree, or of the cells
// beside the surface those are filled whose centres are inside.
#include "Expect.h"

#include "voxc/Mesh/SolidMesh.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace {

using namespace voxc;
using fuzz::expect;

constexpr int kSide = 8;
constexpr int kSteps = 49; ///< Of a coordinate.
constexpr std::size_t kMostTriangles = 24;
constexpr std::uint32_t kFill = 0xff332211;
using Words = std::vector<std::uint32_t>;

/// Each byte is a coordinate, in quarters of a voxel from two voxels below the volume on.
std::shared_ptr<TriangleScene> sceneOf(std::span<const unsigned char> bytes) {
  auto corners = std::make_shared<std::vector<std::array<float, 3>>>();
  for (std::size_t i = 0; i + 3 <= bytes.size() && i < 9 * kMostTriangles; i += 3)
    corners->push_back({static_cast<float>(bytes[i] % kSteps) / 4 - 2,
                        static_cast<float>(bytes[i + 1] % kSteps) / 4 - 2,
                        static_cast<float>(bytes[i + 2] % kSteps) / 4 - 2});
  corners->resize(corners->size() / 3 * 3);
  auto scene = std::make_shared<TriangleScene>();
  scene->materials.emplace_back();
  MeshPart part;
  part.positions = {reinterpret_cast<const std::byte *>(corners->data()), corners->size(), 12,
                    AttributeView::Type::Float32, 3};
  scene->parts.push_back(part);
  scene->instances.push_back({});
  scene->storage.push_back(corners);
  return scene;
}

Words wordsOf(VoxelSource &source) {
  Words words(kSide * kSide * kSide);
  expect(bool(source.read({{}, 3}, words.data())));
  return words;
}

/// Whether a triangle has three corners: a mesh without one is refused.
bool hasTriangle(const TriangleScene &scene) {
  const auto *const corners = reinterpret_cast<const std::array<float, 3> *>(scene.parts[0].positions.data);
  for (std::size_t i = 0; i < scene.parts[0].positions.count; i += 3)
    if (corners[i] != corners[i + 1] && corners[i] != corners[i + 2] && corners[i + 1] != corners[i + 2])
      return true;
  return false;
}

using Scene = std::shared_ptr<TriangleScene>;
using Memory = std::shared_ptr<WorkingMemory>;

void compareVoxelizers(const Scene &scene, const VoxelizeOptions &options, const Memory &memory) {
  const auto quick = makeMeshSource(scene, options, memory);
  const auto simple = makeReferenceMeshSource(*scene, options);
  expect(quick && simple);
  expect(wordsOf(**quick) == wordsOf(**simple));
}

void compareInsides(const Scene &scene, VoxelizeOptions options, const Memory &memory) {
  auto quick = makeMeshSource(scene, options, memory);
  expect(bool(quick));
  const Words surface = wordsOf(**quick);
  const auto filled = fillMesh(*scene, options, std::move(*quick), kFill, {memory});
  expect(bool(filled));
  const Words words = wordsOf(*filled->source);
  options.coverage = Coverage::Centre;
  auto touched = makeMeshSource(scene, options, memory);
  expect(bool(touched));
  const auto solid = centreMesh(*scene, options, std::move(*touched), kFill, {memory});
  const Words inside = solid ? wordsOf(*solid->source) : Words();
  for (std::size_t i = 0; i < words.size(); ++i) {
    expect(surface[i] == 0 || words[i] == surface[i]);
    expect(!solid || surface[i] != 0 || (words[i] != 0) == (inside[i] != 0));
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  const auto scene = sceneOf({data, size});
  if (scene->parts[0].positions.count == 0)
    return 0;
  const auto memory = WorkingMemory::create(std::uint64_t{64} << 20);
  VoxelizeOptions options;
  options.resolution = kSide;
  options.bounds = {{0, 0, 0, kSide, kSide, kSide}};
  if (!hasTriangle(*scene)) {
    expect(!makeMeshSource(scene, options, memory) && !makeReferenceMeshSource(*scene, options));
    return 0;
  }
  // The quotient of what the first coordinate is the remainder of: seeds have 0.
  constexpr std::array kCoverages{Coverage::Conservative, Coverage::Thin, Coverage::Inner};
  const std::size_t choice = data[0] / kSteps;
  options.coverage = kCoverages[choice % kCoverages.size()];
  choice < kCoverages.size() ? compareVoxelizers(scene, options, memory)
                             : compareInsides(scene, options, memory);
  return 0;
}
