// Loops whose turns are known become their turns.
#include "Glsl/Passes.h"
#include "Glsl/Visit.h"

#include <charconv>
#include <optional>
#include <utility>

namespace voxc::glsl {
namespace {

using Kind = Expression::Kind;
using Statements = std::vector<Statement>;

class Unroller {
public:
  explicit Unroller(const Constants &constants) : constants_(constants) {}

  Statements unrolled(Statements statements) const {
    Statements result;
    for (Statement &statement : statements) {
      for (Statements *const inner : {&statement.body, &statement.otherwise})
        *inner = unrolled(std::move(*inner));
      if (statement.qualifiers == "unroll")
        addTurns(statement, result);
      else
        result.push_back(std::move(statement));
    }
    return result;
  }

private:
  std::optional<int> numberOf(Expression expression) const {
    fold(expression, constants_);
    int value = 0;
    const std::string &text = expression.text;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool isNumber =
        expression.kind == Kind::Literal && problem == std::errc() && end == text.data() + text.size();
    return isNumber ? std::optional(value) : std::nullopt;
  }

  /// A loop that counts otherwise stays as it is, with its mark, which the verifier refuses.
  void addTurns(Statement &loop, Statements &to) const {
    const Variable &counter = loop.begin[0].variables[0];
    const Expression &condition = loop.expressions[0];
    const std::optional<int> first = numberOf(counter.initial[0]), bound = numberOf(condition.operands[1]);
    const bool isUp = condition.text == "<";
    if (!first || !bound || !(isUp || condition.text == ">="))
      return to.push_back(std::move(loop));
    bool isFirst = true;
    for (int i = *first; isUp ? i < *bound : i >= *bound; i += isUp ? 1 : -1)
      for (Statement turn : loop.body) {
        put(turn, counter.name, i);
        if (std::exchange(isFirst, false))
          turn.notes.above.insert(turn.notes.above.begin(), loop.notes.above.begin(), loop.notes.above.end());
        to.push_back(std::move(turn));
      }
  }

  static void put(Statement &turn, const std::string &counter, int number) {
    const Constants constants = {{counter, std::to_string(number)}};
    forEachStatement(turn, [&](Statement &inner) {
      for (auto *const some : {&inner.expressions, &inner.step})
        for (Expression &one : *some)
          fold(one, constants);
      for (Variable &variable : inner.variables)
        for (Expression &one : variable.initial)
          fold(one, constants);
    });
  }

  const Constants &constants_;
};

} // namespace

void unroll(Module &module, const Constants &constants) {
  const Unroller unroller(constants);
  for (Declaration &declaration : module.declarations)
    declaration.body = unroller.unrolled(std::move(declaration.body));
}

} // namespace voxc::glsl
