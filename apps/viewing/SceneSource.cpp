// Scenes for the viewer.
#include "viewing/SceneSource.h"

#include "choosing/Suggestion.h"
#include "common/Files.h"
#include "frontend/FormatArgument.h"
#include "options/FrameInputs.h"
#include "tracing/TraceSession.h"
#include "view/FormatText.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/Construct/EditJournal.h"
#include "voxc/IR/Attribute.h"
#include "voxc/IR/Query.h"
#include "voxc/Layout/Edits.h"
#include "voxc/Support/UserCache.h"
#include "voxc/Volume/Frames.h"

#include <algorithm>

namespace voxc::tool {
namespace {

/// A tracer with the device that it is on, and the volume that it goes through.
class KeptTracer final : public Tracer {
public:
  KeptTracer(std::shared_ptr<const Volume> volume, TraceSession tracing)
      : volume_(std::move(volume)), tracing_(std::move(tracing)) {}

  Expected<TraceReport> trace(RaySpan rays, std::span<Hit> hits, const TraceOptions &options) override {
    return tracing_.trace(rays, hits, options);
  }
  Expected<UpdateReport> follow(const Volume &after, std::span<const WordRange> changed) override {
    return tracing_.follow(after, changed);
  }
  /// Of one that has pages.
  PagingReport paging() const { return *tracing_.paging(); }

private:
  std::shared_ptr<const Volume> volume_;
  TraceSession tracing_;
};

} // namespace

void SceneSource::declare(const CommandLine &command) {
  command.add("INPUT", input_, std::string(kInputHelp)).required().takes("");
  command
      .add("--format", format_,
           "Format string or .vir file to begin with; the default is a volume's own, and else as voxc "
           "suggest chooses")
      .takes("FORMAT");
  command.addFlag("--trusted", trusted_,
                  "Skip the check that proves every offset of a volume, for a file of one's own");
  command
      .add("--device", device_,
           "Trace on the device whose name contains this, or which has this number or UUID in 'voxc "
           "devices', or on cpu")
      .takes("NAME");
  memory_.declare(command);
  memory_.declareCoarse(command);
  addThreadsArgument(command, building_);
  command.option("--threads").text("Threads that build and trace; default: as many as the machine has");
  addInputArguments(command, inputArguments_);
  addMemoryArguments(command, building_);
  passes_.declare(command, PassChoice::All);
}

bool SceneSource::isVolume() const { return hasEnding(withoutFrame(input_), ".hvx"); }

Expected<void> SceneSource::check() const {
  VOXC_TRY(checkInputArguments(inputArguments_, input_));
  if (!format_.empty())
    if (Expected<Format> format = readFormat(format_); !format)
      return format.error();
  if (memory_.isGiven() && (!isVolume() || !format_.empty()))
    return Error::usage(
        "--device-memory is for a volume as stored with --compress; give a .hvx file, and no --format");
  if (format_.empty() && !isVolume() && !passes_.names().empty())
    return Error::usage("passes are chosen with the format; give a --format to choose them");
  if (format_.empty())
    for (const std::string &name : passes_.names())
      if (const Pass *const pass = findPass(name); pass && pass->effect != AttributeEffect::Traversal)
        return Error::usage("pass '" + name +
                            "' changes what a volume stores; give a --format too, and it is built anew");
  return {};
}

view::SceneMaker SceneSource::maker(const CommonOptions &common) {
  return {[this, common](const std::string &text, const Progress &progress) {
            return makeModel(text, common, progress);
          },
          [this, common](const view::Model &model, std::string &device) {
            return makeTracers(model, common, device);
          },
          building_.threads};
}

Expected<view::Model> SceneSource::makeModel(const std::string &text, const CommonOptions &common,
                                             const Progress &progress) {
  if (memory_.isGiven())
    return text.empty()
               ? openPages()
               : Error::usage("with --device-memory a volume keeps the format that it was stored in");
  if (!text.empty())
    return buildModel(text, progress);
  if (!format_.empty()) {
    const Expected<Format> format = readFormat(format_);
    return format ? buildModel(view::formatText(view::formatText(*format), passes_.names()), progress)
                  : Expected<view::Model>(format.error());
  }
  return isVolume() ? loadVolume(progress) : suggestModel(common, progress);
}

Expected<view::Model> SceneSource::openPages() {
  Json figures;
  const auto named = VOXC_TRY(parseFramePath(input_));
  auto outline = VOXC_TRY(memory_.open(named.path, named.frame, figures));
  Expected<view::Model> model = modelOf(std::move(outline));
  if (model)
    model->pagedBytes = memory_.volumeBytes();
  return model;
}

Expected<view::Model> SceneSource::loadVolume(const Progress &progress) const {
  const auto named = VOXC_TRY(parseFramePath(input_));
  LoadOptions options{
      .trusted = trusted_, .threads = building_.threads, .progress = progress, .frame = named.frame};
  Expected<Volume> volume = loadEdited(named.path, options, compileCache());
  return volume ? modelOf(std::move(*volume)) : Expected<view::Model>(volume.error());
}

/// The volume with its own format, traversed as the passes say.
Expected<view::Model> SceneSource::modelOf(Volume volume) const {
  view::Model model;
  model.volume = std::make_shared<const Volume>(std::move(volume));
  model.format = model.volume->format();
  model.text = view::formatText(view::formatText(model.format), passes_.names());
  VOXC_TRY(passes_.apply(model.format));
  return model;
}

Expected<view::Model> SceneSource::suggestModel(const CommonOptions &common, const Progress &progress) const {
  SuggestRequest request{.input = input_, .arguments = inputArguments_};
  request.device = device_.empty() ? "cpu" : device_;
  request.memory = makeWorkingMemory(building_);
  request.wish.maxBytes = kMaxWords * sizeof(std::uint32_t);
  request.editable = hasEnding(withoutFrame(input_), ".vox"); // It may be an animation.
  request.hasAllFrames = request.editable;
  Json figures;
  CommonOptions quietly = common;
  quietly.quiet = true;
  const auto suggestion = VOXC_TRY(makeSuggestion(request, quietly, progress, figures));
  const Candidate &candidate = suggestion.rated[suggestion.choice].candidate;
  return buildModel(view::formatText(candidate.text, candidate.passes), progress);
}

Expected<view::Model> SceneSource::buildModel(const std::string &text, const Progress &progress) const {
  auto format = VOXC_TRY(view::readFormatText(view::parseFormatText(text)));
  InputOptions options = makeInputOptions(inputArguments_, format.extent());
  options.progress = progress;
  options.memory = makeWorkingMemory(building_);
  options.threads = threadsOf(building_);
  options.boxOfAllFrames = true;
  auto input = VOXC_TRY(openInput(input_, options));
  BuildOptions building;
  building.provenance = input.provenance;
  building.threads = options.threads;
  building.memory = options.memory;
  building.progress = progress;
  auto volume = VOXC_TRY(isAnimation(input, format) ? buildFrames(format, std::move(input), options, building)
                                                    : buildAlone(format, *input.source, building));
  return view::Model{std::make_shared<const Volume>(std::move(volume)), std::move(format),
                     view::spelledText(text)};
}

/// Whether all frames are to be in the volume: none was named, and the format can be edited.
bool SceneSource::isAnimation(const Input &input, const Format &format) const {
  return input.frames > 1 && withoutFrame(input_) == input_ && whyNoEdits(layoutOf(format)).empty();
}

Expected<Volume> SceneSource::buildFrames(const Format &format, Input input, const InputOptions &options,
                                          const BuildOptions &building) const {
  const std::size_t count = input.frames;
  auto built =
      voxc::buildFrames(format, count, makeFrameInputs(input_, std::move(input.source), options), building);
  return built ? Expected<Volume>(std::move(built->volume)) : built.error();
}

Expected<Volume> SceneSource::buildAlone(const Format &format, VoxelSource &source,
                                         const BuildOptions &building) {
  const auto constructor = VOXC_TRY(Constructor::compile(format));
  Expected<Built> built = constructor.build(source, building);
  return built ? Expected<Volume>(std::move(built->volume)) : built.error();
}

Expected<TraceSession> SceneSource::openTracing(const std::string &device, unsigned threads,
                                                const CommonOptions &common) const {
  TraceSession tracing;
  tracing.choose(device, threads);
  VOXC_TRY(tracing.openDevice(common));
  return tracing;
}

Format SceneSource::kernelFormat(const view::Model &model) const {
  Format format = model.format;
  if (hasBounds_)
    askForBounds(format);
  return format;
}

Expected<view::Tracers> SceneSource::makeTracers(const view::Model &model, const CommonOptions &common,
                                                 std::string &device) const {
  auto tracing = VOXC_TRY(openTracing(device, building_.threads, common));
  device = tracing.deviceInfo().name;
  if (model.pagedBytes > 0)
    return makePagedTracers(model, common, std::move(tracing));
  Json figures;
  VOXC_TRY(tracing.prepare(*model.volume, kernelFormat(model), figures));
  return view::Tracers{std::make_unique<KeptTracer>(model.volume, std::move(tracing))};
}

/// Two of them, with a shelf between them on which the prefetch puts pages.
Expected<view::Tracers> SceneSource::makePagedTracers(const view::Model &model, const CommonOptions &common,
                                                      TraceSession tracing) const {
  auto prefetching = VOXC_TRY(openTracing(cpuDeviceInfo().name, 1, common));
  const auto shelf = memory_.makeShelf();
  Json figures;
  if (Expected<void> prepared = memory_.prepare(tracing, kernelFormat(model), figures, {.takesFrom = shelf});
      !prepared)
    return prepared.error();
  if (Expected<void> prepared = memory_.prepare(prefetching, kernelFormat(model), figures, {.putsOn = shelf});
      !prepared)
    return prepared.error();
  auto kept = std::make_unique<KeptTracer>(model.volume, std::move(tracing));
  auto paging = [&kept = *kept] { return kept.paging(); };
  return view::Tracers{std::move(kept), std::make_unique<KeptTracer>(model.volume, std::move(prefetching)),
                       std::move(paging), [this, shelf](unsigned threads) {
                         return std::make_unique<SurfaceNormals>(memory_.makeNormals(shelf, threads));
                       }};
}

std::vector<std::string> deviceNames() {
  const std::vector<DeviceInfo> devices = listDevices();
  std::vector<std::string> names;
  for (const DeviceInfo &device : devices)
    if (device.usable) {
      const bool isAlone = std::ranges::count(devices, device.name, &DeviceInfo::name) == 1;
      names.push_back(isAlone ? device.name : device.uuid);
    }
  names.push_back(cpuDeviceInfo().name);
  return names;
}

} // namespace voxc::tool
