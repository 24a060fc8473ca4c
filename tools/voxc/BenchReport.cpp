// voxc bench report: one HTML file of the records of voxc bench, and their figures as CSV beside it.
#include "Subcommand.h"

#include "common/Files.h"
#include "report/Report.h"

#include <algorithm>
#include <filesystem>

namespace voxc::tool {
namespace {

constexpr std::size_t kLargePage = 1'000'000;
constexpr std::size_t kMostNotes = 10;

void tellNotes(const std::vector<std::string> &notes) {
  for (std::size_t i = 0; i < notes.size() && i < kMostNotes; ++i)
    printNote(notes[i]);
  if (notes.size() > kMostNotes)
    printNote("and " + std::to_string(notes.size() - kMostNotes) + " more of the kind");
}

class BenchReportCommand final : public Subcommand {
public:
  void declare(const CommandLine &command) override;
  Expected<void> run() override;

private:
  struct Paths {
    std::string page, csv; ///< No CSV where the page goes to standard output or a device.
  };

  Paths outputPaths() const;
  Expected<void> write(const report::Report &report, const Paths &paths) const;
  Expected<report::ModelNotes> readModelNotes(const std::vector<report::Cell> &cells) const;

  std::vector<std::string> folders_, modelNotes_;
  std::string output_;
  bool quiet_ = false;
};

void BenchReportCommand::declare(const CommandLine &command) {
  command.add("DIR", folders_, "Folders of records, as voxc bench writes them").required().takes("");
  command
      .add("-o,--output", output_,
           "The page, with its figures as CSV beside it; the default is report.html in the first folder, "
           "- standard output, without CSV")
      .takes("FILE");
  command.add("--note", modelNotes_, "A sentence on a model; may be given several times")
      .takes("MODEL=TEXT")
      .repeated();
  command.addFlag("--quiet", quiet_, "No notes");
  command.addVersion(versionText());
}

Expected<report::ModelNotes>
BenchReportCommand::readModelNotes(const std::vector<report::Cell> &cells) const {
  report::ModelNotes notes;
  for (const std::string &argument : modelNotes_) {
    const std::string name = argument.substr(0, argument.find('='));
    if (name.size() == argument.size())
      return Error::usage("--note '" + argument + "' has no '='; it should be MODEL=TEXT");
    if (std::ranges::none_of(cells, [&](const report::Cell &cell) { return cell.model.name == name; }))
      return Error::usage("--note is on '" + name + "', but no record is of a model of that name");
    notes[name] = argument.substr(name.size() + 1);
  }
  return notes;
}

Expected<void> BenchReportCommand::run() {
  auto cells = report::readCells(folders_);
  if (!cells)
    return cells.error();
  const auto modelNotes = readModelNotes(*cells);
  if (!modelNotes)
    return modelNotes.error();
  const Paths paths = outputPaths();
  if (paths.csv == paths.page)
    return Error::usage("-o '" + output_ +
                        "' should be the page, such as report.html; the figures go into a .csv beside it");
  const std::string csvName = std::filesystem::path(paths.csv).filename().string();
  report::Report report = report::makeReport(*cells, *modelNotes, csvName);
  if (report.html.size() > kLargePage)
    report.notes.push_back("the report has " + std::to_string(report.html.size()) +
                           " bytes; fewer folders would make a page that opens faster");
  if (!quiet_)
    tellNotes(report.notes);
  return write(report, paths);
}

BenchReportCommand::Paths BenchReportCommand::outputPaths() const {
  namespace fs = std::filesystem;
  const fs::path page = output_.empty() ? fs::path(folders_.front()) / "report.html" : fs::path(output_);
  std::error_code ignored;
  const bool isFile = output_ != "-" && (!fs::exists(page, ignored) || fs::is_regular_file(page, ignored));
  return {page.string(), isFile ? fs::path(page).replace_extension(".csv").string() : ""};
}

Expected<void> BenchReportCommand::write(const report::Report &report, const Paths &paths) const {
  if (!paths.csv.empty())
    if (Expected<void> written = writeText(paths.csv, report.csv); !written)
      return written;
  if (Expected<void> written = writeText(paths.page, report.html); !written)
    return written;
  if (!quiet_ && !paths.csv.empty())
    printNote("wrote " + paths.page + " and " + paths.csv);
  return {};
}

} // namespace

std::unique_ptr<Subcommand> makeBenchReportCommand() { return std::make_unique<BenchReportCommand>(); }

} // namespace voxc::tool
