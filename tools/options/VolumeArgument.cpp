// Loading volumes for the driver.
#include "options/VolumeArgument.h"

#include "common/Interrupt.h"
#include "common/UserCache.h"
#include "voxc/Construct/EditJournal.h"
#include "voxc/Input/NumberedPaths.h"

#include <filesystem>

namespace voxc::tool {

Error volumeFailure(Error error) {
  if (error.message.ends_with("is not a .hvx volume"))
    error.message += "; 'voxc build' makes a volume of another input, and 'voxc run' a picture";
  return error;
}

void VolumeArgument::declare(const CommandLine &command, const std::string &help) {
  command.add("VOLUME", path_, help).required().takes("");
  command.addFlag("--trusted", trusted_, "Skip the walk that proves every offset, for a file of one's own");
  command
      .add(
          "--max-cubes", mostCubes_,
          "Most uniform cubes of voxels that checks and exports decode; a small file may stand for very many")
      .takes("N")
      .between(std::uint64_t{1}, std::uint64_t{1} << 62)
      .showsDefault();
}

void VolumeArgument::declareKernelOptions(const CommandLine &command) {
  attributes_.declare(command);
  walkPasses_.declare(command, PassChoice::WalkOnly);
}

template <typename Load> Expected<Volume> VolumeArgument::loadBy(const Load &load) const {
  LoadOptions options{.trusted = trusted_, .mostCubes = mostCubes_};
  options.progress.stop = &catchInterrupts();
  std::error_code ignored;
  if (!std::filesystem::exists(path_, ignored) && namesFiles(path_))
    return volumeFailure(Error::input("'" + path_ + "' is not a .hvx volume"));
  Expected<Volume> volume = load(options);
  return volume ? std::move(volume) : volumeFailure(volume.error());
}

Expected<Volume> VolumeArgument::load() const {
  return loadBy([this](const LoadOptions &options) { return loadEdited(path_, options, compileCache()); });
}

Expected<Volume> VolumeArgument::loadFile() const {
  return loadBy([this](LoadOptions options) {
    options.withoutJournal = true;
    return Volume::load(path_, options);
  });
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
