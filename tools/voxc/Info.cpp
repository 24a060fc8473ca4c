// voxc info: what a volume says of itself.
#include "Figures.h"
#include "Subcommand.h"
#include "VolumeArgument.h"

#include "common/Statistics.h"
#include "voxc/Layout/PaletteBlocks.h"
#include "voxc/Support/Stopwatch.h"
#include "voxc/Volume/PagedVolume.h"

#include <cinttypes>
#include <cstdio>

namespace voxc::tool {

namespace {

std::uint64_t storedBytes(const Volume &volume) {
  std::uint64_t bytes = 0;
  for (const Stream &stream : volume.streams())
    bytes += stream.storedBytes;
  return bytes;
}

void print(const Volume &volume) {
  const VolumeInfo &info = volume.info();
  const std::uint64_t stored = storedBytes(volume);
  const double bytes = double(volume.bytes());
  std::printf("%s", printIr(info.format).c_str());
  std::printf("extent      %d x %d x %d voxels, in a format of %d x %d x %d\n", info.extent.x, info.extent.y,
              info.extent.z, info.format.extent().x, info.format.extent().y, info.format.extent().z);
  std::printf("voxels      %" PRIu64 "\n", info.voxels);
  std::printf("bytes       %" PRIu64 " (%.2f MiB, %.2f a voxel)\n", volume.bytes(), bytes / (1 << 20),
              info.voxels ? bytes / double(info.voxels) : 0.0);
  if (stored < volume.bytes())
    std::printf("stored      %" PRIu64 " (%.2f MiB, %.1f %%), compressed in pages\n", stored,
                double(stored) / (1 << 20), 100 * double(stored) / bytes);
  if (volume.layout().values == Values::Apart && info.voxels > 0) {
    const WordReader words(volume.words(), volume.layout().log2Granule);
    const std::uint64_t section = words.wordOf(words[1]);
    const double valueBytes = 4.0 * double(words.size() - section);
    std::printf("of these    %.3f a voxel for the shape, %.3f for values apart\n",
                (bytes - valueBytes) / double(info.voxels), valueBytes / double(info.voxels));
    const std::uint64_t few = paletteColours(words, section);
    if (volume.layout().payload == Payload::Palette)
      std::printf("colours     %" PRIu64 " in the palette\n", few);
    if (volume.layout().payload == Payload::Material)
      std::printf("labels      %" PRIu64 "\n", few);
  }
  for (const Stream &stream : volume.streams())
    std::printf("stream      %s: %zu bytes, %" PRIu64 " elements of %" PRIu32 "\n", stream.name.c_str(),
                stream.bytes.size(), stream.elements(), stream.elementBytes);
  std::printf("made with   %s\n", info.provenance.empty() ? "(not told)" : info.provenance.c_str());
  std::printf("to model   ");
  for (const double entry : rowsOf(info.voxelToModel))
    std::printf(" %g", entry);
  std::printf("\n");
}

/// What a compressed file has in place of streams as they are.
void printPages(const PagedVolume &file) {
  for (const PagedStream &stream : file.streams())
    std::printf("pages       %s: %" PRIu64 " of %" PRIu32 " bytes\n", stream.name.c_str(), stream.pages(),
                stream.pageBytes);
}

Json figuresOf(std::span<const PagedStream> streams) {
  Json figures = Json::array();
  for (const PagedStream &stream : streams)
    figures.push_back({{"name", stream.name}, {"page_bytes", stream.pageBytes}, {"pages", stream.pages()}});
  return figures;
}

Json figuresOf(std::span<const Stream> streams) {
  Json figures = Json::array();
  for (const Stream &stream : streams)
    figures.push_back({{"name", stream.name},
                       {"element_bytes", stream.elementBytes},
                       {"elements", stream.elements()},
                       {"bytes", stream.bytes.size()},
                       {"stored_bytes", stream.storedBytes}});
  return figures;
}

class InfoCommand final : public Subcommand {
public:
  void declare(CLI::App &app) override {
    volume_.declare(app);
    addCommonOptions(app, common_);
  }

  Expected<void> run() override {
    const Stopwatch watch;
    Expected<Volume> volume = volume_.load();
    if (!volume)
      return volume.error();
    const double loadSeconds = watch.seconds();
    const Expected<PagedVolume> pages = PagedVolume::open(volume_.path());
    if (tellsOnStdout(common_)) {
      print(*volume);
      if (pages)
        printPages(*pages);
    }
    Json figures;
    addVolumeFigures(figures, *volume);
    figures["load_seconds"] = loadSeconds;
    figures["stored_bytes"] = storedBytes(*volume);
    figures["streams"] = figuresOf(volume->streams());
    if (pages)
      figures["pages"] = figuresOf(pages->streams());
    figures["ir"] = printIr(volume->format());
    figures["provenance"] = volume->info().provenance;
    figures["voxel_to_model"] = rowsOf(volume->info().voxelToModel);
    return writeStatistics(common_.stats, figures);
  }

private:
  VolumeArgument volume_;
  CommonOptions common_;
};

} // namespace

std::unique_ptr<Subcommand> makeInfoCommand() { return std::make_unique<InfoCommand>(); }

} // namespace voxc::tool
