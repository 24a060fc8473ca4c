// Making the catalogue.
#include "report/Catalogue.h"

#include "report/DeviceNames.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace voxc::report {
namespace {

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

constexpr double kMostSpeed = 1e12;

/// Whether a speed is one that a machine may have; what is computed of it stays finite.
bool isDrawable(const tool::bench::Speed &speed) {
  constexpr double kLeast = 1e-12, kMostSpread = 1e6;
  return speed.median >= kLeast && speed.median <= kMostSpeed && speed.spread >= 0 &&
         speed.spread <= kMostSpread;
}

/// The rounds in order, whatever a record says of them.
tool::bench::Speed inOrder(tool::bench::Speed speed) {
  speed.min = std::clamp(speed.min, 0.0, speed.median);
  speed.max = std::clamp(speed.max, speed.median, kMostSpeed);
  return speed;
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
    entry.speed = inOrder(*speed);
  entry.hasClock = cell.device.clock == "gpu";
  entry.isSteady = cell.speed.steady.value_or(true);
  entry.errors = errorsOf(cell);
  return entry;
}

/// The usual passes of each resolution, so that a name is the same on all models and devices.
std::map<double, Passes> usualPassesOf(const std::vector<Entry> &entries) {
  std::map<double, std::vector<const Passes *>> lists;
  for (const Entry &entry : entries)
    if (entry.cell->isMeasured())
      lists[entry.resolution].push_back(&entry.cell->format.passes);
  std::map<double, Passes> usual;
  for (const auto &[resolution, passes] : lists)
    usual[resolution] = usualPasses(passes);
  return usual;
}

/// Names that tell formats with their passes apart.
void nameEntries(std::vector<Entry> &entries) {
  auto usual = usualPassesOf(entries);
  std::map<std::pair<std::string, Passes>, std::size_t> variants;
  for (Entry &entry : entries) {
    Passes passes = entry.cell->format.passes;
    entry.name = entry.look.name + passDifference(passes, usual[entry.resolution]);
    std::ranges::sort(passes);
    entry.variant = variants.try_emplace({entry.look.name, passes}, variants.size()).first->second;
  }
}

std::vector<Entry> makeEntries(const std::vector<Cell> &cells, Catalogue &catalogue) {
  const std::vector<std::string> devices = deviceNames(cells);
  std::map<std::string, std::vector<std::string>> raysOfModels;
  for (const Cell &cell : cells)
    if (!cell.rays.name.empty())
      addTo(raysOfModels[cell.model.name], titleOf(cell.rays));
  std::vector<Entry> entries;
  std::set<std::string> formats;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    Entry entry = makeEntry(cells[i]);
    // A search counts a format with other passes as another one.
    formats.insert(entry.look.name +
                   (catalogue.verdicts.empty() ? "" : passDifference(cells[i].format.passes, {})));
    entry.device = devices[i];
    const std::string &model = cells[i].model.name;
    entry.column = raysOfModels[model].size() > 1 ? model + ", " + titleOf(cells[i].rays) : model;
    addTo(catalogue.models, model);
    addTo(catalogue.columns, entry.column);
    addTo(catalogue.devices, entry.device);
    entries.push_back(std::move(entry));
  }
  catalogue.formats = formats.size();
  nameEntries(entries);
  return entries;
}

/// Of a search, formats whose times are of other moments than those that are compared are beaten by the
/// fastest leader that is no larger.
void rankOther(Entry &entry, const std::vector<Entry> &entries, const std::vector<std::size_t> &compared) {
  std::optional<std::size_t> rival;
  for (const std::size_t i : compared)
    if (const Entry &other = entries[i];
        other.isLeading() &&
        (!rival || (*other.bytes <= *entry.bytes && *other.bytes > *entries[*rival].bytes)))
      rival = i;
  if (rival)
    entry.standing = {Place::Beaten, *rival};
}

void rank(const Stage &stage, std::vector<Entry> &entries, const SearchVerdict *verdict) {
  std::vector<MeasuredPoint> points;
  std::vector<std::size_t> indices, others;
  for (const std::size_t i : stage.entries) {
    if (!entries[i].hasPoint())
      continue;
    const bool isCompared =
        !verdict || verdict->compared.empty() || verdict->compared.contains(entries[i].cell);
    if (isCompared)
      points.push_back({*entries[i].bytes, *entries[i].speed});
    (isCompared ? indices : others).push_back(i);
  }
  const std::vector<Standing> found = standings(points);
  for (std::size_t i = 0; i < indices.size(); ++i)
    entries[indices[i]].standing = {found[i].place, indices[found[i].rival]};
  std::ranges::sort(indices, {}, [&](std::size_t i) { return *entries[i].bytes; });
  for (const std::size_t i : others)
    rankOther(entries[i], entries, indices);
}

Stage makeStage(const std::vector<Entry> &entries, const std::vector<std::size_t> &indices, Passes usual) {
  const Entry &first = entries[indices.front()];
  const bool hasOthers = std::ranges::any_of(indices, [&](std::size_t i) {
    return entries[i].hasPoint() && entries[i].name != entries[i].look.name;
  });
  return {first.cell->model.name,
          first.column,
          first.device,
          first.cell->precision,
          first.resolution,
          first.hasClock,
          indices,
          std::move(usual),
          hasOthers};
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
  auto usual = usualPassesOf(catalogue.entries);
  for (const auto &[key, indices] : groups)
    stages.push_back(makeStage(catalogue.entries, indices, usual[-std::get<2>(key)]));
  return stages;
}

} // namespace

bool Entry::hasPass(std::string_view pass) const {
  return std::ranges::find(cell->format.passes, pass) != cell->format.passes.end();
}

const SearchVerdict *Catalogue::verdictOn(const Stage &stage) const {
  const std::string key = searchStage(*entries[stage.entries.front()].cell);
  const auto found = std::ranges::find_if(
      verdicts, [&](const SearchVerdict &verdict) { return verdict.stages.contains(key); });
  return found == verdicts.end() ? nullptr : &*found;
}

Catalogue makeCatalogue(const std::vector<Cell> &cells, std::vector<SearchVerdict> verdicts) {
  Catalogue catalogue;
  catalogue.verdicts = std::move(verdicts);
  catalogue.entries = makeEntries(cells, catalogue);
  catalogue.stages = makeStages(catalogue);
  for (const Stage &stage : catalogue.stages)
    rank(stage, catalogue.entries, catalogue.verdictOn(stage));
  return catalogue;
}

std::string speedUnit(bool hasClock) { return hasClock ? "Mrays/GPU s" : "Mrays/CPU s"; }

} // namespace voxc::report
