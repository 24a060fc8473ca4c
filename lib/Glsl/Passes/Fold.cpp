// Constants get their values, and what follows from these is gone through.
#include "Glsl/Passes.h"
#include "Glsl/Types.h"
#include "Glsl/Visit.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

namespace voxc::glsl {
namespace {

using Kind = Expression::Kind;
using Statements = std::vector<Statement>;

bool isLiteral(const Expression &expression, std::string_view text) {
  return expression.kind == Kind::Literal && expression.text == text;
}
bool isTrue(const Expression &expression) { return isLiteral(expression, "true"); }
bool isFalse(const Expression &expression) { return isLiteral(expression, "false"); }
Expression truth(bool value) { return {Kind::Literal, value ? "true" : "false", {}, false, "bool"}; }

/// A whole number in decimal digits, and "u" if it is one without a sign.
struct Integer {
  long long value;
  bool isUnsigned;
};

std::optional<Integer> integerOf(const Expression &expression) {
  const std::string_view text = expression.text;
  const bool isUnsigned = text.ends_with('u');
  const std::string_view digits = text.substr(0, text.size() - isUnsigned);
  long long value = 0;
  const auto [end, problem] = std::from_chars(digits.begin(), digits.end(), value);
  if (expression.kind != Kind::Literal || problem != std::errc() || end != digits.end())
    return std::nullopt;
  return Integer{value, isUnsigned};
}

Expression number(Integer integer) {
  return {Kind::Literal,
          std::to_string(integer.value) + (integer.isUnsigned ? "u" : ""),
          {},
          false,
          integer.isUnsigned ? "uint" : "int"};
}

class Folder {
public:
  Folder(const Constants &constants, Names effects) : constants_(constants), effects_(std::move(effects)) {}

  void fold(Declaration &declaration) {
    for (Variable &variable : declaration.variables)
      fold(variable);
    declaration.body = folded(std::move(declaration.body));
    if (!declaration.body.empty() && declaration.type == "void" &&
        declaration.body.back().kind == Statement::Kind::Return)
      declaration.body.pop_back();
  }

  /// Whether something became known: what is written as numbers alone stays as it is written.
  bool fold(Expression &expression) {
    bool changed = false;
    for (Expression &operand : expression.operands)
      changed |= fold(operand);
    if (isConversionToItself(expression))
      take(expression, 0);
    if (expression.kind == Kind::Name)
      if (const auto constant = constants_.find(expression.text); constant != constants_.end()) {
        expression = {Kind::Literal, constant->second, {}, false, expression.type};
        return true;
      }
    if (expression.kind == Kind::Conditional && choosesNothing(expression))
      take(expression, 2);
    return changed && simplify(expression);
  }

private:
  void fold(Variable &variable) {
    for (auto *const some : {&variable.sizes, &variable.initial})
      for (Expression &one : *some)
        fold(one);
  }

  Statements folded(Statements statements) {
    Statements result;
    for (Statement &statement : statements) {
      fold(statement);
      if (statement.kind == Statement::Kind::If && isConstant(statement.expressions[0]))
        splice(std::move(statement), result);
      else if (!isNothing(statement))
        result.push_back(std::move(statement));
      if (!result.empty() && result.back().kind == Statement::Kind::Return) {
        returnAtOnce(result);
        break; // Nothing comes to what follows.
      }
    }
    return result;
  }

  /// T a = b; return a; becomes return b;
  static void returnAtOnce(Statements &statements) {
    if (statements.size() < 2)
      return;
    Statement &declaration = statements[statements.size() - 2], &last = statements.back();
    const bool isAlone = declaration.kind == Statement::Kind::Declaration && declaration.qualifiers.empty() &&
                         declaration.variables.size() == 1 && declaration.variables[0].initial.size() == 1 &&
                         !last.expressions.empty() &&
                         last.expressions[0].is(Kind::Name, declaration.variables[0].name);
    if (!isAlone)
      return;
    last.expressions[0] = std::move(declaration.variables[0].initial[0]);
    last.notes = std::move(declaration.notes);
    statements.erase(statements.end() - 2);
  }

  static bool isConstant(const Expression &expression) { return isTrue(expression) || isFalse(expression); }

  bool isNothing(const Statement &statement) const {
    const bool isEmpty =
        statement.kind == Statement::Kind::If && statement.body.empty() && statement.otherwise.empty();
    return (isEmpty && !hasEffects(statement.expressions[0])) ||
           (statement.kind == Statement::Kind::While && isFalse(statement.expressions[0])) ||
           (statement.kind == Statement::Kind::Block && statement.body.empty());
  }

  /// What an if of which the condition is known comes to, in its place.
  static void splice(Statement statement, Statements &to) {
    Statements &taken = isTrue(statement.expressions[0]) ? statement.body : statement.otherwise;
    if (!taken.empty() && !statement.notes.above.empty()) {
      std::vector<std::string> &above = taken.front().notes.above;
      above.insert(above.begin(), statement.notes.above.begin(), statement.notes.above.end());
    }
    std::ranges::move(taken, std::back_inserter(to));
  }

  void fold(Statement &statement) {
    for (auto *const some : {&statement.expressions, &statement.step})
      for (Expression &one : *some)
        fold(one);
    for (Variable &variable : statement.variables)
      fold(variable);
    statement.begin = folded(std::move(statement.begin));
    const std::size_t before = statement.body.size();
    statement.body = folded(std::move(statement.body));
    statement.otherwise = folded(std::move(statement.otherwise));
    statement.isBraced |= statement.body.size() > 1;
    statement.isBraced &= statement.body.size() == before || !isSimple(statement);
    statement.isElseBraced |= statement.otherwise.size() > 1;
    if (statement.kind == Statement::Kind::If && statement.body.empty() && !statement.otherwise.empty())
      turn(statement);
    if (statement.kind == Statement::Kind::While && statement.body.empty())
      statement.isBraced = true;
  }

  /// One simple statement that is left of several needs no braces.
  static bool isSimple(const Statement &branch) {
    const bool isShort = branch.body.size() == 1 && branch.body[0].notes.above.empty() &&
                         (branch.body[0].kind == Statement::Kind::Return ||
                          branch.body[0].kind == Statement::Kind::Expression);
    return isShort && branch.kind == Statement::Kind::If && branch.otherwise.empty();
  }

  /// if (a) {} else b becomes if (!a) b.
  static void turn(Statement &statement) {
    statement.body = std::exchange(statement.otherwise, {});
    statement.isBraced = std::exchange(statement.isElseBraced, false);
    Expression &condition = statement.expressions[0];
    const bool isSimple =
        condition.kind == Kind::Name || condition.kind == Kind::Call || condition.kind == Kind::Member;
    condition.isGrouped |= !isSimple;
    condition = {Kind::Prefix, "!", {std::move(condition)}, false, "bool"};
  }

  bool hasEffects(const Expression &expression) const {
    bool has = false;
    forEachExpression(expression, [&](const Expression &inner) {
      has |= inner.kind == Kind::Assignment || inner.kind == Kind::Postfix || inner.text == "++" ||
             inner.text == "--" || (inner.kind == Kind::Call && effects_.contains(inner.text));
    });
    return has;
  }

  /// True, since operands have changed.
  bool simplify(Expression &expression) {
    std::vector<Expression> &operands = expression.operands;
    if (expression.is(Kind::Prefix, "!") && isConstant(operands[0]))
      expression = truth(isFalse(operands[0]));
    else if (expression.is(Kind::Prefix, "!") && operands[0].is(Kind::Binary, "==")) {
      operands[0].text = "!=";
      take(expression, 0);
    } else if (expression.kind == Kind::Conditional && isConstant(operands[0]))
      take(expression, isTrue(operands[0]) ? 1 : 2);
    else if (expression.kind == Kind::Binary && (expression.text == "&&" || expression.text == "||"))
      simplifyLogic(expression, expression.text == "&&");
    else if (expression.kind == Kind::Binary)
      simplifyNumbers(expression);
    return true;
  }

  /// a == 0 ? 0 : a is a.
  static bool choosesNothing(const Expression &choice) {
    const Expression &condition = choice.operands[0], &value = choice.operands[2];
    return condition.is(Kind::Binary, "==") && condition.operands[1].kind == Kind::Literal &&
           isLiteral(choice.operands[1], condition.operands[1].text) && value.kind == Kind::Name &&
           condition.operands[0].is(Kind::Name, value.text);
  }

  /// float(a) of what is a float is a.
  static bool isConversionToItself(const Expression &expression) {
    return expression.kind == Kind::Call && expression.operands.size() == 1 &&
           shapeOf(expression.text).isNumeric() && expression.operands[0].type == expression.text;
  }

  /// An expression becomes one of its operands.
  static void take(Expression &expression, std::size_t index) {
    Expression operand = std::move(expression.operands[index]);
    operand.isGrouped = false; // The printer puts parentheses where they are needed.
    expression = std::move(operand);
  }

  /// `neutral`: what && and || take without a change: true, and false.
  void simplifyLogic(Expression &expression, bool neutral) {
    std::vector<Expression> &operands = expression.operands;
    const auto is = [](const Expression &operand, bool value) {
      return value ? isTrue(operand) : isFalse(operand);
    };
    if (is(operands[1], neutral) || is(operands[0], !neutral))
      take(expression, 0);
    else if (is(operands[0], neutral) || (is(operands[1], !neutral) && !hasEffects(operands[0])))
      take(expression, 1);
  }

  void simplifyNumbers(Expression &expression) {
    std::vector<Expression> &operands = expression.operands;
    const std::string &sign = expression.text;
    if ((sign == "==" || sign == "!=") && isConstant(operands[0]) && isConstant(operands[1])) {
      expression = truth((operands[0].text == operands[1].text) == (sign == "=="));
      return;
    }
    const std::optional<Integer> left = integerOf(operands[0]), right = integerOf(operands[1]);
    if (left && right)
      return combine(expression, *left, *right);
    const bool isSum = sign == "+" || sign == "-" || sign == "<<" || sign == ">>" || sign == "|";
    const bool isProduct = sign == "*" || sign == "/";
    if (right && ((isSum && right->value == 0) || (isProduct && right->value == 1)))
      return take(expression, 0);
    if (left && (((sign == "+" || sign == "|") && left->value == 0) || (sign == "*" && left->value == 1)))
      return take(expression, 1);
    if (left && sign == "*" && left->value == 0 && !hasEffects(operands[1]))
      return take(expression, 0);
    if (right && (sign == "+" || sign == "-"))
      joinSums(expression, sign == "+" ? right->value : -right->value);
  }

  /// x + a + b, of which a is a number as well.
  static void joinSums(Expression &expression, long long more) {
    Expression &left = expression.operands[0];
    const std::optional<Integer> inner =
        left.is(Kind::Binary, "+") && !left.isGrouped ? integerOf(left.operands[1]) : std::nullopt;
    if (!inner || inner->value + more < 0)
      return;
    left.operands[1] = number({inner->value + more, inner->isUnsigned});
    take(expression, 0);
    if (inner->value + more == 0)
      take(expression, 0);
  }

  static void combine(Expression &expression, Integer left, Integer right) {
    const long long a = left.value, b = right.value;
    const std::string sign = expression.text;
    if (sign == "==" || sign == "!=")
      expression = truth((a == b) == (sign == "=="));
    else if (sign == "<" || sign == ">")
      expression = truth(sign == "<" ? a < b : a > b);
    else if (sign == "<=" || sign == ">=")
      expression = truth(sign == "<=" ? a <= b : a >= b);
    else if (sign == "+" || sign == "-" || sign == "*")
      replace(expression, {sign == "+" ? a + b : sign == "-" ? a - b : a * b, left.isUnsigned});
    else if ((sign == "<<" || sign == ">>") && b >= 0 && b < 32)
      replace(expression, {sign == "<<" ? a << b : a >> b, left.isUnsigned});
  }

  /// Unless it is none of GLSL's.
  static void replace(Expression &expression, Integer integer) {
    if (integer.value >= 0 && integer.value <= (integer.isUnsigned ? 0xffffffffLL : 0x7fffffffLL))
      expression = number(integer);
  }

  const Constants &constants_;
  const Names effects_;
};

} // namespace

void fold(Expression &expression, const Constants &constants) { Folder(constants, {}).fold(expression); }

void fold(Module &module, const Constants &constants) {
  Folder folder(constants, functionsWithEffects(module));
  for (Declaration &declaration : module.declarations)
    folder.fold(declaration);
}

} // namespace voxc::glsl
