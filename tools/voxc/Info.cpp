// voxc info: what a volume says of itself.
#include "Figures.h"
#include "Subcommand.h"
#include "VolumeArgument.h"

#include "common/Statistics.h"

#include <cinttypes>
#include <cstdio>

namespace voxc::tool {

namespace {

void print(const Volume &volume) {
  const VolumeInfo &info = volume.info();
  const double bytes = 4.0 * double(volume.words().size());
  std::printf("%s", printIr(info.format).c_str());
  std::printf("extent      %d x %d x %d voxels, in a format of %d x %d x %d\n", info.extent.x, info.extent.y,
              info.extent.z, info.format.extent().x, info.format.extent().y, info.format.extent().z);
  std::printf("voxels      %" PRIu64 "\n", info.voxels);
  std::printf("words       %zu (%.2f MiB, %.2f bytes a voxel)\n", volume.words().size(), bytes / (1 << 20),
              info.voxels ? bytes / double(info.voxels) : 0.0);
  std::printf("made with   %s\n", info.provenance.empty() ? "(not told)" : info.provenance.c_str());
  std::printf("to model   ");
  for (const double entry : info.voxelToModel.rows)
    std::printf(" %g", entry);
  std::printf("\n");
}

class InfoCommand final : public Subcommand {
public:
  void declare(CLI::App &app) override {
    volume_.declare(app);
    addCommonOptions(app, common_);
  }

  Expected<void> run() override {
    Expected<Volume> volume = volume_.load();
    if (!volume)
      return volume.error();
    if (tellsOnStdout(common_))
      print(*volume);
    Json figures;
    addVolumeFigures(figures, *volume);
    figures["ir"] = printIr(volume->format());
    figures["provenance"] = volume->info().provenance;
    figures["voxel_to_model"] = volume->info().voxelToModel.rows;
    return writeStatistics(common_.stats, figures);
  }

private:
  VolumeArgument volume_;
  CommonOptions common_;
};

} // namespace

std::unique_ptr<Subcommand> makeInfoCommand() { return std::make_unique<InfoCommand>(); }

} // namespace voxc::tool
