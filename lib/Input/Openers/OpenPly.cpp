// Opening PLY files: a mesh if they have faces, else points.
#include "Input/Openers/Openers.h"

#include "Input/Openers/InputText.h"
#include "Input/Points/PointSource.h"
#include "Mesh/Ply/PlyReader.h"
#include "voxc/Support/Stopwatch.h"

#include <utility>

namespace voxc {

Expected<Input> openPly(const std::string &path, const InputOptions &options) {
  const Stopwatch loading;
  auto reader = VOXC_TRY(PlyReader::open(path));
  if (hasFaces(reader.header())) {
    Expected<Input> mesh = openMesh(path, options);
    if (mesh && options.describe)
      mesh->facts.insert(mesh->facts.begin(), {"kind", "a mesh", {}});
    return mesh;
  }
  const auto side = VOXC_TRY(voxelSide(options, 0));
  auto points = VOXC_TRY(readPoints(reader, options));
  Input input;
  input.source = std::move(points.source);
  input.loadSeconds = loading.seconds();
  input.provenance = points.areIndices
                         ? std::string("coverage=indices")
                         : modelProvenance("points", longestAxis(input.source->extent()), options) +
                               gridProvenance(side, options);
  input.warnings = std::move(points.warnings);
  input.facts = std::move(points.facts);
  if (options.describe)
    input.facts.insert(input.facts.begin(), {"kind", "points", {}});
  return input;
}

} // namespace voxc
