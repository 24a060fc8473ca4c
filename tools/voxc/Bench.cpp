// voxc bench: formats on models, size against speed with the error beside it, resumable; and what is done
// with its results.
#include "BuildArguments.h"
#include "Figures.h"
#include "Outputs.h"
#include "Subcommand.h"

#include "common/ShellWord.h"
#include "common/Statistics.h"
#include "common/Terminal.h"
#include "sweep/Machine.h"
#include "sweep/Summary.h"
#include "sweep/Sweep.h"

#include <algorithm>
#include <set>

namespace voxc::tool {

namespace {

using namespace bench;

struct Action {
  const char *name;
  const char *summary;
  std::unique_ptr<Subcommand> (*make)();
};

/// What can be done with results.
constexpr Action kActions[] = {
    {"export", "Pack measured cells for a machine that has voxc-trace alone", makeBenchExportCommand},
    {"import", "Take in what such a machine found", makeBenchImportCommand},
    {"report", "Make a page of the records of sweeps, and their figures as CSV", makeBenchReportCommand},
};

std::vector<std::string> split(const std::string &text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    if (end > begin)
      parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

class BenchCommand final : public Subcommand {
public:
  void declare(const CommandLine &command) override;
  Expected<void> run() override;

private:
  void declareAxes(const CommandLine &command);
  void declareMeasuring(const CommandLine &command);
  void declareActions(const CommandLine &command);

  Expected<void> checkUsage() const;
  Expected<SweepAxes> readAxes() const;
  Expected<std::vector<SweepModel>> readModels() const;
  Expected<std::vector<FormatLine>> readFormats() const;
  std::vector<std::vector<std::string>> passLists() const;
  SweepOptions options() const;
  std::string commandText() const;
  Expected<void> tell(const Sweep &sweep) const;

  std::vector<std::string> inputs_, formats_, passes_, devices_;
  std::vector<std::string> precisions_{"exact"};
  InputArguments inputArguments_;
  RayArguments rays_;
  BuildArguments building_;
  MeasureOptions measure_;
  double steadyPercent_ = 10;
  std::string folder_;
  bool retry_ = false, again_ = false;
  CommonOptions common_;
  std::vector<std::pair<CommandLine, std::unique_ptr<Subcommand>>> actions_;
  std::optional<CommandLine> command_;
};

void BenchCommand::declareAxes(const CommandLine &command) {
  command
      .add("INPUT", inputs_,
           "Models: an INPUT of voxc build, with NAME= before it and options of inputs behind it if you "
           "like, all in one argument")
      .takes("");
  command
      .add("--formats", formats_,
           "Formats: \"F;F;F\", or a file with one a line, a label and a tab before it if you like; "
           "may be given several times")
      .repeated()
      .takes("LIST");
  command
      .add("--passes", passes_,
           "Passes to run on every format, in this order, or none; given several times, formats are "
           "measured with each")
      .repeated()
      .takes("A,B");
  command.add("--precisions", precisions_, "Precisions, separated by commas")
      .repeated()
      .list()
      .takes("A,B")
      .oneOf(std::vector<std::string>(kPrecisionAttribute.values.begin(), kPrecisionAttribute.values.end()))
      .showsDefault("exact");
  command
      .add("--devices", devices_,
           "Devices whose names contain these, or cpu, separated by commas; default: the best")
      .repeated()
      .list()
      .takes("A,B");
  command
      .add("--cameras", rays_.cameraFile,
           "A camera file: its camera of a model's name, or all if there is none; default: one that sees "
           "the whole volume")
      .takes("FILE");
  command
      .add("--size", rays_.size, "Pixels of the cameras' pictures; default: the camera file's, or 1280x720")
      .takes("WxH");
  command.add("--rays", rays_.rayFiles, "A file of rays; may be given several times")
      .repeated()
      .takes("R.bin");
  addOrderArgument(command, rays_.order);
}

void BenchCommand::declareMeasuring(const CommandLine &command) {
  command.add("--repeat", measure_.rounds, "Rounds in which formats are timed in turn")
      .takes("N")
      .between(1u, 1000u)
      .showsDefault();
  command
      .add("--check", measure_.check,
           "Rays, evenly spread, on which errors, steps and words read are found; 0: none")
      .takes("N")
      .showsDefault();
  command.add("--steady", steadyPercent_, "Spread of the rounds in percent up to which a speed is steady")
      .takes("PERCENT")
      .between(0.0, 1000.0)
      .showsDefault();
  addMaxBytesArgument(command, building_);
  command.option("--max-bytes").text("Give up a volume whose words take more; default: half of the memory");
  addMemoryArguments(command, building_);
  command
      .add("--threads", building_.threads,
           "Threads that build, and of devices that are this processor; default: all")
      .takes("N")
      .between(1u, 1024u);
  command.addFlag("--retry", retry_, "Try cells again that failed in an earlier run");
  command.addFlag("--again", again_, "Measure cells again that an earlier run measured");
}

void BenchCommand::declareActions(const CommandLine &command) {
  for (const Action &action : kActions) {
    const CommandLine subcommand = command.addCommand(action.name, action.summary);
    actions_.emplace_back(subcommand, action.make()).second->declare(subcommand);
  }
  command.requireCommands(0, 1);
}

void BenchCommand::declare(const CommandLine &command) {
  command_ = command;
  declareAxes(command);
  declareMeasuring(command);
  addInputArguments(command, inputArguments_);
  command
      .add("-o,--output", folder_,
           "Folder of results, cached volumes and pictures; an earlier run's is "
           "continued")
      .takes("DIR");
  addCommonOptions(command, common_);
  declareActions(command);
}

Expected<void> BenchCommand::checkUsage() const {
  if (inputs_.empty() || formats_.empty() || folder_.empty())
    return Error::usage("a sweep takes an INPUT at least, --formats and -o DIR; see 'voxc bench --help'");
  return makeOutputFolder(folder_);
}

Expected<std::vector<FormatLine>> BenchCommand::readFormats() const {
  std::vector<FormatLine> lines;
  for (const std::string &argument : formats_) {
    const auto list = readFormatList(argument);
    if (!list)
      return list;
    lines.insert(lines.end(), list->begin(), list->end());
  }
  if (const Expected<void> checked = checkFormats(lines); !checked)
    return checked.error();
  return lines;
}

std::vector<std::vector<std::string>> BenchCommand::passLists() const {
  constexpr const char *kNone = "none";
  std::vector<std::vector<std::string>> lists;
  lists.reserve(passes_.size());
  for (const std::string &text : passes_)
    lists.push_back(text == kNone ? std::vector<std::string>() : split(text, ','));
  if (lists.empty())
    lists.emplace_back();
  return lists;
}

Expected<std::vector<SweepModel>> BenchCommand::readModels() const {
  std::vector<SweepModel> models;
  std::set<std::string> names;
  for (const std::string &input : inputs_) {
    auto model = readModel(input, inputArguments_);
    if (!model)
      return model.error();
    if (!names.insert(model->name).second)
      return Error::usage("two inputs have the name '" + model->name + "'; write NAME=INPUT for one of them");
    auto rays = readRaySets(rays_, model->name);
    if (!rays)
      return rays.error();
    models.push_back({std::move(*model), std::move(*rays)});
  }
  return models;
}

Expected<SweepAxes> BenchCommand::readAxes() const {
  const auto lines = readFormats();
  if (!lines)
    return lines.error();
  auto formats = makeFormats(*lines, passLists());
  if (!formats)
    return formats.error();
  auto models = readModels();
  if (!models)
    return models.error();
  auto devices = findDevices(devices_.empty() ? std::vector<std::string>{""} : devices_, building_.threads);
  if (!devices)
    return devices.error();
  return SweepAxes{std::move(*models), std::move(*formats), precisions_, std::move(*devices)};
}

SweepOptions BenchCommand::options() const {
  const std::uint64_t half = machineMemory() / 2;
  SweepOptions options{.folder = folder_,
                       .build = {},
                       .measure = measure_,
                       .groupBytes = half,
                       .retry = retry_,
                       .again = again_};
  options.measure.threads = building_.threads;
  options.measure.steady = steadyPercent_ / 100;
  options.build.maxBytes = building_.maxBytes.empty() ? half : bytesOf(building_.maxBytes);
  const auto pass = [&](const char *option, const std::string &value) {
    if (!value.empty())
      options.build.options.push_back(std::string(option) + "=" + value);
  };
  pass("--memory", building_.memory);
  pass("--scratch", building_.scratch);
  pass("--threads", building_.threads > 0 ? std::to_string(building_.threads) : "");
  return options;
}

/// The options that were given, so that a reader can run the same; quoted where a shell would split them.
std::string BenchCommand::commandText() const {
  std::string text = "voxc bench";
  for (const std::string &input : inputs_)
    text += " " + shellWord(input);
  for (const Option &option : command_->options())
    if (!option.isWord())
      for (const std::string &value : option.written())
        text += " " + option.name() + (option.takesValue() ? " " + shellWord(value) : "");
  return text;
}

Expected<void> BenchCommand::tell(const Sweep &sweep) const {
  if (tellsOnStdout(common_))
    printSummary(sweep.cells());
  std::size_t failed = 0, kept = 0;
  for (const Cell &cell : sweep.cells()) {
    failed += !cell.record.isMeasured();
    kept += cell.isKept;
  }
  const std::size_t cells = sweep.cells().size();
  if (Expected<void> written =
          writeStatistics(common_.stats, {{"cells", cells}, {"kept", kept}, {"failed", failed}});
      !written)
    return written;
  if (!common_.quiet)
    printNote("'voxc bench report " + folder_ + "' makes a page of these records");
  if (failed > 0)
    return Error::input(std::to_string(failed) + " of " + std::to_string(cells) +
                        " cells failed; the table and the records say why, and --retry tries them again");
  return {};
}

Expected<void> BenchCommand::run() {
  for (auto &[subcommand, action] : actions_)
    if (subcommand.isGiven())
      return action->run();
  if (Expected<void> usable = checkUsage(); !usable)
    return usable;
  disableShaderCaches();
  const auto axes = readAxes();
  if (!axes)
    return axes.error();
  auto sweep = Sweep::open(*axes, makeCells(*axes, madeBy(commandText())), options());
  if (!sweep)
    return sweep.error();
  ProgressBar bar(common_.quiet);
  if (Expected<void> swept = sweep->run(bar.progress()); !swept)
    return swept;
  bar.clear();
  return tell(*sweep);
}

} // namespace

std::unique_ptr<Subcommand> makeBenchCommand() { return std::make_unique<BenchCommand>(); }

} // namespace voxc::tool
