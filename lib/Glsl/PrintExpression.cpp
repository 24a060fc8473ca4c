// Expressions, with the parentheses that they were written with, and those that they need.
#include "Glsl/Operators.h"
#include "Glsl/Print.h"
#include "Glsl/Printer.h"

namespace voxc::glsl {

using Kind = Expression::Kind;

int Printer::rank(const Expression &expression) const {
  switch (expression.kind) {
  case Kind::Binary:
    return rankOfSign(expression.text);
  case Kind::Prefix:
    return kPrefixRank;
  case Kind::Conditional:
    return kConditionalRank;
  case Kind::Assignment:
    return kAssignmentRank;
  default:
    return kPostfixRank;
  }
}

std::string Printer::text(const Expression &expression, int leastRank) const {
  const std::string text = bare(expression);
  return expression.isGrouped || rank(expression) < leastRank ? "(" + text + ")" : text;
}

std::string Printer::bare(const Expression &expression) const {
  const std::vector<Expression> &operands = expression.operands;
  const int own = rank(expression);
  switch (expression.kind) {
  case Kind::Literal:
    return literal(expression.text);
  case Kind::Name:
    return expression.text;
  case Kind::Call:
    return type(expression.text) + "(" + list(operands) + ")";
  case Kind::Member:
    return text(operands[0], own) + "." + expression.text;
  case Kind::Index:
    return text(operands[0], own) + "[" + text(operands[1]) + "]";
  case Kind::Prefix:
    return expression.text + text(operands[0], own);
  case Kind::Postfix:
    return text(operands[0], own) + expression.text;
  case Kind::Binary:
    return text(operands[0], own) + " " + expression.text + " " + text(operands[1], own + 1);
  case Kind::Conditional:
    return text(operands[0], 1) + " ? " + text(operands[1], kConditionalRank) + " : " +
           text(operands[2], kConditionalRank);
  case Kind::Assignment:
    return text(operands[0], kPrefixRank) + " " + expression.text + " " + text(operands[1], kAssignmentRank);
  }
  return "";
}

std::string Printer::list(const std::vector<Expression> &expressions) const {
  std::string list;
  for (const Expression &expression : expressions)
    list += (list.empty() ? "" : ", ") + alone(expression);
  return list;
}

std::string print(const Expression &expression) { return Printer().text(expression); }

} // namespace voxc::glsl
