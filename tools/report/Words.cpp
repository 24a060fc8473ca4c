// Sentences about cells.
#include "report/Words.h"

#include "report/Html.h"

#include <algorithm>
#include <cmath>

namespace voxc::report {
namespace {

std::string counts(const Errors &errors) {
  return "missed " + countText(errors.missed) + ", ghost " + countText(errors.ghost) + ", wrong " +
         countText(errors.wrong) + " of " + countText(errors.rays) + " rays";
}

/// How long a picture takes on a device that counts its own time.
std::string frameWords(const Entry &entry) {
  const tool::bench::RaysPart &rays = entry.cell->rays;
  if (!entry.hasClock || rays.kind != "camera")
    return {};
  return ", " + numberText(double(rays.count) / entry.speed->median / 1000) + " ms a picture";
}

} // namespace

std::string speedWords(const Entry &entry) {
  if (!entry.speed)
    return "no speed";
  return numberText(entry.speed->median) + " " + speedUnit(entry.hasClock) + frameWords(entry) + ", spread " +
         percentText(entry.speed->spread) + (entry.isSteady ? "" : " (not steady)");
}

std::string errorWords(const Entry &entry) {
  return entry.errors ? counts(*entry.errors) : "errors were not checked";
}

std::string wholeName(const Entry &entry) {
  const std::string passes = passList(entry.cell->format.passes);
  return entry.look.name + (passes.empty() ? ", without passes" : ", with " + passes);
}

std::string standingWords(const Catalogue &catalogue, const Entry &entry) {
  const Entry &rival = catalogue.entries[entry.standing.rival];
  switch (entry.standing.place) {
  case Place::Leading:
    return "On the frontier";
  case Place::AsGood:
    return "As good as " + rival.name + ", on the frontier";
  case Place::Beaten:
    break;
  }
  const std::string speed = areEqual(*rival.speed, *entry.speed)
                                ? "as fast"
                                : numberText(rival.speed->median / entry.speed->median) + "× as fast";
  const std::string size =
      *rival.bytes == *entry.bytes ? "the same size" : numberText(*rival.bytes / *entry.bytes) + "× the size";
  return "Beaten by " + rival.name + ", " + speed + " at " + size;
}

std::string pointNote(const Catalogue &catalogue, const Entry &entry) {
  const Cell &cell = *entry.cell;
  std::string note = entry.name + "\n" + bytesText(*entry.bytes);
  if (cell.volume.bytesPerVoxel)
    note += ", " + numberText(*cell.volume.bytesPerVoxel) + " bytes a voxel";
  note += "\n" + speedWords(entry) + "\n" + errorWords(entry);
  if (cell.work.stepsPerRay)
    note += "\n" + numberText(*cell.work.stepsPerRay) + " lookups a ray";
  return note + "\n" + standingWords(catalogue, entry);
}

std::string sideText(double resolution) {
  return resolution > 0 ? std::to_string(std::llround(std::min(resolution, 1e15))) + "³" : "";
}

std::string resolutionTitle(const Stage &stage) {
  const std::string rays =
      stage.column == stage.model ? "" : stage.column.substr(stage.model.size() + 2) + ", ";
  return rays + sideText(stage.resolution);
}

std::string stageTitle(const Stage &stage) {
  return resolutionTitle(stage) + " on " + stage.device +
         (stage.precision.empty() ? "" : ", " + stage.precision + " steps");
}

std::string stageConditions(const Catalogue &catalogue, const Stage &stage) {
  const tool::bench::RaysPart &rays = catalogue.entries[stage.entries.front()].cell->rays;
  const std::string passes = stage.usualPasses.empty() ? "no passes" : passList(stage.usualPasses);
  return countText(double(rays.count)) + " rays" + (rays.kind == "camera" ? " of camera " + rays.name : "") +
         "; " + passes + (stage.hasOtherPasses ? ", unless a name says otherwise" : "");
}

std::string errorSummary(const Catalogue &catalogue, const std::vector<std::size_t> &entries) {
  Errors sum;
  std::size_t unchecked = 0;
  for (const std::size_t i : entries)
    if (const Entry &entry = catalogue.entries[i]; entry.hasPoint() && !entry.errors)
      ++unchecked;
    else if (entry.hasPoint()) {
      const Errors &error = *entry.errors;
      sum = {sum.rays + error.rays, sum.missed + error.missed, sum.ghost + error.ghost,
             sum.wrong + error.wrong};
    }
  std::string words = sum.rays > 0 ? counts(sum) + " checked" : "";
  if (unchecked > 0)
    words += (words.empty() ? "" : "; ") + plural(unchecked, "speed") + " with errors unchecked";
  return words;
}

} // namespace voxc::report
