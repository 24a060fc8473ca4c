// Sentences about cells.
#include "report/Words.h"

#include "report/Html.h"

namespace voxc::report {
namespace {

std::string counts(const ErrorRecord &error) {
  return "missed " + countText(error.missed) + ", ghost " + countText(error.ghost) + ", wrong " +
         countText(error.wrong) + " of " + countText(error.rays) + " rays";
}

/// How long a picture takes on a device that counts its own time.
std::string frameWords(const Cell &cell) {
  if (!cell.device.hasClock || cell.rays.kind != "camera" || !cell.rays.count || *cell.speed.median <= 0)
    return {};
  return ", " + numberText(*cell.rays.count / *cell.speed.median / 1000) + " ms a picture";
}

} // namespace

std::string speedWords(const Cell &cell) {
  if (!cell.speed.median)
    return "no speed";
  std::string words = numberText(*cell.speed.median) + " " + speedUnit(cell.device.hasClock) + frameWords(cell);
  if (cell.speed.spread)
    words += ", spread " + percentText(*cell.speed.spread);
  return words + (cell.speed.steady ? "" : " (not steady)");
}

std::string errorWords(const Cell &cell) {
  return cell.error ? counts(*cell.error) : "errors were not checked";
}

std::string pointNote(const Entry &entry) {
  const Cell &cell = *entry.cell;
  std::string note = entry.look.name + "\n" + bytesText(*cell.volume.bytes);
  if (cell.volume.bytesPerVoxel)
    note += ", " + numberText(*cell.volume.bytesPerVoxel) + " bytes a voxel";
  note += "\n" + speedWords(cell) + "\n" + errorWords(cell);
  if (cell.lookupsPerRay)
    note += "\n" + numberText(*cell.lookupsPerRay) + " lookups a ray";
  return note + (entry.onFrontier ? "\nOn the Pareto frontier" : "");
}

std::string sideText(double resolution) { return resolution > 0 ? numberText(resolution) + "³" : ""; }

std::string stageTitle(const Stage &stage) {
  const std::string rays = stage.column == stage.model ? "" : stage.column.substr(stage.model.size() + 2) + ", ";
  return rays + sideText(stage.resolution) + " on " + stage.device;
}

std::string stageConditions(const Stage &stage) {
  return (stage.precision.empty() ? "" : stage.precision + " steps, ") + "passes: " + stage.passes;
}

std::string errorSummary(const Catalogue &catalogue, const std::vector<std::size_t> &entries) {
  ErrorRecord sum;
  std::size_t unchecked = 0;
  for (const std::size_t i : entries)
    if (const Entry &entry = catalogue.entries[i]; entry.hasPoint() && !entry.cell->error)
      ++unchecked;
    else if (entry.hasPoint()) {
      const ErrorRecord &error = *entry.cell->error;
      sum = {sum.rays + error.rays, sum.missed + error.missed, sum.ghost + error.ghost, sum.wrong + error.wrong, {}, {}};
    }
  std::string words = sum.rays > 0 ? counts(sum) + " checked" : "";
  if (unchecked > 0)
    words += (words.empty() ? "" : "; ") + plural(unchecked, "speed") + " with errors unchecked";
  return words;
}

} // namespace voxc::report
