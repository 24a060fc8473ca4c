// Writing cells as comma-separated values.
#include "report/Csv.h"

#include "report/BuildCommand.h"

#include <algorithm>
#include <cstdio>

namespace voxc::report {
namespace {

using Text = std::string;

/// The shortest text that reads back as the same number.
Text number(double value) {
  char text[32];
  for (const int digits : {15, 16, 17}) {
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    if (std::strtod(text, nullptr) == value)
      break;
  }
  return text;
}

Text text(const std::string &value) { return value; }
Text text(const Figure &value) { return value ? number(*value) : ""; }
Text text(const tool::bench::Count &value) { return value ? std::to_string(*value) : ""; }

/// A figure of the speed that counts, or none.
Text speed(const Entry &entry, double tool::bench::Speed::*figure) {
  return entry.speed ? number((*entry.speed).*figure) : "";
}

Text yesOrNo(bool value) { return value ? "yes" : "no"; }

Text standing(const Entry &entry) {
  return !entry.hasPoint() ? "" : entry.isLeading() ? "on" : entry.isAsGood() ? "as good" : "off";
}

/// The questions that the format answers in the verdict of its search: "smallest balanced".
Text answered(const Catalogue &catalogue, const Entry &entry) {
  Text questions;
  for (const SearchVerdict &verdict : catalogue.verdicts)
    for (const SearchAnswer &answer : verdict.answers)
      if (std::ranges::count(verdict.frontier[answer.finalist].cells, entry.cell) > 0)
        questions += (questions.empty() ? "" : "; ") + answer.question;
  return questions;
}

template <typename Member> Text ofPrediction(const Entry &entry, Member tool::bench::PredictedPart::*figure) {
  return entry.cell->predicted ? text((*entry.cell->predicted).*figure) : "";
}

Text levelWords(const Entry &entry) {
  Text words;
  if (entry.cell->volume.levelWords)
    for (const std::uint64_t count : *entry.cell->volume.levelWords)
      words += (words.empty() ? "" : " ") + std::to_string(count);
  return words;
}

struct Column {
  const char *heading;
  Text (*text)(const Entry &);
};

constexpr Column kColumns[] = {
    {"model", [](const Entry &e) { return text(e.cell->model.name); }},
    {"input", [](const Entry &e) { return text(e.cell->model.input); }},
    {"resolution", [](const Entry &e) { return text(e.cell->resolution); }},
    {"rays", [](const Entry &e) { return text(e.cell->rays.name); }},
    {"ray_count", [](const Entry &e) { return std::to_string(e.cell->rays.count); }},
    {"asked_order", [](const Entry &e) { return e.cell->rays.order.value_or("auto"); }},
    {"order", [](const Entry &e) { return e.cell->speed.order.value_or(""); }},
    {"device", [](const Entry &e) { return text(e.device); }},
    {"clock", [](const Entry &e) { return text(e.cell->device.clock); }},
    {"precision", [](const Entry &e) { return text(e.cell->precision); }},
    {"format", [](const Entry &e) { return text(e.cell->format.name); }},
    {"passes", [](const Entry &e) { return passList(e.cell->format.passes); }},
    {"label", [](const Entry &e) { return text(e.cell->format.label); }},
    {"status", [](const Entry &e) { return Text(e.cell->isMeasured() ? "measured" : "failed"); }},
    {"frontier", standing},
    {"bytes", [](const Entry &e) { return text(e.cell->volume.bytes); }},
    {"bytes_per_voxel", [](const Entry &e) { return text(e.cell->volume.bytesPerVoxel); }},
    {"level_words", levelWords},
    {"mrays_per_s", [](const Entry &e) { return speed(e, &tool::bench::Speed::median); }},
    {"slowest_mrays_per_s", [](const Entry &e) { return speed(e, &tool::bench::Speed::min); }},
    {"fastest_mrays_per_s", [](const Entry &e) { return speed(e, &tool::bench::Speed::max); }},
    {"rounds", [](const Entry &e) { return text(e.cell->speed.rounds); }},
    {"steady", [](const Entry &e) { return e.speed ? yesOrNo(e.isSteady) : Text(); }},
    {"lookups_per_ray", [](const Entry &e) { return text(e.cell->work.stepsPerRay); }},
    {"words_per_ray", [](const Entry &e) { return text(e.cell->work.wordsPerRay); }},
    {"checked_rays", [](const Entry &e) { return text(e.cell->error.rays); }},
    {"missed", [](const Entry &e) { return text(e.cell->error.missed); }},
    {"ghost", [](const Entry &e) { return text(e.cell->error.ghost); }},
    {"wrong", [](const Entry &e) { return text(e.cell->error.wrong); }},
    {"build_seconds", [](const Entry &e) { return text(e.cell->build.buildSeconds); }},
    {"build_cpu_seconds", [](const Entry &e) { return text(e.cell->build.buildCpuSeconds); }},
    {"peak_rss_bytes", [](const Entry &e) { return text(e.cell->build.peakRssBytes); }},
    {"predicted_words", [](const Entry &e) { return ofPrediction(e, &tool::bench::PredictedPart::words); }},
    {"predicted_mrays_per_s",
     [](const Entry &e) { return ofPrediction(e, &tool::bench::PredictedPart::mraysPerS); }},
    {"failure", [](const Entry &e) { return e.cell->failure ? e.cell->failure->reason : Text(); }},
    {"build", [](const Entry &e) { return buildCommand(*e.cell); }},
};

/// A field, in quotes where it has what would end it.
Text field(const Text &value) {
  if (value.find_first_of(",\"\r\n") == Text::npos)
    return value;
  Text quoted = "\"";
  for (const char c : value)
    quoted += c == '"' ? Text("\"\"") : Text(1, c);
  return quoted + "\"";
}

/// The last column is of the whole catalogue.
template <typename FieldOf> Text line(FieldOf fieldOf, const Text &last) {
  Text text;
  for (const Column &column : kColumns)
    text += field(fieldOf(column)) + ",";
  return text + field(last) + "\r\n";
}

} // namespace

std::string toCsv(const Catalogue &catalogue) {
  std::string csv = line([](const Column &column) { return Text(column.heading); }, "verdict");
  for (const Entry &entry : catalogue.entries)
    csv += line([&](const Column &column) { return column.text(entry); }, answered(catalogue, entry));
  return csv;
}

} // namespace voxc::report
