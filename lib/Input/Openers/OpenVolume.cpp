// Opening finished volumes, to convert them.
#include "Input/Openers/Openers.h"

#include "voxc/Source/Sources.h"
#include "voxc/Support/Stopwatch.h"
#include "voxc/Volume/Frames.h"

#include <utility>

namespace voxc {

Expected<Input> openVolume(const std::string &path, const InputOptions &options) {
  const Stopwatch loading;
  const auto named = VOXC_TRY(parseFramePath(path));
  LoadOptions loadOptions;
  loadOptions.memory = options.memory;
  loadOptions.frame = named.frame;
  auto volume = VOXC_TRY(Volume::load(named.path, loadOptions));
  Input input;
  if (const std::size_t frames = framesOf(volume).size(); frames > 1) {
    input.frames = frames;
    if (!options.boxOfAllFrames)
      input.warnings.push_back(
          "it has " + std::to_string(frames) +
          " frames; the first is taken, and another by a number behind the name, as in scene.hvx#" +
          std::to_string(frames));
  }
  input.provenance = volume.info().provenance;
  input.source = makeVolumeSource(std::make_shared<const Volume>(std::move(volume)));
  input.loadSeconds = loading.seconds();
  return input;
}

} // namespace voxc
