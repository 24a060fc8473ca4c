// Opening triangle meshes.
#include "Input/Openers/Openers.h"

#include "Input/Openers/InputText.h"
#include "Input/Openers/MeshFacts.h"
#include "Input/Points/PointSource.h"
#include "Input/Points/ScenePoints.h"
#include "voxc/Mesh/MeshSource.h"
#include "voxc/Mesh/SolidMesh.h"
#include "voxc/Support/Stopwatch.h"

#include <array>
#include <cstdio>
#include <string>
#include <utility>

namespace voxc {

namespace {

VoxelizeOptions voxelizeOptions(const InputOptions &options) {
  return {options.resolution, modelExtent(options), options.bounds,   options.zUp,
          options.coverage,   options.regions,      options.progress, options.colour};
}

Expected<std::unique_ptr<VoxelSource>> voxelize(const std::shared_ptr<const TriangleScene> &scene,
                                                const InputOptions &options) {
  const VoxelizeOptions voxelizing = voxelizeOptions(options);
  return options.reference ? makeReferenceMeshSource(*scene, voxelizing)
                           : makeMeshSource(scene, voxelizing, options.memory);
}

std::string placeOf(const std::array<double, 3> &point) {
  std::array<char, 96> text;
  std::snprintf(text.data(), text.size(), "(%.6g, %.6g, %.6g)", point[0], point[1], point[2]);
  return text.data();
}

/// What is wrong with a mesh that is not filled by its winding numbers.
std::string complaintOf(SolidRule rule, const OpenEdges &open) {
  const std::string where = (open.isAll ? ": " : ": at least ") + std::to_string(open.count) +
                            " edges lack a counterpart, one from " + placeOf(open.from) + " to " +
                            placeOf(open.to) + "; ";
  if (rule == SolidRule::Parity)
    return "the triangles of the mesh do not all face the same way" + where +
           "inside is what a ray enters an odd number of times";
  return "the mesh is not closed" + where + "inside is what its voxels enclose";
}

/// Makes the inside of the mesh voxels.
Expected<void> fill(const TriangleScene &scene, const InputOptions &options, Input &input) {
  const Stopwatch filling;
  auto solid = fillMesh(scene, voxelizeOptions(options), std::move(input.source), options.fillWord,
                        {options.memory, options.threads, options.progress});
  if (!solid)
    return solid.error();
  input.source = std::move(solid->source);
  input.interior = Interior::Fill;
  input.interiorVoxels = solid->voxels;
  input.interiorSeconds = filling.seconds();
  if (solid->rule != SolidRule::Winding)
    input.warnings.push_back(complaintOf(solid->rule, solid->open));
  return {};
}

/// A model of points alone is no surface: each point is one voxel, as in a .ply.
Expected<void> openPoints(const std::string &path, const TriangleScene &scene, const InputOptions &options,
                          Input &input) {
  const auto points = pointsOf(scene, options.memory, options.progress);
  if (!points)
    return points.error();
  auto voxels = placePoints(**points, false, options, [&](const std::string &what) {
    return Error::input("'" + path + "' has unusable points: " + what);
  });
  if (!voxels)
    return voxels.error();
  input.triangles = 0;
  input.source = std::move(voxels->source);
  input.provenance = modelProvenance("points", longestAxis(input.source->extent()), options);
  input.warnings.insert(input.warnings.end(), voxels->warnings.begin(), voxels->warnings.end());
  if (options.describe)
    input.facts = std::move(voxels->facts);
  if (options.describe)
    input.facts.insert(input.facts.begin(), {"kind", "points", {}});
  return {};
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
  if (options.describe)
    input.facts = factsOf(*scene);
  if (isOfPoints(*scene)) {
    auto opened = openPoints(path, *scene, options, input);
    return opened ? Expected<Input>(std::move(input)) : opened.error();
  }
  const Stopwatch binning;
  const auto shared = std::make_shared<const TriangleScene>(std::move(*scene));
  auto source = voxelize(shared, options);
  if (!source)
    return source.error();
  input.source = std::move(*source);
  input.binSeconds = binning.seconds();
  input.provenance = modelProvenance(kCoverageNames[static_cast<std::size_t>(options.coverage)],
                                     longestAxis(input.source->extent()), options);
  if (options.colour == ColourRule::Nearest)
    input.provenance += " colour=nearest";
  if (options.interior == Interior::Fill)
    if (auto filled = fill(*shared, options, input); !filled)
      return filled.error();
  return input;
}

} // namespace voxc
