// Finding pairs.
#include "report/Pairs.h"

#include <algorithm>
#include <map>

namespace voxc::report {
namespace {

/// What must be the same for both, as a list of words; the thing they differ in is left out or replaced.
using Identity = std::vector<std::string>;

Identity identity(const Entry &entry, std::string_view leftOutPass, const std::string &precision) {
  Identity words = {entry.cell->model.name, entry.column, entry.look.name,
                    entry.device,           precision,    std::to_string(entry.resolution)};
  for (const std::string &pass : entry.cell->format.passes)
    if (pass != leftOutPass)
      words.push_back(pass);
  return words;
}

using Index = std::map<Identity, const Entry *>;

} // namespace

std::vector<Pair> pairsByPass(const Catalogue &catalogue, std::string_view pass) {
  Index without;
  for (const Entry &entry : catalogue.entries)
    if (entry.cell->isMeasured() && !entry.hasPass(pass))
      without.emplace(identity(entry, pass, entry.cell->precision), &entry);
  std::vector<Pair> pairs;
  for (const Entry &entry : catalogue.entries) {
    const auto other = without.find(identity(entry, pass, entry.cell->precision));
    if (entry.cell->isMeasured() && entry.hasPass(pass) && other != without.end())
      pairs.push_back({&entry, other->second});
  }
  return pairs;
}

std::vector<Pair> pairsByPrecision(const Catalogue &catalogue) {
  Index exact;
  for (const Entry &entry : catalogue.entries)
    if (entry.cell->isMeasured() && entry.cell->precision == "exact")
      exact.emplace(identity(entry, {}, {}), &entry);
  std::vector<Pair> pairs;
  for (const Entry &entry : catalogue.entries) {
    const auto other = exact.find(identity(entry, {}, {}));
    if (entry.cell->isMeasured() && entry.cell->precision == "fast" && other != exact.end())
      pairs.push_back({&entry, other->second});
  }
  return pairs;
}

double shrinkage(const Pair &pair) {
  return pair.with->bytes && pair.without->bytes ? *pair.without->bytes / *pair.with->bytes : 0;
}

double speedUp(const Pair &pair) {
  return pair.with->speed && pair.without->speed ? pair.with->speed->median / pair.without->speed->median : 0;
}

bool isAsFast(const Pair &pair) {
  return speedUp(pair) > 0 && areEqual(*pair.with->speed, *pair.without->speed);
}

} // namespace voxc::report
