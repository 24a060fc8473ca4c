// Answering questions from the leaders of each stage.
#include "report/Verdict.h"

#include "report/Html.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace voxc::report {
namespace {

constexpr std::size_t kMostBudgets = 3;
constexpr double kNoBudget = std::numeric_limits<double>::infinity();

/// A stage with its leaders, from small and slow to large and fast.
struct Contest {
  const Stage *stage;
  std::vector<const Entry *> leaders;

  const Entry *fastestOf(double budget) const {
    const Entry *best = leaders.front();
    for (const Entry *leader : leaders)
      if (*leader->bytes <= budget)
        best = leader;
    return best;
  }
};

std::vector<Contest> contests(const Catalogue &catalogue, const std::vector<const Stage *> &stages) {
  std::vector<Contest> contests;
  for (const Stage *stage : stages) {
    Contest contest{stage, {}};
    for (const std::size_t i : stage->entries)
      if (catalogue.entries[i].isLeading())
        contest.leaders.push_back(&catalogue.entries[i]);
    std::ranges::sort(contest.leaders, {}, [](const Entry *entry) { return *entry->bytes; });
    if (!contest.leaders.empty())
      contests.push_back(std::move(contest));
  }
  return contests;
}

/// Those within the budget that no speed tells from the answer.
std::vector<const Entry *> asFastAs(const Catalogue &catalogue, const Stage &stage, const Entry &answer,
                                    double budget) {
  std::vector<const Entry *> others;
  for (const std::size_t i : stage.entries)
    if (const Entry &entry = catalogue.entries[i]; &entry != &answer && entry.hasPoint() &&
                                                   *entry.bytes <= budget &&
                                                   areEqual(*entry.speed, *answer.speed))
      others.push_back(&entry);
  std::ranges::stable_sort(others, std::greater(), [](const Entry *entry) { return entry->speed->median; });
  return others;
}

using Answers = std::vector<const Entry *>;

Answers fastestOf(const std::vector<Contest> &contests, double budget) {
  Answers answers;
  for (const Contest &contest : contests)
    answers.push_back(contest.fastestOf(budget));
  return answers;
}

/// Powers of two between the smallest and the largest leader whose answers differ from those before and from
/// the fastest; of many those at the ends and in the middle.
std::vector<double> budgets(const std::vector<Contest> &contests) {
  double least = kNoBudget, most = 0;
  for (const Contest &contest : contests) {
    least = std::min(least, *contest.leaders.front()->bytes);
    most = std::max(most, *contest.leaders.back()->bytes);
  }
  const Answers fastest = fastestOf(contests, kNoBudget);
  std::vector<double> telling;
  for (Answers before = fastestOf(contests, least); least < most; least *= 2) {
    const double budget = std::exp2(std::ceil(std::log2(least)));
    const Answers answers = fastestOf(contests, budget);
    if (answers != before && answers != fastest)
      telling.push_back(budget);
    before = answers;
  }
  if (telling.size() > kMostBudgets)
    telling = {telling.front(), telling[telling.size() / 2], telling.back()};
  return telling;
}

/// "16 MiB", for powers of two.
std::string budgetText(double bytes) {
  static constexpr const char *kUnits[] = {"B", "KiB", "MiB", "GiB", "TiB"};
  std::size_t unit = 0;
  for (; bytes >= 1024 && unit + 1 < std::size(kUnits); ++unit)
    bytes /= 1024;
  return countText(bytes) + " " + kUnits[unit];
}

/// Where a stage has for an answer what no measured difference tells from an answer already given, it gives
/// that: so that chance does not make several answers of one.
void settle(std::vector<Answer> &answers) {
  for (std::size_t i = 1; i < answers.size(); ++i) {
    Answer &answer = answers[i];
    const auto isGiven = [&](const Entry *entry) {
      return *entry->bytes <= *answer.entry->bytes * (1 + kHardlyLarger) &&
             std::any_of(answers.begin(), answers.begin() + static_cast<long>(i),
                         [&](const Answer &other) { return other.entry->variant == entry->variant; });
    };
    if (isGiven(answer.entry))
      continue;
    if (const auto same = std::ranges::find_if(answer.asFast, isGiven); same != answer.asFast.end())
      std::swap(answer.entry, *same);
  }
}

Question ask(const Catalogue &catalogue, const std::vector<Contest> &contests, std::string text,
             double budget, double asFastWithin) {
  Question question{std::move(text), {}};
  for (const Contest &contest : contests) {
    const Entry *answer = contest.fastestOf(budget);
    const double within = asFastWithin > 0 ? asFastWithin : *answer->bytes * (1 + kHardlyLarger);
    question.answers.push_back({contest.stage, answer, asFastAs(catalogue, *contest.stage, *answer, within)});
  }
  settle(question.answers);
  return question;
}

} // namespace

std::vector<Question> verdict(const Catalogue &catalogue, const std::vector<const Stage *> &stages) {
  const std::vector<Contest> all = contests(catalogue, stages);
  if (all.empty())
    return {};
  if (fastestOf(all, 0) == fastestOf(all, kNoBudget))
    return {ask(catalogue, all, "Smallest and fastest", kNoBudget, kNoBudget)};
  std::vector<Question> questions = {ask(catalogue, all, "Smallest", 0, 0)};
  for (const double budget : budgets(all))
    questions.push_back(ask(catalogue, all, "Best below " + budgetText(budget), budget, budget));
  questions.push_back(ask(catalogue, all, "Fastest", kNoBudget, kNoBudget));
  return questions;
}

} // namespace voxc::report
