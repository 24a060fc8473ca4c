// The verdict in words.
#include "search/SearchReport.h"

#include "choosing/BuildCommand.h"
#include "choosing/PredictionFigures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace voxc::tool {

namespace {

using measure::Finalist;
using measure::Record;
using measure::SearchAnswer;

template <typename... Values> std::string print(const char *format, const Values &...values) {
  std::array<char, 512> text;
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

std::string ratioText(const Finalist &finalist) {
  return finalist.predictedRatio > 0 ? print("%.2f", finalist.predictedRatio) : "-";
}

std::string table(const measure::SearchVerdict &verdict) {
  std::string text = "\n        size  speed" + std::string(35, ' ') + "predicted/measured  format\n";
  for (const Finalist &finalist : verdict.frontier)
    text += print("  %10s  %-39s %18s  ", finalist.sizeText.c_str(), finalist.setSpeedsText.c_str(),
                  ratioText(finalist).c_str()) +
            finalist.name + "\n";
  return text;
}

std::string answers(const measure::SearchVerdict &verdict) {
  std::string text;
  for (const SearchAnswer &answer : verdict.answers) {
    const Finalist &finalist = verdict.frontier[answer.finalist];
    text += print("%-22s ", (answer.question + ":").c_str()) + finalist.name + ", " + finalist.sizeText +
            " at " + finalist.speedText + "\n";
  }
  return text;
}

/// The predicted format that a finalist is; none if records of another kind lie in the folder.
const PredictedFormat *formatOf(const SearchResult &result, const Finalist &finalist) {
  const measure::FormatPart &wanted = finalist.cells.front()->format;
  const auto &formats = result.acquisition.formats();
  const auto found = std::ranges::find_if(formats, [&](const PredictedFormat &format) {
    return format.candidate.text == wanted.name && format.candidate.passes == wanted.passes;
  });
  return found == formats.end() ? nullptr : &*found;
}

/// ": compile: ...", of the first format that failed.
std::string whyNone(const SearchResult &result) {
  for (const auto &[index, finding] : result.loop.findings())
    for (const Record &record : finding.records)
      if (record.failure)
        return ": " + record.failure->stage + ": " + record.failure->reason;
  return {};
}

/// What the command at the end builds.
std::string meaningOf(const std::string &objective) {
  constexpr std::pair<const char *, const char *> kMeanings[] = {
      {"balanced", "balanced, as twice the speed is worth four times the bytes; --objective smallest or "
                   "fastest prints another's command:"},
      {"fastest", "fastest (--objective fastest):"},
      {"smallest", "smallest (--objective smallest):"}};
  return std::ranges::find(kMeanings, objective, [](const auto &row) { return std::string(row.first); })
      ->second;
}

double medianError(const SearchResult &result) {
  std::vector<double> errors;
  for (const auto &[index, finding] : result.loop.findings()) {
    double predicted = 0; // Nanoseconds.
    for (const Record &record : finding.records)
      predicted += record.predicted && record.predicted->mraysPerS.value_or(0) > 0
                       ? 1000 / *record.predicted->mraysPerS / static_cast<double>(finding.records.size())
                       : std::nan("");
    if (const auto time = result.acquisition.timeOf(index); time && predicted > 0)
      errors.push_back(std::abs(*time / predicted - 1));
  }
  return measure::median(errors);
}

Json answerFigures(const Finalist &finalist) {
  const measure::FormatPart &format = finalist.cells.front()->format;
  return {{"name", finalist.name},
          {"format", format.name},
          {"passes", format.passes},
          {"bytes", static_cast<std::uint64_t>(finalist.bytes)},
          {"mrays_per_s", finalist.mraysPerS}};
}

Json verdictFigures(const measure::SearchVerdict &verdict) {
  Json figures{{"formats", verdict.formats}, {"objective", verdict.objective}};
  for (const SearchAnswer &answer : verdict.answers)
    figures[answer.question] = answerFigures(verdict.frontier[answer.finalist]);
  return figures;
}

} // namespace

std::string searchReport(const SearchResult &result) {
  const measure::SearchVerdict &verdict = result.verdict;
  std::string text = print("%zu of %zu formats measured on %s in %.0f s; %llu of %llu checked rays wrong",
                           verdict.formats, result.rated, result.device.c_str(), result.seconds,
                           static_cast<unsigned long long>(verdict.wrongRays),
                           static_cast<unsigned long long>(verdict.checkedRays));
  if (const double factor = verdict.worstFactor(); factor > 0)
    text += print("; speeds of the best predicted within a factor of %.2f", factor);
  if (result.loop.isComplete())
    text += "\nnothing that was not measured promises more\n";
  else
    text += print("\n%s: run the command again to go on\n",
                  result.isInterrupted ? "it was interrupted" : "the budget ended first");
  if (verdict.frontier.empty())
    return text;
  text += table(verdict) + "\n" + answers(verdict);
  if (const PredictedFormat *format = formatOf(result, verdict.answer(verdict.objective)))
    text += "\n" + meaningOf(verdict.objective) + "\n" +
            buildCommand(result.input, result.arguments, format->candidate) + "\n";
  return text;
}

std::string whyNoAnswer(const SearchResult &result) {
  if (result.verdict.fastest > 0)
    return print(
        "no format has the %g M/s that --min-speed asks for; the fastest that was measured has %.2f M/s",
        result.leastSpeed, result.verdict.fastest);
  return "no format could be measured" + whyNone(result);
}

void addSearchFigures(Json &figures, const SearchResult &result) {
  const measure::SearchVerdict &verdict = result.verdict;
  figures["rated"] = result.rated;
  figures["kept"] = result.kept;
  figures["measured"] = verdict.formats;
  figures["complete"] = result.loop.isComplete();
  figures["seconds"] = result.seconds;
  figures["area"] = result.acquisition.frontier().area();
  figures["checked_rays"] = verdict.checkedRays;
  figures["wrong_rays"] = verdict.wrongRays;
  figures["median_error"] = medianError(result);
  figures["worst_factor"] = verdict.worstFactor();
  figures["verdict"] = verdictFigures(verdict);
  Json rows = Json::array();
  for (const Finalist &finalist : verdict.frontier) {
    Json row = answerFigures(finalist);
    row["chosen"] = &finalist == &verdict.answer(verdict.objective);
    rows.push_back(std::move(row));
  }
  figures["frontier"] = std::move(rows);
  figures["formats"] = Json::array();
  for (const PredictedFormat &format : result.acquisition.formats())
    figures["formats"].push_back(predictionFigures(format, result.rays));
}

} // namespace voxc::tool
