// voxc verify: a volume's structure, its losslessness, and its kernel against the exact oracle.
#include "building/ColourLoss.h"
#include "building/Comparison.h"
#include "common/Statistics.h"
#include "common/Terminal.h"
#include "options/Figures.h"
#include "options/InputArguments.h"
#include "options/VolumeArgument.h"
#include "program/Applications.h"
#include "tracing/ErrorCheck.h"
#include "tracing/TraceSession.h"
#include "voxc/Oracle/Oracle.h"
#include "voxc/Oracle/VerifyRays.h"
#include "voxc/Source/Sources.h"
#include "voxc/Volume/CoarseBlocks.h"

#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

namespace voxc::tool {

namespace {

constexpr std::size_t kMostTold = 3; ///< Of what is found wrong, in one sentence.

void printHit(const char *name, const Hit &hit) {
  if (hit.isHit())
    std::printf("    %s (%d, %d, %d) at t = %.9g\n", name, hit.voxel[0], hit.voxel[1], hit.voxel[2],
                double(hit.t));
  else
    std::printf("    %s nothing\n", name);
}

void printExample(std::uint64_t index, const Ray &ray, const Hit &kernel, const Hit &oracle) {
  std::printf("  ray %" PRIu64 " from (%.9g, %.9g, %.9g) along (%.9g, %.9g, %.9g)\n", index,
              double(ray.origin[0]), double(ray.origin[1]), double(ray.origin[2]), double(ray.direction[0]),
              double(ray.direction[1]), double(ray.direction[2]));
  printHit("kernel", kernel);
  printHit("oracle", oracle);
}

void printErrors(const ErrorFigures &error) {
  std::printf("kernel       %12s %8s %8s %8s %8s %8s %12s %12s %8s\n", "rays", "missed", "ghost", "wrong",
              "colour", "boundary", "max_dt", "rms_dt", "max_ulp");
  std::printf("             %12" PRIu64 " %8" PRIu64 " %8" PRIu64 " %8" PRIu64 " %8" PRIu64 " %8" PRIu64
              " %12.3g %12.3g %8.3g\n",
              error.rays, error.missed, error.ghost, error.wrong, error.colour, error.boundary, error.maxDt,
              error.rmsDt, error.maxUlpDt);
}

Json differenceFigures(const VoxelDifferences &found) {
  return {{"equal", found.equal},
          {"missing", found.missing},
          {"surplus", found.surplus},
          {"changed", found.changed}};
}

class VerifyCommand final : public Subcommand {
public:
  void declare(const CommandLine &command) override;
  Expected<void> run() override;

private:
  Expected<void> checkPlan();
  Expected<void> checkVolume();
  Expected<void> outcome();
  Expected<void> checkVoxels(const std::shared_ptr<const Volume> &volume, const Progress &progress);
  Expected<void> checkCoarse(const Volume &volume, const Progress &progress);
  Expected<void> checkKernel(const Volume &volume, const Progress &progress);
  void printDifferences(const VoxelDifferences &found) const;
  bool accepts(const ErrorFigures &error) const;
  void fail(std::string what) { failures_.push_back(std::move(what)); }

  std::optional<CommandLine> command_;
  VolumeArgument volume_;
  std::string against_;
  InputArguments inputArguments_;
  std::size_t rays_ = 100000;
  std::uint64_t seed_ = 1;
  bool allowBoundary_ = false;
  TraceSession tracing_;
  CommonOptions common_;

  Json figures_;
  std::vector<std::string> failures_;
};

void VerifyCommand::declare(const CommandLine &command) {
  command_ = command;
  volume_.declare(command,
                  "A .hvx file; or a build plan, of which what stands is compared with the plan's input");
  command.add("--against", against_, "Compare with this input, voxel by voxel, both ways").takes("INPUT");
  addInputArguments(command, inputArguments_);
  command.add("--rays", rays_, "Rays to trace by the kernel and by the oracle; 0 needs no device")
      .takes("N")
      .between(std::size_t{0}, std::size_t{1} << 30)
      .showsDefault();
  command.add("--seed", seed_, "Another number makes other rays").takes("N").showsDefault();
  command.addFlag("--allow-boundary", allowBoundary_,
                  "Accept, but still count, differences that float rounding at a cell's boundary explains");
  tracing_.declare(command);
  volume_.declareKernelOptions(command);
  volume_.declareBounds(command);
  addCommonOptions(command, common_);
}

Expected<void> VerifyCommand::checkVoxels(const std::shared_ptr<const Volume> &volume,
                                          const Progress &progress) {
  InputArguments arguments = inputArguments_, asked = inputArguments_;
  fillFromProvenance(arguments, volume->info().provenance);
  if (!asked.fillColour.empty())
    asked.interior = arguments.interior; // To fill may have been asked for when the volume was built.
  if (asked.resolution == 0 && asked.voxelSize.empty())
    asked.voxelSize = arguments.voxelSize; // So may a size that has a unit.
  VOXC_TRY(checkInputArguments(asked, against_));
  InputOptions options = makeInputOptions(arguments, volume->format().extent());
  options.progress = progress;
  options.reference = true;
  auto input = VOXC_TRY(openInput(against_, options));
  const std::unique_ptr<VoxelSource> decoded = makeVolumeSource(volume);
  auto kept = VOXC_TRY(asKept(*volume, *input.source, progress));
  auto found = VOXC_TRY(compareVoxels(*decoded, kept ? *kept : *input.source, progress));

  printDifferences(found);
  figures_["voxel_differences"] = differenceFigures(found);
  if (kept && !kindOf(volume->layout().payload).isShapeAlone()) {
    const ColourError error = kept->error();
    figures_["colour_error"] = errorFigures(error);
    if (tellsOnStdout(common_))
      std::printf("lossy        %s\n", errorText(error).c_str());
  }
  if (!found.none())
    fail("the volume differs from '" + against_ + "', first at voxel (" + std::to_string(found.first->x) +
         ", " + std::to_string(found.first->y) + ", " + std::to_string(found.first->z) + ")");
  if (volume->info().extent != input.source->extent())
    fail("the volume's extent differs from that of '" + against_ + "'");
  return {};
}

void VerifyCommand::printDifferences(const VoxelDifferences &found) const {
  if (tellsOnStdout(common_))
    std::printf("losslessness %" PRIu64 " voxels equal, %" PRIu64 " missing, %" PRIu64 " surplus, %" PRIu64
                " changed\n",
                found.equal, found.missing, found.surplus, found.changed);
}

/// Blocks that the volume has must be those of its voxels.
Expected<void> VerifyCommand::checkCoarse(const Volume &volume, const Progress &progress) {
  const auto kept = VOXC_TRY(coarseBlocksOf(volume));
  if (!kept)
    return {};
  const int log2Side = kept->log2Side;
  const auto made = VOXC_TRY(makeCoarseBlocks(volume, log2Side, progress));
  figures_["coarse_blocks"] = kept->blocks.size();
  if (tellsOnStdout(common_))
    std::printf("coarse       %zu blocks of %d voxels a side, %s\n", kept->blocks.size(), 1 << log2Side,
                made == *kept ? "the means of the voxels" : "not those of the voxels");
  if (made != *kept)
    fail("the coarse blocks of the volume are not those of its voxels");
  return {};
}

bool VerifyCommand::accepts(const ErrorFigures &error) const {
  return error.clean() ||
         (allowBoundary_ && error.colour == 0 && error.missed + error.ghost + error.wrong == error.boundary);
}

Expected<void> VerifyCommand::checkKernel(const Volume &volume, const Progress &progress) {
  auto format = VOXC_TRY(volume_.kernelFormat(volume));
  VOXC_TRY(tracing_.openDevice(common_));
  VOXC_TRY(tracing_.prepare(volume, format, figures_));
  const auto oracle = VOXC_TRY(Oracle::of(volume, progress));
  const std::vector<Ray> plain = verifyRays(volume.info().extent, rays_, seed_);
  std::vector<BoundedRay> bounded;
  if (questionOf(format).bounds)
    bounded = withHardBounds(oracle, plain, seed_);
  const RaySpan rays = bounded.empty() ? RaySpan(plain) : RaySpan(bounded);
  std::vector<Hit> hits(rays.size());
  VOXC_TRY(tracing_.trace(rays, hits, {.progress = progress}, figures_));

  const ErrorFigures error = compare(oracle, rays, hits, questionOf(format));
  figures_["error"] = errorJson(error);
  if (tellsOnStdout(common_)) {
    printErrors(error);
    for (const std::uint64_t index : error.examples)
      printExample(index, rays[index], hits[index], oracle.trace(rays[index], rays.bounds(index)));
  }
  if (!accepts(error))
    fail("the kernel's hits differ from the oracle's on " +
         std::to_string(error.missed + error.ghost + error.wrong + error.colour) + " of " +
         std::to_string(error.rays) + " rays");
  return {};
}

Expected<void> VerifyCommand::run() { return isBuildPlan(volume_.path()) ? checkPlan() : checkVolume(); }

/// What stands of a plan, against the plan's own input.
Expected<void> VerifyCommand::checkPlan() {
  for (const Option &option : command_->given())
    if (!option.isWord() && option.group() != kCommonOptions)
      return Error::usage(option.name() + " is for a volume; a build plan is held against its own input");
  ProgressBar bar(common_.quiet);
  const auto found = VOXC_TRY(tool::checkPlan(volume_.path(), {}, bar.progress()));
  bar.clear();
  figures_["outputs"] = found.outputs;
  figures_["missing_outputs"] = found.missing;
  figures_["voxel_differences"] = differenceFigures(found.differences);
  figures_["broken"] = Json::array();
  if (tellsOnStdout(common_))
    std::printf("outputs      %" PRIu64 " of %" PRIu64 " stand\n", found.outputs - found.missing,
                found.outputs);
  printDifferences(found.differences);
  for (const BrokenOutput &output : found.broken) {
    figures_["broken"].push_back({{"file", output.path},
                                  {"problem", output.problem},
                                  {"voxel_differences", differenceFigures(output.differences)}});
    fail(output.problem.empty() ? "'" + output.path + "' has not the voxels of the plan's input"
                                : output.problem);
  }
  return outcome();
}

Expected<void> VerifyCommand::checkVolume() {
  if (const std::vector<std::string> words = toWords(inputArguments_); against_.empty() && !words.empty())
    return Error::usage(words.front().substr(0, words.front().find('=')) +
                        " is for the input that --against names; name one, or leave it out");
  ProgressBar bar(common_.quiet);
  auto loaded = VOXC_TRY(volume_.load());
  const auto volume = std::make_shared<const Volume>(std::move(loaded));
  addVolumeFigures(figures_, *volume);
  if (tellsOnStdout(common_))
    std::printf("structure    %zu words, %s\n", volume->words().size(),
                volume_.trusted() ? "trusted" : "every offset proven in range");
  if (!against_.empty())
    VOXC_TRY(checkVoxels(volume, bar.progress()));
  VOXC_TRY(checkCoarse(*volume, bar.progress()));
  if (rays_ > 0)
    VOXC_TRY(checkKernel(*volume, bar.progress()));
  bar.clear();
  return outcome();
}

/// Writes the figures; the error is all that was found wrong.
Expected<void> VerifyCommand::outcome() {
  VOXC_TRY(writeStatistics(common_.stats, figures_));
  if (failures_.empty())
    return {};
  std::string message = failures_.front();
  for (std::size_t i = 1; i < std::min(failures_.size(), kMostTold); ++i)
    message += "; " + failures_[i];
  if (failures_.size() > kMostTold)
    message += "; and " + std::to_string(failures_.size() - kMostTold) + " more, which --stats names";
  return Error::input(message);
}

} // namespace

std::unique_ptr<Subcommand> makeVerifyCommand() { return std::make_unique<VerifyCommand>(); }

} // namespace voxc::tool
