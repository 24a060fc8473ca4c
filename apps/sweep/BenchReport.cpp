// voxc bench report: one HTML file of the records of voxc bench, and their figures as CSV beside it. What
// makes them is Python (tools/report).
#include "sweep/BenchActions.h"

#include "common/Terminal.h"
#include "jobs/PythonProgram.h"

namespace voxc::tool {
namespace {

class BenchReportCommand final : public Subcommand {
public:
  void declare(const CommandLine &command) override;
  Expected<void> run() override;

private:
  std::vector<std::string> arguments() const;

  std::vector<std::string> folders_, modelNotes_;
  std::string output_;
  bool quiet_ = false;
};

void BenchReportCommand::declare(const CommandLine &command) {
  command.add("DIR", folders_, "Folders of records, as voxc bench writes them").required().takes("");
  command
      .add("-o,--output", output_,
           "The page, with its figures as CSV beside it; the default is report.html in the first folder, - "
           "standard output, without CSV")
      .takes("FILE");
  command.add("--note", modelNotes_, "A sentence on a model; may be given several times")
      .takes("MODEL=TEXT")
      .repeated();
  command.addFlag("--quiet", quiet_, "No notes");
  command.addVersion(versionText());
}

/// As the program takes them: whatever begins with a dash is no option of it.
std::vector<std::string> BenchReportCommand::arguments() const {
  std::vector<std::string> words;
  if (!output_.empty())
    words.push_back("--output=" + output_);
  for (const std::string &note : modelNotes_)
    words.push_back("--note=" + note);
  words.emplace_back("--");
  words.insert(words.end(), folders_.begin(), folders_.end());
  return words;
}

Expected<void> BenchReportCommand::run() {
  ProgressBar bar(true);
  const auto notes = VOXC_TRY(runPythonProgram("bench-report.py", arguments(), bar.progress()));
  if (!quiet_)
    for (const std::string &note : notes)
      printNote(note);
  return {};
}

} // namespace

std::unique_ptr<Subcommand> makeBenchReportCommand() { return std::make_unique<BenchReportCommand>(); }

} // namespace voxc::tool
