// The command lines of Slurm, and reading what they print.
#include "cluster/Slurm.h"

#include "cluster/Program.h"

#include <charconv>
#include <sstream>

namespace voxc::tool::cluster {
namespace {

/// The output of one of Slurm's programs, or its complaint.
Expected<std::string> ask(const std::vector<std::string> &words) {
  auto report = VOXC_TRY(runProgram(words));
  if (report.exitCode == 0)
    return std::move(report.output);
  std::string said = report.output.substr(0, report.output.find('\n'));
  return Error::environment(
      words[0] + " failed: " + (said.empty() ? "exit code " + std::to_string(report.exitCode) : said));
}

template <typename Number> bool readNumber(std::string_view text, Number &number) {
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
  return failure == std::errc() && end == text.data() + text.size();
}

std::vector<std::string> split(const std::string &line, char separator) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, separator);)
    fields.push_back(field);
  return fields;
}

std::string joined(const std::vector<std::string> &words, const char *separator) {
  std::string text;
  for (const std::string &word : words)
    text += (text.empty() ? "" : separator) + word;
  return text;
}

/// A path as sbatch takes it for a log: a percent sign of its own is not one of Slurm's patterns.
std::string logPath(const std::string &folder) {
  std::string path;
  for (const char letter : folder)
    path += letter == '%' ? std::string("%%") : std::string(1, letter);
  return path + "/job-%A-%a.log";
}

/// Runs sbatch; returns the number of the array.
Expected<std::string> handOver(const std::vector<std::string> &words) {
  const auto output = VOXC_TRY(ask(words));
  // "123", or "123;cluster"; warnings stand on lines before it.
  const std::string text = output.substr(0, output.find_last_not_of(" \n") + 1);
  const std::string last = text.substr(text.rfind('\n') + 1);
  const std::string number = last.substr(0, last.find(';'));
  if (number.empty() || number.find_first_not_of("0123456789") != std::string::npos)
    return Error::environment("sbatch answered '" + last + "' where it should give the number of a job");
  return number;
}

} // namespace

double secondsOfTime(std::string_view text) {
  double days = 0;
  if (const std::size_t dash = text.find('-'); dash != std::string_view::npos) {
    if (!readNumber(text.substr(0, dash), days))
      return 0;
    text.remove_prefix(dash + 1);
  }
  double seconds = 0;
  for (const std::string &field : split(std::string(text), ':')) {
    double number = 0;
    if (!readNumber(std::string_view(field), number))
      return 0;
    seconds = 60 * seconds + number;
  }
  return 86400 * days + seconds;
}

Expected<std::vector<QueuedJob>> Slurm::queue(std::size_t levels) const {
  std::string names;
  for (std::size_t level = 0; level < levels; ++level)
    names += (level == 0 ? "" : ",") + nameOf(level);
  const auto output = VOXC_TRY(
      ask({"squeue", "--me", "--array", "--noheader", "--name=" + names, "--format=%F %K %T %j %r"}));
  std::vector<QueuedJob> jobs;
  for (const std::string &line : split(output, '\n')) {
    std::istringstream words(line);
    std::string array, index, state, name;
    // Warnings stand on lines of their own.
    if (!(words >> array >> index >> state >> name))
      continue;
    std::string reason;
    std::getline(words >> std::ws, reason);
    QueuedJob job{array, 0, 0, state != "PENDING", reason == "launch failed requeued held"};
    const std::size_t dash = name.rfind('-');
    if (dash != std::string::npos && readNumber(std::string_view(name).substr(dash + 1), job.level) &&
        job.level < levels && readNumber(std::string_view(index), job.number))
      jobs.push_back(std::move(job));
  }
  return jobs;
}

void Slurm::release(const std::vector<QueuedJob> &jobs) const {
  std::string held;
  for (const QueuedJob &job : jobs)
    if (job.isHeld)
      held += (held.empty() ? "" : ",") + job.array + "_" + std::to_string(job.number);
  // If that fails they are still held when they are looked at next.
  if (!held.empty())
    (void)ask({"scontrol", "release", held});
}

Expected<std::string> Slurm::submit(const SlurmArray &array) const {
  std::vector<std::string> words = {"sbatch",
                                    "--parsable",
                                    "--job-name=" + nameOf(array.level),
                                    "--array=" + array.indices,
                                    "--output=" + logPath(array.logFolder),
                                    "--requeue",
                                    "--kill-on-invalid-dep=yes"};
  if (!array.after.empty())
    words.push_back("--dependency=afterok:" + joined(array.after, ":"));
  words.insert(words.end(), options_.begin(), options_.end());
  words.push_back("--wrap=" + array.command);
  if (!array.avoid.empty()) {
    std::vector<std::string> elsewhere = words;
    elsewhere.insert(elsewhere.begin() + 1, "--exclude=" + joined(array.avoid, ","));
    if (auto number = handOver(elsewhere))
      return number;
    // No other node would do.
  }
  auto number = handOver(words);
  if (!number && number.error().message.find("Invalid job array") != std::string::npos)
    return Error::environment(number.error().message +
                              "; its indices must be below Slurm's MaxArraySize: plan fewer parts");
  return number;
}

std::vector<JobAccount> Slurm::accounts(const std::vector<std::string> &arrays) const {
  std::vector<JobAccount> accounts;
  if (arrays.empty())
    return accounts;
  const std::string jobs = "--jobs=" + joined(arrays, ",");
  const auto kept =
      ask({"sacct", "--noheader", "--parsable2", jobs, "--format=JobID,NodeList,State,ElapsedRaw,TotalCPU"});
  const auto output =
      kept ? kept
           : ask({"squeue", "--noheader", "--array", "--states=all", jobs, "--format=%F_%K|%N|%T|%M|"});
  if (!output)
    return accounts;
  for (const std::string &line : split(*output, '\n')) {
    const std::vector<std::string> fields = split(line, '|');
    // The steps of a job have a point in their names; what they took is in the job's own line.
    if (fields.size() < 4 || fields[0].find('.') != std::string::npos)
      continue;
    JobAccount account{fields[0], fields[1], fields[2], secondsOfTime(fields[3]), {}};
    if (account.node == "None assigned")
      account.node.clear();
    if (kept && fields.size() > 4)
      account.cpuSeconds = secondsOfTime(fields[4]);
    accounts.push_back(std::move(account));
  }
  return accounts;
}

} // namespace voxc::tool::cluster
