// Opening triangle meshes.
#include "Input/Openers/Openers.h"

#include "Input/Openers/InputText.h"
#include "Input/Openers/MeshFacts.h"
#include "Input/Openers/MeshWords.h"
#include "Input/Points/PointSource.h"
#include "Input/Points/ScenePoints.h"
#include "Support/Text.h"
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
  VoxelizeOptions voxelizing{options.resolution, modelExtent(options), options.bounds,  options.zUp,
                             options.coverage,   options.regions,      options.progress};
  voxelizing.voxelSize = options.voxelSize.value;
  voxelizing.align = options.align;
  // What is no colour has no mean in linear light.
  const bool areNumbers = options.materialWords == MaterialWords::MetallicRoughness ||
                          options.materialWords == MaterialWords::EmissionStrength;
  voxelizing.colour = areNumbers ? ColourRule::Nearest : options.colour;
  return voxelizing;
}

/// Metres of a step of 1, where the kind of file says so: glTF is in metres.
double unitOf(const std::string &path) {
  const std::string name = lowerCase(path);
  return name.ends_with(".glb") || name.ends_with(".gltf") ? 1 : 0;
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

std::string percent(double share) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.2g %%", 100 * share);
  return text.data();
}

constexpr const char *kByParity = "inside is what a ray enters an odd number of times";

/// What is wrong with a mesh that is not closed, or whose triangles face both ways.
std::string complaintOf(const SolidMesh &solid) {
  const OpenEdges &open = solid.open;
  const std::string where = (open.isAll ? ": " : ": at least ") + std::to_string(open.count) +
                            " edges lack a counterpart, one from " + placeOf(open.from) + " to " +
                            placeOf(open.to) + "; ";
  if (solid.holes != 0) {
    const std::string holes =
        solid.holes == 1 ? "its hole is closed by a fan that has "
                         : "its " + std::to_string(solid.holes) + " holes are closed by fans that have ";
    return "the mesh is not closed" + where + holes + percent(solid.holeShare) + " of its area (at most " +
           percent(kMostHoles) + " may be closed), and " +
           (solid.rule == SolidRule::Winding && !solid.isDoubleSided ? "inside is what it then winds around"
                                                                     : kByParity);
  }
  if (solid.rule == SolidRule::Parity)
    return "the triangles of the mesh do not all face the same way" + where + kByParity;
  return "the mesh is not closed" + where +
         (solid.isDoubleSided ? "inside is what its closed double-sided parts hold"
                              : "inside is what its voxels enclose") +
         ", as to close its holes takes more than " + percent(kMostHoles) + " of its area";
}

/// Makes the inside of the mesh voxels; by its cells' centres, if that is the rule.
Expected<void> fill(const TriangleScene &scene, const InputOptions &options, Input &input) {
  const Stopwatch filling;
  const auto make = options.coverage == Coverage::Centre ? centreMesh : fillMesh;
  auto solid = VOXC_TRY(make(scene, voxelizeOptions(options), std::move(input.source), options.fillWord,
                             {options.memory, options.threads, options.progress}));
  input.source = std::move(solid.source);
  input.interior = Interior::Fill;
  input.interiorVoxels = solid.voxels;
  input.interiorSeconds = filling.seconds();
  if (solid.open.count != 0)
    input.warnings.push_back(complaintOf(solid));
  if (solid.isDoubleSided)
    input.notes.push_back("triangles lie on others that face the other way; of these, one of each two says "
                          "what is inside, which a ray enters an odd number of times");
  return {};
}

/// A model of points alone is no surface: each point is one voxel, as in a .ply.
Expected<void> openPoints(const std::string &path, const TriangleScene &scene, const InputOptions &options,
                          double side, Input &input) {
  const auto points = VOXC_TRY(pointsOf(scene, options.memory, options.progress));
  auto voxels = placePoints(*points, false, options, [&](const std::string &what) {
    return Error::input("'" + path + "' has unusable points: " + what);
  });
  if (!voxels)
    return voxels.error();
  input.triangles = 0;
  input.source = std::move(voxels->source);
  input.provenance =
      modelProvenance("points", longestAxis(input.source->extent()), options) + gridProvenance(side, options);
  input.warnings.insert(input.warnings.end(), voxels->warnings.begin(), voxels->warnings.end());
  if (options.describe)
    input.facts = std::move(voxels->facts);
  if (options.describe)
    input.facts.insert(input.facts.begin(), {"kind", "points", {}});
  return {};
}

} // namespace

Expected<Input> openMesh(const std::string &path, const InputOptions &options) {
  const bool areMetal = options.materialWords == MaterialWords::MetallicRoughness;
  const auto load = [areMetal](const std::string &file, const std::shared_ptr<WorkingMemory> &memory,
                               const Progress &progress) {
    return loadScene(file, memory, progress, areMetal);
  };
  return openMeshBy(load, path, options);
}

Expected<Input> openMeshBy(const LoadScene &load, const std::string &path, const InputOptions &given) {
  const Stopwatch loading;
  InputOptions options = given;
  const auto side = VOXC_TRY(voxelSide(given, unitOf(path)));
  options.voxelSize = {side, 0};
  auto scene = VOXC_TRY(load(path, options.memory, options.progress));
  if (auto shown = showWords(scene, options.materialWords); !shown)
    return Error::input("'" + path + "': " + shown.error().message);
  Input input;
  input.words = options.materialWords;
  input.loadSeconds = loading.seconds();
  input.loaderPeakBytes = scene.loaderPeakBytes;
  input.triangles = triangleCount(scene);
  input.warnings = std::move(scene.warnings);
  input.files = std::move(scene.files);
  if (options.describe)
    input.facts = factsOf(scene);
  if (isOfPoints(scene)) {
    auto opened = openPoints(path, scene, options, side, input);
    return opened ? Expected<Input>(std::move(input)) : opened.error();
  }
  const Stopwatch binning;
  const auto shared = std::make_shared<const TriangleScene>(std::move(scene));
  input.source = VOXC_TRY(voxelize(shared, options));
  input.binSeconds = binning.seconds();
  input.provenance = modelProvenance(kCoverageNames[static_cast<std::size_t>(options.coverage)],
                                     longestAxis(input.source->extent()), options) +
                     gridProvenance(side, options);
  if (options.colour == ColourRule::Nearest)
    input.provenance += " colour=nearest";
  if (options.interior == Interior::Fill || options.coverage == Coverage::Centre)
    VOXC_TRY(fill(*shared, options, input));
  return input;
}

} // namespace voxc
