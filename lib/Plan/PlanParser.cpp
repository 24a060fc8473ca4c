// Parsing of plan text (docs/ir.md):   plan "R(4, 4, 4) G(8)" storage=0123456789abcdef payload=rgba8 {
// stratum 1: raw dense(4, 4, 4) cell=8 ... }
#include "PlanFields.h"

#include "IR/Lexer.h"
#include "voxc/Layout/SlotKind.h"

#include <algorithm>
#include <charconv>

namespace voxc {
namespace {

/// What every plan begins with.
constexpr std::string_view kPlanWord = "plan";

class PlanParser {
public:
  PlanParser(std::string_view text, Diagnostics &diagnostics) : lexer_(text), diagnostics_(diagnostics) {}

  Plan parse() {
    parseText();
    plan_.layout.complete();
    if (!diagnostics_.hasErrors())
      verify(plan_, diagnostics_, ranges_);
    return std::move(plan_);
  }

  Plan parseFinished() {
    Plan plan = parse();
    if (!diagnostics_.hasErrors())
      verifyFinished(plan, diagnostics_, ranges_);
    return plan;
  }

private:
  bool fail(const Token &found, const std::string &wanted) {
    diagnostics_.error(found.range, "found " + quoted(found) + " where " + wanted + " should be");
    return false;
  }
  bool expect(char punctuation) {
    return lexer_.accept(punctuation) || fail(lexer_.peek(), std::string("'") + punctuation + "'");
  }
  bool expectWord(std::string_view word) {
    const Token token = lexer_.next();
    return token.isWord(word) || fail(token, "'" + std::string(word) + "'");
  }

  bool parseText() {
    const std::size_t begin = lexer_.peek().range.begin;
    if (!expectWord(kPlanWord))
      return false;
    const Token format = lexer_.next();
    ranges_.plan = {begin, format.range.end};
    if (format.kind != TokenKind::String)
      return fail(format, "the format in quotation marks");
    plan_.layout.format = format.text.substr(1, format.text.size() - 2);
    if (!parseFields(plan_, planFields()) || !expect('{'))
      return false;
    while (!lexer_.peek().is('}'))
      if (!parseStratum())
        return false;
    lexer_.next();
    return lexer_.peek().kind == TokenKind::End || fail(lexer_.peek(), "the end");
  }

  bool parseStratum() {
    if (!expectWord("stratum"))
      return false;
    const Token number = lexer_.next();
    if (number.text != std::to_string(ranges_.strata.size() + 1))
      return fail(number, std::to_string(ranges_.strata.size() + 1) + ", the next stratum's number,");
    if (!expect(':'))
      return false;
    const Token level = lexer_.next();
    if (level.kind != TokenKind::Word)
      return fail(level, "the kind of level that the stratum comes from");
    PlannedStratum stratum;
    stratum.level = level.text;
    const Token slots = lexer_.next();
    stratum.slots = findSlotKind(slots.text);
    if (!stratum.slots)
      return fail(slots, "a kind of slots: " + slotNames());
    stratum.encoding = defaultEncoding(*stratum.slots);
    stratum.sharing = stratum.slots->sharing;
    if (!parseShape(stratum.log2Shape) || !parseFields(stratum, stratumFields()))
      return false;
    ranges_.strata.push_back({level.range.begin, slots.range.end});
    plan_.layout.strata.push_back(stratum);
    plan_.traversals.push_back(stratum);
    plan_.constructions.push_back(stratum);
    return true;
  }

  bool parseShape(Int3 &shape) {
    for (int axis = 0; axis < 3; ++axis) {
      if (!expect(axis == 0 ? '(' : ','))
        return false;
      const Token number = lexer_.next();
      const char *end = number.text.data() + number.text.size();
      const auto [stop, problem] = std::from_chars(number.text.data(), end, shape[axis]);
      if (problem != std::errc() || stop != end)
        return fail(number, "log2 of the children along an axis");
    }
    return expect(')');
  }

  /// Attributes up to what is none.
  template <typename Owner> bool parseFields(Owner &owner, std::span<const Field<Owner>> fields) {
    while (lexer_.peek().kind == TokenKind::Word && !lexer_.peek().isWord("stratum")) {
      const Token name = lexer_.next();
      const auto field = std::ranges::find(fields, name.text, &Field<Owner>::name);
      if (field == fields.end() || !field->isOf(owner))
        return fail(name, "one of " + fieldNames(owner, fields));
      if (!expect('='))
        return false;
      const Token value = lexer_.nextValue();
      if (!field->parse(owner, value.text))
        return fail(value,
                    "a value of " + std::string(field->name) + " (" + std::string(field->values) + ")");
    }
    return true;
  }

  template <typename Owner>
  static std::string fieldNames(const Owner &owner, std::span<const Field<Owner>> fields) {
    std::string names;
    for (const Field<Owner> &field : fields)
      if (field.isOf(owner))
        names += (names.empty() ? "" : ", ") + std::string(field.name);
    return names;
  }

  static std::string slotNames() {
    std::string names;
    for (const SlotKind *kind : slotKinds())
      names += (names.empty() ? "" : ", ") + std::string(kind->name);
    return names;
  }

  Lexer lexer_;
  Diagnostics &diagnostics_;
  Plan plan_;
  PlanRanges ranges_;
};

} // namespace

bool isPlanText(std::string_view text) {
  const Token first = Lexer(text).peek();
  return first.isWord(kPlanWord);
}

Plan parsePlan(std::string_view text, Diagnostics &diagnostics) {
  return PlanParser(text, diagnostics).parse();
}

Expected<Plan> parseFinishedPlan(std::string_view text, std::string_view name) {
  Diagnostics diagnostics;
  Plan plan = PlanParser(text, diagnostics).parseFinished();
  if (diagnostics.hasErrors())
    return toError(diagnostics, text, name);
  return plan;
}

} // namespace voxc
