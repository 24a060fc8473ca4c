// Every expression and every statement of a tree, each before those inside it.
#pragma once

#include "Glsl/Tree.h"

#include <string_view>

namespace voxc::glsl {

/// Calls `visit(expression)` for one and for all inside it. `Tree` is an Expression, const or not.
template <typename Tree, typename Visit>
void forEachExpression(Tree &expression, const Visit &visit)
  requires requires { expression.operands; }
{
  visit(expression);
  for (auto &operand : expression.operands)
    forEachExpression(operand, visit);
}

/// Calls `visit(statement)` for one and for all inside it.
template <typename Tree, typename Visit> void forEachStatement(Tree &statement, const Visit &visit) {
  visit(statement);
  for (auto *const inner : {&statement.begin, &statement.body, &statement.otherwise})
    for (auto &one : *inner)
      forEachStatement(one, visit);
}

/// Those of a variable: its sizes, and what it begins with.
template <typename Tree, typename Visit> void forEachExpressionOf(Tree &variable, const Visit &visit) {
  for (auto *const some : {&variable.sizes, &variable.initial})
    for (auto &one : *some)
      forEachExpression(one, visit);
}

/// Those of a statement, and of all inside it.
template <typename Tree, typename Visit>
void forEachExpression(Tree &statement, const Visit &visit)
  requires requires { statement.otherwise; }
{
  forEachStatement(statement, [&](auto &inner) {
    for (auto &variable : inner.variables)
      forEachExpressionOf(variable, visit);
    for (auto *const some : {&inner.expressions, &inner.step})
      for (auto &one : *some)
        forEachExpression(one, visit);
  });
}

/// Those of a declaration.
template <typename Tree, typename Visit>
void forEachExpression(Tree &declaration, const Visit &visit)
  requires requires { declaration.parameters; }
{
  for (auto &variable : declaration.variables)
    forEachExpressionOf(variable, visit);
  for (auto &statement : declaration.body)
    forEachExpression(statement, visit);
}

/// The names of types in a declaration: of what a function returns and takes, of its variables, of members.
template <typename Visit> void forEachType(const Declaration &declaration, const Visit &visit) {
  visit(declaration.type);
  for (const Parameter &parameter : declaration.parameters)
    visit(parameter.type);
  for (const Variable &variable : declaration.variables)
    visit(variable.type);
  for (const Statement &statement : declaration.body)
    forEachStatement(statement, [&](const Statement &inner) {
      for (const Variable &variable : inner.variables)
        visit(variable.type);
    });
}

/// The variable that an expression is or is a part of: `traversal` of traversal.cell.x; "" if it is another
/// value.
inline std::string_view rootOf(const Expression &expression) {
  const Expression *at = &expression;
  while (at->kind == Expression::Kind::Member || at->kind == Expression::Kind::Index)
    at = &at->operands[0];
  return at->kind == Expression::Kind::Name ? std::string_view(at->text) : "";
}

} // namespace voxc::glsl
