// A fragment at a time, as a volume that holds its voxels alone.
#include "jobs/PlanInput.h"

#include "building/ColourLoss.h"
#include "cluster/PlanFiles.h"
#include "program/Applications.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/Source/Sources.h"
#include "voxc/Support/File.h"
#include "voxc/Support/UserCache.h"

#include <filesystem>
#include <fstream>
#include <memory>

namespace voxc::tool {

using namespace cluster;

namespace {

/// What a plan's outputs are compared with, and what makes volumes of them.
struct Bench {
  const BuildPlan &plan;
  const PlanFiles &files;
  const Constructor &constructor;
  VoxelSource &input;
  const BuildOptions &options;
};

/// All outputs of a plan but its volume.
std::vector<WorkItem> fragmentsOf(const MergeTree &tree) {
  std::vector<WorkItem> items;
  for (std::size_t level = 0; level + 1 < tree.levels(); ++level)
    for (std::uint64_t index = 0; index < tree.count(level); ++index)
      items.push_back({level, index});
  return items;
}

/// The voxels of an output and those of the input in the same cubes. Errors: the output is broken (`Input`).
Expected<VoxelDifferences> compareOutput(const Bench &bench, const WorkItem &item) {
  auto built = VOXC_TRY(bench.constructor.mergeRun({bench.files.output(item)}, bench.options));
  const auto volume = std::make_shared<const Volume>(std::move(built.volume));
  const auto kept = VOXC_TRY(asKept(*volume, bench.input, bench.options.progress));
  const FragmentShare share = bench.plan.shareOf(item);
  const int log2Cells = 3 * bench.plan.cubes.log2Side;
  return compareVoxels(*makeVolumeSource(volume), kept ? *kept : bench.input, bench.options.progress,
                       {share.begin << log2Cells, share.end << log2Cells});
}

Expected<void> check(const Bench &bench, const WorkItem &item, PlanCheck &found) {
  const std::string path = bench.files.output(item);
  const auto differences = compareOutput(bench, item);
  if (!differences && differences.error().kind != ErrorKind::Input)
    return differences.error();
  if (!differences)
    found.broken.push_back({path, differences.error().message, {}});
  else if (!differences->none())
    found.broken.push_back({path, "", *differences});
  if (differences)
    found.differences.add(*differences);
  return {};
}

} // namespace

bool isBuildPlan(const std::string &path) {
  constexpr std::string_view kFirstWords = "voxc build plan ";
  std::string words(kFirstWords.size(), ' ');
  // A pipe would be waited for, and what was read of it were gone.
  std::error_code failure;
  if (!std::filesystem::is_regular_file(path, failure))
    return false;
  std::ifstream file(path, std::ios::binary);
  return file.read(words.data(), static_cast<std::streamsize>(words.size())) && words == kFirstWords;
}

Expected<PlanCheck> checkPlan(const std::string &path, const BuildArguments &means,
                              const Progress &progress) {
  const auto plan = VOXC_TRY(loadPlan(path));
  const PlanFiles files(plan, path);
  PlanCheck found;
  std::vector<WorkItem> there;
  for (const WorkItem &item : fragmentsOf(plan.tree())) {
    ++found.outputs;
    if (std::filesystem::exists(files.output(item)))
      there.push_back(item);
    else
      ++found.missing;
  }
  const BuildOptions options{
      .threads = threadsOf(means), .memory = makeWorkingMemory(means), .progress = progress};
  const auto input = VOXC_TRY(openPlanned(plan, there, options));
  const auto constructor = VOXC_TRY(Constructor::compile(plan.format, compileCache()));
  const Bench bench{plan, files, constructor, *input.source, options};
  for (const WorkItem &item : there)
    VOXC_TRY(check(bench, item, found));
  return found;
}

} // namespace voxc::tool
