// voxc suggest: the format that an input asks for, found without building any.
#include "BuildArguments.h"
#include "Building.h"
#include "InputArguments.h"
#include "Subcommand.h"
#include "SuggestReport.h"

#include "common/Files.h"
#include "common/Statistics.h"
#include "common/Terminal.h"
#include "voxc/Search/SampleRays.h"
#include "voxc/Search/SceneValues.h"
#include "voxc/Support/File.h"

#include <algorithm>
#include <bit>
#include <cstdio>
#include <map>
#include <sstream>

namespace voxc::tool {

namespace {

/// Of a node of a graph, about.
constexpr std::uint64_t kNodeBytes = 48;
/// Of each kind: more do not change which format it is.
constexpr std::size_t kSampledRays = 1024;
/// A picture in which neighbours are as close as in one of the usual size, and packets lie everywhere.
constexpr int kWidth = 1280;
constexpr int kHeight = 720;

const std::map<std::string, Wish::Objective> kObjectives = {{"balanced", Wish::Objective::Balanced},
                                                            {"fastest", Wish::Objective::Fastest},
                                                            {"smallest", Wish::Objective::Smallest}};

/// Of a number of each different grid of 4^3 voxels, within what short pointers may have.
int bitsOfGrids(const SceneDag &dag) {
  constexpr int kHeight = 2;
  const std::uint64_t grids = dag.log2Side() < kHeight ? 0 : dag.count(kHeight);
  return std::clamp(static_cast<int>(std::bit_width(grids)), 8, 24);
}

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
    constexpr int kMost = 1 << kMaxLog2Extent;
    InputOptions options = makeInputOptions(suggestion.arguments, {kMost, kMost, kMost});
    options.memory = makeWorkingMemory(buildArguments_);
    options.progress = progress_;
    Expected<LookedAt> scene = look(options, figures);
    if (!scene)
      return scene.error();
    const SceneDag &dag = scene->shape;
    suggestion.voxels = scene->values.voxels();
    const Expected<SceneValues::Cheapest> values = scene->values.finish();
    if (!values)
      return values.error();
    const CandidateTraits traits{.oneColour = scene->values.isOne(),
                                 .paletteBits = values->paletteBits,
                                 .visible = scene->values.isVisible(),
                                 .pointerBits = bitsOfGrids(dag)};
    if (dag.isEmpty())
      return Error::input("'" + input_ + "' has no voxels, so that any format would do");
    Expected<std::vector<Candidate>> candidates = makeCandidates(dag.log2Side(), traits);
    if (!candidates)
      return candidates.error();
    Expected<std::vector<RaySet>> rays = makeRays(dag, scene->extent);
    if (!rays)
      return rays.error();
    const Stopwatch watch;
    for (const RaySet &set : *rays)
      suggestion.rays.push_back(set.name);
    suggestion.valueWords = traits.oneColour ? 0 : values->words;
    suggestion.rated =
        rateFormats({dag, scene->colours ? &*scene->colours : nullptr, values->words}, std::move(*candidates),
                    *rays, defaultSpeedModel(device_), wish_, progress_);
    figures["rate_seconds"] = watch.seconds();
    if (progress_.stopped())
      return Error::interrupted();
    suggestion.choice = choose(suggestion.rated, wish_);
    if (!suggestion.choice)
      return Error::input("no format takes so few bytes as --max-bytes allows; a lower resolution would");
    return suggestion;
  }

  /// What was read of an input.
  struct LookedAt {
    SceneDag shape;
    std::optional<SceneDag> colours; ///< If there was memory for them.
    SceneValues values;
    Int3 extent;
  };

  Expected<LookedAt> look(const InputOptions &options, Json &figures) const {
    const Stopwatch watch;
    Expected<LookedAt> scene = read(options, SceneDag::Detail::Colours, options.memory->bound() / kNodeBytes);
    // Shapes alone are far fewer.
    if (!scene && scene.error().kind == ErrorKind::Environment)
      scene = read(options, SceneDag::Detail::Shape, options.memory->bound() / kNodeBytes);
    figures["read_seconds"] = watch.seconds();
    return scene;
  }

  Expected<LookedAt> read(const InputOptions &options, SceneDag::Detail detail, std::size_t mostNodes) const {
    Expected<Input> input = openInput(input_, options);
    if (!input)
      return input.error();
    tellWarnings(*input, common_);
    Expected<SceneValues> values = SceneValues::create(options.memory);
    if (!values)
      return values.error();
    const auto look = [&](std::span<const std::uint32_t> cells) { values->add(cells); };
    Expected<SceneDag> dag =
        SceneDag::build(*input->source, {.detail = detail, .mostNodes = mostNodes, .look = look}, progress_);
    if (!dag)
      return dag.error();
    const Int3 extent = input->source->extent();
    if (detail == SceneDag::Detail::Shape)
      return LookedAt{std::move(*dag), std::nullopt, std::move(*values), extent};
    SceneDag shape = dag->shape();
    return LookedAt{std::move(shape), std::move(*dag), std::move(*values), extent};
  }

  Expected<std::vector<Candidate>> makeCandidates(int log2Side, const CandidateTraits &traits) const {
    if (formatsPath_.empty())
      return candidatesFor(log2Side, traits);
    Expected<std::string> text = readTextFile(formatsPath_);
    if (!text)
      return text.error();
    std::vector<Candidate> candidates;
    std::istringstream lines(*text);
    for (std::string line; std::getline(lines, line);) {
      if (line.empty() || line.starts_with('#'))
        continue;
      for (const bool shortPointers : {false, true}) {
        Expected<Candidate> candidate = makeCandidate(line, traits, shortPointers);
        if (!candidate)
          return candidate.error();
        if (!shortPointers || candidate->format != candidates.back().format)
          candidates.push_back(std::move(*candidate));
      }
    }
    return candidates;
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
      sets.push_back({path, spread(*rays)});
    }
    if (sets.empty()) {
      sets.push_back({"camera", sampleCamera(frameExtent(extent, kWidth, kHeight), kSampledRays)});
      std::vector<Ray> bounces = sampleBounces(dag, sets.front().rays, 1);
      if (!bounces.empty()) // Something is seen.
        sets.push_back({"bounced", std::move(bounces)});
    }
    return sets;
  }

  /// Packets from all over a file.
  static std::vector<Ray> spread(const std::vector<Ray> &rays) {
    constexpr std::size_t kPacket = kReplayPacket;
    const std::size_t packets = std::min(rays.size(), kSampledRays) / kPacket;
    std::vector<Ray> some;
    for (std::size_t packet = 0; packet < packets; ++packet) {
      const auto first = rays.begin() + static_cast<std::ptrdiff_t>(rays.size() / packets * packet);
      some.insert(some.end(), first, first + kPacket);
    }
    return some;
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
