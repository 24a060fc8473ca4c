// The table of a sweep.
#include "sweep/Summary.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <map>
#include <string>

namespace voxc::tool::bench {
namespace {

std::string number(const char *format, const Figure &value, double factor = 1) {
  if (!value)
    return "-";
  char text[32];
  std::snprintf(text, sizeof text, format, *value * factor);
  return text;
}

/// "11 R(4^3) G(7) +whole-level-dedup".
std::string nameOf(const FormatPart &format) {
  std::string name = format.label.empty() ? format.name : format.label + " " + format.name;
  for (const std::string &pass : format.passes)
    name += " +" + pass;
  return name;
}

std::string titleOf(const Record &record) {
  return record.model.name + ", " + titleOf(record.rays) + " (" + std::to_string(record.rays.count) +
         " rays), " + record.precision + ", " + record.device.name;
}

/// "12.9 MiB": three digits that count, and the unit that fits.
std::string sizeText(const Count &bytes) {
  static constexpr const char *kUnits[] = {"B", "KiB", "MiB", "GiB", "TiB"};
  if (!bytes)
    return "-";
  double value = double(*bytes);
  std::size_t unit = 0;
  for (; value >= 1000 && unit + 1 < std::size(kUnits); ++unit)
    value /= 1024;
  return number("%.3g", value) + " " + kUnits[unit];
}

/// The columns behind the name, each as wide as its head and its figures need.
constexpr const char *kColumns = "%-*s %9s %8s %8s %12s %7s %8s %7s %7s %6s\n";

/// As wide as the longest name of a table, so that its columns stay one below the other.
int nameWidth(const std::vector<const Record *> &table) {
  std::size_t width = std::strlen("format");
  for (const Record *record : table)
    if (record->isMeasured())
      width = std::max(width, nameOf(record->format).size());
  return static_cast<int>(width);
}

void printHead(const Record &record, int width) {
  std::printf("\n%s\n", titleOf(record).c_str());
  std::printf(kColumns, width, "format", "size", "B/voxel", "build s",
              record.device.clock == "gpu" ? "Mrays/GPU s" : "Mrays/CPU s", "spread", "x first", "steps",
              "words", "wrong");
}

Figure wrongRays(const ErrorPart &error) {
  if (!error.rays)
    return std::nullopt;
  return double(error.missed.value_or(0) + error.ghost.value_or(0) + error.wrong.value_or(0));
}

/// How many times as fast as the first, and whether that is more than rounds differ by.
std::string ratioText(const std::optional<Speed> &speed, const std::optional<Speed> &first) {
  if (!speed || !first)
    return "-";
  return number("%.3f", speed->median / first->median) + (areEqual(*speed, *first) ? "=" : " ");
}

void printRow(const Record &record, const std::optional<Speed> &first, int width) {
  const std::string name = nameOf(record.format);
  if (record.failure) {
    const std::string words =
        record.failure->words ? ", " + std::to_string(*record.failure->words) + " words" : "";
    std::printf("%-*s failed (%s%s): %s\n", width, name.c_str(), record.failure->stage.c_str(), words.c_str(),
                record.failure->reason.c_str());
    return;
  }
  const std::optional<Speed> &speed = speedOf(record);
  const Figure median = speed ? Figure(speed->median) : std::nullopt;
  const Figure spread = speed ? Figure(speed->spread) : std::nullopt;
  const std::string mark = record.speed.steady.value_or(false) ? " " : "!";
  std::printf(
      kColumns, width, name.c_str(), sizeText(record.volume.bytes).c_str(),
      number("%.3g", record.volume.bytesPerVoxel).c_str(), number("%.3g", record.build.buildSeconds).c_str(),
      number("%.4g", median).c_str(), (number("%.1f%%", spread, 100) + mark).c_str(),
      ratioText(speed, first).c_str(), number("%.1f", record.work.stepsPerRay).c_str(),
      number("%.1f", record.work.wordsPerRay).c_str(), number("%.0f", wrongRays(record.error)).c_str());
}

} // namespace

void printSummary(const std::vector<Cell> &cells) {
  std::vector<std::string> titles;
  std::map<std::string, std::vector<const Record *>> tables;
  for (const Cell &cell : cells) {
    const std::string title = titleOf(cell.record) + cell.record.rays.digest; // Others may have their name.
    auto &table = tables[title];
    if (table.empty())
      titles.push_back(title);
    table.push_back(&cell.record);
  }
  std::size_t failed = 0;
  for (const std::string &title : titles) {
    const auto &table = tables[title];
    const int width = nameWidth(table);
    printHead(*table.front(), width);
    std::optional<Speed> first;
    for (const Record *record : table) {
      if (!first && record->isMeasured())
        first = speedOf(*record);
      printRow(*record, first, width);
      failed += !record->isMeasured();
    }
  }
  std::printf("\n%zu cells, of which %zu failed; speeds are medians; = as fast as the first within the "
              "spread, ! not steady\n",
              cells.size(), failed);
}

} // namespace voxc::tool::bench
