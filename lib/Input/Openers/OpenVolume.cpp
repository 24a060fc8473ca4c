// Opening finished volumes, to convert them.
#include "Input/Openers/Openers.h"

#include "voxc/Source/Sources.h"
#include "voxc/Support/Stopwatch.h"

#include <utility>

namespace voxc {

Expected<Input> openVolume(const std::string &path, const InputOptions &options) {
  const Stopwatch loading;
  auto volume = Volume::load(path, {.memory = options.memory});
  if (!volume)
    return volume.error();
  Input input;
  input.provenance = volume->info().provenance;
  input.source = makeVolumeSource(std::make_shared<const Volume>(std::move(*volume)));
  input.loadSeconds = loading.seconds();
  return input;
}

} // namespace voxc
