// voxc plan: cuts the building of a volume into parts of equal predicted cost.
#include "building/BuildSession.h"
#include "cluster/BuildPlan.h"
#include "cluster/CubeCosts.h"
#include "cluster/EvenCut.h"
#include "common/FiguresFile.h"
#include "common/Files.h"
#include "common/Terminal.h"
#include "jobs/InputContent.h"
#include "options/Figures.h"
#include "options/InputArguments.h"
#include "options/Outputs.h"
#include "program/Applications.h"
#include "voxc/Volume/Frames.h"

#include <filesystem>
#include <numeric>

namespace voxc::tool {

using namespace cluster;

namespace {

namespace fs = std::filesystem;

/// An input with the path in it made absolute: a task may run in any folder.
std::string absoluteInput(const std::string &input) {
  if (input.starts_with("builtin:"))
    return input;
  const std::string path = fileOf(input);
  const std::size_t behind = input.ends_with(path) ? 0 : input.size() - withoutFrame(input).size();
  const std::size_t before = input.size() - behind - path.size();
  return input.substr(0, before) + fs::absolute(path).lexically_normal().string() +
         input.substr(input.size() - behind);
}

class PlanCommand final : public Subcommand {
public:
  void declare(const CommandLine &command) override {
    building_.declare(command);
    building_.declareCompress(command);
    command.add("--parts", parts_, "Parts to build, each by one task")
        .takes("N")
        .between(1u, 1u << 20)
        .showsDefault();
    command.add("--fan-in", fanIn_, "Outputs that a merge joins at most")
        .takes("N")
        .between(kLeastFanIn, kMostFanIn)
        .showsDefault();
    addVolumePath(command, volume_, building_.inputArguments(),
                  "Volume that is written in the end; default: the plan's name with .hvx")
        .takes("V.hvx");
    command.add("-o,--output", output_, "Build plan to write").takes("P.plan").required();
    addCommonOptions(command, common_);
  }

  Expected<void> run() override {
    VOXC_TRY(checkOutputFile(output_));
    if (building_.isLossy())
      return Error::usage("--lossy looks at all voxels to choose colours, which the parts of a plan cannot; "
                          "build in one go, or state the palette");
    Json figures;
    ProgressBar bar(common_.quiet);
    auto format = VOXC_TRY(building_.readFormat("cpu", common_, bar.progress(), figures));
    auto plan = VOXC_TRY(makePlan(format, bar.progress(), figures));
    bar.clear();
    VOXC_TRY(writeText(output_, printPlan(plan)));
    return tellFigures(common_, figures);
  }

private:
  Expected<BuildPlan> makePlan(Format &format, const Progress &progress, Json &figures) const {
    auto opened = VOXC_TRY(building_.open(format, common_, progress, figures));
    BuildPlan plan;
    plan.format = storageFormat(format);
    VOXC_TRY(nameInput(plan, opened));
    VOXC_TRY(checkVolume(plan));
    plan.volume = volume_.empty() ? fs::path(output_).filename().replace_extension(".hvx").string()
                                  : fs::absolute(volume_).lexically_normal().string();
    plan.compress = building_.means().compress;
    plan.fanIn = fanIn_;
    const VoxelSource &source = *opened.input.source;
    plan.extent = source.extent();
    plan.cubes = partNumbersOf(source, plan.format);
    if (!source.view())
      return Error::input("this input can be read by one process only; voxc build builds it");
    auto costs = VOXC_TRY(predictCosts(opened.input, building_.input(), opened.options, plan.cubes.log2Side));
    cut(plan, costs, figures);
    return plan;
  }

  /// Error: the volume would take the place of the plan, of its input, or of one with edits that wait.
  Expected<void> checkVolume(const BuildPlan &plan) const {
    const std::string volume =
        volume_.empty() ? fs::path(output_).replace_extension(".hvx").string() : volume_;
    VOXC_TRY(checkOutputFile(volume));
    VOXC_TRY(checkFiguresApart(common_.stats, volume));
    const auto whole = [](const std::string &path) { return fs::absolute(path).lexically_normal(); };
    const auto isVolume = [&](const std::string &path) {
      std::error_code ignored;
      return whole(path) == whole(volume) || fs::equivalent(path, volume, ignored);
    };
    if (isVolume(output_))
      return Error::usage("the plan and its volume would both be '" + volume +
                          "'; name the volume by --volume");
    for (const InputFile &file : plan.files)
      if (isVolume(file.path))
        return Error::usage("the volume '" + volume + "' is the input of the plan; name another by --volume");
    return {};
  }

  Expected<void> nameInput(BuildPlan &plan, const BuildSession::Opened &opened) const {
    plan.input = absoluteInput(building_.input());
    const auto files = VOXC_TRY(contentFiles(plan.input, opened.input.files));
    for (const ContentFile &file : files) {
      const auto digest = VOXC_TRY(fileDigest(file.path));
      if (file.path.find('\n') != std::string::npos)
        return Error::input("'" + file.path + "' has a line break in its name, which a plan cannot hold");
      plan.files.push_back({digest, file.path});
    }
    for (const std::string &word : toWords(opened.arguments))
      plan.options.push_back(word == "--crop" ? "crop=yes" : word.substr(2));
    return {};
  }

  void cut(BuildPlan &plan, const CubeCosts &costs, Json &figures) const {
    const int log2Cubes = 3 * (costs.log2Side - plan.cubes.log2Side);
    std::uint64_t begin = 0;
    std::uint64_t most = 0;
    std::uint64_t sum = 0;
    for (const std::uint64_t end : cutEvenly(costs.costs, parts_)) {
      const std::uint64_t cost =
          std::accumulate(costs.costs.begin() + static_cast<std::ptrdiff_t>(begin),
                          costs.costs.begin() + static_cast<std::ptrdiff_t>(end), std::uint64_t{0});
      plan.ranges.push_back({begin << log2Cubes, end << log2Cubes, cost});
      begin = end;
      most = std::max(most, cost);
      sum += cost;
    }
    figures["digest"] = plan.digest();
    figures["parts"] = plan.ranges.size();
    figures["merges"] = plan.tree().merges();
    figures["cubes"] = plan.cubes.count;
    figures["predicted_voxels"] = costs.voxels;
    figures["records"] = costs.records;
    figures["longest_part"] =
        sum == 0 ? 1.0 : static_cast<double>(most * plan.ranges.size()) / static_cast<double>(sum);
  }

  BuildSession building_;
  unsigned parts_ = 64;
  std::uint64_t fanIn_ = kDefaultFanIn;
  std::string volume_;
  std::string output_;
  CommonOptions common_;
};

} // namespace

std::unique_ptr<Subcommand> makePlanCommand() { return std::make_unique<PlanCommand>(); }

} // namespace voxc::tool
