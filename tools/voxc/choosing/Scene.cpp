// Reading the input of a search.
#include "choosing/Scene.h"

#include "common/FormatList.h"
#include "voxc/Layout/Stratum.h"
#include "voxc/Support/Stopwatch.h"

#include <algorithm>
#include <utility>

namespace voxc::tool {

InputOptions sceneOptions(const InputArguments &arguments, std::shared_ptr<WorkingMemory> memory,
                          const Progress &progress) {
  constexpr int kMost = 1 << kMaxLog2Extent;
  InputOptions options = makeInputOptions(arguments, {kMost, kMost, kMost});
  options.memory = std::move(memory);
  options.progress = progress;
  return options;
}

Expected<Scene> readScene(const std::string &input, const InputOptions &options, const CommonOptions &common,
                          Json &figures) {
  ToldSentences told;
  std::string provenance;
  const auto open = [&]() -> Expected<std::unique_ptr<VoxelSource>> {
    auto opened = VOXC_TRY(openInput(input, options));
    tellWarnings(opened, common, told);
    provenance = opened.provenance;
    return std::move(opened.source);
  };
  const Stopwatch watch;
  Expected<SearchScene> scene = readSearchScene(input, open, options.memory, options.progress);
  figures["read_seconds"] = watch.seconds();
  if (!scene)
    return scene.error();
  return Scene{std::move(*scene), std::move(provenance), std::move(told)};
}

Expected<std::vector<Candidate>> readCandidates(const std::string &list, const SearchScene &scene) {
  std::vector<std::string> texts;
  if (!list.empty()) {
    const auto lines = VOXC_TRY(readFormatList(list));
    for (const FormatLine &line : lines)
      texts.push_back(line.text);
  }
  return candidatesOf(texts, scene);
}

void noteOtherSizes(const std::vector<Candidate> &candidates, const SearchScene &scene,
                    const CommonOptions &common) {
  const std::vector<std::string> others = formatsOfOtherSizes(candidates, scene);
  const auto fits = [&](const Candidate &candidate) {
    return std::ranges::find(others, candidate.text) == others.end();
  };
  if (!others.empty() && !common.quiet && std::ranges::any_of(candidates, fits))
    printNote("formats that are not of " + std::to_string(std::uint64_t{1} << scene.shape.log2Side()) +
              " voxels a side, as the scene is, are left out: '" + others.front() + "'" +
              (others.size() > 1 ? " and " + std::to_string(others.size() - 1) + " more" : ""));
}

} // namespace voxc::tool
