// Statements.
#include "Glsl/Parser.h"

namespace voxc::glsl {

using Kind = Statement::Kind;

Statement Parser::statement() {
  Statement statement;
  statement.notes = takeNotes();
  if (isNext("{")) {
    statement.body = body(statement.isBraced);
    return statement;
  }
  if (takeIf("if"))
    return branch(std::move(statement));
  if (takeIf("while"))
    return loop(std::move(statement));
  if (isNext("[")) {
    for (const char *const part : {"[", "[", "unroll", "]", "]"})
      expect(part);
    statement.qualifiers = "unroll";
  }
  if (takeIf("for"))
    return count(std::move(statement));
  Notes notes = std::move(statement.notes);
  statement = simple();
  statement.notes = std::move(notes);
  end(statement.notes);
  return statement;
}

/// The semicolon, and the comment behind it.
void Parser::end(Notes &notes) {
  expect(";");
  notes.behind = std::exchange(behind_, {});
}

/// A statement without its semicolon.
Statement Parser::simple() {
  Statement statement;
  if (takeIf("break")) {
    statement.kind = Kind::Break;
  } else if (takeIf("continue")) {
    statement.kind = Kind::Continue;
  } else if (takeIf("return")) {
    statement.kind = Kind::Return;
    if (!isNext(";"))
      statement.expressions.push_back(expression());
  } else if (beginsDeclaration()) {
    statement.kind = Kind::Declaration;
    if (isNext("const") || isNext("precise"))
      statement.qualifiers = take().text;
    statement.variables = variables(word("a type"));
  } else {
    statement.kind = Kind::Expression;
    statement.expressions.push_back(expression());
  }
  return statement;
}

bool Parser::beginsDeclaration() const {
  return isNext("const") || isNext("precise") ||
         (peek().kind == Token::Kind::Word && peek(1).kind == Token::Kind::Word);
}

/// The names of a type, up to the end of the statement.
std::vector<Variable> Parser::variables(const std::string &type) {
  std::vector<Variable> variables;
  do {
    Variable variable = {type, word("a name")};
    variable.sizes = sizes();
    if (takeIf("="))
      variable.initial.push_back(expression());
    variables.push_back(std::move(variable));
  } while (takeIf(","));
  return variables;
}

/// One statement, or those in braces. A comment behind the opening brace is above the first of them.
std::vector<Statement> Parser::body(bool &isBraced) {
  std::vector<Statement> statements;
  isBraced = takeIf("{");
  if (!isBraced) {
    statements.push_back(statement());
    return statements;
  }
  const std::string opening = std::exchange(behind_, {});
  while (!problem_ && !isNext("}"))
    statements.push_back(statement());
  if (!opening.empty() && !statements.empty())
    statements.front().notes.above.insert(statements.front().notes.above.begin(), opening);
  if (!peek().notes.above.empty())
    fail("a statement before its comment's block ends");
  expect("}");
  return statements;
}

Statement Parser::branch(Statement statement) {
  statement.kind = Kind::If;
  expect("(");
  statement.expressions.push_back(expression());
  expect(")");
  if (!behind_.empty()) // Of the condition: above the whole.
    statement.notes.above.push_back(std::exchange(behind_, {}));
  statement.body = body(statement.isBraced);
  if (takeIf("else"))
    statement.otherwise = body(statement.isElseBraced);
  return statement;
}

Statement Parser::loop(Statement statement) {
  statement.kind = Kind::While;
  expect("(");
  statement.expressions.push_back(expression());
  expect(")");
  statement.body = body(statement.isBraced);
  return statement;
}

Statement Parser::count(Statement statement) {
  statement.kind = Kind::For;
  expect("(");
  if (!isNext(";"))
    statement.begin.push_back(simple());
  expect(";");
  if (!isNext(";"))
    statement.expressions.push_back(expression());
  expect(";");
  if (!isNext(")"))
    statement.step.push_back(expression());
  expect(")");
  statement.body = body(statement.isBraced);
  return statement;
}

} // namespace voxc::glsl
