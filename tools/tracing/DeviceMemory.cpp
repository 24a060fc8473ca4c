// Tracing a page file within a budget of memory.
#include "tracing/DeviceMemory.h"

#include "common/Statistics.h"
#include "options/BuildArguments.h"
#include "options/VolumeArgument.h"

namespace voxc::tool {

void DeviceMemory::declare(const CommandLine &command) {
  const OptionGroup group(command, "Device");
  command
      .add("--device-memory", budget_,
           "Trace a volume that was stored with --compress in so much memory, such as 128MiB: its pages are "
           "read when rays need them, and hits are the same")
      .takes("SIZE")
      .check(sizeProblem);
}

void DeviceMemory::declareCoarse(const CommandLine &command) {
  const OptionGroup group(command, "Device");
  command
      .add("--allow-coarse", coarse_,
           "Let a block of voxels that looks smaller than so many pixels stand in for its pages, by its mean "
           "colour, if these are not there; the volume was stored with --coarse. 0: hits are the same")
      .takes("PIXELS")
      .between(0.0, 1e6)
      .needs(command.option("--device-memory"));
}

Expected<Volume> DeviceMemory::open(const std::string &path, int frame, Json &figures) {
  auto opened = PagedVolume::open(path);
  if (!opened)
    return volumeFailure(opened.error());
  if (frame > 0)
    VOXC_TRY(opened->chooseFrame(frame));
  volume_.emplace(std::move(*opened));
  const PagedStream &words = volume_->streams().front();
  Volume outline(volume_->info(), std::vector<std::uint32_t>(2));
  addVolumeFigures(figures, outline);
  figures["bytes"] = words.bytes;
  figures["words"] = words.bytes / sizeof(std::uint32_t);
  return outline;
}

Expected<void> DeviceMemory::prepare(TraceSession &tracing, const Format &format, Json &figures,
                                     PagingOptions options) const {
  options.memoryBytes = bytesOf(budget_);
  options.coarse = coarse_.has_value();
  return tracing.preparePages(*volume_, format, std::move(options), figures);
}

std::shared_ptr<PageShelf> DeviceMemory::makeShelf() const {
  return std::make_shared<PageShelf>(bytesOf(budget_) / 2);
}

} // namespace voxc::tool
