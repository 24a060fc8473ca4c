// The options of voxc search.
#include "search/SearchOptions.h"

#include "common/ShellWord.h"
#include "search/ObjectiveOption.h"
#include "sweep/Machine.h"
#include "sweep/Model.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <map>

namespace voxc::tool {

namespace {

/// "180", "180s", "3m", "2h" in seconds; 0 for what is none of these.
double secondsOf(const std::string &text) {
  std::size_t end = 0;
  double value = 0;
  try {
    value = std::stod(text, &end);
  } catch (const std::exception &) {
    return 0;
  }
  static const std::map<std::string, double> kUnits = {
      {"", 1}, {"s", 1}, {"m", 60}, {"min", 60}, {"h", 3600}};
  const auto unit = kUnits.find(text.substr(end));
  return unit != kUnits.end() && value > 0 && value < 1e9 ? value * unit->second : 0;
}

} // namespace

void SearchOptions::declare(CLI::App &app) {
  app.add_option("INPUT", input, kInputHelp)->required()->type_name("");
  addInputArguments(app, inputArguments);
  app.get_option("--resolution")
      ->description("Voxels on the longest axis; default: " + std::to_string(kDefaultResolution));
  app.add_option("--budget", budgetText_, "Time that the search may take, such as 90s, 5m or 2h")
      ->type_name("TIME")
      ->capture_default_str();
  app.add_option("-o,--output", folder, "Folder of results and volumes; an earlier search's is continued")
      ->required()
      ->type_name("DIR");
  app.add_option("--device", device, "Device whose name contains this, or cpu; default: the best")
      ->type_name("NAME");
  app.add_option("--precision", precision, "exact or fast")
      ->type_name("P")
      ->check(CLI::IsMember(std::vector<std::string>(kPrecisionAttribute.values.begin(),
                                                     kPrecisionAttribute.values.end()))
                  .description(""))
      ->capture_default_str();
  addObjectiveArgument(app, objective_, "Whose command is told");
  addMaxBytesArgument(app, building);
  app.get_option("--max-bytes")->description("The most bytes that a volume's words may take, such as 64MiB");
  app.add_option("--min-speed", leastSpeed, "The least speed that is of use, in million rays a second")
      ->type_name("M")
      ->check(CLI::NonNegativeNumber.description(""));
  app.add_option("--cameras", rays.cameraFile,
                 "A camera file: its camera of the input's name, or all if there is none; default: one that "
                 "sees the whole volume, and rays from where it hits that go anywhere")
      ->type_name("FILE");
  app.add_option("--size", rays.size, "Pixels of the cameras' pictures; default: the file's, or 480x270")
      ->type_name("WxH");
  app.add_option("--rays", rays.rayFiles, "A file of rays; may be given several times")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->type_name("R.bin");
  app.add_option("--formats", formatsPath, "A file of formats, one a line, to choose from and nothing else")
      ->type_name("FILE");
  app.add_flag("--all", all, "Measure all formats that are looked at, however little they promise");
  app.add_option("--max-levels", explore.maxLevels, "The most levels of a format")
      ->type_name("N")
      ->check(CLI::Range(1, 8).description(""))
      ->capture_default_str();
  app.add_option("--explore", explore.mostFormats, "The most formats of which size and speed are foretold")
      ->type_name("N")
      ->check(CLI::Range(1, 10'000'000).description(""))
      ->capture_default_str();
  app.add_option("--check", check, "Rays, evenly spread, on which errors are found; 0: none")
      ->type_name("N")
      ->capture_default_str();
  app.add_option("--seed", seed, "Of the rays that go anywhere")->type_name("N")->capture_default_str();
  app.add_option("--threads", building.threads,
                 "Threads that build, and of a device that is this processor; default: all")
      ->type_name("N")
      ->check(CLI::Range(1u, 1024u).description(""));
  addMemoryArguments(app, building);
  addCommonOptions(app, common);
}

Expected<void> SearchOptions::read() {
  budget = secondsOf(budgetText_);
  if (budget <= 0)
    return Error::usage("--budget '" + budgetText_ + "' is no time; it should be such as 90s, 5m or 2h");
  wish = {objectiveOf(objective_), std::min(maxWordsOf(building), kMaxWords) * sizeof(std::uint32_t)};
  // Several volumes of a batch lie in memory together, on a device too.
  constexpr std::uint64_t kShare = 12;
  if (building.maxBytes.empty())
    wish.maxBytes = std::min(wish.maxBytes, bench::machineMemory() / kShare);
  if (inputArguments.resolution == 0)
    inputArguments.resolution = kDefaultResolution;
  return {};
}

std::string SearchOptions::commandText() const {
  std::string text = "voxc search " + shellWord(input);
  for (const std::string &word : bench::toWords(inputArguments))
    text += " " + word;
  return text + " --budget " + budgetText_ + " -o " + shellWord(folder);
}

} // namespace voxc::tool
