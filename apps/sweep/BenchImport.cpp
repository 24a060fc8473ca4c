// voxc bench import: takes in what another machine found when it traced the packs of a sweep.
#include "sweep/BenchActions.h"
#include "sweep/SampleCheck.h"
#include "sweep/Sweep.h"

#include "common/Files.h"
#include "common/Statistics.h"
#include "options/Figures.h"
#include "voxc/Measure/RecordFile.h"
#include "voxc/Support/File.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

namespace voxc::tool {

namespace {

using namespace bench;
namespace fs = std::filesystem;

/// The seconds of all rounds of a cell, and what else was told.
struct Findings {
  Json figures;
  std::vector<double> seconds, cpuSeconds, deviceSeconds;
  std::string hits; ///< The file with the hits of its sample, or "".
};

/// Adds the repeats of a round but for the first, which warms the device. False if they are no list of
/// seconds.
bool addRepeats(const Json &rounds, const char *key, std::vector<double> &seconds) {
  const auto list = rounds.find(key);
  if (list == rounds.end() || !list->is_array())
    return false;
  for (std::size_t i = 0; i < list->size(); ++i) {
    const Json &entry = (*list)[i];
    if (!entry.is_number() || !std::isfinite(entry.get<double>()) || entry.get<double>() <= 0)
      return false;
    if (i > 0)
      seconds.push_back(entry.get<double>());
  }
  return true;
}

bool isResult(const Json &figures) {
  const auto hasText = [&](const char *key) { return figures.contains(key) && figures[key].is_string(); };
  return figures.is_object() && hasText("device") && hasText("driver") && hasText("device_kind") &&
         figures.contains("rounds") && figures["rounds"].is_object();
}

class BenchImportCommand final : public Subcommand {
public:
  void declare(const CommandLine &command) override {
    command.add("DIR", folder_, "Folder of the sweep that was exported").required().takes("");
    command.add("RESULTS", results_, "Folders of results, as the packs' script leaves them")
        .required()
        .takes("");
    command.add("--steady", steadyPercent_, "Spread of the repeats in percent up to which a speed is steady")
        .takes("PERCENT")
        .between(0.0, 1000.0)
        .showsDefault();
    addCommonOptions(command, common_);
  }

  Expected<void> run() override;

private:
  Expected<void> readFolder(const std::string &path);
  Expected<void> readResult(const fs::path &path);
  Record makeRecord(const Record &base, const Findings &findings) const;

  std::string folder_;
  std::vector<std::string> results_;
  double steadyPercent_ = 10;
  std::map<std::string, Findings> findings_; ///< By the cell that was exported.
  CommonOptions common_;
};

Expected<void> BenchImportCommand::readResult(const fs::path &path) {
  const auto broken = [&](const std::string &what) { return Error::input(path.string() + " " + what); };
  const auto text = VOXC_TRY(readTextFile(path.string()));
  const Json figures = Json::parse(text, nullptr, false);
  if (!isResult(figures))
    return broken("is no result; it should be what voxc-trace --stats wrote, with device, driver and rounds");
  Findings &findings = findings_[path.stem().stem().string()]; // Of CELL.ROUND.json.
  if (!findings.figures.is_null() && findings.figures["device"] != figures["device"])
    return broken("is of another device than the results before it; import them one device at a time");
  const Json &rounds = figures["rounds"];
  if (!addRepeats(rounds, "seconds", findings.seconds) ||
      !addRepeats(rounds, "cpu_seconds", findings.cpuSeconds) ||
      !addRepeats(rounds, "device_seconds", findings.deviceSeconds))
    return broken("has rounds that are no lists of seconds");
  if (findings.figures.is_null())
    findings.figures = figures;
  const fs::path hits = path.parent_path() / (path.stem().stem().string() + ".hits");
  std::error_code ignored;
  if (fs::exists(hits, ignored))
    findings.hits = hits.string();
  return {};
}

Expected<void> BenchImportCommand::readFolder(const std::string &path) {
  std::error_code failure;
  std::vector<fs::path> files;
  for (fs::directory_iterator entry(path, failure), end; !failure && entry != end; entry.increment(failure))
    if (entry->path().extension() == ".json")
      files.push_back(entry->path());
  if (failure)
    return Error::input("folder '" + path + "' cannot be read: " + failure.message());
  std::ranges::sort(files);
  for (const fs::path &file : files)
    VOXC_TRY(readResult(file));
  return {};
}

Record BenchImportCommand::makeRecord(const Record &base, const Findings &findings) const {
  Record record = base;
  const Json &figures = findings.figures;
  const bool isProcessor = figures["device_kind"] == "cpu" || findings.deviceSeconds.empty();
  record.device = {figures["device"], "vulkan", figures["driver"], {}, isProcessor ? "cpu" : "gpu"};
  const std::uint64_t rays = base.rays.count;
  record.speed = {findings.seconds.size(),
                  speedOf(rays, findings.seconds),
                  speedOf(rays, findings.cpuSeconds),
                  speedOf(rays, findings.deviceSeconds),
                  {},
                  {}};
  const std::optional<Speed> &speed = speedOf(record);
  record.speed.steady = speed && speed->spread <= steadyPercent_ / 100;
  // What was found on this machine is not known of that one.
  record.kernel = {};
  record.work = {};
  record.error = {};
  record.predicted.reset();
  const auto figure = [&](const char *key) {
    return figures.contains(key) && figures[key].is_number() ? Figure(figures[key].get<double>())
                                                             : std::nullopt;
  };
  if (figures.contains("order") && figures["order"].is_string())
    record.speed.order = figures["order"].get<std::string>();
  record.kernel.uploadSeconds = figure("upload_seconds");
  record.kernel.firstDispatchSeconds = figure("first_dispatch_seconds");
  if (figures.contains("hits") && figures["hits"].is_number_unsigned())
    record.work.hits = figures["hits"].get<std::uint64_t>();
  return record;
}

Expected<void> BenchImportCommand::run() {
  const std::string recordsPath = (fs::path(folder_) / kResultsName).string();
  VOXC_TRY(checkFiguresNoResults(folder_, common_));
  for (const std::string &path : results_)
    VOXC_TRY(readFolder(path));
  const auto records = VOXC_TRY(readRecords(folder_));
  auto writer = VOXC_TRY(RecordWriter::open(recordsPath));
  SampleCheck check(folder_);
  std::size_t taken = 0;
  for (const Record &base : records) {
    const auto findings = findings_.find(base.cell);
    if (findings == findings_.end() || findings->second.seconds.empty())
      continue;
    Record record = makeRecord(base, findings->second);
    if (!findings->second.hits.empty()) {
      const auto hits = VOXC_TRY(readHits(findings->second.hits));
      VOXC_TRY(check.add(record, hits));
    }
    record.cell = cellDigest(record);
    VOXC_TRY(writer.append(record));
    ++taken;
  }
  if (taken == 0)
    return Error::input("there are no results of cells of '" + folder_ +
                        "'; they should be CELL.ROUND.json, with two repeats at least");
  return tellFigures(common_, {{"cells", taken}, {"unknown", findings_.size() - taken}});
}

} // namespace

std::unique_ptr<Subcommand> makeBenchImportCommand() { return std::make_unique<BenchImportCommand>(); }

} // namespace voxc::tool
