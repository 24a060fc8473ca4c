// Computing the verdict of a search.
#include "voxc/Measure/SearchVerdict.h"

#include "Measure/Json.h"
#include "voxc/Measure/Digest.h"
#include "voxc/Support/File.h"

#include "voxc/Search/Composition.h"
#include "voxc/Search/Suggest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <utility>

namespace voxc::measure {
namespace {

template <typename... Values> std::string print(const char *format, const Values &...values) {
  std::array<char, 64> text;
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

using Variant = std::pair<std::string, std::vector<std::string>>;

Variant variantOf(const Record &cell) { return {cell.format.name, cell.format.passes}; }

/// Its median speed, if it has one that times can be made of.
std::optional<double> medianOf(const Record &cell) {
  const auto &speed = speedOf(cell);
  return cell.isMeasured() && speed && speed->median > 0 ? std::optional(speed->median) : std::nullopt;
}

/// Of the mean time of sets of rays with these speeds.
double meanSpeed(const std::vector<double> &speeds) {
  double time = 0;
  for (const double speed : speeds)
    time += 1 / speed / static_cast<double>(speeds.size());
  return 1 / time;
}

double predictedRatio(const Finalist &finalist) {
  std::vector<double> predicted;
  for (const Record *cell : finalist.cells)
    if (const double speed = cell->predicted ? cell->predicted->mraysPerS.value_or(0) : 0; speed > 0)
      predicted.push_back(speed);
  return predicted.size() == finalist.cells.size() ? meanSpeed(predicted) / finalist.mraysPerS : 0;
}

/// A format of which all cells were measured, on `sets` sets of rays.
std::optional<Finalist> makeFinalist(const Variant &variant, const std::vector<const Record *> &cells,
                                     std::size_t sets) {
  Finalist finalist{.name = plainName(variant.first, variant.second), .cells = cells};
  std::vector<double> speeds;
  for (const Record *cell : cells)
    if (const auto median = medianOf(*cell))
      speeds.push_back(*median);
  finalist.bytes = static_cast<double>(cells.front()->volume.bytes.value_or(0));
  if (speeds.size() != sets || finalist.bytes <= 0)
    return std::nullopt;
  finalist.mraysPerS = meanSpeed(speeds);
  finalist.predictedRatio = predictedRatio(finalist);
  finalist.sizeText = verdictSize(finalist.bytes);
  finalist.speedText = print("%.2f M/s", finalist.mraysPerS);
  return finalist;
}

/// Those that no other beats in both size and speed, from small to large.
std::vector<Finalist> frontierOf(std::vector<Finalist> finalists) {
  std::ranges::stable_sort(finalists, [](const Finalist &a, const Finalist &b) {
    return std::pair(a.bytes, -a.mraysPerS) < std::pair(b.bytes, -b.mraysPerS);
  });
  std::vector<Finalist> frontier;
  for (Finalist &finalist : finalists)
    if (frontier.empty() || finalist.mraysPerS > frontier.back().mraysPerS)
      frontier.push_back(std::move(finalist));
  return frontier;
}

/// Whether no set of rays tells the speeds of two formats apart.
bool areAsFast(const Finalist &a, const Finalist &b) {
  for (std::size_t set = 0; set < a.cells.size(); ++set)
    if (!areEqual(*speedOf(*a.cells[set]), *speedOf(*b.cells[set])))
      return false;
  return true;
}

/// "16 KiB", "2 MiB", for powers of two.
std::string powerText(double bytes) {
  constexpr double kMebibyte = 1 << 20;
  return bytes < 1024        ? print("%g bytes", bytes)
         : bytes < kMebibyte ? print("%g KiB", bytes / 1024)
                             : print("%g MiB", bytes / kMebibyte);
}

class Asking {
public:
  Asking(const std::vector<Finalist> &frontier, const std::vector<Finalist> &all)
      : frontier_(frontier), all_(all) {}

  std::vector<SearchAnswer> answers() {
    ask("smallest", 0, frontier_.front().bytes);
    // Between the smallest and the fastest, sizes that people name: powers of two.
    const double most = frontier_.back().bytes;
    for (double bytes = std::exp2(std::ceil(std::log2(frontier_.front().bytes))); bytes < most; bytes *= 2)
      if (const std::size_t best = fastestOf(bytes); best != answers_.back().finalist)
        ask("best below " + powerText(bytes), best, bytes);
    ask("fastest", frontier_.size() - 1, all_.back().bytes);
    std::vector<SizeTime> points;
    points.reserve(frontier_.size());
    for (const Finalist &finalist : frontier_)
      points.push_back({finalist.bytes, 1000 / finalist.mraysPerS});
    const std::size_t balanced = choose(points, Wish::Objective::Balanced).value_or(0);
    ask("balanced", balanced, frontier_[balanced].bytes);
    return std::move(answers_);
  }

private:
  std::size_t fastestOf(double bytes) const {
    std::size_t best = 0;
    while (best + 1 < frontier_.size() && frontier_[best + 1].bytes <= bytes)
      ++best;
    return best;
  }

  void ask(const std::string &question, std::size_t finalist, double mostBytes) {
    SearchAnswer answer{question, finalist, {}};
    for (const Finalist &other : all_)
      if (other.cells != frontier_[finalist].cells && other.bytes <= mostBytes &&
          areAsFast(other, frontier_[finalist]))
        answer.asFast.push_back(other.name);
    answers_.push_back(std::move(answer));
  }

  const std::vector<Finalist> &frontier_, &all_;
  std::vector<SearchAnswer> answers_;
};

/// The cells of each format, those of the same set of rays at the same place.
std::map<Variant, std::vector<const Record *>> variantsOf(std::vector<const Record *> cells) {
  std::ranges::stable_sort(cells, {}, [](const Record *cell) { return cell->rays.digest; });
  std::map<Variant, std::vector<const Record *>> variants;
  for (const Record *cell : cells)
    variants[variantOf(*cell)].push_back(cell);
  return variants;
}

/// Tells the speed on each set of rays, in the order in which the sets first came.
void tellSets(std::vector<Finalist> &frontier, const std::vector<const Record *> &cells) {
  std::vector<std::string> order;
  for (const Record *cell : cells)
    if (std::ranges::find(order, cell->rays.digest) == order.end())
      order.push_back(cell->rays.digest);
  for (Finalist &finalist : frontier) {
    std::ranges::stable_sort(finalist.cells, {}, [&](const Record *cell) {
      return std::ranges::find(order, cell->rays.digest) - order.begin();
    });
    for (const Record *cell : finalist.cells)
      finalist.setSpeedsText += (finalist.setSpeedsText.empty() ? "" : ", ") +
                                print("%.2f M/s ", *medianOf(*cell)) + cell->rays.name;
  }
}

/// What the formats of one verdict have in common.
std::string placeOf(const Record &cell) {
  return cell.model.name + "\n" + cell.model.digest + "\n" + std::to_string(cell.resolution.value_or(0)) +
         "\n" + cell.device.name + "\n" + cell.device.clock + "\n" + cell.precision;
}

std::vector<std::string> digestsOf(const auto &cells) {
  std::vector<std::string> digests;
  digests.reserve(cells.size());
  for (const Record *cell : cells)
    digests.push_back(cell->cell);
  std::ranges::sort(digests);
  return digests;
}

Json toJson(const Finalist &finalist) {
  std::vector<std::string> cells;
  cells.reserve(finalist.cells.size());
  for (const Record *cell : finalist.cells)
    cells.push_back(cell->cell);
  return {{"name", finalist.name},
          {"size", finalist.sizeText},
          {"speed", finalist.speedText},
          {"set_speeds", finalist.setSpeedsText},
          {"cells", cells}};
}

/// As tools/report/voxc_report/searches.py reads it.
Json toJson(const SearchVerdict &verdict) {
  Json json{{"formats", verdict.formats},
            {"cells", digestsOf(verdict.cells)},
            {"compared", digestsOf(verdict.compared)},
            {"frontier", Json::array()},
            {"answers", Json::array()}};
  for (const Finalist &finalist : verdict.frontier)
    json["frontier"].push_back(toJson(finalist));
  for (const SearchAnswer &answer : verdict.answers)
    json["answers"].push_back(
        {{"question", answer.question}, {"format", answer.finalist}, {"as_fast", answer.asFast}});
  return json;
}

} // namespace

std::string verdictSize(double bytes) {
  constexpr double kMebibyte = 1 << 20;
  return bytes < 1024        ? print("%.0f bytes", bytes)
         : bytes < kMebibyte ? print("%.1f KiB", bytes / 1024)
                             : print("%.2f MiB", bytes / kMebibyte);
}

std::string plainName(const std::string &format, std::span<const std::string> passes) {
  const auto traversals = searchedTraversals();
  std::string name = format;
  const char *separator = " with ";
  for (const std::string &pass : passes) {
    const bool isTraversal = std::ranges::find(traversals, pass) != traversals.end();
    const char *phrase = isTraversal                          ? pass.c_str()
                         : pass.starts_with("short-pointers") ? "short pointers"
                         : pass == "octant-masks"             ? "octant masks"
                                                              : nullptr;
    if (!phrase)
      continue; // All formats of a search that can have it do.
    name.append(separator).append(phrase);
    separator = ", ";
  }
  return name;
}

const Finalist &SearchVerdict::answer(std::string_view question) const {
  return frontier[std::ranges::find(answers, question, &SearchAnswer::question)->finalist];
}

double SearchVerdict::worstFactor() const {
  double worst = 0;
  for (const Finalist &finalist : frontier)
    if (finalist.predictedRatio > 0)
      worst = std::max({worst, finalist.predictedRatio, 1 / finalist.predictedRatio});
  return worst;
}

SearchVerdict makeSearchVerdict(const std::vector<const Record *> &cells,
                                const std::function<bool(const Record &)> &isCompared,
                                const std::string &objective, double leastSpeed) {
  SearchVerdict verdict{.objective = objective};
  std::set<std::string> sets;
  for (const Record *cell : cells) {
    verdict.cells.insert(cell);
    sets.insert(cell->rays.digest);
    const auto &error = cell->error;
    verdict.checkedRays += error.rays.value_or(0);
    verdict.wrongRays += error.missed.value_or(0) + error.ghost.value_or(0) + error.wrong.value_or(0);
  }
  std::vector<Finalist> finalists;
  for (const auto &[variant, ofVariant] : variantsOf(cells)) {
    ++verdict.formats;
    if (!std::ranges::all_of(ofVariant, [&](const Record *cell) { return isCompared(*cell); }))
      continue;
    if (auto finalist = makeFinalist(variant, ofVariant, sets.size())) {
      verdict.compared.insert(ofVariant.begin(), ofVariant.end());
      verdict.fastest = std::max(verdict.fastest, finalist->mraysPerS);
      if (finalist->mraysPerS >= leastSpeed)
        finalists.push_back(std::move(*finalist));
    }
  }
  verdict.frontier = frontierOf(finalists);
  if (verdict.frontier.empty())
    return verdict;
  std::ranges::stable_sort(finalists, {}, &Finalist::bytes);
  verdict.answers = Asking(verdict.frontier, finalists).answers();
  tellSets(verdict.frontier, cells);
  return verdict;
}

Expected<void> writeVerdict(const std::string &folder, const SearchVerdict &verdict) {
  if (verdict.cells.empty())
    return {};
  Digest digest;
  digest.add(placeOf(**verdict.cells.begin()));
  return writeFile(folder + "/" + kVerdictPrefix + digest.hex() + ".json", toJson(verdict).dump(2) + "\n");
}

} // namespace voxc::measure
