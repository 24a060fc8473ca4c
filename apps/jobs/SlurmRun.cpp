// Arrays with dependencies, and waiting for them.
#include "jobs/SlurmRun.h"

#include "cluster/NumberList.h"
#include "common/Command.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <thread>

namespace voxc::tool {

using namespace cluster;

namespace {

/// Questions in a row that Slurm may leave without an answer: its controller may be starting again.
constexpr int kMostSilence = 60;

/// A word as the shell takes it.
std::string quoted(const std::string &word) {
  std::string text = "'";
  for (const char letter : word)
    text += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return text + "'";
}

/// The line that a job of a level runs. In the command's words its number stands for what no word can hold.
std::string commandLine(const Jobs &jobs, std::size_t level) {
  constexpr char kMark = '\0';
  std::error_code ignored;
  const std::string folder = jobs.workingFolder();
  std::string line = folder.empty() ? "" : "cd " + quoted(folder) + " && ";
  line += "exec " + quoted(std::filesystem::read_symlink("/proc/self/exe", ignored).string());
  for (const std::string &word : jobs.command(level, std::string(1, kMark))) {
    const std::size_t mark = word.find(kMark);
    if (mark == std::string::npos) {
      line += " " + quoted(word);
      continue;
    }
    const std::string before = word.substr(0, mark), behind = word.substr(mark + 1);
    line += (before.empty() ? " " : " " + quoted(before)) + "\"$SLURM_ARRAY_TASK_ID\"" +
            (behind.empty() ? "" : quoted(behind));
  }
  return line;
}

/// The numbers of the arrays that have items of a level.
std::vector<std::string> arraysOf(const std::vector<QueuedJob> &queue, std::size_t level) {
  std::set<std::string> arrays;
  for (const QueuedJob &job : queue)
    if (job.level == level)
      arrays.insert(job.array);
  return {arrays.begin(), arrays.end()};
}

/// Hands over what no job of the queue does, for nodes other than `avoid`; adds the arrays that there are
/// then to `arrays`. Returns how many jobs.
Expected<std::uint64_t> handOver(const Jobs &jobs, const Slurm &slurm, const Jobs::Missing &missing,
                                 const std::vector<QueuedJob> &queue, const std::vector<std::string> &avoid,
                                 std::set<std::string> &arrays) {
  std::uint64_t count = 0;
  std::vector<std::string> below;
  for (std::size_t level = 0; level < missing.size(); ++level) {
    std::vector<std::uint64_t> numbers = missing[level];
    std::erase_if(numbers, [&](std::uint64_t number) {
      return std::ranges::any_of(
          queue, [&](const QueuedJob &job) { return job.level == level && job.number == number; });
    });
    std::vector<std::string> here = arraysOf(queue, level);
    if (!numbers.empty()) {
      const auto array = VOXC_TRY(slurm.submit(
          {level, numberListText(numbers), below, avoid, commandLine(jobs, level), jobs.folder()}));
      here.push_back(array);
      count += numbers.size();
    }
    arrays.insert(here.begin(), here.end());
    below = std::move(here);
  }
  return count;
}

class Waiting {
public:
  Waiting(const Jobs &jobs, const SlurmMeans &means, const JobWatch &watch, const Slurm &slurm)
      : jobs_(jobs), means_(means), watch_(watch), slurm_(slurm) {}

  /// Waits until no job of the work waits or runs.
  Expected<void> forAll(std::uint64_t all) const {
    int silence = 0;
    for (;;) {
      const auto queue = slurm_.queue(jobs_.levels());
      if (queue && queue->empty())
        return {};
      if (!queue && ++silence > kMostSilence)
        return queue.error();
      if (queue) {
        silence = 0;
        slurm_.release(*queue);
        const std::uint64_t left = std::min<std::uint64_t>(queue->size(), all);
        watch_.progress.at("jobs", 1 - static_cast<double>(left) / static_cast<double>(all), all - left);
      }
      VOXC_TRY(sleep());
    }
  }

private:
  Expected<void> sleep() const {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::duration<double>(means_.pollSeconds);
    do {
      if (watch_.progress.stopped())
        return Error::interrupted();
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    } while (Clock::now() < end);
    return {};
  }

  const Jobs &jobs_;
  const SlurmMeans &means_;
  const JobWatch &watch_;
  const Slurm &slurm_;
};

/// What the jobs took, as far as Slurm can say.
void addAccounts(Json &figures, const std::vector<JobAccount> &accounts) {
  if (accounts.empty())
    return;
  std::optional<double> cpuSeconds;
  double longest = 0;
  std::map<std::string, std::uint64_t> states;
  for (const JobAccount &account : accounts) {
    if (account.cpuSeconds)
      cpuSeconds = cpuSeconds.value_or(0) + *account.cpuSeconds;
    longest = std::max(longest, account.seconds);
    ++states[account.state.substr(0, account.state.find(' '))];
  }
  if (cpuSeconds)
    figures["jobs_cpu_seconds"] = *cpuSeconds;
  figures["longest_job_seconds"] = longest;
  for (const auto &[state, count] : states)
    figures["job_states"][state] = count;
}

/// The nodes on which jobs failed and none ended well: a disk may be full there.
std::vector<std::string> nodesThatFail(const std::vector<JobAccount> &accounts) {
  std::set<std::string> failed;
  for (const JobAccount &account : accounts)
    if (!account.node.empty() && !account.state.starts_with("COMPLETED"))
      failed.insert(account.node);
  for (const JobAccount &account : accounts)
    if (account.state.starts_with("COMPLETED"))
      failed.erase(account.node);
  return {failed.begin(), failed.end()};
}

/// Why work is left, as far as Slurm can say.
Error whatFailed(const Jobs &jobs, std::uint64_t missing, const std::vector<JobAccount> &accounts) {
  std::string failed;
  for (const JobAccount &account : accounts)
    if (!account.state.starts_with("COMPLETED"))
      failed += (failed.empty() ? "; " : ", ") + account.job + " " + account.state;
  return Error::environment(std::to_string(missing) + " of " + jobs.allName() +
                            " are still missing, and no job made any of them" + failed + "; logs lie in '" +
                            jobs.folder() + "'");
}

} // namespace

Slurm slurmOf(const Jobs &jobs, const SlurmMeans &means) { return Slurm(jobs.name(), means.options); }

Expected<void> runBySlurm(const Jobs &jobs, const SlurmMeans &means, const JobWatch &watch, Json &figures) {
  const Slurm slurm = slurmOf(jobs, means);
  std::set<std::string> arrays;
  std::vector<std::string> avoid;
  std::uint64_t submitted = 0;
  for (bool isFirst = true;; isFirst = false) {
    // In this order: what ends meanwhile stands, and is not handed over twice.
    const auto queue = VOXC_TRY(slurm.queue(jobs.levels()));
    const auto missing = VOXC_TRY(jobs.missing());
    const std::uint64_t count = countOf(missing);
    if (isFirst)
      figures["missing"] = count;
    else if (count > 0 && !watch.quiet)
      printNote("note: " + std::to_string(count) + " of " + jobs.allName() +
                " are still missing, and are asked for again");
    if (count == 0)
      break;
    std::set<std::string> round;
    const auto handed = VOXC_TRY(handOver(jobs, slurm, missing, queue, avoid, round));
    arrays.insert(round.begin(), round.end());
    submitted += handed;
    figures["submitted"] = submitted;
    if (!means.wait)
      return {};
    VOXC_TRY(Waiting(jobs, means, watch, slurm).forAll(count));
    // What failed wherever it ran may do on another node: once, if nothing else was done meanwhile.
    const std::vector<JobAccount> accounts = slurm.accounts({round.begin(), round.end()});
    const bool wasElsewhere = !avoid.empty();
    avoid = nodesThatFail(accounts);
    const auto left = VOXC_TRY(jobs.missing());
    // Where all jobs were of an earlier run, which may have been cancelled, none was asked for so far.
    if (left == missing && handed > 0 && (wasElsewhere || avoid.empty()))
      return whatFailed(jobs, countOf(left), accounts);
  }
  addAccounts(figures, slurm.accounts({arrays.begin(), arrays.end()}));
  return {};
}

} // namespace voxc::tool
