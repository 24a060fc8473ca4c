// Loading volumes for the driver.
#include "VolumeArgument.h"

#include "common/Interrupt.h"

#include <CLI/CLI.hpp>

namespace voxc::tool {

void VolumeArgument::declare(CLI::App &app) {
  app.add_option("VOLUME", path_, "A .hvx file")->required()->type_name("");
  app.add_flag("--trusted", trusted_, "Skip the walk that proves every offset, for a file of one's own");
  app.add_option(
         "--max-cubes", mostCubes_,
         "Most uniform cubes of voxels that checks and exports decode; a small file may stand for very many")
      ->type_name("N")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1} << 62).description(""))
      ->capture_default_str();
}

void VolumeArgument::declareKernelOptions(CLI::App &app) {
  attributes_.declare(app);
  walkPasses_.declare(app, PassChoice::WalkOnly);
}

Expected<Volume> VolumeArgument::load() const {
  LoadOptions options{.trusted = trusted_, .mostCubes = mostCubes_};
  options.progress.stop = &catchInterrupts();
  return Volume::load(path_, options);
}

Expected<Format> VolumeArgument::kernelFormat(const Volume &volume) const {
  Format format = volume.format();
  if (Expected<void> passed = walkPasses_.apply(format); !passed)
    return passed.error();
  if (Expected<void> applied = attributes_.apply(format); !applied)
    return applied.error();
  return format;
}

} // namespace voxc::tool
