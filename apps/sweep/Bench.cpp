// voxc bench: formats on models, size against speed with the error beside it, resumable; and what is done
// with its results.
#include "sweep/BenchActions.h"
#include "sweep/SharedSweep.h"
#include "sweep/Summary.h"
#include "sweep/SweepArguments.h"

#include "common/Statistics.h"
#include "common/Terminal.h"
#include "options/Figures.h"
#include "program/Applications.h"
#include "voxc/Measure/Machine.h"
#include "voxc/Support/ShellWord.h"

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

class BenchCommand final : public Subcommand {
public:
  void declare(const CommandLine &command) override;
  Expected<void> run() override;

private:
  void declareActions(const CommandLine &command);

  Expected<void> checkNoSweep() const;
  Expected<void> checkUsage() const;
  std::string commandText() const;
  Expected<void> runHere();
  Expected<void> runInShares();
  Expected<void> tell(const std::vector<Cell> &cells, Json figures) const;

  SweepArguments arguments_;
  std::string folder_;
  ShareOptions shares_;
  CommonOptions common_;
  std::vector<std::pair<CommandLine, std::unique_ptr<Subcommand>>> actions_;
  std::optional<CommandLine> command_;
};

void BenchCommand::declareActions(const CommandLine &command) {
  for (const Action &action : kActions) {
    const CommandLine subcommand = command.addCommand(action.name, action.summary);
    actions_.emplace_back(subcommand, action.make()).second->declare(subcommand);
  }
  command.requireCommands(0, 1);
}

void BenchCommand::declare(const CommandLine &command) {
  command_ = command;
  arguments_.declare(command);
  command
      .add("-o,--output", folder_,
           "Folder of results, cached volumes and pictures; an earlier run's is continued")
      .takes("DIR");
  shares_.declare(command, "as many as there are models, whose formats are then measured together");
  addCommonOptions(command, common_);
  declareActions(command);
}

/// Options before an action are of a sweep. Error: `Usage`.
Expected<void> BenchCommand::checkNoSweep() const {
  const std::vector<Option> given = command_->given();
  if (given.empty())
    return {};
  return Error::usage(
      given.front().name() +
      " is of a sweep, and what is done with results has options of its own; leave it out, or "
      "write it behind");
}

Expected<void> BenchCommand::checkUsage() const {
  if (!arguments_.isGiven() || folder_.empty())
    return Error::usage("a sweep takes an INPUT at least, --formats and -o DIR; see 'voxc bench --help'");
  return makeResultsFolder(folder_, common_);
}

/// The options that were given, so that a reader can run the same.
std::string BenchCommand::commandText() const {
  std::string text = "voxc bench";
  for (const bool areWords : {true, false})
    for (const Option &option : command_->options())
      for (const std::string &word :
           option.isWord() == areWords ? option.words() : std::vector<std::string>())
        text += " " + shellWord(word);
  return text;
}

/// What the cells' processors were, for cells whose speed is a processor's, if they are of several kinds.
std::string processorsOf(const std::vector<Cell> &cells) {
  std::set<std::string> names;
  for (const Cell &cell : cells)
    if (cell.record.device.clock == "cpu")
      names.insert(cell.record.madeBy.processor);
  std::string text;
  if (names.size() > 1)
    for (const std::string &name : names)
      text += (text.empty() ? "" : "; ") + name;
  return text;
}

Expected<void> BenchCommand::tell(const std::vector<Cell> &cells, Json figures) const {
  if (tellsOnStdout(common_))
    printSummary(cells);
  std::size_t failed = 0, kept = 0;
  for (const Cell &cell : cells) {
    failed += !cell.record.isMeasured();
    kept += cell.isKept;
  }
  figures.update({{"cells", cells.size()}, {"kept", kept}, {"failed", failed}});
  VOXC_TRY(writeStatistics(common_.stats, figures));
  // Who joins the shares tells what failed.
  if (shares_.share())
    return {};
  if (const std::string processors = processorsOf(cells); !processors.empty() && !common_.quiet)
    printNote(
        "note: speeds were measured on several kinds of processors, and only those of one kind compare: " +
        processors);
  if (!common_.quiet)
    printNote("'voxc bench report " + folder_ + "' makes a page of these records");
  if (failed > 0)
    return Error::input(std::to_string(failed) + " of " + std::to_string(cells.size()) +
                        " cells failed; the table and the records say why, and --retry tries them again");
  return {};
}

Expected<void> BenchCommand::runHere() {
  disableShaderCaches();
  const auto axes = VOXC_TRY(arguments_.readAxes(false));
  std::vector<Cell> cells = makeCells(axes, madeBy(commandText()));
  SweepOptions options = arguments_.options(folder_);
  if (const auto share = shares_.share()) {
    keepShare(cells, *share);
    options.records = shareFileName(sweepDigest(axes), *share);
  }
  auto sweep = VOXC_TRY(Sweep::open(axes, std::move(cells), std::move(options)));
  ProgressBar bar(common_.quiet);
  VOXC_TRY(sweep.run(bar.progress()));
  bar.clear();
  return tell(sweep.cells(), {});
}

Expected<void> BenchCommand::runInShares() {
  const auto axes = VOXC_TRY(arguments_.readAxes(true));
  const std::vector<Cell> cells = makeCells(axes, madeBy(commandText()));
  const SweepOptions options = arguments_.options(folder_);
  const std::uint64_t count = shares_.count(axes.models.size());
  SharedCells shared{{}, shareOfEach(cells, count), count, axes.devices, sweepDigest(axes)};
  for (const Cell &cell : cells)
    shared.cells.push_back(cell.record.cell);
  ProgressBar bar(common_.quiet);
  Json figures;
  const auto found =
      measureInShares(std::move(shared), {folder_, shares_.command("bench"), options.retry, options.again},
                      shares_, arguments_.threads(), {bar.progress(), common_.quiet}, figures);
  bar.clear();
  if (!found)
    return found.error();
  std::vector<Cell> measured;
  for (std::size_t i = 0; i < found->size(); ++i)
    for (const Record &record : (*found)[i].records) {
      measured.push_back(cells[i]);
      measured.back().record = record;
      measured.back().isKept = (*found)[i].isKept;
    }
  return found->empty() ? tellFigures(common_, figures) : tell(measured, std::move(figures));
}

Expected<void> BenchCommand::run() {
  for (auto &[subcommand, action] : actions_)
    if (subcommand.isGiven()) {
      VOXC_TRY(checkNoSweep());
      return action->run();
    }
  VOXC_TRY(checkUsage());
  return shares_.areElsewhere() ? runInShares() : runHere();
}

} // namespace

std::unique_ptr<Subcommand> makeBenchCommand() { return std::make_unique<BenchCommand>(); }

} // namespace voxc::tool
