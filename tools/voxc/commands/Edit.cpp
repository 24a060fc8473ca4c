// voxc edit: replaces boxes of a volume: in a journal beside it, or by a build of what they touch.
#include "voxc/Source/Edit.h"
#include "building/ColourLoss.h"
#include "common/Statistics.h"
#include "common/Terminal.h"
#include "options/BuildArguments.h"
#include "options/BuildFigures.h"
#include "options/Figures.h"
#include "options/InputArguments.h"
#include "options/Outputs.h"
#include "options/VolumeArgument.h"
#include "program/Subcommand.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/Construct/EditJournal.h"
#include "voxc/Layout/Values.h"
#include "voxc/Support/Stopwatch.h"
#include "voxc/Support/UserCache.h"
#include "voxc/Volume/VolumeSummary.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
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
    return Error::usage(
        "'" + text +
        "' fills nothing; write X0,Y0,Z0,X1,Y1,Z1=RRGGBB or =RRGGBBAA, or --clear to empty a box");
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
  const auto named = VOXC_TRY(parseFramePath(text.substr(0, at)));
  auto volume = VOXC_TRY(loadEdited(named.path, {.frame = named.frame}, compileCache()));
  const Int3 extent = volume.info().extent;
  return VoxelEdit{
      {(*low)[0], (*low)[1], (*low)[2]}, extent, 0, std::make_shared<const Volume>(std::move(volume))};
}

/// True if an edit brings colours that a volume keeps in place of others.
bool isRounded(const VoxelEdit &edit, const Rounding &rounding) {
  if (!edit.pasted)
    return edit.word != 0 && rounding(edit.word) != edit.word;
  bool rounds = false;
  (void)decode(*edit.pasted, [&](const Cube &, std::uint32_t word) {
    rounds = rounding(word) != word;
    return !rounds; // It ends early then, as if it were interrupted.
  });
  return rounds;
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
    {"--fill", "BOX=RRGGBB",
     "Fills such a box with a colour, of 6 digits or 8 (RRGGBBAA); 05000000 is label 5 of a volume of labels",
     parseFill},
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
    const Option output =
        command.add("-o,--output", output_, "Volume to write; may be the one that is read").takes("V.hvx");
    const Option journal =
        command
            .addFlag(
                "--journal", journal_,
                "Add the edits to the journal beside the volume in place of writing a file: at once on the "
                "disk, and part of the volume for every command")
            .excludes(output);
    command
        .addFlag("--compact", compact_,
                 "Write the volume with all edits of its journal, and others if there are any")
        .needs(output);
    addMemoryArguments(command, arguments_);
    addCompressArgument(command, arguments_.compress);
    command.option("--compress").excludes(journal);
    addCommonOptions(command, common_);
  }

  Expected<void> run() override {
    if (!journal_ && output_.empty())
      return Error::usage("it is not said where the edits go; give -o V.hvx, or --journal");
    auto edits = VOXC_TRY(readEdits());
    if (edits.empty() && !compact_)
      return Error::usage("there is nothing to edit; give --clear, --fill or --paste");
    if (!common_.quiet)
      noteEmptyBoxes(edits);
    return journal_ ? addToJournal(edits) : writeVolume(std::move(edits));
  }

private:
  /// The edits in the order in which they were written.
  Expected<std::vector<VoxelEdit>> readEdits() const {
    std::vector<VoxelEdit> edits;
    std::map<std::string, std::size_t> used; // Of each option, how many of its values.
    for (const Option &option : command_->given())
      for (const EditKind &kind : kKinds)
        if (option.name() == kind.option) {
          auto edit = VOXC_TRY(kind.parse(written_.at(kind.option)[used[kind.option]++]));
          edits.push_back(std::move(edit));
        }
    return edits;
  }

  static void noteEmptyBoxes(const std::vector<VoxelEdit> &edits) {
    for (std::size_t i = 0; i < edits.size(); ++i)
      if (const Int3 &size = edits[i].size; size.x == 0 || size.y == 0 || size.z == 0)
        printNote("warning: edit " + std::to_string(i + 1) +
                  " is of a box without voxels, and changes nothing");
  }

  Expected<void> addToJournal(const std::vector<VoxelEdit> &edits) {
    Expected<EditJournal> journal = EditJournal::open(volume_.path());
    if (!journal)
      return volumeFailure(journal.error());
    auto options = VOXC_TRY(volume_.loadOptions());
    options.memory = makeWorkingMemory(arguments_);
    VOXC_TRY(journal->append(edits, options, compileCache()));
    if (!common_.quiet)
      VOXC_TRY(noteWhatIsLost(edits, journal->volume().format));
    Json figures;
    figures["edits"] = edits.size();
    figures["transactions"] = journal->transactions();
    addWritten(figures, journalPathOf(volume_.path()));
    return tellFigures(common_, figures);
  }

  /// What a reader of the journal will make otherwise of the volume or of the edits.
  Expected<void> noteWhatIsLost(const std::vector<VoxelEdit> &edits, const Format &format) const {
    VOXC_TRY(noteLostStreams());
    const Rounding rounding = roundingOf(layoutOf(format).payload);
    for (std::size_t i = 0; rounding && i < edits.size(); ++i)
      if (isRounded(edits[i], rounding))
        printNote("lossy: edit " + std::to_string(i + 1) +
                  " has colours that the format rounds; --compact tells by how much");
    return {};
  }

  Expected<void> noteLostStreams() const {
    const auto summary = VOXC_TRY(summarizeVolume(volume_.path()));
    const SideStreams streams = sideStreamsOf(summary);
    if (streams.attributes)
      printNote("warning: what is edited has no attributes; voxc attach gives it new ones");
    if (streams.coarseBlocks)
      printNote(
          "warning: what is edited has no coarse blocks; voxc export --compress --coarse makes new ones");
    return {};
  }

  Expected<void> writeVolume(std::vector<VoxelEdit> edits) {
    std::optional<EditJournal> journal; // Held, so that no edit comes to it meanwhile.
    const Expected<bool> isReplaced = replaces();
    if (!isReplaced)
      return volumeFailure(isReplaced.error());
    if (!*isReplaced) {
      VOXC_TRY(checkOutputFile(output_));
    } else {
      Expected<EditJournal> opened = EditJournal::open(volume_.path());
      if (!opened)
        return volumeFailure(opened.error());
      journal.emplace(std::move(*opened));
    }
    const auto memory = makeWorkingMemory(arguments_);
    auto [loaded, waiting] = VOXC_TRY(volume_.loadWaiting(memory));
    const auto volume = std::make_shared<const Volume>(std::move(loaded));
    if (!framesOf(*volume).empty())
      return Error::usage(
          "'" + volume_.path() + "' has " + std::to_string(framesOf(*volume).size()) +
          " frames, and edits change one; choose it by --frame N, and a file for that one alone by -o");
    VOXC_TRY(volume_.leaveOtherFrames(output_, common_));
    VOXC_TRY(checkEdits(edits, volume->info().extent)); // Alone: its message counts them.
    edits.insert(edits.begin(), waiting.begin(), waiting.end());
    if (!common_.quiet)
      VOXC_TRY(noteLostStreams());
    ProgressBar bar(common_.quiet);
    Json figures;
    const BuildOptions options = optionsOf(*volume, edits.size(), memory, bar.progress());
    if (Expected<void> edited = journal ? foldIn(*journal, volume, edits, options, figures)
                                        : edit(volume, edits, output_, options, figures);
        !edited)
      return edited;
    bar.clear();
    tellLoss(figures);
    return tellFigures(common_, figures);
  }

  void tellLoss(Json &figures) const {
    if (!loss_)
      return;
    figures["colour_error"] = errorFigures(*loss_);
    if (!common_.quiet && std::ranges::any_of(loss_->largest, [](int largest) { return largest > 0; }))
      printNote("lossy: " + errorText(*loss_));
  }

  /// True if the volume takes the place of the one that is read, by that name or through links; another hard
  /// link is a file of its own. A volume of frames has no journal, which would keep others from editing it.
  Expected<bool> replaces() const {
    std::error_code ignored;
    if (!std::filesystem::equivalent(volume_.path(), output_, ignored) ||
        std::filesystem::weakly_canonical(journalPathOf(volume_.path()), ignored) !=
            std::filesystem::weakly_canonical(journalPathOf(output_), ignored))
      return false;
    const auto summary = VOXC_TRY(summarizeVolume(volume_.path()));
    return std::ranges::find(summary.streams, kFrameStream, &StreamSummary::name) == summary.streams.end();
  }

  BuildOptions optionsOf(const Volume &volume, std::size_t edits, std::shared_ptr<WorkingMemory> memory,
                         const Progress &progress) const {
    BuildOptions options;
    options.provenance = provenanceOf(volume, edits);
    options.memory = std::move(memory);
    options.compress = arguments_.compress;
    options.progress = progress;
    return options;
  }

  /// Writes the file under another name first.
  Expected<void> foldIn(EditJournal &journal, const std::shared_ptr<const Volume> &volume,
                        const std::vector<VoxelEdit> &edits, const BuildOptions &options, Json &figures) {
    std::error_code failure;
    std::filesystem::path own = output_; // The file itself, where that is a link to it.
    if (std::filesystem::is_symlink(own, failure))
      own = std::filesystem::canonical(own, failure);
    std::string folded = own.string() + ".folded";
    while (std::filesystem::exists(folded, failure)) // Of whomever that is.
      folded += "-";
    VOXC_TRY(edit(volume, edits, folded, options, figures));
    VOXC_TRY(journal.fold(folded));
    addWritten(figures, output_);
    return {};
  }

  Expected<void> edit(const std::shared_ptr<const Volume> &volume, const std::vector<VoxelEdit> &edits,
                      const std::string &path, BuildOptions options, Json &figures) {
    auto constructor = VOXC_TRY(Constructor::compile(volume->format(), compileCache()));
    options.path = path;
    auto built = VOXC_TRY(constructor.edit(volume, edits, options));
    loss_ = built.report.colourError;
    figures["edits"] = edits.size();
    addVolumeFigures(figures, built.volume);
    addBuildFigures(figures, built.report);
    addFileFigure(figures, path);
    if (path == output_)
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
  bool journal_ = false;
  bool compact_ = false;
  std::optional<ColourError> loss_; ///< Of what was built, where the format rounds colours.
  BuildArguments arguments_;
  CommonOptions common_;
};

} // namespace

std::unique_ptr<Subcommand> makeEditCommand() { return std::make_unique<EditCommand>(); }

} // namespace voxc::tool
