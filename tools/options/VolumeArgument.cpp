// Loading volumes for the driver.
#include "options/VolumeArgument.h"

#include "common/Interrupt.h"
#include "voxc/Input/NumberedPaths.h"
#include "voxc/Support/UserCache.h"
#include "voxc/Volume/CoarseBlocks.h"
#include "voxc/Volume/Stream.h"

#include <algorithm>
#include <filesystem>
#include <limits>

namespace voxc::tool {

Error volumeFailure(Error error) {
  if (error.message.ends_with("is not a .hvx volume"))
    error.message += "; 'voxc build' makes a volume of another input, and 'voxc run' a picture";
  return error;
}

void VolumeArgument::declare(const CommandLine &command, const std::string &help) {
  command.add("VOLUME", path_, help).required().takes("");
  command.add("--frame", frame_, "Which frame of a volume of several, from 1 on; as V.hvx#N")
      .takes("N")
      .between(1, std::numeric_limits<int>::max());
  command.addFlag("--trusted", trusted_, "Skip the check that proves every offset, for a file of one's own");
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
  traversalPasses_.declare(command, PassChoice::TraversalOnly);
}

Expected<int> VolumeArgument::frame() const {
  const auto named = VOXC_TRY(parseFramePath(path_));
  if (named.frame > 0 && frame_ > 0 && named.frame != frame_)
    return Error::usage("'" + path_ + "' names another frame than --frame " + std::to_string(frame_) +
                        "; give one of them");
  return named.frame > 0 ? named.frame : frame_;
}

Expected<LoadOptions> VolumeArgument::loadOptions() const {
  const auto frame = VOXC_TRY(this->frame());
  LoadOptions options{.trusted = trusted_, .frame = frame, .mostCubes = mostCubes_};
  options.progress.stop = &catchInterrupts();
  return options;
}

Expected<void> VolumeArgument::leaveOtherFrames(const std::string &output,
                                                const CommonOptions &common) const {
  const auto frame = VOXC_TRY(this->frame());
  if (frame == 0)
    return {};
  const auto summary = VOXC_TRY(summarizeVolume(path()));
  const auto stream = std::ranges::find(summary.streams, kFrameStream, &StreamSummary::name);
  if (stream == summary.streams.end() || stream->elements() < 2)
    return {};
  const std::string frames = std::to_string(stream->elements());
  std::error_code ignored;
  if (std::filesystem::equivalent(path(), output, ignored))
    return Error::usage("'" + path() + "' has " + frames + " frames, and would keep frame " +
                        std::to_string(frame) + " alone; give -o another file");
  if (!common.quiet)
    printNote("warning: only frame " + std::to_string(frame) + " of " + frames + " is written");
  return {};
}

SideStreams sideStreamsOf(const VolumeSummary &summary) {
  SideStreams found;
  for (const StreamSummary &stream : summary.streams) {
    const bool isCoarse = coarseSideOf(stream.name).has_value();
    found.coarseBlocks = found.coarseBlocks || isCoarse;
    found.attributes =
        found.attributes || (!isCoarse && stream.name != kWordStream && stream.name != kFrameStream);
  }
  return found;
}

void VolumeArgument::noteLostStreams(const Volume &loaded, const CommonOptions &common) const {
  if (common.quiet || loaded.streams().size() > 1 || checkNoJournal(path()))
    return;
  const auto summary = summarizeVolume(path());
  if (!summary)
    return;
  const SideStreams streams = sideStreamsOf(*summary);
  const std::string lost = streams.attributes && streams.coarseBlocks ? "attributes and coarse blocks"
                           : streams.attributes                       ? "attributes"
                                                                      : "coarse blocks";
  if (streams.attributes || streams.coarseBlocks)
    printNote("warning: the " + lost + " of '" + path() +
              "' are of its voxels before the edits in its journal, and are left out");
}

template <typename Load>
std::invoke_result_t<Load, LoadOptions> VolumeArgument::loadBy(std::shared_ptr<WorkingMemory> memory,
                                                               const Load &load) const {
  auto options = VOXC_TRY(loadOptions());
  options.memory = std::move(memory);
  std::error_code ignored;
  if (!std::filesystem::exists(path(), ignored) && namesFiles(path()))
    return volumeFailure(Error::input("'" + path() + "' is not a .hvx volume"));
  auto loaded = load(options);
  if (!loaded)
    return volumeFailure(loaded.error());
  return loaded;
}

Expected<Volume> VolumeArgument::load(std::shared_ptr<WorkingMemory> memory) const {
  return loadBy(std::move(memory),
                [this](const LoadOptions &options) { return loadEdited(path(), options, compileCache()); });
}

Expected<WaitingVolume> VolumeArgument::loadWaiting(std::shared_ptr<WorkingMemory> memory) const {
  return loadBy(std::move(memory),
                [this](const LoadOptions &options) { return voxc::loadWaiting(path(), options); });
}

Expected<Format> VolumeArgument::kernelFormat(const Volume &volume) const {
  Format format = volume.format();
  VOXC_TRY(traversalPasses_.apply(format));
  VOXC_TRY(attributes_.apply(format));
  return format;
}

} // namespace voxc::tool
