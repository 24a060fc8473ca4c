// voxc suggest: the format that an input asks for, found without building any.
#include "BuildArguments.h"
#include "InputArguments.h"
#include "Subcommand.h"
#include "SuggestReport.h"

#include "common/Files.h"
#include "common/Statistics.h"
#include "common/Terminal.h"
#include "search/KeptWeights.h"
#include "search/Scene.h"
#include "voxc/Search/SampleRays.h"

#include <cstdio>
#include <map>

namespace voxc::tool {

namespace {

/// A picture in which neighbours are as close as in one of the usual size, and packets lie everywhere.
constexpr int kWidth = 1280;
constexpr int kHeight = 720;

const std::map<std::string, Wish::Objective> kObjectives = {{"balanced", Wish::Objective::Balanced},
                                                            {"fastest", Wish::Objective::Fastest},
                                                            {"smallest", Wish::Objective::Smallest}};

class SuggestCommand final : public Subcommand {
public:
  void declare(CLI::App &app) override {
    app.add_option("INPUT", input_, kInputHelp)->required()->type_name("");
    addInputArguments(app, inputArguments_);
    app.get_option("--resolution")
        ->description("Voxels on the longest axis; default: " + std::to_string(kDefaultResolution));
    app.add_option("--objective", objective_,
                   "What is wanted: balanced (default; twice the speed is worth four times the bytes), "
                   "fastest or smallest")
        ->type_name("WISH")
        ->check(CLI::IsMember(kObjectives).description(""));
    addMaxBytesArgument(app, buildArguments_);
    app.get_option("--max-bytes")
        ->description("The most bytes that the volume's words may take, such as 64MiB");
    app.add_option("--device", device_,
                   "Device that will trace: cpu (default), or one of Vulkan's that is a processor")
        ->type_name("NAME");
    app.add_option("--rays", rayFiles_, "A file of rays in place of sampled ones; may be given several times")
        ->type_name("R.bin");
    app.add_option("--formats", formatsPath_,
                   "A file of formats, one a line, in place of those that voxc knows")
        ->type_name("FILE");
    app.add_flag("--all", all_, "List all formats that no other beats in both size and speed");
    addMemoryArguments(app, buildArguments_);
    addCommonOptions(app, common_);
  }

  Expected<void> run() override {
    ProgressBar bar(common_.quiet);
    progress_ = bar.progress();
    wish_ = {kObjectives.at(objective_),
             std::min(maxWordsOf(buildArguments_), kMaxWords) * sizeof(std::uint32_t)};
    Json figures;
    Expected<Suggestion> suggestion = suggest(figures);
    if (!suggestion)
      return suggestion.error();
    bar.clear();
    std::fputs(suggestReport(*suggestion, all_).c_str(), stdout);
    addSuggestFigures(figures, *suggestion);
    return writeStatistics(common_.stats, figures);
  }

private:
  Expected<Suggestion> suggest(Json &figures) const {
    Suggestion suggestion{.input = input_, .arguments = inputArguments_, .device = device_, .wish = wish_};
    if (suggestion.arguments.resolution == 0)
      suggestion.arguments.resolution = kDefaultResolution;
    const auto memory = makeWorkingMemory(buildArguments_);
    Expected<Scene> scene = readScene(input_, suggestion.arguments, memory, common_, progress_, figures);
    if (!scene)
      return scene.error();
    Expected<std::vector<Candidate>> candidates = readCandidates(formatsPath_, *scene);
    if (!candidates)
      return candidates.error();
    Expected<std::vector<RaySet>> rays = makeRays(scene->shape, scene->extent);
    if (!rays)
      return rays.error();
    const Stopwatch watch;
    for (const RaySet &set : *rays)
      suggestion.rays.push_back(set.name);
    suggestion.voxels = scene->voxels;
    suggestion.valueWords = scene->valueWords;
    suggestion.rated =
        rateFormats(scene->priced(), std::move(*candidates), *rays, speedModelFor(device_), wish_, progress_);
    figures["rate_seconds"] = watch.seconds();
    if (progress_.stopped())
      return Error::interrupted();
    suggestion.choice = choose(suggestion.rated, wish_);
    if (!suggestion.choice)
      return Error::input("no format takes so few bytes as --max-bytes allows; a lower resolution would");
    return suggestion;
  }

  Expected<std::vector<RaySet>> makeRays(const SceneDag &dag, Int3 extent) const {
    std::vector<RaySet> sets;
    for (const std::string &path : rayFiles_) {
      Expected<std::vector<Ray>> rays = readRays(path);
      if (!rays)
        return rays.error();
      if (rays->size() < kReplayPacket)
        return Error::input("'" + path + "' has " + std::to_string(rays->size()) + " rays; " +
                            std::to_string(kReplayPacket) + " or more tell what a packet costs");
      sets.push_back({path, spreadPackets(*rays)});
    }
    if (sets.empty()) {
      sets.push_back({"camera", sampleCamera(frameExtent(extent, kWidth, kHeight), kReplayedRays)});
      std::vector<Ray> bounces = sampleBounces(dag, sets.front().rays, 1);
      if (!bounces.empty()) // Something is seen.
        sets.push_back({"bounced", std::move(bounces)});
    }
    return sets;
  }

  std::string input_;
  InputArguments inputArguments_;
  std::string objective_ = "balanced";
  Wish wish_;
  std::string device_ = "cpu";
  std::vector<std::string> rayFiles_;
  std::string formatsPath_;
  bool all_ = false;
  BuildArguments buildArguments_;
  CommonOptions common_;
  Progress progress_;
};

} // namespace

std::unique_ptr<Subcommand> makeSuggestCommand() { return std::make_unique<SuggestCommand>(); }

} // namespace voxc::tool
