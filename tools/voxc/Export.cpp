// voxc export: the voxels of a volume as a dense grid, points or MagicaVoxel, the volume itself, stored
// otherwise, or a page that shows it.
#include "BuildArguments.h"
#include "Building.h"
#include "Figures.h"
#include "Outputs.h"
#include "PageExport.h"
#include "Subcommand.h"
#include "VolumeArgument.h"

#include "common/Statistics.h"
#include "common/Terminal.h"
#include "voxc/Source/Export.h"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace voxc::tool {

namespace {

class ExportCommand final : public Subcommand {
public:
  void declare(CLI::App &app) override {
    volume_.declare(app);
    app.add_option("-o,--output", output_,
                   "File to write; its ending says what: .raw, .ply, .vox, .hvx for the volume itself, or "
                   ".html for a "
                   "page that shows it in a browser, with the words and the kernel in it")
        ->type_name("FILE")
        ->required();
    addCompressArgument(app, compress_);
    page_.declare(app);
    app.add_option(
           "--page-bytes", pageBytes_,
           "Bytes of a page of a compressed volume, a power of two from 4KiB to 1MiB: small ones are read "
           "for less, large ones take fewer bytes")
        ->type_name("SIZE")
        ->check(sizeCheck())
        ->needs(app.get_option("--compress"))
        ->capture_default_str();
    addCommonOptions(app, common_);
  }

  Expected<void> run() override {
    if (Expected<void> writable = checkOutputFile(output_); !writable)
      return writable;
    if (Expected<void> checked = page_.check(output_); !checked)
      return checked;
    Expected<Volume> volume = volume_.load();
    if (!volume)
      return volume.error();
    ProgressBar bar(common_.quiet);
    const Stopwatch watch;
    Json figures;
    if (Expected<void> exported = write(*volume, bar.progress(), figures); !exported)
      return exported;
    addVolumeFigures(figures, *volume);
    figures["export_seconds"] = watch.seconds();
    addFileFigure(figures, output_);
    addWritten(figures, output_);
    return tellFigures(common_, figures);
  }

private:
  Expected<void> write(const Volume &volume, const Progress &progress, Json &figures) {
    if (!isPage(output_))
      return exportVoxels(volume, output_,
                          {.compress = compress_,
                           .pageBytes = std::uint32_t(std::min<std::uint64_t>(bytesOf(pageBytes_), ~0u)),
                           .progress = progress});
    if (compress_)
      return Error::usage(
          "--compress is for a file that ends in .hvx; the words of a page are always compressed");
    return page_.write(volume, volume_.path(), output_, progress, figures);
  }

  VolumeArgument volume_;
  std::string output_;
  bool compress_ = false;
  PageExport page_;
  std::string pageBytes_ = "256KiB";
  CommonOptions common_;
};

} // namespace

std::unique_ptr<Subcommand> makeExportCommand() { return std::make_unique<ExportCommand>(); }

} // namespace voxc::tool
