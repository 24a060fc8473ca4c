// The options of voxc search.
#include "search/SearchOptions.h"

#include "choosing/ObjectiveOption.h"
#include "sweep/Model.h"
#include "voxc/IR/Query.h"
#include "voxc/Measure/Machine.h"
#include "voxc/Support/ShellWord.h"

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

void SearchOptions::declare(const CommandLine &command) {
  command.add("INPUT", input, kInputHelp).required().takes("");
  addInputArguments(command, inputArguments);
  command.option("--resolution")
      .text("Voxels on the longest axis; default: " + std::to_string(kDefaultResolution));
  command.add("--budget", budgetText_, "Time that the search may take, such as 90s, 5m or 2h")
      .takes("TIME")
      .showsDefault();
  command.add("-o,--output", folder, "Folder of results and volumes; an earlier search's is continued")
      .required()
      .takes("DIR");
  command.add("--device", device, "Device whose name contains this, or cpu; default: the best").takes("NAME");
  command.add("--precision", precision, "exact or fast")
      .takes("P")
      .oneOf(std::vector<std::string>(precisionNames().begin(), precisionNames().end()))
      .showsDefault();
  addObjectiveArgument(command, objective_, "Whose command is printed");
  addMaxBytesArgument(command, building);
  command.option("--max-bytes").text("The most bytes that a volume's words may take, such as 64MiB");
  command.add("--min-speed", leastSpeed, "The least speed that is of use, in million rays a second")
      .takes("M")
      .notNegative();
  command
      .add("--cameras", rays.cameraFile,
           "A camera file: its camera of the input's name, or all if there is none; default: one that sees "
           "the whole volume, and rays from where it hits that go anywhere")
      .takes("FILE");
  command.add("--size", rays.size, "Pixels of the cameras' pictures; default: the file's, or 480x270")
      .takes("WxH");
  command.add("--rays", rays.rayFiles, "A file of rays; may be given several times")
      .repeated()
      .takes("R.bin");
  addOrderArgument(command, rays.order);
  command
      .add("--formats", formatList,
           "Choose from these and nothing else: \"F;F;F\", or a file with one a line, a label and a tab "
           "before it if you like")
      .takes("LIST");
  command.addFlag("--all", all, "Measure all formats that are looked at, however little they promise");
  command
      .add("--max-levels", maxLevels,
           "The most levels of a format; default: 4, but as many as it takes of those that it begins with")
      .takes("N")
      .between(1, 8);
  command.add("--explore", explore.mostFormats, "The most formats of which size and speed are predicted")
      .takes("N")
      .between(1, 10'000'000)
      .showsDefault();
  command.add("--check", check, "Rays, evenly spread, on which errors are found; 0: none")
      .takes("N")
      .showsDefault();
  command.add("--seed", seed, "Of the rays that go anywhere").takes("N").showsDefault();
  command
      .add("--threads", building.threads,
           "Threads that build, and of a device that is this processor; default: all")
      .takes("N")
      .between(1u, 1024u);
  addMemoryArguments(command, building);
  shares.declare(command, "one for every 16 formats");
  addCommonOptions(command, common);
}

Expected<void> SearchOptions::read() {
  budget = secondsOf(budgetText_);
  if (budget <= 0)
    return Error::usage("--budget '" + budgetText_ + "' is no time; it should be such as 90s, 5m or 2h");
  if ((shares.areElsewhere() || shares.share()) && !(all && !formatList.empty()))
    return Error::usage("shares measure all formats of a list; give --formats LIST and --all with them");
  wish = {objectiveOf(objective_), std::min(maxWordsOf(building), kMaxWords) * sizeof(std::uint32_t)};
  // Several volumes of a batch lie in memory together, on a device too.
  constexpr std::uint64_t kShare = 12;
  if (building.maxBytes.empty())
    wish.maxBytes = std::min(wish.maxBytes, measure::machineMemory() / kShare);
  VOXC_TRY(checkInputArguments(inputArguments, input));
  fillResolution(inputArguments, input);
  return {};
}

std::string SearchOptions::commandText() const {
  std::string text = "voxc search " + shellWord(input);
  for (const std::string &word : toWords(inputArguments))
    text += " " + shellWord(word);
  if (wish.objective != Wish::Objective::Balanced)
    text += " --objective " + objective_;
  return text + " --budget " + budgetText_ + " -o " + shellWord(folder);
}

} // namespace voxc::tool
