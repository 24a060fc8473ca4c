// voxc bench: formats on models, size against speed with the error beside it, resumable; and what is done
// with its results.
#include "Figures.h"
#include "Outputs.h"
#include "Subcommand.h"

#include "common/ShellWord.h"
#include "common/Statistics.h"
#include "common/Terminal.h"
#include "jobs/JobOptions.h"
#include "sweep/Machine.h"
#include "sweep/SharedSweep.h"
#include "sweep/Summary.h"
#include "sweep/SweepArguments.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <string_view>

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

/// Options that say who measures, and not what; a share that is measured elsewhere is not told them.
constexpr std::string_view kNotForShares[] = {"--local",   "--slurm",  "--partition", "--sbatch", "--poll",
                                              "--no-wait", "--shares", "--share",     "--stats",  "--quiet"};

class BenchCommand final : public Subcommand {
public:
  void declare(const CommandLine &command) override;
  Expected<void> run() override;

private:
  void declareShares(const CommandLine &command);
  void declareActions(const CommandLine &command);

  Expected<void> checkUsage() const;
  std::vector<std::string> givenWords() const;
  std::vector<std::string> shareCommand() const;
  std::string commandText() const;
  Expected<void> runHere();
  Expected<void> runInShares();
  Expected<void> tell(const std::vector<Cell> &cells, Json figures) const;

  SweepArguments arguments_;
  std::string folder_;
  JobOptions jobs_;
  std::string share_;
  std::uint64_t shares_ = 0;
  CommonOptions common_;
  std::vector<std::pair<CommandLine, std::unique_ptr<Subcommand>>> actions_;
  std::optional<CommandLine> command_;
};

void BenchCommand::declareShares(const CommandLine &command) {
  const OptionGroup group(command, "Shares");
  jobs_.declare(command);
  command
      .add("--shares", shares_,
           "Shares that Slurm measures, each a job; default: as many as there are models, whose formats are "
           "then "
           "measured together")
      .takes("N")
      .between(std::uint64_t{1}, std::uint64_t{1000000})
      .needs(command.option("--slurm"));
  addShareArgument(command, share_);
  const Option share = command.option("--share");
  share.excludes(command.option("--local"));
  share.excludes(command.option("--slurm"));
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
  arguments_.declare(command);
  command
      .add("-o,--output", folder_,
           "Folder of results, cached volumes and pictures; an earlier run's is "
           "continued")
      .takes("DIR");
  declareShares(command);
  addCommonOptions(command, common_);
  declareActions(command);
}

Expected<void> BenchCommand::checkUsage() const {
  if (!arguments_.isGiven() || folder_.empty())
    return Error::usage("a sweep takes an INPUT at least, --formats and -o DIR; see 'voxc bench --help'");
  return makeOutputFolder(folder_);
}

/// The options that were given, with INPUT, so that a reader or a process can run the same.
std::vector<std::string> BenchCommand::givenWords() const {
  std::vector<std::string> words;
  for (const bool areWords : {true, false})
    for (const Option &option : command_->options())
      if (option.isWord() == areWords)
        std::ranges::copy(option.words(), std::back_inserter(words));
  return words;
}

std::string BenchCommand::commandText() const {
  std::string text = "voxc bench";
  for (const std::string &word : givenWords())
    text += " " + shellWord(word);
  return text;
}

std::vector<std::string> BenchCommand::shareCommand() const {
  std::vector<std::string> words{"bench"};
  for (const Option &option : command_->options())
    if (std::ranges::find(kNotForShares, option.name()) == std::end(kNotForShares))
      std::ranges::copy(option.words(), std::back_inserter(words));
  words.emplace_back("--quiet");
  return words;
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
  if (Expected<void> written = writeStatistics(common_.stats, figures); !written)
    return written;
  // Who joins the shares tells what failed.
  if (shareOf(share_))
    return {};
  if (const std::string processors = processorsOf(cells); !processors.empty() && !common_.quiet)
    printNote("note: speeds were measured on several kinds of processors, and are compared of one alone: " +
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
  const auto axes = arguments_.readAxes(false);
  if (!axes)
    return axes.error();
  std::vector<Cell> cells = makeCells(*axes, madeBy(commandText()));
  SweepOptions options = arguments_.options(folder_);
  if (const auto share = shareOf(share_)) {
    keepShare(cells, *share);
    options.records = shareFileName(sweepDigest(*axes), *share);
  }
  auto sweep = Sweep::open(*axes, std::move(cells), std::move(options));
  if (!sweep)
    return sweep.error();
  ProgressBar bar(common_.quiet);
  if (Expected<void> swept = sweep->run(bar.progress()); !swept)
    return swept;
  bar.clear();
  return tell(sweep->cells(), {});
}

Expected<void> BenchCommand::runInShares() {
  const auto axes = arguments_.readAxes(true);
  if (!axes)
    return axes.error();
  const std::uint64_t usual = jobs_.bySlurm() ? axes->models.size() : jobs_.processes();
  const SweepOptions options = arguments_.options(folder_);
  auto sweep = SharedSweep::open(*axes, makeCells(*axes, madeBy(commandText())),
                                 {.folder = folder_,
                                  .shares = shares_ > 0 ? shares_ : usual,
                                  .command = shareCommand(),
                                  .retry = options.retry,
                                  .again = options.again});
  if (!sweep)
    return sweep.error();
  if (Expected<void> made = makeOutputFolder(sweep->folder()); !made)
    return made;
  ProgressBar bar(common_.quiet);
  Json figures;
  if (auto done = jobs_.run(*sweep, arguments_.threads(), {bar.progress(), common_.quiet}, figures); !done)
    return done;
  bar.clear();
  if (!jobs_.waits())
    return tellFigures(common_, figures);
  const auto cells = sweep->join();
  return cells ? tell(*cells, std::move(figures)) : cells.error();
}

Expected<void> BenchCommand::run() {
  for (auto &[subcommand, action] : actions_)
    if (subcommand.isGiven())
      return action->run();
  if (Expected<void> usable = checkUsage(); !usable)
    return usable;
  return jobs_.isGiven() ? runInShares() : runHere();
}

} // namespace

std::unique_ptr<Subcommand> makeBenchCommand() { return std::make_unique<BenchCommand>(); }

} // namespace voxc::tool
