// Running programs in Python.
#include "jobs/PythonProgram.h"

#include "jobs/Child.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <sstream>

namespace voxc::tool {
namespace {

namespace fs = std::filesystem;

/// Starts the first program of a name, and a path as it is.
constexpr const char *kStarter = "/usr/bin/env";
constexpr const char *kPythons[] = {"python3", "/usr/bin/python3"};
/// The exit codes where there is no Python, or one that cannot be started, and of a program of ours that
/// lacks a module, which it names.
constexpr int kNoPython = 127, kBadPython = 126, kNoModule = 69;

/// Debian's packages of modules.
constexpr std::pair<const char *, const char *> kPackages[] = {
    {"matplotlib", "python3-matplotlib"}, {"numpy", "python3-numpy"}, {"PIL", "python3-pil"}};

fs::path findProgram(const std::string &name) {
  std::error_code failure;
  const fs::path folder = fs::read_symlink("/proc/self/exe", failure).parent_path();
  return folder / ".." / "share" / "voxc" / "report" / name;
}

bool hasNoPython(const ChildReport &report) {
  return report.exitCode == kNoPython || report.exitCode == kBadPython;
}

bool isMissing(const ChildReport &report) { return hasNoPython(report) || report.exitCode == kNoModule; }

Error missing(const ChildReport &report) {
  if (hasNoPython(report))
    return Error::environment("this is drawn by Python with Matplotlib, and there is no Python; install the "
                              "package python3-matplotlib");
  const auto row = std::ranges::find(kPackages, report.failure,
                                     [](const auto &entry) { return std::string(entry.first); });
  return Error::environment("this is drawn by Python with Matplotlib, and Python has no " + report.failure +
                            "; install the package " +
                            (row == std::end(kPackages) ? "python3-matplotlib" : row->second));
}

/// What a program of ours says, whose exit codes are those of voxc.
Error failureOf(const ChildReport &report) {
  switch (report.exitCode) {
  case 1:
    return Error::input(report.failure);
  case 2:
    return Error::usage(report.failure);
  default:
    return Error::environment(report.failure);
  }
}

std::vector<std::string> linesOf(const std::string &text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    lines.push_back(line);
  return lines;
}

} // namespace

Expected<std::vector<std::string>> runPythonProgram(const std::string &name,
                                                    const std::vector<std::string> &arguments,
                                                    const Progress &progress) {
  const fs::path program = findProgram(name);
  std::error_code failure;
  if (!fs::exists(program, failure))
    return Error::environment("there is no '" + program.lexically_normal().string() +
                              "', which makes this; it is installed with voxc");
  Expected<ChildReport> report = ChildReport{};
  for (const char *python : kPythons) {
    std::vector<std::string> words{kStarter, python, program.string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    report = runProgram(words, progress);
    if (!report)
      return report.error();
    if (!isMissing(*report))
      break;
  }
  if (isMissing(*report))
    return missing(*report);
  if (!report->succeeded)
    return failureOf(*report);
  return linesOf(report->errors);
}

} // namespace voxc::tool
