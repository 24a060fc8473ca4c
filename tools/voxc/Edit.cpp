// voxc edit: replaces boxes of a volume, and builds only what they touch.
#include "BuildArguments.h"
#include "BuildFigures.h"
#include "Figures.h"
#include "InputArguments.h"
#include "Outputs.h"
#include "Subcommand.h"
#include "VolumeArgument.h"

#include "common/Statistics.h"
#include "common/Terminal.h"
#include "common/UserCache.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/Source/Edit.h"
#include "voxc/Support/Stopwatch.h"

#include <array>
#include <charconv>
#include <map>
#include <memory>
#include <optional>

namespace voxc::tool {

namespace {

/// Whole numbers with commas between; nothing if that is not what the text is.
template <std::size_t N> std::optional<std::array<std::int32_t, N>> parseInts(std::string_view text) {
  std::array<std::int32_t, N> values{};
  for (std::size_t i = 0; i < N; ++i) {
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), values[i]);
    text.remove_prefix(std::size_t(end - text.data()));
    if (failure != std::errc() || (i + 1 < N ? !text.starts_with(',') : !text.empty()))
      return std::nullopt;
    if (i + 1 < N)
      text.remove_prefix(1);
  }
  return values;
}

/// "X0,Y0,Z0,X1,Y1,Z1": voxels from the first place up to, and without, the second.
Expected<VoxelEdit> parseBox(const std::string &text) {
  const auto ends = parseInts<6>(text);
  if (!ends)
    return Error::usage("'" + text +
                        "' is no box; write X0,Y0,Z0,X1,Y1,Z1, the first voxel and the one behind the last");
  const auto &[x0, y0, z0, x1, y1, z1] = *ends;
  if (x1 < x0 || y1 < y0 || z1 < z0 || x0 < 0 || y0 < 0 || z0 < 0)
    return Error::usage("the box '" + text + "' begins behind its end, or below 0");
  return VoxelEdit{{x0, y0, z0}, {x1 - x0, y1 - y0, z1 - z0}, 0, nullptr};
}

Expected<VoxelEdit> parseClear(const std::string &text) { return parseBox(text); }

/// "BOX=COLOUR".
Expected<VoxelEdit> parseFill(const std::string &text) {
  const std::size_t equals = text.find('=');
  const auto colour = equals == std::string::npos ? std::nullopt : parseColour(text.substr(equals + 1));
  if (!colour || *colour == 0)
    return Error::usage("'" + text +
                        "' fills nothing; write X0,Y0,Z0,X1,Y1,Z1=RRGGBB, or --clear to empty a box");
  Expected<VoxelEdit> edit = parseBox(text.substr(0, equals));
  if (edit)
    edit->word = *colour;
  return edit;
}

/// "FILE.hvx@X,Y,Z".
Expected<VoxelEdit> parsePaste(const std::string &text) {
  const std::size_t at = text.rfind('@');
  const auto low =
      at == std::string::npos ? std::nullopt : parseInts<3>(std::string_view(text).substr(at + 1));
  if (!low)
    return Error::usage("'" + text + "' does not say where to; write FILE.hvx@X,Y,Z");
  Expected<Volume> volume = Volume::load(text.substr(0, at));
  if (!volume)
    return volume.error();
  const Int3 extent = volume->info().extent;
  return VoxelEdit{
      {(*low)[0], (*low)[1], (*low)[2]}, extent, 0, std::make_shared<const Volume>(std::move(*volume))};
}

/// The kinds of edits, each an option.
struct EditKind {
  const char *option;
  const char *type;
  const char *summary;
  Expected<VoxelEdit> (*parse)(const std::string &text);
};

constexpr EditKind kKinds[] = {
    {"--clear", "X0,Y0,Z0,X1,Y1,Z1", "Empties the voxels from the first place up to, and without, the second",
     parseClear},
    {"--fill", "BOX=RRGGBB", "Fills such a box with a colour", parseFill},
    {"--paste", "W.hvx@X,Y,Z",
     "Puts the voxels of another volume, from this place on; where it is empty nothing changes", parsePaste},
};

class EditCommand final : public Subcommand {
public:
  void declare(const CommandLine &command) override {
    command_ = command;
    volume_.declare(command);
    for (const EditKind &kind : kKinds)
      command
          .add(kind.option, written_[kind.option], std::string(kind.summary) + "; may be given several times")
          .takes(kind.type)
          .repeated();
    command.add("-o,--output", output_, "Volume to write; may be the one that is read")
        .takes("V.hvx")
        .required();
    addMemoryArguments(command, arguments_);
    addCompressArgument(command, arguments_.compress);
    addCommonOptions(command, common_);
  }

  Expected<void> run() override {
    if (Expected<void> writable = checkOutputFile(output_); !writable)
      return writable;
    Expected<Volume> loaded = volume_.load();
    if (!loaded)
      return loaded.error();
    const auto volume = std::make_shared<const Volume>(std::move(*loaded));
    if (volume->streams().size() > 1 && !common_.quiet)
      printNote("warning: what is edited has no attributes; voxc attach gives it new ones");
    Expected<std::vector<VoxelEdit>> edits = readEdits();
    if (!edits)
      return edits.error();
    ProgressBar bar(common_.quiet);
    Json figures;
    if (Expected<void> edited = edit(volume, *edits, bar.progress(), figures); !edited)
      return edited;
    bar.clear();
    return tellFigures(common_, figures);
  }

private:
  /// The edits in the order in which they were written.
  Expected<std::vector<VoxelEdit>> readEdits() const {
    std::vector<VoxelEdit> edits;
    std::map<std::string, std::size_t> used; // Of each option, how many of its values.
    for (const Option &option : command_->given())
      for (const EditKind &kind : kKinds)
        if (option.name() == kind.option) {
          Expected<VoxelEdit> edit = kind.parse(written_.at(kind.option)[used[kind.option]++]);
          if (!edit)
            return edit.error();
          edits.push_back(std::move(*edit));
        }
    if (edits.empty())
      return Error::usage("there is nothing to edit; give --clear, --fill or --paste");
    return edits;
  }

  Expected<void> edit(const std::shared_ptr<const Volume> &volume, const std::vector<VoxelEdit> &edits,
                      const Progress &progress, Json &figures) const {
    Expected<Constructor> constructor = Constructor::compile(volume->format(), compileCache());
    if (!constructor)
      return constructor.error();
    BuildOptions options;
    options.provenance = provenanceOf(*volume, edits.size());
    options.memory = makeWorkingMemory(arguments_);
    options.path = output_;
    options.compress = arguments_.compress;
    options.progress = progress;
    Expected<Built> built = constructor->edit(volume, edits, options);
    if (!built)
      return built.error();
    figures["edits"] = edits.size();
    addVolumeFigures(figures, built->volume);
    addBuildFigures(figures, built->report);
    addFileFigure(figures, output_);
    addWritten(figures, output_);
    return {};
  }

  /// What the volume was made of before, and how many edits there were since.
  static std::string provenanceOf(const Volume &volume, std::size_t edits) {
    const std::string &before = volume.info().provenance;
    return before + (before.empty() ? "" : " ") + "edits=" + std::to_string(edits);
  }

  std::optional<CommandLine> command_;
  std::map<std::string, std::vector<std::string>> written_; ///< What each option was given.
  VolumeArgument volume_;
  std::string output_;
  BuildArguments arguments_;
  CommonOptions common_;
};

} // namespace

std::unique_ptr<Subcommand> makeEditCommand() { return std::make_unique<EditCommand>(); }

} // namespace voxc::tool
