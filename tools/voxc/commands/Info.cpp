// voxc info: what the head of a volume says, and on request what a check of all of it proves; of other
// inputs what they say of themselves.
#include "building/InputReport.h"
#include "common/Interrupt.h"
#include "common/Statistics.h"
#include "common/Terminal.h"
#include "options/Figures.h"
#include "program/Subcommand.h"
#include "voxc/Construct/EditJournal.h"
#include "voxc/Input/FileFeatures.h"
#include "voxc/Layout/PaletteBlocks.h"
#include "voxc/Support/UserCache.h"
#include "voxc/Volume/CoarseBlocks.h"
#include "voxc/Volume/Frames.h"
#include "voxc/Volume/VolumeSummary.h"

#include <algorithm>
#include <cinttypes>
#include <cstdio>

namespace voxc::tool {

namespace {

constexpr double kMiB = 1 << 20;

double share(double part, double whole) { return whole > 0 ? part / whole : 0; }

std::string levelText(const Format &format, std::size_t level) {
  Format alone;
  alone.levels = {format.levels[level]};
  return toString(alone);
}

void printPart(const std::string &name, std::uint64_t words, std::uint64_t bytes) {
  const double part = double(words * sizeof(std::uint32_t));
  std::printf("  %-16s %12.0f bytes, %5.1f %%\n", name.c_str(), part, 100 * share(part, double(bytes)));
}

/// The bytes of each level, if the file tells them.
void printWords(const VolumeInfo &info, std::uint64_t bytes) {
  if (!info.wordCounts)
    return;
  for (std::size_t i = 0; i < info.wordCounts->levels.size(); ++i)
    printPart(levelText(info.format, i), info.wordCounts->levels[i], bytes);
  if (info.wordCounts->values > 0)
    printPart("values apart", info.wordCounts->values, bytes);
}

std::string digestText(const VolumeInfo &info) {
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016" PRIx64, storageDigest(info.format));
  return digits;
}

void printBytes(const VolumeSummary &summary) {
  const double voxels = double(summary.info.voxels), bytes = double(summary.bytes());
  std::printf("bytes       %.0f (%.2f MiB, %.3g a voxel)\n", bytes, bytes / kMiB, share(bytes, voxels));
  printWords(summary.info, summary.bytes());
  if (summary.storedBytes() < summary.bytes())
    std::printf("stored      %" PRIu64 " (%.2f MiB, %.1f %%), compressed in pages\n", summary.storedBytes(),
                double(summary.storedBytes()) / kMiB, 100 * share(double(summary.storedBytes()), bytes));
}

void printStream(const StreamSummary &stream) {
  std::printf("stream      %s: %" PRIu64 " bytes, %" PRIu64 " elements of %" PRIu32 "\n", stream.name.c_str(),
              stream.bytes, stream.elements(), stream.elementBytes);
  if (stream.pageBytes > 0)
    std::printf("pages       %s: %" PRIu64 " of %" PRIu32 " bytes\n", stream.name.c_str(), stream.pages(),
                stream.pageBytes);
}

/// As rows of a matrix that takes the corner of a voxel to the units of the model.
void printTransform(const Transform &voxelToModel) {
  const auto rows = rowsOf(voxelToModel);
  for (int row = 0; row < 3; ++row)
    std::printf("%s%-2c = %g x + %g y + %g z + %g\n", row == 0 ? "to model    " : "            ", "XYZ"[row],
                rows[4 * row], rows[4 * row + 1], rows[4 * row + 2], rows[4 * row + 3]);
}

/// Frames of a volume that has a stream of them; else the one that it is.
std::uint64_t framesOf(const VolumeSummary &summary) {
  const auto found = std::ranges::find(summary.streams, kFrameStream, &StreamSummary::name);
  return found == summary.streams.end() ? 1 : found->elements();
}

void print(const VolumeSummary &summary) {
  const VolumeInfo &info = summary.info;
  const Int3 whole = info.format.extent();
  std::printf("%s", printIr(info.format).c_str());
  std::printf("extent      %d x %d x %d voxels, in a format of %d x %d x %d\n", info.extent.x, info.extent.y,
              info.extent.z, whole.x, whole.y, whole.z);
  std::printf("voxels      %" PRIu64 "\n", info.voxels);
  if (const std::uint64_t frames = framesOf(summary); frames > 1)
    std::printf("frames      %" PRIu64 ", of which all but the streams tells of the first\n", frames);
  printBytes(summary);
  for (const StreamSummary &stream : summary.streams)
    printStream(stream);
  std::printf("made with   %s\n",
              info.provenance.empty() ? "(not known)" : printable(info.provenance).c_str());
  printTransform(info.voxelToModel);
  std::printf("digest      0x%s, which that of a kernel or a header must equal\n", digestText(info).c_str());
}

/// What stands in a table of the words, which the check has proved.
void printPalette(const Volume &volume) {
  const PayloadKind &payload = kindOf(volume.layout().payload);
  if (volume.info().voxels == 0 || payload.mostBits == 0)
    return;
  const WordReader words = volume.layout().reader(volume.words());
  const std::uint64_t few = paletteColours(words, words.wordOf(words[1]));
  if (!payload.labels)
    std::printf("colours     %" PRIu64 " in the palette\n", few);
  else
    std::printf("labels      %" PRIu64 "\n", few);
}

Json figuresOf(const VolumeSummary &summary) {
  const VolumeInfo &info = summary.info;
  Json figures = {{"format", toString(info.format)},
                  {"extent", {info.extent.x, info.extent.y, info.extent.z}},
                  {"words", summary.streams.front().elements()},
                  {"bytes", summary.bytes()},
                  {"voxels", info.voxels},
                  {"stored_bytes", summary.storedBytes()},
                  {"ir", printIr(info.format)},
                  {"storage_digest", digestText(info)},
                  {"provenance", info.provenance},
                  {"voxel_to_model", rowsOf(info.voxelToModel)}};
  figures["frames"] = framesOf(summary);
  for (const StreamSummary &stream : summary.streams) {
    figures["streams"].push_back({{"name", stream.name},
                                  {"element_bytes", stream.elementBytes},
                                  {"elements", stream.elements()},
                                  {"bytes", stream.bytes},
                                  {"stored_bytes", stream.storedBytes}});
    if (stream.pageBytes > 0)
      figures["pages"].push_back(
          {{"name", stream.name}, {"page_bytes", stream.pageBytes}, {"pages", stream.pages()}});
  }
  if (info.wordCounts) {
    figures["level_words"] = info.wordCounts->levels;
    figures["value_words"] = info.wordCounts->values;
  }
  return figures;
}

class InfoCommand final : public Subcommand {
public:
  void declare(const CommandLine &command) override {
    command.add("INPUT", path_, "A .hvx file, or another input, of which nothing is built").takes("");
    command.addFlag("--files", files_,
                    "Print what is read of foreign files, warned of and refused, as a table");
    command.addFlag("--prove", prove_, "Of a .hvx file: read all of it, and follow every pointer in it");
    addCommonOptions(command, common_);
  }

  Expected<void> run() override {
    if (files_ != path_.empty())
      return Error::usage("info takes an INPUT or --files; give one of them");
    if (files_)
      return tellFiles();
    return isVolumePath(path_) ? tellVolume() : tellInput();
  }

private:
  Expected<void> tellFiles() const {
    if (prove_)
      return Error::usage("--prove is for .hvx files; leave it out");
    if (!common_.stats.empty())
      return Error::usage("--stats is for an INPUT; the table of --files has no figures");
    std::printf("%s", fileFeatureTable().c_str());
    return {};
  }

  Expected<void> tellInput() const {
    if (prove_)
      return Error::usage("--prove is for .hvx files; leave it out");
    Json figures;
    VOXC_TRY(reportInput(path_, common_, figures));
    return writeStatistics(common_.stats, figures);
  }

  Expected<void> tellVolume() const {
    const auto summary = summarizeVolume(path_);
    // Of a kind that is known and not read there is more to say.
    if (!summary && !path_.ends_with(".hvx") && summary.error().message.ends_with("is not a .hvx volume"))
      return tellInput();
    if (!summary)
      return summary.error();
    Json figures = figuresOf(*summary);
    const auto edits = VOXC_TRY(readJournal(path_));
    figures["waiting_edits"] = edits.size();
    if (tellsOnStdout(common_)) {
      print(*summary);
      if (!edits.empty())
        std::printf(
            "journal     %zu edits that are not in the file yet, of which the lines above say nothing\n",
            edits.size());
    }
    if (prove_)
      VOXC_TRY(prove(figures));
    return writeStatistics(common_.stats, figures);
  }

  Expected<void> prove(Json &figures) const {
    LoadOptions options;
    options.progress.stop = &catchInterrupts();
    const Stopwatch watch;
    const auto volume = VOXC_TRY(loadEdited(path_, options, compileCache()));
    VOXC_TRY(coarseBlocksOf(volume));
    figures["load_seconds"] = watch.seconds();
    if (!tellsOnStdout(common_))
      return {};
    printPalette(volume);
    std::printf("proved      all bytes are those that were written, and every pointer leads to words\n");
    return {};
  }

  std::string path_;
  bool files_ = false;
  bool prove_ = false;
  CommonOptions common_;
};

} // namespace

std::unique_ptr<Subcommand> makeInfoCommand() { return std::make_unique<InfoCommand>(); }

} // namespace voxc::tool
