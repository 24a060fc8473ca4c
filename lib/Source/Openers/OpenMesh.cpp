// Opening triangle meshes.
#include "Source/Openers/Openers.h"

#include "Source/Openers/InputText.h"
#include "voxc/Mesh/Voxelizer.h"
#include "voxc/Support/Stopwatch.h"

#include <utility>

namespace voxc {

Expected<Input> openMesh(const std::string &path, const InputOptions &options) {
  const Stopwatch loading;
  auto mesh = loadMesh(path);
  if (!mesh)
    return mesh.error();
  Input input;
  input.loadSeconds = loading.seconds();
  input.triangles = mesh->triangles.size();
  input.warnings = std::move(mesh->warnings);
  const Stopwatch voxelizing;
  auto source = voxelize(
      *mesh, {options.resolution, options.formatExtent, options.bounds, options.zUp, options.progress});
  if (!source)
    return source.error();
  input.source = std::move(*source);
  input.voxelizeSeconds = voxelizing.seconds();
  input.provenance = modelProvenance("conservative", longestAxis(input.source->extent()), options);
  return input;
}

} // namespace voxc
