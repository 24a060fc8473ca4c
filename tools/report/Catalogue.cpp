// Making the catalogue.
#include "report/Catalogue.h"

#include "report/DeviceNames.h"
#include "report/Pareto.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace voxc::report {
namespace {

std::string joined(const std::vector<std::string> &parts) {
  std::string text;
  for (const std::string &part : parts)
    text += (text.empty() ? "" : ", ") + part;
  return text.empty() ? kNoPasses : text;
}

/// The place of a value in a list, or behind its end.
std::size_t placeIn(const std::vector<std::string> &list, const std::string &value) {
  return static_cast<std::size_t>(std::ranges::find(list, value) - list.begin());
}

/// The same, where a new value is added.
std::size_t addTo(std::vector<std::string> &list, const std::string &value) {
  const std::size_t place = placeIn(list, value);
  if (place == list.size())
    list.push_back(value);
  return place;
}

std::optional<Errors> errorsOf(const Cell &cell) {
  const tool::bench::ErrorPart &error = cell.error;
  if (!error.rays || !error.missed || !error.ghost || !error.wrong)
    return std::nullopt;
  return Errors{double(*error.rays), double(*error.missed), double(*error.ghost), double(*error.wrong)};
}

/// Whether a speed is one that a machine may have; what is computed of it stays finite.
bool isDrawable(const tool::bench::Speed &speed) {
  constexpr double kLeast = 1e-12, kMost = 1e12, kMostSpread = 1e6;
  return speed.median >= kLeast && speed.median <= kMost && speed.spread >= 0 && speed.spread <= kMostSpread;
}

/// The figures of a cell, as far as they make sense.
Entry makeEntry(const Cell &cell) {
  Entry entry{&cell, lookOf(cell.format.name)};
  if (cell.volume.bytes && *cell.volume.bytes > 0)
    entry.bytes = double(*cell.volume.bytes);
  if (cell.build.peakRssBytes && *cell.build.peakRssBytes > 0)
    entry.peakBytes = double(*cell.build.peakRssBytes);
  entry.resolution = double(cell.resolution.value_or(0));
  if (const auto &speed = speedOf(cell); cell.isMeasured() && speed && isDrawable(*speed))
    entry.speed = speed;
  entry.hasClock = cell.device.clock == "gpu";
  entry.isSteady = cell.speed.steady.value_or(true);
  entry.errors = errorsOf(cell);
  entry.passes = joined(cell.format.passes);
  return entry;
}

std::vector<Entry> makeEntries(const std::vector<Cell> &cells, Catalogue &catalogue) {
  const std::vector<std::string> devices = deviceNames(cells);
  std::map<std::string, std::vector<std::string>> raysOfModels;
  for (const Cell &cell : cells)
    if (!cell.rays.name.empty())
      addTo(raysOfModels[cell.model.name], cell.rays.name);
  std::vector<Entry> entries;
  std::vector<std::string> formats;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    Entry entry = makeEntry(cells[i]);
    entry.format = addTo(formats, entry.look.name);
    entry.device = devices[i];
    const std::string &model = cells[i].model.name;
    entry.column = raysOfModels[model].size() > 1 ? model + ", " + cells[i].rays.name : model;
    addTo(catalogue.models, model);
    addTo(catalogue.columns, entry.column);
    addTo(catalogue.devices, entry.device);
    entries.push_back(std::move(entry));
  }
  catalogue.formats = formats.size();
  return entries;
}

/// The passes that most of these entries have; of several such those with whole-level-dedup, then the
/// shortest.
std::string commonPasses(const std::vector<Entry> &entries, const std::vector<std::size_t> &indices) {
  std::map<std::string, std::size_t> counts;
  for (const std::size_t i : indices)
    ++counts[entries[i].passes];
  const auto rank = [](const auto &row) {
    const bool deduplicates = row.first.find("whole-level-dedup") != std::string::npos;
    return std::tuple(row.second, deduplicates, -static_cast<long>(row.first.size()));
  };
  return std::ranges::max_element(counts, {}, rank)->first;
}

void markFrontier(const Stage &stage, std::vector<Entry> &entries) {
  std::vector<SizeSpeed> points;
  std::vector<std::size_t> indices;
  for (const std::size_t i : stage.entries)
    if (entries[i].hasPoint()) {
      points.push_back({*entries[i].bytes, entries[i].speed->median});
      indices.push_back(i);
    }
  const std::vector<bool> isOn = paretoFrontier(points);
  for (std::size_t i = 0; i < indices.size(); ++i)
    entries[indices[i]].onFrontier = isOn[i];
}

Stage makeStage(const std::vector<Entry> &entries, const std::vector<std::size_t> &indices) {
  const Entry &first = entries[indices.front()];
  Stage stage{first.cell->model.name,         first.column,     first.device,  first.cell->precision,
              commonPasses(entries, indices), first.resolution, first.hasClock};
  for (const std::size_t i : indices)
    if (entries[i].passes == stage.passes)
      stage.entries.push_back(i);
  stage.otherPasses = indices.size() - stage.entries.size();
  return stage;
}

std::vector<Stage> makeStages(const Catalogue &catalogue) {
  using Key = std::tuple<std::size_t, std::size_t, double, std::size_t, std::string, bool>;
  std::map<Key, std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < catalogue.entries.size(); ++i) {
    const Entry &entry = catalogue.entries[i];
    groups[{placeIn(catalogue.models, entry.cell->model.name), placeIn(catalogue.columns, entry.column),
            -entry.resolution, placeIn(catalogue.devices, entry.device), entry.cell->precision,
            entry.hasClock}]
        .push_back(i);
  }
  std::vector<Stage> stages;
  stages.reserve(groups.size());
  for (const auto &[key, indices] : groups)
    stages.push_back(makeStage(catalogue.entries, indices));
  return stages;
}

} // namespace

bool Entry::hasPass(std::string_view pass) const {
  return std::ranges::find(cell->format.passes, pass) != cell->format.passes.end();
}

Catalogue makeCatalogue(const std::vector<Cell> &cells) {
  Catalogue catalogue;
  catalogue.entries = makeEntries(cells, catalogue);
  catalogue.stages = makeStages(catalogue);
  for (const Stage &stage : catalogue.stages)
    markFrontier(stage, catalogue.entries);
  return catalogue;
}

std::string speedUnit(bool hasClock) { return hasClock ? "Mrays/GPU s" : "Mrays/CPU s"; }

} // namespace voxc::report
