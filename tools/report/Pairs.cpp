// Finding pairs.
#include "report/Pairs.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace voxc::report {
namespace {

/// What must be the same for both, as a list of words; the thing they differ in is left out or replaced.
using Identity = std::vector<std::string>;

Identity identity(const Entry &entry, std::string_view leftOutPass, const std::string &precision) {
  Identity words = {entry.cell->model.name, entry.column, entry.look.name, entry.device, precision,
                    std::to_string(entry.cell->resolution)};
  for (const std::string &pass : entry.cell->format.passes)
    if (pass != leftOutPass)
      words.push_back(pass);
  return words;
}

using Index = std::map<Identity, const Entry *>;

bool isSide(double value) { return std::isfinite(value) && value > 0; }

double ratio(Figure above, Figure below) {
  return above && below && isSide(*above) && isSide(*below) ? *above / *below : 0;
}

} // namespace

std::vector<Pair> pairsByPass(const Catalogue &catalogue, std::string_view pass) {
  Index without;
  for (const Entry &entry : catalogue.entries)
    if (entry.cell->measured && !entry.hasPass(pass))
      without.emplace(identity(entry, pass, entry.cell->precision), &entry);
  std::vector<Pair> pairs;
  for (const Entry &entry : catalogue.entries) {
    const auto other = without.find(identity(entry, pass, entry.cell->precision));
    if (entry.cell->measured && entry.hasPass(pass) && other != without.end())
      pairs.push_back({&entry, other->second});
  }
  return pairs;
}

std::vector<Pair> pairsByPrecision(const Catalogue &catalogue) {
  Index exact;
  for (const Entry &entry : catalogue.entries)
    if (entry.cell->measured && entry.cell->precision == "exact")
      exact.emplace(identity(entry, {}, {}), &entry);
  std::vector<Pair> pairs;
  for (const Entry &entry : catalogue.entries) {
    const auto other = exact.find(identity(entry, {}, {}));
    if (entry.cell->measured && entry.cell->precision == "fast" && other != exact.end())
      pairs.push_back({&entry, other->second});
  }
  return pairs;
}

double shrinkage(const Pair &pair) {
  return ratio(pair.without->cell->volume.bytes, pair.with->cell->volume.bytes);
}

double speedUp(const Pair &pair) {
  return ratio(pair.with->cell->speed.median, pair.without->cell->speed.median);
}

bool isAsFast(const Pair &pair) {
  const SpeedRecord &with = pair.with->cell->speed, &without = pair.without->cell->speed;
  const double first = with.median.value_or(0), second = without.median.value_or(0);
  return std::abs(first - second) <=
         std::max(first * with.spread.value_or(0), second * without.spread.value_or(0));
}

} // namespace voxc::report
