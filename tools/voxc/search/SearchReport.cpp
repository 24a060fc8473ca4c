// The verdict in words.
#include "search/SearchReport.h"

#include "search/BuildCommand.h"
#include "search/RatedFigures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace voxc::tool {

namespace {

using bench::Record;

template <typename... Values> std::string print(const char *format, const Values &...values) {
  std::array<char, 512> text;
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

std::string sizeText(double bytes) {
  constexpr double kMebibyte = 1 << 20;
  return bytes < kMebibyte ? print("%.1f KiB", bytes / 1024) : print("%.2f MiB", bytes / kMebibyte);
}

const RatedFormat &formatOf(const SearchResult &result, std::size_t index) {
  return result.race.formats()[index];
}

double speedOf(const SearchResult &result, std::size_t index) { return 1000 / *result.race.timeOf(index); }

/// "12.1 M/s overview, 3.4 M/s bounced".
std::string speedsOf(const SearchResult &result, std::size_t index) {
  std::string text;
  for (const Record &record : result.contest.findings().at(index).records)
    if (const auto &speed = bench::speedOf(record))
      text += (text.empty() ? "" : ", ") + print("%.2f M/s ", speed->median) + record.rays.name;
  return text;
}

/// How fast the format was foretold to be, of how fast it is; 0 if that is not known, as of what `voxc bench`
/// measured.
double foretold(const SearchResult &result, std::size_t index) {
  double nanoseconds = 0;
  const auto &records = result.contest.findings().at(index).records;
  for (const Record &record : records) {
    const double speed = record.predicted ? record.predicted->mraysPerS.value_or(0) : 0;
    if (speed <= 0)
      return 0;
    nanoseconds += 1000 / speed / static_cast<double>(records.size());
  }
  return *result.race.timeOf(index) / nanoseconds;
}

std::string foretoldText(const SearchResult &result, std::size_t index) {
  const double ratio = foretold(result, index);
  return ratio > 0 ? print("%4.2f", ratio) : "-";
}

std::string table(const SearchResult &result, const std::vector<std::size_t> &leading) {
  std::string text = "\n        size  speed" + std::string(38, ' ') + "foretold  format\n";
  for (const std::size_t i : leading)
    text +=
        print("  %10s  %-40s  x %4s  ", sizeText(static_cast<double>(formatOf(result, i).bytes())).c_str(),
              speedsOf(result, i).c_str(), foretoldText(result, i).c_str()) +
        nameOf(formatOf(result, i).candidate) + "\n";
  return text;
}

std::string verdict(const SearchResult &result, const std::string &question, std::size_t index) {
  const RatedFormat &format = formatOf(result, index);
  return print("%-22s ", (question + ":").c_str()) + nameOf(format.candidate) +
         print(", %s at %.2f M/s\n", sizeText(static_cast<double>(format.bytes())).c_str(),
               speedOf(result, index));
}

/// The fastest that is no larger.
std::size_t bestBelow(const SearchResult &result, const std::vector<std::size_t> &leading, double bytes) {
  std::size_t best = leading.front();
  for (const std::size_t i : leading)
    if (static_cast<double>(formatOf(result, i).bytes()) <= bytes)
      best = i;
  return best;
}

std::string verdicts(const SearchResult &result, const std::vector<std::size_t> &leading) {
  std::string text = verdict(result, "smallest", leading.front());
  // Between the smallest and the fastest, sizes that people name: powers of two.
  std::size_t last = leading.front();
  const double least = static_cast<double>(formatOf(result, leading.front()).bytes());
  const double most = static_cast<double>(formatOf(result, leading.back()).bytes());
  for (double bytes = std::exp2(std::ceil(std::log2(least))); bytes < most; bytes *= 2)
    if (const std::size_t best = bestBelow(result, leading, bytes); best != last) {
      text += verdict(result, "best below " + sizeText(bytes), best);
      last = best;
    }
  return text + verdict(result, "fastest", leading.back());
}

/// Rays that were checked, and how many of them were wrong.
struct Checked {
  std::uint64_t rays = 0, wrong = 0;
};

Checked checkedBy(const SearchResult &result) {
  Checked checked;
  for (const auto &[index, finding] : result.contest.findings())
    for (const Record &record : finding.records) {
      checked.rays += record.error.rays.value_or(0);
      checked.wrong +=
          record.error.missed.value_or(0) + record.error.ghost.value_or(0) + record.error.wrong.value_or(0);
    }
  return checked;
}

double medianError(const SearchResult &result) {
  std::vector<double> errors;
  for (const auto &[index, finding] : result.contest.findings())
    if (const double ratio = result.race.timeOf(index) ? foretold(result, index) : 0; ratio > 0)
      errors.push_back(std::abs(ratio - 1));
  return median(errors);
}

} // namespace

std::optional<std::size_t> chosen(const SearchResult &result) {
  std::vector<RatedFormat> measured;
  std::vector<std::size_t> numbers;
  for (const std::size_t i : result.contest.frontier()) {
    RatedFormat &format = measured.emplace_back(formatOf(result, i));
    format.nanoseconds = {*result.race.timeOf(i)};
    numbers.push_back(i);
  }
  const auto choice = choose(measured, result.wish);
  return choice ? std::optional(numbers[*choice]) : std::nullopt;
}

std::string searchReport(const SearchResult &result) {
  const std::vector<std::size_t> leading = result.contest.frontier();
  const Checked checked = checkedBy(result);
  std::string text = print("%zu of %zu formats measured on %s in %.0f s; %llu of %llu checked rays wrong; "
                           "speeds foretold within %.0f %%\n",
                           result.contest.findings().size(), result.rated, result.device.c_str(),
                           result.seconds, static_cast<unsigned long long>(checked.wrong),
                           static_cast<unsigned long long>(checked.rays), 100 * medianError(result));
  text += result.contest.isComplete() ? "nothing that was not measured promises more\n"
                                      : "the budget ended first: run the command again to go on\n";
  const auto choice = chosen(result);
  if (!choice)
    return text + "no format could be measured\n";
  text += table(result, leading) + "\n" + verdicts(result, leading);
  return text + "\n" + buildCommand(result.input, result.arguments, formatOf(result, *choice).candidate) +
         "\n";
}

void addSearchFigures(Json &figures, const SearchResult &result) {
  const Checked checked = checkedBy(result);
  figures["rated"] = result.rated;
  figures["kept"] = result.kept;
  figures["measured"] = result.contest.findings().size();
  figures["complete"] = result.contest.isComplete();
  figures["seconds"] = result.seconds;
  figures["area"] = result.race.frontier().area();
  figures["checked_rays"] = checked.rays;
  figures["wrong_rays"] = checked.wrong;
  figures["median_error"] = medianError(result);
  const auto choice = chosen(result);
  Json rows = Json::array();
  for (const std::size_t i : result.contest.frontier()) {
    const RatedFormat &format = formatOf(result, i);
    rows.push_back({{"format", format.candidate.text},
                    {"passes", format.candidate.passes},
                    {"bytes", format.bytes()},
                    {"mrays_per_s", speedOf(result, i)},
                    {"chosen", choice == i}});
  }
  figures["frontier"] = std::move(rows);
  figures["formats"] = Json::array();
  for (const RatedFormat &format : result.race.formats())
    figures["formats"].push_back(ratedFigures(format, result.rays));
}

} // namespace voxc::tool
