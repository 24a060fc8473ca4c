// voxc accuracy: speed against error of every precision, traversal and device, on the same rays.
#include "accuracy/Findings.h"

#include "common/CameraOptions.h"
#include "common/FiguresFile.h"
#include "common/Files.h"
#include "common/Statistics.h"
#include "common/Terminal.h"
#include "jobs/PythonProgram.h"
#include "options/Figures.h"
#include "options/Outputs.h"
#include "options/VolumeArgument.h"
#include "program/Applications.h"
#include "tracing/TraceSession.h"
#include "voxc/IR/Query.h"

#include <filesystem>

namespace voxc::tool {

namespace {

/// The rays that all variants trace, and the picture that they make; 0 x 0 if they come from a file.
struct Rays {
  std::vector<Ray> rays;
  Camera camera{.width = 0, .height = 0};
};

std::vector<std::string> precisions() { return {precisionNames().begin(), precisionNames().end()}; }

class AccuracyCommand final : public Subcommand {
public:
  void declare(const CommandLine &command) override;
  Expected<void> run() override;

private:
  void declareChoice(const CommandLine &command);
  Expected<void> checkUsage() const;
  Expected<Rays> loadRays(const VolumeInfo &volume) const;
  Expected<Findings> compete(const Volume &volume, const Rays &rays, const Progress &progress);
  Expected<std::vector<std::unique_ptr<VariantCandidate>>>
  prepareAll(const std::vector<Variant> &variants, const Volume &volume, const Camera &camera);
  Expected<std::vector<LodFinding>> findLods(const Variant &variant, const Volume &volume, const Rays &rays,
                                             const Progress &progress);
  Expected<void> findSeries(const std::vector<Variant> &variants, const Volume &volume, const Oracle &oracle,
                            const Progress &progress, Findings &findings);
  Expected<void> tell(const Volume &volume, const Findings &findings) const;
  void drawPlots() const;

  VolumeArgument volume_;
  std::string raysPath_;
  CameraOptions camera_;
  std::string folder_;
  measure::Devices devices_;
  VariantChoice choice_{precisions(), traversalsOfTrees(), {""}};
  std::vector<double> lods_;
  unsigned rounds_ = 5;
  std::size_t check_ = 20000;
  bool series_ = false;
  std::size_t seriesRays_ = 10000;
  CommonOptions common_;
};

void declareValues(const CommandLine &command, const char *name, std::vector<std::string> &values,
                   const char *summary) {
  std::string defaults;
  for (const std::string &value : values)
    defaults += (defaults.empty() ? "" : ",") + value;
  command.add(name, values, summary).list().takes("A,B").oneOf(values).showsDefault(defaults);
}

void AccuracyCommand::declareChoice(const CommandLine &command) {
  command
      .add("--device", choice_.devices,
           "Trace on the device whose name contains this; may be given several times")
      .takes("NAME")
      .showsDefault("")
      .repeated();
  command.add("--threads", choice_.threads, "Threads of a device that is this processor; default: all")
      .takes("N")
      .between(1u, 1024u);
  declareValues(command, "--precisions", choice_.precisions, "Precisions to compare, separated by commas");
  declareValues(command, "--traversals", choice_.traversals,
                "Traversals of trees to compare, separated by commas");
  command.addFormer("--walks", "--traversals");
  command
      .add("--lods", lods_,
           "Sizes in pixels at which to stop early, as --lod of voxc render does, with the first of the "
           "others")
      .list()
      .takes("A,B")
      .between(0.0, 1e6);
}

void AccuracyCommand::declare(const CommandLine &command) {
  volume_.declare(command);
  command.add("--rays", raysPath_, "Rays to trace, in place of a camera's; - for standard input")
      .takes("R.bin");
  addCameraOptions(command, camera_);
  declareChoice(command);
  command.add("--repeat", rounds_, "Rounds in which all are timed in turn")
      .takes("N")
      .between(3u, 1000u)
      .showsDefault();
  command.add("--check", check_, "Rays, evenly spread, whose hits are compared with the exact oracle's")
      .takes("N")
      .positive()
      .showsDefault();
  command.addFlag(
      "--series", series_,
      "Also trace from origins up to 10^9 voxels away, and volumes of 2^4 to 2^16 voxels an axis");
  command.add("--series-rays", seriesRays_, "Rays at each place of a series")
      .takes("N")
      .positive()
      .showsDefault();
  command.add("-o,--output", folder_, "Folder for accuracy.json and the plots, accuracy.svg and others")
      .takes("DIR");
  addCommonOptions(command, common_);
}

Expected<void> AccuracyCommand::checkUsage() const {
  const bool isPicture = !camera_.camera.empty() || !camera_.size.empty() || camera_.fov != 0 ||
                         isOrthographic(camera_) || camera_.cubicVoxels || !lods_.empty();
  if (!raysPath_.empty() && isPicture)
    return Error::usage("--rays is no picture: --camera, --size, --fov and --lods are for cameras");
  if (Expected<Camera> camera = makeCamera(camera_, {1, 1, 1}); !camera)
    return camera.error();
  if (folder_.empty())
    return {};
  for (const char *own : {"accuracy.json", "accuracy.svg", "lod.svg"})
    VOXC_TRY(checkFiguresApart(common_.stats, folder_ + "/" + own));
  return makeOutputFolder(folder_);
}

Expected<Rays> AccuracyCommand::loadRays(const VolumeInfo &volume) const {
  Rays rays;
  if (!raysPath_.empty()) {
    auto read = VOXC_TRY(readRays(raysPath_));
    if (read.empty())
      return Error::input("ray file '" + raysPath_ + "' is empty; it should hold one ray at least");
    rays.rays = std::move(read);
    return rays;
  }
  auto camera = VOXC_TRY(makeCamera(camera_, volume.extent, volume.voxelToModel));
  rays.camera = camera;
  rays.rays = cameraRays(camera);
  return rays;
}

Expected<std::vector<std::unique_ptr<VariantCandidate>>>
AccuracyCommand::prepareAll(const std::vector<Variant> &variants, const Volume &volume,
                            const Camera &camera) {
  std::vector<std::unique_ptr<VariantCandidate>> candidates;
  for (const Variant &variant : variants) {
    const auto spread = static_cast<float>(variant.lod > 0 ? variant.lod * pixelSpread(camera) : 0);
    auto candidate = VOXC_TRY(prepare(variant, volume, devices_, choice_.threads, spread));
    candidates.push_back(std::move(candidate));
  }
  return candidates;
}

Expected<std::vector<LodFinding>> AccuracyCommand::findLods(const Variant &variant, const Volume &volume,
                                                            const Rays &rays, const Progress &progress) {
  std::vector<Variant> variants{variant};
  for (const double pixels : lods_)
    variants.push_back(withLod(variant, pixels));
  auto candidates = VOXC_TRY(prepareAll(variants, volume, rays.camera));
  VOXC_TRY(traceInTurn(candidates, rays.rays, rounds_, progress));

  const auto pictureOf = [&](const VariantCandidate &candidate) {
    return shade(rays.rays, candidate.subject.hits(), rays.camera.width, rays.camera.height);
  };
  const VariantCandidate &full = *candidates.front();
  const Picture reference = pictureOf(full);
  std::vector<LodFinding> findings;
  for (std::size_t i = 1; i < candidates.size(); ++i) {
    const VariantCandidate &coarse = *candidates[i];
    findings.push_back({coarse.variant.lod, mraysPerCpuSecond(coarse),
                        measure::median(full.times.cpuSeconds) / measure::median(coarse.times.cpuSeconds),
                        measure::areEqual(full.times.cpuSeconds, coarse.times.cpuSeconds),
                        difference(reference, pictureOf(coarse))});
  }
  return findings;
}

Expected<Findings> AccuracyCommand::compete(const Volume &volume, const Rays &rays,
                                            const Progress &progress) {
  Findings findings;
  findings.rounds = rounds_;
  const std::vector<Variant> variants = makeVariants(volume.format(), choice_);
  auto candidates = VOXC_TRY(prepareAll(variants, volume, rays.camera));
  VOXC_TRY(traceInTurn(candidates, rays.rays, rounds_, progress));
  const auto oracle = VOXC_TRY(Oracle::of(volume, progress));
  check(candidates, oracle, rays.rays, check_);
  findings.candidates = std::move(candidates);

  if (!lods_.empty())
    findings.lods = VOXC_TRY(findLods(variants.front(), volume, rays, progress));
  if (series_)
    VOXC_TRY(findSeries(variants, volume, oracle, progress, findings));
  return findings;
}

Expected<void> AccuracyCommand::findSeries(const std::vector<Variant> &variants, const Volume &volume,
                                           const Oracle &oracle, const Progress &progress,
                                           Findings &findings) {
  const SeriesOptions options{seriesRays_, rounds_, choice_.threads, progress};
  const auto candidates = VOXC_TRY(prepareAll(variants, volume, {}));
  auto distances = VOXC_TRY(distanceSeries(candidates, oracle, volume.info().extent, options));
  auto resolutions = VOXC_TRY(resolutionSeries(choice_, devices_, options));
  findings.distances = std::move(distances);
  findings.resolutions = std::move(resolutions);
  return {};
}

/// The figures stand without plots, which need more than voxc.
void AccuracyCommand::drawPlots() const {
  ProgressBar bar(true);
  const auto drawn = runPythonProgram("accuracy-plots.py", {folder_}, bar.progress());
  if (!drawn && !common_.quiet)
    printNote("there are no plots: " + drawn.error().message);
}

Expected<void> AccuracyCommand::tell(const Volume &volume, const Findings &findings) const {
  if (tellsOnStdout(common_))
    printTables(findings);
  Json figures{{"schema", "voxc accuracy 1"}};
  addVolumeFigures(figures, volume);
  figures["rays"] = findings.candidates[0]->subject.hits().size();
  addFindings(figures, findings);
  if (!folder_.empty()) {
    const std::string path = (std::filesystem::path(folder_) / "accuracy.json").string();
    VOXC_TRY(writeStatistics(path, figures));
    drawPlots();
  }
  return writeStatistics(common_.stats, figures);
}

Expected<void> AccuracyCommand::run() {
  VOXC_TRY(checkUsage());
  limitDeviceThreads(choice_.threads);
  ProgressBar bar(common_.quiet);
  auto volume = VOXC_TRY(volume_.load());
  auto rays = VOXC_TRY(loadRays(volume.info()));
  auto findings = VOXC_TRY(compete(volume, rays, bar.progress()));
  bar.clear();
  return tell(volume, findings);
}

} // namespace

std::unique_ptr<Subcommand> makeAccuracyCommand() { return std::make_unique<AccuracyCommand>(); }

} // namespace voxc::tool
