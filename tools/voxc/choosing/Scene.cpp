// Reading an input into a graph.
#include "choosing/Scene.h"

#include "bench/FormatList.h"
#include "voxc/Search/SceneValues.h"
#include "voxc/Support/Stopwatch.h"

#include <algorithm>
#include <bit>

namespace voxc::tool {

namespace {

/// Of a node of a graph, about.
constexpr std::uint64_t kNodeBytes = 48;

/// Of a number of each different grid of 4^3 voxels, within what short pointers may have.
int bitsOfGrids(const SceneDag &dag) {
  constexpr int kHeight = 2;
  const std::uint64_t grids = dag.log2Side() < kHeight ? 0 : dag.count(kHeight);
  return std::clamp(static_cast<int>(std::bit_width(grids)), 8, 24);
}

class Reader {
public:
  Reader(const std::string &input, const InputArguments &arguments,
         const std::shared_ptr<WorkingMemory> &memory, const CommonOptions &common, const Progress &progress)
      : input_(input), options_(makeInputOptions(arguments, {kMost, kMost, kMost})), common_(common) {
    options_.memory = memory;
    options_.progress = progress;
  }

  Expected<Scene> read() {
    Expected<Scene> scene = readWith(SceneDag::Detail::Colours);
    // Shapes alone are far fewer.
    if (!scene && scene.error().kind == ErrorKind::Environment)
      return readWith(SceneDag::Detail::Shape);
    return scene;
  }

private:
  static constexpr int kMost = 1 << kMaxLog2Extent;

  Expected<Scene> readWith(SceneDag::Detail detail) {
    Expected<Input> input = openInput(input_, options_);
    if (!input)
      return input.error();
    tellWarnings(*input, common_, told_);
    Expected<SceneValues> values = SceneValues::create(options_.memory);
    if (!values)
      return values.error();
    const auto look = [&](std::span<const std::uint32_t> cells) { values->add(cells); };
    Expected<SceneDag> dag = SceneDag::build(
        *input->source, {.detail = detail, .mostNodes = options_.memory->bound() / kNodeBytes, .look = look},
        options_.progress);
    if (!dag)
      return dag.error();
    const bool hasColours = detail == SceneDag::Detail::Colours;
    SceneDag shape = hasColours ? dag->shape() : std::move(*dag);
    return finish({.shape = std::move(shape),
                   .colours = hasColours ? std::optional(std::move(*dag)) : std::nullopt,
                   .extent = input->source->extent(),
                   .voxelToModel = input->source->voxelToModel(),
                   .provenance = input->provenance,
                   .traits = {},
                   .told = told_},
                  *values);
  }

  Expected<Scene> finish(Scene scene, SceneValues &values) const {
    if (scene.shape.isEmpty())
      return Error::input("'" + input_ + "' has no voxels, so that any format would do");
    const Expected<SceneValues::Cheapest> cheapest = values.finish();
    if (!cheapest)
      return cheapest.error();
    scene.voxels = values.voxels();
    scene.valueWords = values.isOne() ? 0 : cheapest->words;
    scene.traits = {.oneColour = values.isOne(),
                    .paletteBits = cheapest->paletteBits,
                    .visible = values.isVisible(),
                    .pointerBits = bitsOfGrids(scene.shape)};
    return scene;
  }

  const std::string &input_;
  InputOptions options_;
  const CommonOptions &common_;
  ToldSentences told_;
};

} // namespace

Expected<Scene> readScene(const std::string &input, const InputArguments &arguments,
                          const std::shared_ptr<WorkingMemory> &memory, const CommonOptions &common,
                          const Progress &progress, Json &figures) {
  const Stopwatch watch;
  Expected<Scene> scene = Reader(input, arguments, memory, common, progress).read();
  figures["read_seconds"] = watch.seconds();
  return scene;
}

Expected<std::vector<Candidate>> readCandidates(const std::string &list, const Scene &scene) {
  if (list.empty())
    return candidatesFor(scene.shape.log2Side(), scene.traits);
  const auto lines = bench::readFormatList(list);
  if (!lines)
    return lines.error();
  std::vector<Candidate> candidates;
  for (const bench::FormatLine &line : *lines)
    for (const SmallGrids grids : {SmallGrids::Pointed, SmallGrids::Numbered}) {
      Expected<Candidate> candidate = makeCandidate(line.text, scene.traits, {.grids = grids});
      if (!candidate)
        return candidate.error();
      if (grids == SmallGrids::Pointed || candidate->format != candidates.back().format)
        candidates.push_back(std::move(*candidate));
    }
  return candidates;
}

namespace {

int log2SideOf(const Candidate &candidate) { return maxComponent(candidate.format.log2Extent()); }

std::string sideText(int log2Side) { return std::to_string(std::uint64_t{1} << log2Side); }

std::vector<std::string> formatsOfOtherSizes(const std::vector<Candidate> &candidates, const Scene &scene) {
  std::vector<std::string> others;
  for (const Candidate &candidate : candidates)
    if (log2SideOf(candidate) != scene.shape.log2Side() &&
        (others.empty() || others.back() != candidate.text))
      others.push_back(candidate.text);
  return others;
}

} // namespace

void noteOtherSizes(const std::vector<Candidate> &candidates, const Scene &scene,
                    const CommonOptions &common) {
  const std::vector<std::string> others = formatsOfOtherSizes(candidates, scene);
  const auto fits = [&](const Candidate &candidate) {
    return log2SideOf(candidate) == scene.shape.log2Side();
  };
  if (!others.empty() && !common.quiet && std::ranges::any_of(candidates, fits))
    printNote("formats that are not of " + sideText(scene.shape.log2Side()) +
              " voxels a side, as the scene is, are left out: '" + others.front() + "'" +
              (others.size() > 1 ? " and " + std::to_string(others.size() - 1) + " more" : ""));
}

Error explainNone(const std::vector<Candidate> &candidates, const Scene &scene) {
  const auto fits = [&](const Candidate &candidate) {
    return log2SideOf(candidate) == scene.shape.log2Side();
  };
  if (candidates.empty() || std::ranges::any_of(candidates, fits))
    return Error::input("no format takes so few bytes as --max-bytes allows; a lower resolution would");
  const Candidate &first = candidates.front();
  const bool isSmaller = log2SideOf(first) < scene.shape.log2Side();
  return Error::input("no format of the list is of the scene's size: '" + first.text + "' has " +
                      sideText(log2SideOf(first)) + " voxels a side, " + (isSmaller ? "fewer" : "more") +
                      " than the " + sideText(scene.shape.log2Side()) +
                      " that the scene takes; the numbers of a format's levels should add up to " +
                      std::to_string(scene.shape.log2Side()) + ", as in G(" +
                      std::to_string(scene.shape.log2Side()) + ")");
}

} // namespace voxc::tool
