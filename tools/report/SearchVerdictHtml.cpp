// The verdict of a search in sentences of the page.
#include "report/BuildCommand.h"
#include "report/FormatLook.h"
#include "report/Html.h"
#include "report/ModelParts.h"

#include <algorithm>
#include <set>

namespace voxc::report {
namespace {

constexpr std::size_t kMostAsFast = 3;

std::string rivalWords(const std::vector<std::string> &names) {
  std::string text;
  for (std::size_t i = 0; i < names.size() && i < kMostAsFast; ++i)
    text += (i == 0 ? "" : ", ") + textTag("span", {{"class", "name"}}, names[i]);
  if (names.size() > kMostAsFast)
    text += " and " + countText(static_cast<double>(names.size() - kMostAsFast)) + " more";
  return text.empty() ? "" : " As fast, within the spread: " + text + ".";
}

std::string answerWords(const Finalist &finalist, const SearchAnswer &answer) {
  const Cell &cell = *finalist.cells.front();
  std::string text = legendMark(lookOf(cell.format.name).family) + textTag("b", {}, finalist.name) + ", " +
                     finalist.sizeText + " at " + finalist.speedText;
  if (finalist.cells.size() > 1)
    text += " (" + escaped(finalist.setSpeedsText) + ")";
  return tag("p", {}, text + "." + rivalWords(answer.asFast));
}

std::string capitalised(std::string text) {
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text;
}

} // namespace

std::string searchVerdictHtml(const SearchVerdict &verdict) {
  if (verdict.frontier.empty())
    return {};
  std::set<std::size_t> told; // Their commands.
  std::string rows;
  for (const SearchAnswer &answer : verdict.answers) {
    const Finalist &finalist = verdict.frontier[answer.finalist];
    std::string words = answerWords(finalist, answer);
    if (told.insert(answer.finalist).second)
      words += textTag("code", {}, buildCommand(*finalist.cells.front()));
    rows += tag("div", {}, textTag("dt", {}, capitalised(answer.question)) + tag("dd", {}, words)) + "\n";
  }
  const Cell &cell = *verdict.frontier.front().cells.front();
  const std::string sentence = "Of " + plural(verdict.formats, "format") + " that a search measured on " +
                               cell.device.name + ". M/s are million rays a second of the " +
                               (cell.device.clock == "gpu" ? "device's own clock" : "processor's time") +
                               ", of the mean time of all sets of rays; the charts show each set by itself.";
  return tag("dl", {{"class", "verdict"}}, rows) + textTag("p", {{"class", "hint"}}, sentence);
}

} // namespace voxc::report
