// Setting the attribute of a choice, where it is taken and fits.
#include "voxc/Passes/Pass.h"

#include <algorithm>

namespace voxc {
namespace {

bool isInScope(ChoiceScope scope, const Format &format, std::size_t index) {
  const Level &level = format.levels[index];
  switch (scope) {
  case ChoiceScope::Format:
    return false;
  case ChoiceScope::Levels:
    return true;
  case ChoiceScope::LowerLevels:
    return index > 0;
  case ChoiceScope::LastLevel:
    return index + 1 == format.levels.size();
  case ChoiceScope::Trees:
    return level.kind->isTree() && level.log2Size() != Int3{}; // Of one cell there is nothing to traverse.
  }
  return false;
}

constexpr std::string_view notTakenBy(ChoiceScope scope) {
  switch (scope) {
  case ChoiceScope::LowerLevels:
    return "no level below the first takes ";
  case ChoiceScope::LastLevel:
    return "the last level does not take ";
  case ChoiceScope::Trees:
    return "no tree of more than one cell takes ";
  default:
    return "no level takes ";
  }
}

/// A value that was set before, and is another one.
std::string excludedBy(std::string_view what, const AttributeKind &kind, std::string_view before,
                       std::string_view value) {
  return std::string(what) + " has " + std::string(kind.name) + "=" + std::string(before) + " already, and " +
         std::string(kind.name) + "=" + std::string(value) + " excludes it; give one of the two passes";
}

/// What levels have chosen that the format's choices exclude.
void verifyExcluded(const Format &format, Diagnostics &diagnostics) {
  for (const Level &level : format.levels)
    for (const AttributeKind *kind : level.kind->attributes)
      for (const AttributeValue &excluded : kind->excludes)
        if (const std::string_view value = level.attribute(*kind);
            value != kind->values.front() && format.attributes.value(*excluded.kind) == excluded.value)
          diagnostics.error(level.range,
                            "this level has " + std::string(kind->name) + "=" + std::string(value) +
                                ", which " + std::string(excluded.kind->name) + "=" +
                                std::string(excluded.value) + " excludes; give one of the two passes");
}

class Chooser {
public:
  Chooser(const Format &format, const AttributeChoice &choice, std::string_view value)
      : chosen(format), choice_(choice), value_(value) {}

  /// Errors are what the format cannot have, and what was chosen before.
  void choose(Diagnostics &problems) {
    if (choice_.scope == ChoiceScope::Format)
      chooseOnFormat(problems);
    for (std::size_t i = 0; i < chosen.levels.size(); ++i)
      if (isInScope(choice_.scope, chosen, i))
        chooseOn(chosen.levels[i], problems);
    if (choice_.implied)
      chosen.setAttribute(*choice_.implied, choice_.implied->values[1]);
  }

  Format chosen;
  bool isTaken = false; ///< By the format, or a level.

private:
  bool isAnother(std::string_view before) const {
    return before != value_ && before != choice_.kind->values.front();
  }

  void chooseOnFormat(Diagnostics &problems) {
    isTaken = true;
    if (const std::string_view before = chosen.attributes.value(*choice_.kind); isAnother(before))
      problems.error({}, excludedBy("the format", *choice_.kind, before, value_));
    chosen.setAttribute(*choice_.kind, value_);
  }

  void chooseOn(Level &level, Diagnostics &problems) {
    if (std::ranges::find(level.kind->attributes, choice_.kind) == level.kind->attributes.end())
      return;
    isTaken = true;
    if (const std::string_view before = level.attribute(*choice_.kind); isAnother(before))
      problems.error(level.range, excludedBy(choice_.scope == ChoiceScope::Trees ? "this tree" : "this level",
                                             *choice_.kind, before, value_));
    level.setAttribute(*choice_.kind, value_);
  }

  const AttributeChoice &choice_;
  std::string_view value_;
};

PassResult leave(Diagnostics &diagnostics, std::string why) {
  diagnostics.note({}, std::move(why));
  return PassResult::Unchanged;
}

PassResult choose(Format &format, const AttributeChoice &choice, std::string_view value,
                  Diagnostics &diagnostics) {
  Chooser chooser(format, choice, value);
  Diagnostics before, unfit;
  chooser.choose(before);
  const std::string name = std::string(choice.kind->name) + "=" + std::string(value);
  if (!chooser.isTaken)
    return leave(diagnostics, std::string(notTakenBy(choice.scope)) + name);
  for (const Diagnostic &problem : before.all())
    diagnostics.error(problem.range, problem.message);
  if (diagnostics.hasErrors())
    return PassResult::Unchanged;
  if (chooser.chosen == format)
    return leave(diagnostics, name + " is there already");
  verify(chooser.chosen, unfit);
  verifyExcluded(chooser.chosen, unfit);
  if (unfit.hasErrors() && choice.unfit == Unfit::LeftOut)
    return leave(diagnostics, unfit.all().front().message);
  for (const Diagnostic &problem : unfit.all())
    diagnostics.error(problem.range, problem.message);
  if (unfit.hasErrors())
    return PassResult::Unchanged;
  format = std::move(chooser.chosen);
  return PassResult::Changed;
}

} // namespace

std::string AttributeChoice::valueWith(int number) const {
  std::string text(value);
  if (const std::size_t at = text.find('#'); at != std::string::npos)
    text.replace(at, 1, std::to_string(number));
  return text;
}

PassResult Pass::run(Format &format, Diagnostics &diagnostics, std::optional<int> with) const {
  if (function)
    return function(format, diagnostics);
  return choose(format, choice, choice.valueWith(with.value_or(number ? number->byDefault : 0)), diagnostics);
}

} // namespace voxc
