// The frontiers of all models side by side: which formats are worth having everywhere.
#include "report/Html.h"
#include "report/Sections.h"
#include "report/Words.h"

#include <algorithm>
#include <map>
#include <set>

namespace voxc::report {
namespace {

/// Stages that differ in the model alone.
struct Round {
  std::vector<const Stage *> stages;
};

bool hasPoints(const Catalogue &catalogue, const Stage &stage) {
  return std::ranges::any_of(stage.entries, [&](std::size_t i) { return catalogue.entries[i].hasPoint(); });
}

std::vector<Round> makeRounds(const Catalogue &catalogue) {
  std::map<std::string, std::size_t> places;
  std::vector<Round> rounds;
  for (const Stage &stage : catalogue.stages) {
    if (!hasPoints(catalogue, stage))
      continue;
    const std::string key = sideText(stage.resolution) + "\n" + stage.device + "\n" + stage.precision;
    const auto [found, isNew] = places.try_emplace(key, rounds.size());
    if (isNew)
      rounds.emplace_back();
    rounds[found->second].stages.push_back(&stage);
  }
  std::erase_if(rounds, [](const Round &round) { return round.stages.size() < 2; });
  return rounds;
}

const Entry *entryOf(const Catalogue &catalogue, const Stage &stage, std::size_t variant) {
  for (const std::size_t i : stage.entries)
    if (catalogue.entries[i].variant == variant)
      return &catalogue.entries[i];
  return nullptr;
}

std::string dot(const Entry *entry) {
  if (!entry)
    return tag("td", {}, "");
  if (!entry->hasPoint())
    return textTag("td", {{"class", "failed"}, {"title", "failed"}}, "failed");
  if (entry->isLeading())
    return textTag("td", {{"class", "on"}, {"title", "on the frontier"}}, "●");
  return entry->isAsGood() ? textTag("td", {{"class", "good"}, {"title", "as good as the frontier"}}, "≈")
                           : textTag("td", {{"class", "off"}, {"title", "dominated"}}, "·");
}

/// "exact steps; whole-level-dedup, unless a name says otherwise".
std::string roundConditions(const Round &round) {
  const Stage &first = *round.stages.front();
  const bool hasOthers = std::ranges::any_of(round.stages, &Stage::hasOtherPasses);
  return (first.precision.empty() ? "" : first.precision + " steps; ") +
         (first.usualPasses.empty() ? "no passes" : passList(first.usualPasses)) +
         (hasOthers ? ", unless a name says otherwise" : "");
}

/// A format with its passes in one round.
struct Row {
  std::string name;
  std::string cells;
  std::size_t wins = 0;
  bool isEverywhere = false;
};

Row makeRow(const Catalogue &catalogue, const Round &round, std::size_t variant) {
  Row row;
  for (const Stage *stage : round.stages) {
    const Entry *entry = entryOf(catalogue, *stage, variant);
    row.cells += dot(entry);
    row.wins += entry && (entry->isLeading() || entry->isAsGood());
    if (entry)
      row.name = entry->name;
  }
  row.isEverywhere = row.wins == round.stages.size();
  return row;
}

/// Formats that win most first, others in their order.
std::vector<Row> makeRows(const Catalogue &catalogue, const Round &round) {
  std::set<std::size_t> variants;
  for (const Stage *stage : round.stages)
    for (const std::size_t i : stage->entries)
      variants.insert(catalogue.entries[i].variant);
  std::map<std::pair<std::size_t, std::size_t>, Row> rows;
  for (const std::size_t variant : variants) {
    Row row = makeRow(catalogue, round, variant);
    rows.emplace(std::pair(round.stages.size() - row.wins, variant), std::move(row));
  }
  std::vector<Row> order;
  order.reserve(rows.size());
  for (auto &[rank, row] : rows)
    order.push_back(std::move(row));
  return order;
}

/// The first of these names: a search has hundreds that are on no frontier.
std::string nameWords(const std::vector<std::string> &names) {
  constexpr std::size_t kMost = 30;
  std::string text;
  for (std::size_t i = 0; i < names.size() && i < kMost; ++i)
    text += (i == 0 ? "" : ", ") + names[i];
  return names.size() > kMost ? text + " and " + countText(double(names.size() - kMost)) + " more" : text;
}

std::string roundHtml(const Catalogue &catalogue, const Round &round) {
  std::string head = textTag("th", {{"scope", "col"}}, "Format"), body;
  std::vector<std::string> winners, losers;
  for (const Stage *stage : round.stages)
    head += textTag("th", {{"scope", "col"}}, stage->column);
  for (const Row &row : makeRows(catalogue, round)) {
    const char *style = row.isEverywhere ? "always" : "";
    if (row.wins > 0)
      body += tag("tr", {{"class", style}}, textTag("th", {{"scope", "row"}}, row.name) + row.cells) + "\n";
    if (row.isEverywhere)
      winners.push_back(row.name);
    if (row.wins == 0)
      losers.push_back(row.name);
  }
  const Stage &first = *round.stages.front();
  const std::string sentence = winners.empty()
                                   ? "No format is on the frontier of every model."
                                   : "On the frontier of every model: " + nameWords(winners) + ".";
  const std::string caption = textTag("b", {}, sideText(first.resolution) + " on " + first.device) + " " +
                              textTag("span", {}, roundConditions(round)) + textTag("p", {}, sentence);
  const std::string table =
      tag("table", {{"class", "dots"}}, tag("thead", {}, tag("tr", {}, head)) + tag("tbody", {}, body));
  return tag("figure", {{"class", "round"}},
             tag("figcaption", {}, caption) + tag("div", {{"class", "scroll"}}, table) +
                 (losers.empty()
                      ? ""
                      : textTag("p", {{"class", "remarks"}}, "On none: " + nameWords(losers) + ".")));
}

} // namespace

std::string frontierSection(const Catalogue &catalogue) {
  std::string content;
  for (const Round &round : makeRounds(catalogue))
    content += roundHtml(catalogue, round);
  return content.empty() ? "" : fill("section/frontier.html", {{"content", content}});
}

} // namespace voxc::report
