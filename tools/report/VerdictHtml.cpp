// The verdict in sentences.
#include "report/BuildCommand.h"
#include "report/Html.h"
#include "report/ModelParts.h"
#include "report/Verdict.h"
#include "report/Words.h"

#include <algorithm>
#include <set>

namespace voxc::report {
namespace {

constexpr std::size_t kMostRivals = 3;

/// "1.12 Mrays/CPU s on llvmpipe (exact)", with a warning where the speed or the hits are not to be relied
/// on.
std::string speedOn(const Answer &answer, bool tellsPrecision) {
  const Entry &entry = *answer.entry;
  std::string text =
      numberText(entry.speed->median) + " " + speedUnit(entry.hasClock) + " on " + entry.device;
  if (tellsPrecision && !entry.cell->precision.empty())
    text += ", " + entry.cell->precision;
  if (!entry.isSteady)
    text += " (not steady)";
  if (entry.errors && entry.errors->sum() > 0)
    text += " (" + countText(entry.errors->sum()) + " of " + countText(entry.errors->rays) + " rays wrong)";
  return text;
}

/// What answers as well, of all devices together.
std::string asFastWords(const std::vector<const Answer *> &answers) {
  std::vector<const Entry *> rivals;
  std::set<std::size_t> known;
  for (const Answer *answer : answers)
    for (const Entry *rival : answer->asFast)
      if (known.insert(rival->variant).second)
        rivals.push_back(rival);
  return rivals.empty() ? "" : " As fast, within the spread: " + nameList(rivals, kMostRivals) + ".";
}

/// One format that answers, with what it does on each device that it answers for.
std::string answerHtml(const std::vector<const Answer *> &answers, bool tellsPrecision, bool tellsCommand) {
  const Entry &entry = *answers.front()->entry;
  std::string speeds;
  for (const Answer *answer : answers)
    speeds += (speeds.empty() ? "" : "; ") + speedOn(*answer, tellsPrecision);
  std::string text = tag("p", {},
                         legendMark(entry.look.family) + textTag("b", {}, entry.name) + ", " +
                             bytesText(*entry.bytes) + ": " + escaped(speeds) + "." + asFastWords(answers));
  if (tellsCommand)
    text += textTag("code", {}, buildCommand(*entry.cell));
  return text;
}

/// Answers by their format, in the order of the stages.
std::vector<std::vector<const Answer *>> grouped(const std::vector<Answer> &answers) {
  std::vector<std::vector<const Answer *>> groups;
  for (const Answer &answer : answers) {
    const auto isSame = [&](const auto &group) {
      return group.front()->entry->variant == answer.entry->variant;
    };
    auto group = std::ranges::find_if(groups, isSame);
    if (group == groups.end())
      group = groups.insert(groups.end(), {{}});
    group->push_back(&answer);
  }
  return groups;
}

} // namespace

std::string nameList(const std::vector<const Entry *> &entries, std::size_t most) {
  std::string text;
  for (std::size_t i = 0; i < entries.size() && i < most; ++i)
    text += (i == 0 ? "" : ", ") + textTag("span", {{"class", "name"}}, entries[i]->name);
  if (entries.size() > most)
    text += " and " + countText(double(entries.size() - most)) + " more";
  return text;
}

std::string verdictHtml(const Catalogue &catalogue, const std::vector<const Stage *> &stages) {
  std::set<std::string> precisions;
  for (const Stage *stage : stages)
    precisions.insert(stage->precision);
  std::set<std::size_t> told;
  std::string rows;
  for (const Question &question : verdict(catalogue, stages)) {
    std::string answers;
    for (const auto &group : grouped(question.answers))
      answers += answerHtml(group, precisions.size() > 1, told.insert(group.front()->entry->variant).second);
    rows += tag("div", {}, textTag("dt", {}, question.text) + tag("dd", {}, answers)) + "\n";
  }
  return rows.empty() ? "" : tag("dl", {{"class", "verdict"}}, rows);
}

} // namespace voxc::report
