// The table of a sweep.
#include "sweep/Summary.h"

#include <cinttypes>
#include <cstdio>
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

Figure asFigure(const Count &count) { return count ? Figure(double(*count)) : std::nullopt; }

/// "11 R(4^3) G(7) +whole-level-dedup".
std::string nameOf(const FormatPart &format) {
  std::string name = format.label.empty() ? format.name : format.label + " " + format.name;
  for (const std::string &pass : format.passes)
    name += " +" + pass;
  return name;
}

std::string titleOf(const Record &record) {
  return record.model.name + ", " + record.rays.name + " (" + std::to_string(record.rays.count) + " rays), " +
         record.precision + ", " + record.device.name;
}

void printHead(const Record &record) {
  std::printf("\n%s\n%-40s %9s %8s %8s %9s %7s %7s %8s %8s %8s\n", titleOf(record).c_str(), "format", "MiB",
              "B/voxel", "build s", record.device.clock == "gpu" ? "Mrays/gpu" : "Mrays/cpu", "spread",
              "ratio", "steps", "words", "wrong");
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

void printRow(const Record &record, const std::optional<Speed> &first) {
  const std::string name = nameOf(record.format);
  if (record.failure) {
    const std::string words =
        record.failure->words ? ", " + std::to_string(*record.failure->words) + " words" : "";
    std::printf("%-40s failed (%s%s): %s\n", name.c_str(), record.failure->stage.c_str(), words.c_str(),
                record.failure->reason.c_str());
    return;
  }
  const std::optional<Speed> &speed = speedOf(record);
  const Figure median = speed ? Figure(speed->median) : std::nullopt;
  const Figure spread = speed ? Figure(speed->spread) : std::nullopt;
  std::printf("%-40s %9s %8s %8s %9s %6s%s %7s %8s %8s %8s\n", name.c_str(),
              number("%.2f", asFigure(record.volume.bytes), 1.0 / (1 << 20)).c_str(),
              number("%.3g", record.volume.bytesPerVoxel).c_str(),
              number("%.2f", record.build.buildSeconds).c_str(), number("%.4g", median).c_str(),
              number("%.1f%%", spread, 100).c_str(), record.speed.steady.value_or(false) ? " " : "!",
              ratioText(speed, first).c_str(), number("%.1f", record.work.stepsPerRay).c_str(),
              number("%.1f", record.work.wordsPerRay).c_str(),
              number("%.0f", wrongRays(record.error)).c_str());
}

} // namespace

void printSummary(const std::vector<Cell> &cells) {
  std::vector<std::string> titles;
  std::map<std::string, std::vector<const Record *>> tables;
  for (const Cell &cell : cells) {
    const std::string title = titleOf(cell.record);
    auto &table = tables[title];
    if (table.empty())
      titles.push_back(title);
    table.push_back(&cell.record);
  }
  std::size_t failed = 0;
  for (const std::string &title : titles) {
    const auto &table = tables[title];
    printHead(*table.front());
    std::optional<Speed> first;
    for (const Record *record : table) {
      if (!first && record->isMeasured())
        first = speedOf(*record);
      printRow(*record, first);
      failed += !record->isMeasured();
    }
  }
  std::printf(
      "\n%zu cells, of which %zu failed; speeds are medians; = as fast as the first within the spread, ! not "
      "steady\n",
      cells.size(), failed);
}

} // namespace voxc::tool::bench
