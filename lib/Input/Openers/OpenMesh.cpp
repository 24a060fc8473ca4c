// Opening triangle meshes.
#include "Input/Openers/Openers.h"

#include "Input/Openers/InputText.h"
#include "voxc/Mesh/MeshSource.h"
#include "voxc/Support/Stopwatch.h"

#include <array>
#include <utility>

namespace voxc {

namespace {

constexpr std::array<const char *, 2> kCoverageNames{"conservative", "thin"};

Expected<std::unique_ptr<VoxelSource>> voxelize(std::shared_ptr<const TriangleScene> scene,
                                                const InputOptions &options) {
  const VoxelizeOptions voxelizing{options.resolution, options.formatExtent, options.bounds,
                                   options.zUp,        options.coverage,     options.progress};
  return options.reference ? makeReferenceMeshSource(*scene, voxelizing)
                           : makeMeshSource(std::move(scene), voxelizing, options.memory);
}

} // namespace

Expected<Input> openMesh(const std::string &path, const InputOptions &options) {
  const Stopwatch loading;
  auto scene = loadScene(path, options.memory, options.progress);
  if (!scene)
    return scene.error();
  Input input;
  input.loadSeconds = loading.seconds();
  input.loaderPeakBytes = scene->loaderPeakBytes;
  input.triangles = triangleCount(*scene);
  input.warnings = std::move(scene->warnings);
  const Stopwatch binning;
  auto source = voxelize(std::make_shared<const TriangleScene>(std::move(*scene)), options);
  if (!source)
    return source.error();
  input.source = std::move(*source);
  input.binSeconds = binning.seconds();
  input.provenance = modelProvenance(kCoverageNames[static_cast<std::size_t>(options.coverage)],
                                     longestAxis(input.source->extent()), options);
  return input;
}

} // namespace voxc
