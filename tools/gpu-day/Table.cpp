// Tables of figures.
#include "Table.h"

#include "common/Command.h"
#include "common/Files.h"
#include "common/Json.h"
#include "voxc/Measure/Digest.h"
#include "voxc/Measure/RecordFile.h"
#include "voxc/Support/File.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

namespace voxc::gpu {
namespace {

namespace fs = std::filesystem;
using tool::Json;
using namespace measure;

/// What is told of a format in a table: rows of two dispatches, as tracers run them, in groups of 64.
bool isOfTables(const Json &row) { return row.value("dispatches", 2) == 2 && row.value("group", 64) == 64; }

Expected<std::vector<fs::path>> filesOf(const std::string &folder) {
  std::error_code failure;
  std::vector<fs::path> files;
  for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end; entry.increment(failure))
    files.push_back(entry->path());
  if (failure)
    return Error::input("folder '" + folder + "' cannot be read: " + failure.message());
  std::ranges::sort(files);
  return files;
}

Record recordOf(const Json &cell, const std::string &precision, const Json &row) {
  Record record;
  const Json &device = cell.at("device"), &speed = row.at("mrays_per_s"), &error = row.at("error");
  record.model = {cell.at("scene"), cell.at("scene"), Digest().add(std::string(cell.at("scene"))).hex()};
  record.format.label = cell.at("label");
  record.precision = precision.find("fast") != std::string::npos ? "fast" : "exact";
  if (precision != record.precision)
    record.format.label += ", " + precision;
  record.format.name = cell.value("format", record.format.label);
  record.format.digest = Digest().add(record.format.label).add(record.format.name).hex();
  record.device = {device.at("name"), "vulkan", device.at("driver"), {}, "gpu"};
  record.rays = {row.at("rays"), "file", row.at("count"), {}, Digest().add(std::string(row.at("rays"))).hex(),
                 "given"};
  if (cell.contains("words"))
    record.volume = {cell["words"].get<std::uint64_t>(), cell["bytes"].get<std::uint64_t>()};
  if (cell.contains("voxels"))
    record.model.voxels = cell["voxels"].get<std::uint64_t>();
  const double median = speed.at("median"), least = speed.at("min"), most = speed.at("max");
  record.speed.rounds = speed.at("runs").get<std::uint64_t>();
  record.speed.mraysPerDeviceS = Speed{least, median, most, (most - least) / median};
  record.speed.steady = (most - least) / median <= 0.1;
  record.speed.order = "given";
  record.error.rays = record.rays.count;
  record.error.missed = error.at("missed").get<std::uint64_t>();
  record.error.ghost = error.at("ghost").get<std::uint64_t>();
  record.error.wrong = error.at("wrong").get<std::uint64_t>();
  record.error.colour = error.at("colour").get<std::uint64_t>();
  record.error.maxUlpDt = error.at("max_ulp_dt").get<double>();
  record.madeBy = {versionText(), "none", "not known", {}, "voxc-gpu-day"};
  record.cell = cellDigest(record);
  return record;
}

std::string number(const char *format, double value) {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::uint64_t differencesOf(const Json &rows) {
  std::uint64_t all = 0;
  for (const Json &row : rows)
    for (const char *const kind : {"missed", "ghost", "wrong", "colour"})
      all += row.at("error").value(kind, std::uint64_t{0});
  return all;
}

/// The rows of one scene: a format and precision each, a column for each set of rays.
class SceneTable {
public:
  explicit SceneTable(std::string scene) : scene_(std::move(scene)) {}

  void add(const Json &cell, const std::string &precision, const Json &rows) {
    std::string line = "| " + std::string(cell.at("label")) + " | " +
                       (cell.contains("bytes") ? number("%.1f", cell["bytes"].get<double>() / 1e6) : "") +
                       " | " + precision + " |";
    std::vector<std::string> sets;
    std::uint64_t rays = 0, ulp = 0;
    for (const Json &row : rows)
      if (isOfTables(row)) {
        sets.push_back(row.at("rays"));
        line += " " + number("%.3g", row.at("mrays_per_s").at("median").get<double>() / 1000) + " |";
        rays += row.at("count").get<std::uint64_t>();
        ulp = std::max(ulp, row.at("error").value("max_ulp_dt", std::uint64_t{0}));
      }
    if (sets_.empty())
      sets_ = sets;
    lines_ += line + " " + std::to_string(differencesOf(rows)) + " | " + std::to_string(ulp) + " |\n";
    rays_ = std::max(rays_, rays);
  }

  std::string text() const {
    std::string head = "| Format | MB | precision |", rule = "|---|---|---|";
    for (const std::string &set : sets_) {
      head += " " + set + " |";
      rule += "---|";
    }
    return "## " + scene_ + "\n\nGrays/s of " + std::to_string(rays_) +
           " rays; those that are not the oracle's; and the most that a t is off, in ulps.\n\n" + head +
           " wrong | ulp |\n" + rule + "---|---|\n" + lines_;
  }

private:
  std::string scene_, lines_;
  std::vector<std::string> sets_;
  std::uint64_t rays_ = 0;
};

/// All that a day has found.
class Day {
public:
  Expected<void> readFolder(const fs::path &folder);
  /// What other programs have said: figures of `voxc trace` within a budget of memory, and plain texts.
  Expected<void> readTexts(const fs::path &folder);
  std::string json() const { return all_.dump(1) + "\n"; }
  const std::string &records() const { return records_; }
  std::string table() const;

private:
  Expected<void> readFile(const fs::path &file);
  void addCell(const Json &cell);
  void addLattice(const Json &cell);
  void fail(const std::string &what, const std::string &sentence);

  Json all_{{"schema", 1}, {"cells", Json::array()}, {"lattice", Json::array()}, {"failed", Json::object()}};
  void addPages(const std::string &name, const Json &figures);

  std::map<std::string, SceneTable> tables_;
  std::string records_, device_, failures_, lattice_, pages_, texts_;
  std::uint64_t latticeRays_ = 0;
};

void Day::fail(const std::string &what, const std::string &sentence) {
  all_["failed"][what] = sentence;
  failures_ += "- " + what + ": " + sentence + "\n";
}

void Day::addCell(const Json &cell) {
  for (const auto &[kind, kernel] : cell["kernels"].items()) {
    if (kernel.contains("failed")) {
      fail(std::string(cell.at("label")) + ", " + kind, kernel["failed"]);
      continue;
    }
    for (const Json &row : kernel["rows"])
      if (isOfTables(row))
        records_ += toLine(recordOf(cell, kind, row)) + "\n";
    tables_.try_emplace(cell["scene"], cell["scene"]).first->second.add(cell, kind, kernel["rows"]);
  }
  all_["cells"].push_back(cell);
}

void Day::addLattice(const Json &cell) {
  for (const auto &[kind, found] : cell["lattice"].items()) {
    if (found.contains("failed")) {
      fail("hard rays, " + std::string(cell.at("format")) + ", " + kind, found["failed"]);
      continue;
    }
    const auto rays = found.at("rays").get<std::uint64_t>();
    latticeRays_ += rays;
    lattice_ += "| " + std::string(cell.at("format")) + " | " + kind + " | " + std::to_string(rays) + " | " +
                std::to_string(found.at("hits").get<std::uint64_t>()) + " | " +
                std::to_string(found.at("wrong").get<std::uint64_t>()) + " |\n";
  }
  all_["lattice"].push_back(cell);
}

Expected<void> Day::readFile(const fs::path &file) {
  const auto text = VOXC_TRY(readTextFile(file.string()));
  if (file.extension() == ".failed") {
    fail(file.stem().string(), text.substr(0, text.find('\n')));
    return {};
  }
  const Json cell = Json::parse(text, nullptr, false);
  if (!cell.is_object() || !cell.contains("device") ||
      !(cell.contains("kernels") || cell.contains("lattice")))
    return Error::input("'" + file.string() + "' has no figures of voxc-gpu-day");
  device_ = std::string(cell["device"]["name"]) + ", " + std::string(cell["device"]["driver"]);
  if (cell.contains("kernels"))
    addCell(cell);
  else
    addLattice(cell);
  return {};
}

Expected<void> Day::readFolder(const fs::path &folder) {
  const auto files = VOXC_TRY(filesOf(folder.string()));
  for (const fs::path &file : files)
    if (file.extension() == ".json" || file.extension() == ".failed")
      VOXC_TRY(readFile(file));
  return {};
}

void Day::addPages(const std::string &name, const Json &figures) {
  const auto figure = [&](const char *key) { return figures.value(key, 0.0); };
  pages_ += "| " + name + " | " + number("%.1f", figure("enough_bytes") / 1e6) + " | " +
            number("%.0f", figure("pages_read")) + " | " + number("%.0f", figure("rounds")) + " | " +
            number("%.3f", figure("page_seconds")) + " | " + number("%.1f", figure("mrays_per_s")) + " |\n";
  all_["pages"][name] = figures;
}

Expected<void> Day::readTexts(const fs::path &folder) {
  const auto files = VOXC_TRY(filesOf(folder.string()));
  for (const fs::path &file : files) {
    const auto text = VOXC_TRY(readTextFile(file.string()));
    if (file.extension() == ".txt") {
      texts_ += "\n## " + file.stem().string() + "\n\n```\n" + text + "```\n";
      all_["texts"][file.stem().string()] = text;
    } else if (file.extension() == ".json") {
      if (const Json figures = Json::parse(text, nullptr, false); figures.is_object())
        addPages(file.stem().string(), figures);
    } else if (!text.empty()) {
      fail(file.filename().string(), text.substr(0, text.find('\n')));
    }
  }
  return {};
}

std::string Day::table() const {
  std::string text = "# " + device_ + "\n";
  for (const auto &[scene, rows] : tables_)
    text += "\n" + rows.text();
  if (!lattice_.empty())
    text += "\n## Hard rays\n\n" + std::to_string(latticeRays_) +
            " rays of a lattice against exact hits by integers, all compared on the device.\n\n"
            "| Format | arithmetic | rays | hits | wrong |\n|---|---|---|---|---|\n" +
            lattice_;
  if (!pages_.empty())
    text +=
        "\n## Pages\n\nA volume of which a part is in memory; MB that would be enough, and million rays a "
        "second of the time that passed.\n\n"
        "| Budget | enough | pages read | rounds | seconds of pages | speed |\n|---|---|---|---|---|---|\n" +
        pages_;
  text += texts_;
  return failures_.empty() ? text : text + "\n## Failed\n\n" + failures_;
}

} // namespace

Expected<void> writeTables(const std::string &folder, const std::string &output) {
  Day day;
  for (const char *const part : {"cells", "lattice"})
    VOXC_TRY(day.readFolder(fs::path(folder) / part));
  if (const fs::path texts = fs::path(folder) / "texts"; fs::exists(texts))
    VOXC_TRY(day.readTexts(texts));
  const auto path = [&](const char *name) { return (fs::path(output) / name).string(); };
  for (const auto &[name, text] :
       {std::pair{"gpu-day.json", day.json()}, std::pair{"results.jsonl", day.records()},
        std::pair{"table.md", day.table()}})
    VOXC_TRY(tool::writeText(path(name), text));
  return {};
}

} // namespace voxc::gpu
