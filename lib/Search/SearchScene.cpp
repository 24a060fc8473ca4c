// Reading a scene into a graph.
#include "voxc/Search/SearchScene.h"

#include "Source/GridExtent.h"
#include "voxc/Layout/Stratum.h"
#include "voxc/Search/SceneValues.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace voxc {
namespace {

using Opener = std::function<Expected<std::unique_ptr<VoxelSource>>()>;

/// Of a node of a graph, about.
constexpr std::uint64_t kNodeBytes = 48;

/// Of a number of each different grid of 4^3 voxels, within what short pointers may have.
int bitsOfGrids(const SceneDag &dag) {
  constexpr int kHeight = 2;
  const std::uint64_t grids = dag.log2Side() < kHeight ? 0 : dag.count(kHeight);
  return std::clamp(static_cast<int>(std::bit_width(grids)), 8, 24);
}

/// Adds what the values say.
Expected<SearchScene> finish(const std::string &name, SearchScene scene, SceneValues &values) {
  if (scene.shape.isEmpty())
    return Error::input("'" + name + "' has no voxels, so that any format would do");
  const auto cheapest = VOXC_TRY(values.finish());
  scene.voxels = values.voxels();
  scene.valueWords = values.isOne() ? 0 : cheapest.words;
  scene.traits = {.oneColour = values.isOne(),
                  .paletteBits = cheapest.paletteBits,
                  .visible = values.isVisible(),
                  .pointerBits = bitsOfGrids(scene.shape)};
  return scene;
}

Expected<SearchScene> readWith(SceneDag::Detail detail, const std::string &name, const Opener &open,
                               const std::shared_ptr<WorkingMemory> &memory, const Progress &progress) {
  const auto source = VOXC_TRY(open());
  auto values = VOXC_TRY(SceneValues::create(memory));
  const auto look = [&](std::span<const std::uint32_t> cells) { values.add(cells); };
  auto dag = VOXC_TRY(SceneDag::build(
      *source, {.detail = detail, .mostNodes = memory->bound() / kNodeBytes, .look = look}, progress));
  std::optional<SceneDag> colours;
  if (detail == SceneDag::Detail::Colours)
    colours = std::exchange(dag, dag.shape());
  return finish(name,
                {.shape = std::move(dag),
                 .colours = std::move(colours),
                 .extent = source->extent(),
                 .voxelToModel = source->voxelToModel(),
                 .traits = {}},
                values);
}

int log2SideOf(const Candidate &candidate) { return maxComponent(candidate.format.log2Extent()); }

/// Whether it holds the scene, and wastes no height.
bool isOfSize(const Candidate &candidate, const SearchScene &scene) {
  const Int3 held = candidate.format.extent();
  return log2SideOf(candidate) <= scene.shape.log2Side() && held.x >= scene.extent.x &&
         held.y >= scene.extent.y && held.z >= scene.extent.z;
}

std::string sideText(int log2Side) { return std::to_string(std::uint64_t{1} << log2Side); }

} // namespace

Expected<SearchScene> readSearchScene(const std::string &name, const Opener &open,
                                      const std::shared_ptr<WorkingMemory> &memory,
                                      const Progress &progress) {
  Expected<SearchScene> scene = readWith(SceneDag::Detail::Colours, name, open, memory, progress);
  // Shapes alone are far fewer.
  if (!scene && scene.error().kind == ErrorKind::Environment)
    return readWith(SceneDag::Detail::Shape, name, open, memory, progress);
  return scene;
}

Expected<std::vector<Candidate>> candidatesOf(const std::vector<std::string> &texts,
                                              const SearchScene &scene) {
  if (texts.empty())
    return candidatesFor(scene.shape.log2Side(), scene.traits);
  std::vector<Candidate> candidates;
  for (const std::string &text : texts)
    for (const SmallGrids grids : {SmallGrids::Pointed, SmallGrids::Numbered}) {
      auto candidate = VOXC_TRY(makeCandidate(text, scene.traits, {.grids = grids}));
      if (grids == SmallGrids::Pointed || candidate.format != candidates.back().format)
        candidates.push_back(std::move(candidate));
    }
  return candidates;
}

std::vector<std::string> formatsOfOtherSizes(const std::vector<Candidate> &candidates,
                                             const SearchScene &scene) {
  std::vector<std::string> others;
  for (const Candidate &candidate : candidates)
    if (!isOfSize(candidate, scene) && (others.empty() || others.back() != candidate.text))
      others.push_back(candidate.text);
  return others;
}

Error explainNone(const std::vector<Candidate> &candidates, const SearchScene &scene) {
  const auto fits = [&](const Candidate &candidate) { return isOfSize(candidate, scene); };
  if (candidates.empty() || std::ranges::any_of(candidates, fits))
    return Error::input("no format takes so few bytes as --max-bytes allows, or without it a volume; a lower "
                        "resolution would");
  const Candidate &first = candidates.front();
  if (log2SideOf(first) == scene.shape.log2Side()) // A side alone is as long.
    return Error::input("no format of the list is of the scene's size: '" + first.text + "' has " +
                        extentText(first.format.extent()) + " voxels, but the scene takes " +
                        extentText(scene.extent));
  const bool isSmaller = log2SideOf(first) < scene.shape.log2Side();
  return Error::input("no format of the list is of the scene's size: '" + first.text + "' has " +
                      sideText(log2SideOf(first)) + " voxels a side, " + (isSmaller ? "fewer" : "more") +
                      " than the " + sideText(scene.shape.log2Side()) +
                      " that the scene takes; the numbers of a format's levels should add up to " +
                      std::to_string(scene.shape.log2Side()) + ", as in G(" +
                      std::to_string(scene.shape.log2Side()) + ")");
}

} // namespace voxc
