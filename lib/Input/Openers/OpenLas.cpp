// Opening points of laser scans (.las).
#include "Input/Openers/Openers.h"

#include "Input/Las/LasFile.h"
#include "Input/Openers/InputText.h"
#include "Input/Points/PointSource.h"
#include "Support/WatchedFile.h"
#include "voxc/Support/Stopwatch.h"

#include <utility>

namespace voxc {

Expected<Input> openLas(const std::string &path, const InputOptions &given) {
  const Stopwatch loading;
  const auto side = VOXC_TRY(voxelSide(given, 0));
  // The format says so: z is the height.
  InputOptions options = given;
  options.zUp |= options.isAutomatic && !options.isUpKnown;
  const auto file = VOXC_TRY(WatchedFile::open(path, options.memory));
  const auto broken = [&](const std::string &what) {
    return Error::input("'" + path + "' is not a usable LAS file: " + what);
  };
  const auto header = readLasHeader(file->bytes());
  if (!header)
    return broken(header.error().message);
  const auto points = VOXC_TRY(readLasPoints(*header, *options.memory, options.progress));
  auto voxels = VOXC_TRY(placePoints(*points, false, options, broken));
  Input input;
  input.source = std::move(voxels.source);
  input.provenance =
      modelProvenance("points", longestAxis(input.source->extent()), options) + gridProvenance(side, options);
  input.warnings = std::move(voxels.warnings);
  for (std::string &warning : points->warnings())
    input.warnings.push_back(std::move(warning));
  input.facts = std::move(voxels.facts);
  input.loadSeconds = loading.seconds();
  return input;
}

} // namespace voxc
