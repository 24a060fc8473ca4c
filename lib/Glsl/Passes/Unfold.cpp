// Conditionals to statements.
#include "Glsl/Passes.h"
#include "Glsl/Visit.h"

#include "Glsl/Types.h"

#include <algorithm>
#include <utility>

namespace voxc::glsl {
namespace {

using Kind = Expression::Kind;
using Statements = std::vector<Statement>;

Statement make(Statement::Kind kind, std::vector<Expression> expressions) {
  Statement statement;
  statement.kind = kind;
  statement.expressions = std::move(expressions);
  return statement;
}

Expression negated(Expression condition) {
  return {Kind::Prefix, "!", {std::move(condition)}, false, "bool"};
}

class Unfolder {
public:
  Unfolder(Module &module, Unfolding unfolding)
      : module_(module), unfolding_(unfolding), effects_(functionsWithEffects(module)) {
    for (const Declaration &declaration : module.declarations)
      if (declaration.kind == Declaration::Kind::Function)
        functions_.insert(declaration.name);
  }

  void run() {
    for (Declaration &declaration : module_.declarations) {
      made_ = 0;
      declaration.body = unfolded(std::move(declaration.body));
    }
  }

private:
  static bool isConditional(const Expression &expression) {
    return expression.kind == Kind::Conditional || expression.is(Kind::Binary, "&&") ||
           expression.is(Kind::Binary, "||");
  }

  bool callsAny(const Expression &expression, const Names &names) const {
    bool calls = false;
    forEachExpression(expression, [&](const Expression &inner) {
      calls |= inner.kind == Kind::Call && names.contains(inner.text);
    });
    return calls;
  }

  /// Whether this very expression becomes statements.
  bool unfolds(const Expression &expression) const {
    if (!isConditional(expression))
      return false;
    const auto later = std::span(expression.operands).subspan(1);
    if (unfolding_ == Unfolding::Effects)
      return std::ranges::any_of(later,
                                 [&](const Expression &e) { return callsAny(e, effects_) || holdsAny(e); });
    if (expression.kind != Kind::Conditional)
      return std::ranges::any_of(later, [&](const Expression &e) { return holdsAny(e); });
    return !shapeOf(expression.type).isNumeric() || std::ranges::any_of(later, [&](const Expression &e) {
      return callsAny(e, functions_) || holdsAny(e);
    });
  }

  /// Whether anything in an expression becomes statements.
  bool holdsAny(const Expression &expression) const {
    return unfolds(expression) ||
           std::ranges::any_of(expression.operands, [&](const Expression &e) { return holdsAny(e); });
  }

  Statements unfolded(Statements statements) {
    Statements result;
    for (Statement &statement : statements)
      add(std::move(statement), result);
    return result;
  }

  void add(Statement statement, Statements &to) {
    statement.body = unfolded(std::move(statement.body));
    statement.otherwise = unfolded(std::move(statement.otherwise));
    statement.isBraced |= statement.body.size() > 1;
    statement.isElseBraced |= statement.otherwise.size() > 1;
    const bool holds =
        std::ranges::any_of(statement.expressions, [&](const Expression &e) { return holdsAny(e); });
    if (statement.kind == Statement::Kind::Declaration)
      return declaration(std::move(statement), to);
    if (holds && statement.kind == Statement::Kind::While)
      return loop(std::move(statement), to);
    if (!holds)
      return to.push_back(std::move(statement));
    const std::size_t first = to.size();
    Notes notes = std::move(statement.notes);
    if (statement.kind == Statement::Kind::Return)
      deliver(std::move(statement.expressions[0]), nullptr, to);
    else if (Expression &whole = statement.expressions[0];
             statement.kind == Statement::Kind::Expression && whole.is(Kind::Assignment, "="))
      deliver(std::move(whole.operands[1]), &whole.operands[0], to);
    else {
      statement.expressions[0] = value(std::move(whole), to);
      to.push_back(std::move(statement));
    }
    to[first].notes = std::move(notes);
  }

  void declaration(Statement statement, Statements &to) {
    const auto isPlain = [&](const Variable &variable) {
      return variable.initial.empty() || !holdsAny(variable.initial[0]);
    };
    if (std::ranges::all_of(statement.variables, isPlain))
      return to.push_back(std::move(statement));
    const std::size_t first = to.size();
    for (Variable &variable : statement.variables) {
      Statement one;
      one.kind = Statement::Kind::Declaration;
      const bool plain = isPlain(variable);
      std::vector<Expression> initial;
      if (!plain)
        initial = std::exchange(variable.initial, {});
      const Expression name = {Kind::Name, variable.name, {}, false, variable.type};
      one.variables.push_back(std::move(variable));
      to.push_back(std::move(one));
      if (!plain)
        deliver(std::move(initial[0]), &name, to);
    }
    to[first].notes = std::move(statement.notes);
  }

  /// while (c) becomes a loop that ends where c, made inside, does not hold.
  void loop(Statement statement, Statements &to) {
    Statements body;
    Expression condition = value(std::move(statement.expressions[0]), body);
    Statement end = make(Statement::Kind::If, {negated(std::move(condition))});
    end.body.push_back(make(Statement::Kind::Break, {}));
    body.push_back(std::move(end));
    std::ranges::move(statement.body, std::back_inserter(body));
    statement.expressions[0] = {Kind::Literal, "true", {}, false, "bool"};
    statement.body = std::move(body);
    statement.isBraced = true;
    to.push_back(std::move(statement));
  }

  /// Assigns a value to `target`, or returns it where that is null.
  void deliver(Expression expression, const Expression *target, Statements &to) {
    if (!unfolds(expression)) {
      expression = value(std::move(expression), to);
      return to.push_back(end(std::move(expression), target));
    }
    if (expression.kind == Kind::Conditional)
      return deliverEither(std::move(expression), target, to);
    const bool isAnd = expression.text == "&&";
    Expression &right = expression.operands[1];
    Expression left = value(std::move(expression.operands[0]), to);
    if (!target) {
      Statement early = make(Statement::Kind::If, {isAnd ? negated(std::move(left)) : std::move(left)});
      early.body.push_back(end({Kind::Literal, isAnd ? "false" : "true", {}, false, "bool"}, nullptr));
      to.push_back(std::move(early));
      return deliver(std::move(right), nullptr, to);
    }
    to.push_back(end(std::move(left), target));
    Statement later = make(Statement::Kind::If, {isAnd ? *target : negated(*target)});
    deliver(std::move(right), target, later.body);
    later.isBraced = later.body.size() > 1;
    to.push_back(std::move(later));
  }

  void deliverEither(Expression expression, const Expression *target, Statements &to) {
    Statement either = make(Statement::Kind::If, {value(std::move(expression.operands[0]), to)});
    either.expressions[0].isGrouped = false;
    deliver(std::move(expression.operands[1]), target, either.body);
    either.isBraced = either.body.size() > 1;
    Statements &otherwise = target ? either.otherwise : to;
    Statements last;
    deliver(std::move(expression.operands[2]), target, last);
    if (target) {
      otherwise = std::move(last);
      either.isElseBraced = otherwise.size() > 1;
      return to.push_back(std::move(either));
    }
    to.push_back(std::move(either));
    std::ranges::move(last, std::back_inserter(to));
  }

  static Statement end(Expression value, const Expression *target) {
    value.isGrouped = false;
    if (!target)
      return make(Statement::Kind::Return, {std::move(value)});
    const std::string type = target->type;
    return make(Statement::Kind::Expression,
                {{Kind::Assignment, "=", {*target, std::move(value)}, false, type}});
  }

  /// An expression in which nothing is left to unfold, and the statements that come before it.
  Expression value(Expression expression, Statements &to) {
    if (!holdsAny(expression))
      return expression;
    if (unfolds(expression)) {
      const Expression name = {Kind::Name, "chosen_" + std::to_string(++made_), {}, false, expression.type};
      Statement declared = make(Statement::Kind::Declaration, {});
      declared.variables.push_back({name.type, name.text});
      to.push_back(std::move(declared));
      deliver(std::move(expression), &name, to);
      return name;
    }
    for (Expression &operand : expression.operands)
      operand = value(std::move(operand), to);
    return expression;
  }

  Module &module_;
  Unfolding unfolding_;
  Names effects_, functions_;
  int made_ = 0; ///< Variables, in the function at hand.
};

} // namespace

void unfold(Module &module, Unfolding unfolding) { Unfolder(module, unfolding).run(); }

} // namespace voxc::glsl
