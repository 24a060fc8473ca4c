// Expressions, by the ranks of operators.
#include "Glsl/Operators.h"
#include "Glsl/Parser.h"

namespace voxc::glsl {

using Kind = Expression::Kind;

Expression Parser::expression() {
  Expression left = conditional();
  if (!isAssignment(peek().text))
    return left;
  std::string sign = take().text;
  return {Kind::Assignment, std::move(sign), {std::move(left), expression()}};
}

Expression Parser::conditional() {
  Expression condition = binary(1);
  if (!takeIf("?"))
    return condition;
  Expression then = expression();
  expect(":");
  return {Kind::Conditional, "", {std::move(condition), std::move(then), conditional()}};
}

Expression Parser::binary(int leastRank) {
  Expression left = prefix();
  for (int rank = rankOfSign(peek().text); rank >= leastRank; rank = rankOfSign(peek().text)) {
    std::string sign = take().text;
    left = {Kind::Binary, std::move(sign), {std::move(left), binary(rank + 1)}};
  }
  return left;
}

Expression Parser::prefix() {
  for (const char *sign : {"-", "+", "~", "!", "++", "--"})
    if (takeIf(sign))
      return {Kind::Prefix, sign, {prefix()}};
  return postfix();
}

Expression Parser::postfix() {
  Expression value = primary();
  while (true) {
    if (takeIf(".")) {
      value = {Kind::Member, word("a member"), {std::move(value)}};
    } else if (takeIf("[")) {
      value = {Kind::Index, "", {std::move(value), expression()}};
      expect("]");
    } else if (isNext("++") || isNext("--")) {
      std::string sign = take().text;
      value = {Kind::Postfix, std::move(sign), {std::move(value)}};
    } else {
      return value;
    }
  }
}

Expression Parser::primary() {
  if (takeIf("(")) {
    Expression value = expression();
    expect(")");
    value.isGrouped = true;
    return value;
  }
  if (peek().kind == Token::Kind::Number || isNext("true") || isNext("false"))
    return {Kind::Literal, take().text};
  std::string name = word("a value");
  if (!isNext("("))
    return {Kind::Name, std::move(name)};
  return {Kind::Call, std::move(name), arguments()};
}

std::vector<Expression> Parser::arguments() {
  std::vector<Expression> arguments;
  expect("(");
  if (takeIf(")"))
    return arguments;
  do
    arguments.push_back(expression());
  while (takeIf(","));
  expect(")");
  return arguments;
}

/// What stands in brackets behind the name of an array: an expression, or nothing where it is open.
std::vector<Expression> Parser::sizes() {
  std::vector<Expression> sizes;
  while (takeIf("[")) {
    sizes.push_back(isNext("]") ? Expression{} : expression());
    expect("]");
  }
  return sizes;
}

} // namespace voxc::glsl
