// voxc export: the voxels of a volume as a dense grid, points or MagicaVoxel.
#include "Figures.h"
#include "Outputs.h"
#include "Subcommand.h"
#include "VolumeArgument.h"

#include "common/Statistics.h"
#include "common/Terminal.h"
#include "voxc/Source/Export.h"

namespace voxc::tool {

namespace {

class ExportCommand final : public Subcommand {
public:
  void declare(CLI::App &app) override {
    volume_.declare(app);
    app.add_option("-o,--output", output_, "File to write; its ending says what: .raw, .ply or .vox")
        ->type_name("FILE")
        ->required();
    addCommonOptions(app, common_);
  }

  Expected<void> run() override {
    if (Expected<void> writable = checkOutputFile(output_); !writable)
      return writable;
    Expected<Volume> volume = volume_.load();
    if (!volume)
      return volume.error();
    ProgressBar bar(common_.quiet);
    const Stopwatch watch;
    if (Expected<void> exported = exportVoxels(*volume, output_, bar.progress()); !exported)
      return exported;
    Json figures;
    addVolumeFigures(figures, *volume);
    figures["export_seconds"] = watch.seconds();
    return tellFigures(common_, figures);
  }

private:
  VolumeArgument volume_;
  std::string output_;
  CommonOptions common_;
};

} // namespace

std::unique_ptr<Subcommand> makeExportCommand() { return std::make_unique<ExportCommand>(); }

} // namespace voxc::tool
