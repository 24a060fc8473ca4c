// From a plan to a fragment, or to the volume.
#include "jobs/PlanTasks.h"

#include "jobs/PlanInput.h"

#include "cluster/NumberList.h"
#include "cluster/PlanFiles.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/Support/UserCache.h"
#include "voxc/Volume/Volume.h"

namespace voxc::tool {

using namespace cluster;

namespace {

/// A plan, with the items that a task is asked for and that do not stand.
struct Task {
  BuildPlan plan;
  std::vector<WorkItem> missing;
  std::uint64_t standing = 0;
};

/// The items of a level, or of all merges for level 1.
Expected<Task> readTask(const std::string &path, const std::string &numbers, std::size_t level) {
  auto plan = VOXC_TRY(loadPlan(path));
  const MergeTree tree = plan.tree();
  const std::uint64_t limit = level == 0 ? tree.count(0) : tree.merges();
  const auto chosen = parseNumberList(numbers, limit);
  if (!chosen)
    return Error::usage("'" + numbers + "' is no list of numbers from 0 to " + std::to_string(limit - 1) +
                        "; write one such as 0,3,5-9");
  Task task{std::move(plan), {}, 0};
  const PlanFiles files(task.plan, path);
  VOXC_TRY(files.makeFolder());
  for (const std::uint64_t number : *chosen) {
    const WorkItem item = level == 0 ? WorkItem{0, number} : tree.merge(number);
    if (files.stands(item))
      ++task.standing;
    else
      task.missing.push_back(item);
  }
  return task;
}

BuildOptions optionsOf(const BuildArguments &arguments, const Progress &progress) {
  BuildOptions options;
  options.threads = arguments.threads == 0 ? 1 : arguments.threads;
  options.memory = makeWorkingMemory(arguments);
  options.progress = progress;
  return options;
}

void addTaskFigures(Json &figures, const Task &task, std::uint64_t voxels, std::uint64_t scratchBytes) {
  figures["done"] = task.missing.size();
  figures["standing"] = task.standing;
  figures["voxels"] = voxels;
  figures["scratch_bytes"] = scratchBytes;
}

} // namespace

Expected<void> buildParts(const std::string &path, const std::string &numbers,
                          const BuildArguments &arguments, const Progress &progress, Json &figures) {
  const auto task = VOXC_TRY(readTask(path, numbers, 0));
  std::uint64_t voxels = 0;
  BuildOptions options = optionsOf(arguments, progress);
  if (!task.missing.empty()) {
    auto input = VOXC_TRY(openPlanned(task.plan, task.missing, options));
    auto constructor = VOXC_TRY(Constructor::compile(task.plan.format, compileCache()));
    options.provenance = input.provenance;
    const PlanFiles files(task.plan, path);
    Json seconds = Json::array();
    for (const WorkItem &item : task.missing) {
      const auto report = VOXC_TRY(
          constructor.buildFragment(*input.source, task.plan.shareOf(item), files.output(item), options));
      voxels += report.voxels;
      seconds.push_back(
          {{"part", item.index}, {"voxels", report.voxels}, {"build_cpu_seconds", report.cpuSeconds}});
    }
    figures["parts"] = std::move(seconds);
  }
  addTaskFigures(figures, task, voxels, options.memory->scratchPeak());
  return {};
}

namespace {

/// Writes the output of one merge. Returns its voxels.
Expected<std::uint64_t> merge(const Constructor &constructor, const BuildPlan &plan, const PlanFiles &files,
                              const WorkItem &item, BuildOptions options) {
  const MergeTree tree = plan.tree();
  std::vector<std::string> paths;
  for (const WorkItem &child : tree.childrenOf(item))
    paths.push_back(files.output(child));
  if (!tree.isRoot(item)) {
    auto report = constructor.joinFragments(paths, plan.shareOf(item), files.output(item), options);
    return report ? Expected<std::uint64_t>(report->voxels) : report.error();
  }
  options.path = files.output(item);
  options.compress = plan.compress;
  VOXC_TRY(checkNoJournal(options.path)); // Its edits would be of no file.
  const auto built = VOXC_TRY(constructor.merge(paths, options));
  VOXC_TRY(files.noteVolume());
  return built.report.voxels;
}

} // namespace

Expected<void> mergeParts(const std::string &path, const std::string &numbers,
                          const BuildArguments &arguments, const Progress &progress, Json &figures) {
  const auto task = VOXC_TRY(readTask(path, numbers, 1));
  std::uint64_t voxels = 0;
  const BuildOptions options = optionsOf(arguments, progress);
  if (!task.missing.empty()) {
    auto constructor = VOXC_TRY(Constructor::compile(task.plan.format, compileCache()));
    const PlanFiles files(task.plan, path);
    for (const WorkItem &item : task.missing) {
      const auto merged = VOXC_TRY(merge(constructor, task.plan, files, item, options));
      voxels += merged;
    }
  }
  addTaskFigures(figures, task, voxels, options.memory->scratchPeak());
  return {};
}

} // namespace voxc::tool
