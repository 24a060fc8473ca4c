// What voxc suggest says.
#include "choosing/SuggestReport.h"

#include "choosing/BuildCommand.h"
#include "choosing/PredictionFigures.h"
#include "voxc/Measure/SavedWeights.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace voxc::tool {

namespace {

template <typename... Values> std::string print(const char *format, const Values &...values) {
  std::array<char, 512> text;
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

double mebibytes(std::uint64_t bytes) { return static_cast<double>(bytes) / (1 << 20); }

/// Millions of rays a second.
double speed(double nanoseconds) { return 1000 / nanoseconds; }

std::string speedsOf(const Suggestion &suggestion, const PredictedFormat &format) {
  std::string text;
  for (std::size_t i = 0; i < suggestion.rays.size(); ++i)
    text +=
        (i == 0 ? "" : ", ") + print("%.1f M/s %s", speed(format.nanoseconds[i]), suggestion.rays[i].c_str());
  return text;
}

/// What another format has more and less of.
std::string besides(const char *what, const PredictedFormat &other, const PredictedFormat &choice) {
  return print("  the %s, %s, would take %.2f times the bytes and have %.2f times the speed\n", what,
               nameOf(other.candidate).c_str(),
               static_cast<double>(other.bytes()) / static_cast<double>(choice.bytes()),
               choice.time() / other.time());
}

std::string table(const Suggestion &suggestion) {
  std::vector<const PredictedFormat *> frontier;
  const std::vector<bool> marks = frontierOf(suggestion.rated);
  for (std::size_t i = 0; i < marks.size(); ++i)
    if (marks[i])
      frontier.push_back(&suggestion.rated[i]);
  std::ranges::sort(frontier, {}, &PredictedFormat::bytes);
  std::string text = "\n         MiB  speed\n";
  for (const PredictedFormat *format : frontier)
    text += print("  %10.3f  %-40s ", mebibytes(format->bytes()), speedsOf(suggestion, *format).c_str()) +
            nameOf(format->candidate) + "\n";
  return text;
}

/// Of a format whose colours stand apart from its levels, or are one: ", of which 20 % are colours".
std::string shareOfColours(const Suggestion &suggestion, const PredictedFormat &format) {
  const Layout layout = layoutOf(format.candidate.format);
  if (!layout.ranksVoxels() && !layout.hasOneColour())
    return "";
  return print(", of which %.0f %% are colours",
               100 * static_cast<double>(4 * suggestion.valueWords) / static_cast<double>(format.bytes()));
}

/// How far off speeds may be, and how that is mended.
std::string trustIn(const Suggestion &suggestion) {
  if (suggestion.areSpeedsMeasured)
    return "speeds are predicted by what a search measured on this machine\n";
  return print("speeds are predicted from another machine's, and were up to %.1f times off\n  to measure on "
               "this machine: ",
               measure::kWorstUnmeasured) +
         searchCommand(suggestion.input, suggestion.arguments, suggestion.device) + "\n";
}

} // namespace

std::string suggestReport(const Suggestion &suggestion, bool all) {
  const PredictedFormat &choice = suggestion.rated[suggestion.choice];
  const auto fastest = std::ranges::min_element(suggestion.rated, {}, &PredictedFormat::time);
  const auto smallest = std::ranges::min_element(suggestion.rated, {}, &PredictedFormat::bytes);
  std::string text = nameOf(choice.candidate) + "\n";
  text += print("  %.3f MiB, %.2f bits a voxel%s; about %s on one core (%s)\n", mebibytes(choice.bytes()),
                8 * static_cast<double>(choice.bytes()) / static_cast<double>(suggestion.voxels),
                shareOfColours(suggestion, choice).c_str(), speedsOf(suggestion, choice).c_str(),
                suggestion.device.c_str());
  if (fastest->time() < choice.time())
    text += besides("fastest", *fastest, choice);
  if (smallest->bytes() < choice.bytes())
    text += besides("smallest", *smallest, choice);
  text += print("  of %zu formats, %s; ", suggestion.rated.size(),
                choice.price.exact ? "priced to the word" : "this one priced nearly to the word") +
          trustIn(suggestion);
  if (all)
    text += table(suggestion);
  return text + "\n" + buildCommand(suggestion.input, suggestion.arguments, choice.candidate) + "\n";
}

void addSuggestFigures(Json &figures, const Suggestion &suggestion) {
  figures["input"] = suggestion.input;
  figures["resolution"] = suggestion.arguments.resolution;
  figures["device"] = suggestion.device;
  figures["speeds_measured_here"] = suggestion.areSpeedsMeasured;
  figures["voxels"] = suggestion.voxels;
  figures["value_words"] = suggestion.valueWords;
  const std::vector<bool> frontier = frontierOf(suggestion.rated);
  Json formats = Json::array();
  for (std::size_t i = 0; i < suggestion.rated.size(); ++i) {
    Json entry = predictionFigures(suggestion.rated[i], suggestion.rays);
    entry["frontier"] = bool(frontier[i]);
    entry["chosen"] = i == suggestion.choice;
    formats.push_back(std::move(entry));
  }
  figures["formats"] = std::move(formats);
}

} // namespace voxc::tool
