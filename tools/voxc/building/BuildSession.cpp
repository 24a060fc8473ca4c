// Building volumes for the driver.
#include "building/BuildSession.h"

#include "choosing/BuildCommand.h"
#include "choosing/Suggestion.h"
#include "common/Statistics.h"
#include "frontend/FormatArgument.h"
#include "options/Figures.h"
#include "options/FrameInputs.h"
#include "voxc/Construct/Frames.h"
#include "voxc/Facts/PointerChoice.h"
#include "voxc/Layout/Layout.h"
#include "voxc/Support/UserCache.h"
#include "voxc/Volume/Frames.h"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace voxc::tool {

namespace {

constexpr const char *kAutoFormat = "auto";

} // namespace

void BuildSession::declare(const CommandLine &command) {
  command_ = command;
  command
      .add("FORMAT", format_,
           "Format string, .vir file, or - for standard input; auto: as voxc suggest chooses")
      .required()
      .takes("");
  command.add("INPUT", input_, kInputHelp).required().takes("");
  addInputArguments(command, inputArguments_);
  addMemoryArguments(command, buildArguments_);
  payload_.declare(command);
  command.addFlag(
      "--lossy", lossy_,
      "With --palette, takes the 2^N colours that stand best for those of the input, and reports the error");
  passes_.declare(command, PassChoice::OfInput);
}

void BuildSession::declareThreads(const CommandLine &command) {
  addThreadsArgument(command, buildArguments_);
}

void BuildSession::declareCompress(const CommandLine &command) {
  addCompressArgument(command, buildArguments_.compress);
}

void BuildSession::declareFrames(const CommandLine &command) {
  command.addFlag("--frames", frames_, "All frames of an animation in one volume, which share what is equal");
}

void BuildSession::declareMaxBytes(const CommandLine &command) {
  addMaxBytesArgument(command, buildArguments_);
}

void BuildSession::defaultInput(const CommandLine &command, const std::string &input) {
  input_ = defaultInput_ = input;
  command.option("INPUT").required(false).showsDefault();
  format_ = kAutoFormat;
  command.option("FORMAT").required(false).showsDefault();
}

/// True if the one argument is a file that holds no format, whether it is there or not, or a kind of input
/// with its colon.
bool BuildSession::hasInputAlone() const {
  if (defaultInput_.empty() || command_->option("INPUT").count() > 0 || format_ == kAutoFormat)
    return false;
  if (looksLikeFile(format_))
    return !format_.ends_with(".vir");
  const bool isFormat = format_ == "-" || tool::readFormat(format_);
  std::error_code ignored;
  return !isFormat && ((format_.find(':') != std::string::npos && !format_.starts_with("format")) ||
                       std::filesystem::exists(format_, ignored));
}

/// The passes are those of the candidate; more can only be said of a format that one knows.
Expected<Format> BuildSession::suggestFormat(const std::string &device, const CommonOptions &common,
                                             const Progress &progress, Json &figures) {
  if (!passes_.names().empty() || payload_.isAuto())
    return Error::usage("passes and payloads are chosen with the format; name a FORMAT to choose them");
  SuggestRequest request{
      .input = input_, .arguments = inputArguments_, .hasAllFrames = frames_, .device = device};
  request.wish.maxBytes = std::min(maxWordsOf(buildArguments_), kMaxWords) * sizeof(std::uint32_t);
  request.memory = makeWorkingMemory(buildArguments_);
  const Stopwatch watch;
  auto suggestion = VOXC_TRY(makeSuggestion(request, common, progress, figures));
  figures["choose_seconds"] = watch.seconds();
  const Candidate &candidate = suggestion.rated[suggestion.choice].candidate;
  inputArguments_ = suggestion.arguments;
  told_ = std::move(suggestion.told);
  format_ = candidate.text;
  suggestedPasses_ = candidate.passes;
  isSuggested_ = true;
  figures["format"] = candidate.text;
  if (!common.quiet)
    printNote("format: " + buildCommand(input_, inputArguments_, candidate));
  return candidate.format;
}

Expected<Format> BuildSession::readFormat(const std::string &device, const CommonOptions &common,
                                          const Progress &progress, Json &figures) {
  if (hasInputAlone())
    input_ = std::exchange(format_, kAutoFormat);
  if (format_ == kAutoFormat)
    return suggestFormat(device, common, progress, figures);
  Expected<Format> format = tool::readFormat(format_);
  if (!format && parseFormat(input_))
    return Error::usage("FORMAT comes first, then INPUT: write \"" + input_ + "\" before " + format_);
  if (!format)
    return format;
  written_ = *format;
  VOXC_TRY(passes_.apply(*format, tellingMissed(common.quiet)));
  return format;
}

/// What FORMAT and the passes say, had it been written with this payload, if any, and these bits for what the
/// input has to tell. `from` has been given how a kernel goes through the format; that stays.
Expected<Format> BuildSession::formOf(const Format &from, const PayloadChoice *choice,
                                      std::optional<int> pointerBits) const {
  Format format = *written_;
  if (choice) {
    format.setAttribute(kPayloadAttribute, choice->payload);
    format.setAttribute(kValuesAttribute, choice->apart ? "apart" : "in-place");
    Diagnostics diagnostics;
    verify(format, diagnostics);
    if (diagnostics.hasErrors())
      return Error::input(diagnostics.all().front().message);
  }
  VOXC_TRY(runPasses(format, passes_.namesWith(pointerBits)));
  for (const AttributeKind *kind : formatAttributes())
    if (kind->effect == AttributeEffect::Traversal)
      format.setAttribute(*kind, from.attributes.value(*kind));
  return format;
}

/// The bits of short pointers, which a note tells.
std::optional<int> BuildSession::choosePointers(const Facts &facts, const CommonOptions &common,
                                                Json &figures) const {
  const std::optional<int> bits = choosePointerBits(facts);
  figures["pointer_bits"] = bits ? *bits : 32;
  if (!common.quiet)
    printNote(bits ? "short pointers of " + std::to_string(*bits) + " bits number all shapes of 4^3 voxels"
                   : "pointers stay words: too many shapes of 4^3 voxels for short ones");
  return bits;
}

Expected<void> BuildSession::chooseByFacts(Format &format, VoxelSource &source,
                                           const std::shared_ptr<WorkingMemory> &memory,
                                           const CommonOptions &common, const Progress &progress,
                                           Json &figures) const {
  const bool asksBits = passes_.asksPointerBits();
  if (!payload_.isAuto() && !asksBits)
    return {};
  if (Expected<void> checked = payload_.check(format); payload_.isAuto() && !checked)
    return checked;
  const Stopwatch watch;
  const std::unique_ptr<VoxelSource> view = source.view();
  const auto facts = VOXC_TRY(measureFacts(view ? *view : source, {.memory = memory}, progress));
  figures["choose_seconds"] = watch.seconds();
  const std::optional<int> bits = asksBits ? choosePointers(facts, common, figures) : std::nullopt;
  if (!payload_.isAuto()) {
    Expected<Format> formed = formOf(format, nullptr, bits);
    if (formed)
      format = std::move(*formed);
    return formed ? Expected<void>() : formed.error();
  }
  const auto form = [&](const PayloadChoice &choice) { return formOf(format, &choice, bits); };
  Expected<void> chosen = payload_.apply(format, form, facts, figures);
  if (chosen && !common.quiet)
    printNote("payload " + std::string(figures["payload"]) + ": " + std::string(figures["payload_why"]));
  return chosen;
}

void BuildSession::tellLoss(const Prepared &prepared, const BuildReport &report, const CommonOptions &common,
                            Json &figures) {
  const std::optional<ColourError> error =
      prepared.reduced ? std::optional(prepared.reduced->error()) : report.colourError;
  if (!error)
    return;
  figures["colour_error"] = errorFigures(*error);
  if (!common.quiet)
    printNote("lossy: " + errorText(*error));
}

Expected<BuildSession::Opened> BuildSession::open(Format &format, const CommonOptions &common,
                                                  const Progress &progress, Json &figures) const {
  VOXC_TRY(checkInputArguments(inputArguments_, input_));
  const auto memory = makeWorkingMemory(buildArguments_);
  InputArguments arguments = inputArguments_;
  if (hasLabels(format) && arguments.colourMap.empty())
    arguments.colourMap = "labels";
  InputOptions options = makeInputOptions(arguments, format.extent());
  options.progress = progress;
  options.memory = memory;
  options.threads = threadsOf(buildArguments_);
  options.boxOfAllFrames = frames_;
  const Stopwatch opening;
  if (frames_ && payload_.isAuto())
    return Error::usage(
        "--payload auto looks at the colours of one frame; state a payload that holds those of "
        "all, or leave --frames out");
  if (frames_ && passes_.asksPointerBits())
    return Error::usage(
        "--short-pointers=auto counts the shapes of one frame; say how many bits those of all "
        "need, or leave --frames out");
  if (frames_ && withoutFrame(input_) != input_)
    return Error::usage("'" + input_ + "' names one frame, and --frames takes all; leave one of them out");
  auto input = VOXC_TRY(openInput(input_, options));
  if (frames_ && input.frames < 2)
    return Error::input("'" + input_ + "' has no frames; leave --frames out");
  figures["input_seconds"] = opening.seconds();
  ToldSentences told = told_;
  tellWarnings(input, common, told);
  if (Expected<void> chosen = chooseByFacts(format, *input.source, memory, common, progress, figures);
      !chosen)
    return chosen.error();
  return Opened{std::move(input), std::move(arguments), std::move(options)};
}

Expected<BuildSession::Prepared> BuildSession::prepare(Format &format, const CommonOptions &common,
                                                       const Progress &progress, Json &figures) const {
  auto opened = VOXC_TRY(open(format, common, progress, figures));
  Input *input = &opened.input;
  const unsigned threads = threadsOf(buildArguments_);
  BuildOptions options{"", threads, opened.options.memory, "", progress};
  auto constructor = VOXC_TRY(Constructor::compile(format, compileCache()));
  options.provenance = input->provenance;
  std::unique_ptr<RoundedSource> reduced;
  if (lossy_ && frames_)
    return Error::usage("--lossy takes the colours of one frame; leave it or --frames out");
  if (lossy_)
    reduced = VOXC_TRY(reduceToPalette(*input->source, format, progress));
  if (reduced)
    options.provenance += std::string(" colours=") + kReducedColours;
  figures["input"] = input_;
  figures["passes"] = suggestedPasses_.empty() ? passes_.names() : suggestedPasses_;
  figures["threads"] = threads;
  figures["memory_bound_bytes"] = options.memory->bound();
  figures["compile_seconds"] = constructor.compileSeconds();
  addInputFigures(figures, *input);
  return Prepared{std::move(constructor), std::move(opened.input), std::move(opened.options),
                  std::move(options), std::move(reduced)};
}

Expected<Volume> BuildSession::build(Format &format, const std::string &path, const CommonOptions &common,
                                     const Progress &progress, Json &figures) const {
  auto prepared = VOXC_TRY(prepare(format, common, progress, figures));
  prepared.options.path = path;
  prepared.options.compress = buildArguments_.compress;
  prepared.options.maxWords = maxWordsOf(buildArguments_);
  if (frames_)
    return buildFrames(format, std::move(prepared), figures);
  BuildResult built = prepared.constructor.build(prepared.source(), prepared.options);
  if (!built) {
    figures["words"] = built.wordsReached();
    return built.error();
  }
  addVolumeFigures(figures, built->volume);
  addBuildFigures(figures, built->report);
  tellLoss(prepared, built->report, common, figures);
  if (!path.empty()) {
    addFileFigure(figures, path);
    addWritten(figures, path);
  }
  if (built->volume.info().voxels == 0 && !common.quiet)
    printNote("warning: the volume is empty: the input has no voxel" +
              std::string(inputArguments_.bounds.empty() ? "" : " within --bounds"));
  return std::move(built->volume);
}

Expected<Volume> BuildSession::buildFrames(const Format &format, Prepared prepared, Json &figures) const {
  const std::size_t count = prepared.input.frames;
  const OpenFrame open = makeFrameInputs(input_, std::move(prepared.input.source), prepared.inputOptions);
  auto built = VOXC_TRY(voxc::buildFrames(format, count, open, prepared.options, compileCache()));
  addVolumeFigures(figures, built.volume);
  addBuildFigures(figures, built.report);
  for (const FrameReport &frame : built.frames)
    figures["animation"].push_back(
        {{"voxels", frame.voxels}, {"changed_voxels", frame.changed}, {"words", frame.words}});
  if (!prepared.options.path.empty()) {
    addFileFigure(figures, prepared.options.path);
    addWritten(figures, prepared.options.path);
  }
  return std::move(built.volume);
}

Expected<void> BuildSession::buildFragment(Format &format, std::uint64_t index, std::uint64_t count,
                                           const std::string &path, const CommonOptions &common,
                                           const Progress &progress, Json &figures) const {
  if (buildArguments_.compress)
    return Error::usage(
        "a fragment is not compressed; give --compress to the voxc merge that makes a volume of it");
  if (!buildArguments_.maxBytes.empty() && !isSuggested_)
    return Error::usage(
        "--max-bytes bounds the words of a volume, which a fragment has not yet; leave it out");
  auto prepared = VOXC_TRY(prepare(format, common, progress, figures));
  auto report =
      VOXC_TRY(prepared.constructor.buildFragment(prepared.source(), index, count, path, prepared.options));
  figures["fragment"] = index;
  figures["fragments"] = count;
  figures["voxels"] = report.voxels;
  figures["build_seconds"] = report.seconds;
  figures["build_cpu_seconds"] = report.cpuSeconds;
  figures["voxelize_seconds"] = report.readSeconds;
  figures["scratch_bytes"] = report.scratchBytes;
  tellLoss(prepared, report, common, figures);
  addFileFigure(figures, path);
  addWritten(figures, path);
  return {};
}

} // namespace voxc::tool
