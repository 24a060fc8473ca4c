// voxc export: the voxels of a volume as a file of another kind, the volume itself, stored otherwise, or a
// page that shows it.
#include "voxc/Source/Export.h"
#include "building/ColourLoss.h"
#include "common/Files.h"
#include "common/NumberedName.h"
#include "common/Statistics.h"
#include "common/Terminal.h"
#include "options/BuildArguments.h"
#include "options/BuildFigures.h"
#include "options/Figures.h"
#include "options/Outputs.h"
#include "options/VolumeArgument.h"
#include "program/Applications.h"
#include "voxc/Components/Components.h"
#include "voxc/Volume/CoarseBlocks.h"

#include <algorithm>
#include <bit>
#include <cstdio>
#include <optional>

namespace voxc::tool {

namespace {

class ExportCommand final : public Subcommand {
public:
  void declare(const CommandLine &command) override {
    volume_.declare(command);
    command.add("-o,--output", output_, "File to write; its ending says what: " + kinds())
        .takes("FILE")
        .required();
    command.addFlag("--lossy", options_.lossy,
                    "Of a .vox file: takes the 255 colours that stand best for those of the volume, rather "
                    "than to fail; the errors are reported");
    command
        .add("--slices", slices_,
             "Of .png pictures, the plane that they lie in: z (default), y or x, one for each cell along "
             "that axis; or of a scan, by its own axes: axial, coronal, sagittal")
        .takes("PLANE")
        .oneOf({kEnumNames<SlicePlane>.begin(), kEnumNames<SlicePlane>.end()});
    command.addFlag("--texture", options_.texture,
                    "Of a .glb file: colours in a texture, with fewer and larger faces that meet without "
                    "gaps, rather than one a vertex");
    addCompressArgument(command, options_.save.compress);
    if (page_)
      page_->declare(command);
    command
        .add("--page-bytes", pageBytes_,
             "Bytes of a page of a compressed volume, a power of two from 4KiB to 1MiB: small ones are read "
             "for less, large ones take fewer bytes")
        .takes("SIZE")
        .check(sizeProblem)
        .needs(command.option("--compress"))
        .showsDefault();
    command
        .add("--coarse", coarseSide_,
             "Keep the mean colours of blocks of so many voxels a side beside the words of a .hvx file, for "
             "render --allow-coarse: 4, 8, 16 or 32")
        .takes("N")
        .oneOf({"4", "8", "16", "32"})
        .needs(command.option("--compress"));
    addCommonOptions(command, common_);
  }

  Expected<void> run() override {
    VOXC_TRY(checkOutputFile(output_));
    VOXC_TRY(page_ ? page_->check(output_) : Expected<void>());
    if (hasEnding(output_, ".hvx"))
      VOXC_TRY(volume_.leaveOtherFrames(output_, common_));
    Expected<Volume> volume = volume_.load();
    if (!volume)
      return volume.error();
    volume_.noteLostStreams(*volume, common_);
    ProgressBar bar(common_.quiet);
    const Stopwatch watch;
    Json figures;
    options_.save.progress = bar.progress();
    if (!coarseSide_.empty())
      volume = withCoarse(std::move(*volume), figures);
    if (!volume)
      return volume.error();
    VOXC_TRY(write(*volume, figures));
    addVolumeFigures(figures, *volume);
    figures["export_seconds"] = watch.seconds();
    if (figures.value("files_written", 1) == 1)
      addFileFigure(figures, numbered_ ? (*numbered_)(0) : output_);
    for (std::uint64_t number = 0; number < files_; ++number)
      addWritten(figures, numbered_ ? (*numbered_)(number) : output_);
    bar.clear();
    if (!common_.quiet)
      tellSize(figures, *volume);
    return tellFigures(common_, figures);
  }

private:
  static std::string kinds() {
    std::string text;
    for (const ExportFormat &format : exportFormats())
      text += std::string(format.ending) + ", " + std::string(format.holds) + "; ";
    if (makePageWriter())
      return text + "or .html, a page that shows it in a browser, with the words and the kernel in it";
    return text.substr(0, text.size() - 2);
  }

  Expected<void> write(const Volume &volume, Json &figures) {
    const bool isVox = hasEnding(output_, ".vox");
    const bool isPicture = hasEnding(output_, ".png");
    if (!slices_.empty() && !isPicture)
      return Error::usage("--slices is for pictures, whose name ends in .png");
    options_.slices = fromString<SlicePlane>(slices_).value_or(SlicePlane::Z);
    if (isVox || isPicture)
      numbered_ = parseNumberedName(output_);
    if (options_.lossy && !isVox)
      return Error::usage("--lossy is for a file that ends in .vox; every other kind keeps all colours");
    if (options_.lossy && hasLabels(volume.format()))
      return Error::usage(
          "--lossy chooses colours, but the voxels have labels, which a .vox file keeps as they "
          "are; leave it out");
    if (page_ && page_->isPage(output_)) {
      if (options_.save.compress)
        return Error::usage(
            "--compress is for a file that ends in .hvx; the words of a page are always compressed");
      if (options_.texture)
        return Error::usage("--texture is for a file that ends in .glb; a page shows each voxel's colour");
      return page_->write(volume, volume_.path(), output_, options_.save.progress, figures);
    }
    options_.save.pageBytes = std::uint32_t(std::min<std::uint64_t>(bytesOf(pageBytes_), ~0u));
    options_.otherKinds = componentExports();
    const auto exported =
        VOXC_TRY(exportVoxels(volume, numbered_ ? asPercent(*numbered_) : output_, options_));
    tell(exported, figures);
    return {};
  }

  /// The volume with the blocks that were asked for, if it is to be a file that may have some.
  Expected<Volume> withCoarse(Volume volume, Json &figures) const {
    if (!hasEnding(output_, ".hvx"))
      return volume; // Which is not compressed: an error that is told.
    const auto side = unsigned(std::stoul(coarseSide_));
    auto blocks = VOXC_TRY(makeCoarseBlocks(volume, std::countr_zero(side), options_.save.progress));
    figures["coarse_side"] = side;
    figures["coarse_blocks"] = blocks.blocks.size();
    return withCoarseBlocks(std::make_shared<const Volume>(std::move(volume)), std::move(blocks));
  }

  void tell(const Exported &exported, Json &figures) {
    files_ = exported.files;
    for (const std::string &warning : exported.warnings)
      if (!common_.quiet)
        printNote("warning: " + warning);
    if (exported.files != 1)
      figures["files_written"] = exported.files;
    if (exported.rectangles != 0)
      figures["rectangles"] = exported.rectangles;
    if (!exported.loss)
      return;
    figures["colour_error"] = errorFigures(*exported.loss);
    if (!common_.quiet)
      printNote("note: 255 colours stand for those of the volume: " + errorText(*exported.loss));
  }

  /// Of a surface that other programs will hardly open, for it has each face of each voxel that is seen.
  void tellSize(const Json &figures, const Volume &volume) const {
    constexpr double kMuch = 100e6, kMega = 1e6;
    const double bytes = figures.value("file_bytes", 0.0);
    if (bytes < kMuch || !hasEnding(output_, ".glb"))
      return;
    char text[256];
    std::snprintf(text, sizeof text,
                  "warning: %.0f MB of faces; a volume of half the resolution has about a quarter of them, "
                  "and -o NAME.hvx --compress keeps all voxels in less than %.1f MB",
                  bytes / kMega, std::max(double(volume.words().size_bytes()) / kMega, 0.1));
    printNote(text);
  }

  VolumeArgument volume_;
  std::string output_;
  ExportOptions options_;
  std::unique_ptr<PageWriter> page_ = makePageWriter();
  std::string pageBytes_ = "256KiB";
  std::string coarseSide_;               ///< Empty: none.
  std::string slices_;                   ///< Empty: the default.
  std::optional<NumberedPath> numbered_; ///< If there may be several files.
  std::uint64_t files_ = 1;
  CommonOptions common_;
};

} // namespace

std::unique_ptr<Subcommand> makeExportCommand() { return std::make_unique<ExportCommand>(); }

} // namespace voxc::tool
