// Statements, line by line.
#include "Glsl/Printer.h"

namespace voxc::glsl {

using Kind = Statement::Kind;

namespace {

/// Whether an else would belong to what stands before it, and not to this.
bool takesElse(const Statement &branch) {
  return !branch.otherwise.empty() && branch.body.size() == 1 &&
         (branch.body[0].kind == Kind::If || branch.body[0].kind == Kind::While ||
          branch.body[0].kind == Kind::For);
}

} // namespace

void Printer::statement(const Statement &statement, int depth) {
  above(statement.notes, depth);
  switch (statement.kind) {
  case Kind::Block:
    line(depth, "{");
    return body(statement.body, true, depth);
  case Kind::If:
    return branch(statement, depth);
  case Kind::While:
    line(depth, "while (" + text(statement.expressions[0]) + ")" + (statement.isBraced ? " {" : ""));
    return body(statement.body, statement.isBraced, depth);
  case Kind::For: {
    const std::string begin = statement.begin.empty() ? "" : simple(statement.begin[0]);
    const std::string condition = statement.expressions.empty() ? "" : " " + text(statement.expressions[0]);
    const std::string step = statement.step.empty() ? "" : " " + text(statement.step[0]);
    const std::string mark = statement.qualifiers == "unroll" ? "[[unroll]] " : "";
    line(depth,
         mark + "for (" + begin + ";" + condition + ";" + step + ")" + (statement.isBraced ? " {" : ""));
    return body(statement.body, statement.isBraced, depth);
  }
  default:
    return line(depth, simple(statement) + ";", statement.notes.behind);
  }
}

/// What a line that ends in a brace, or in none, leads to.
void Printer::body(const std::vector<Statement> &statements, bool isBraced, int depth) {
  for (const Statement &inner : statements)
    statement(inner, depth + 1);
  if (isBraced)
    line(depth, "}");
}

void Printer::branch(const Statement &statement, int depth) {
  const Statement *at = &statement;
  std::string before;
  while (true) {
    const bool isBraced = at->isBraced || takesElse(*at);
    line(depth, before + "if (" + text(at->expressions[0]) + ")" + (isBraced ? " {" : ""));
    for (const Statement &inner : at->body)
      this->statement(inner, depth + 1);
    const std::string closed = isBraced ? "} " : "";
    if (at->otherwise.empty()) {
      if (isBraced)
        line(depth, "}");
      return;
    }
    before = closed + "else ";
    const Statement &next = at->otherwise.front();
    if (at->isElseBraced || next.kind != Kind::If || !next.notes.above.empty())
      break;
    at = &next;
  }
  line(depth, before.substr(0, before.size() - 1) + (at->isElseBraced ? " {" : ""));
  body(at->otherwise, at->isElseBraced, depth);
}

std::string Printer::simple(const Statement &statement) const {
  const auto value = [&] {
    return statement.expressions.empty() ? "" : " " + text(statement.expressions[0]);
  };
  switch (statement.kind) {
  case Kind::Break:
    return "break";
  case Kind::Continue:
    return "continue";
  case Kind::Return:
    return "return" + value();
  case Kind::Declaration:
    return beforeLocal(statement.qualifiers) + variables(statement.variables);
  default:
    return text(statement.expressions[0]);
  }
}

std::string Printer::beforeLocal(const std::string &qualifiers) const {
  return qualifiers.empty() ? "" : qualifiers + " ";
}

std::string Printer::variables(const std::vector<Variable> &variables) const {
  std::vector<std::string> names;
  for (const Variable &one : variables) {
    std::string name = one.name;
    for (const Expression &size : one.sizes)
      name += "[" + text(size) + "]";
    names.push_back(name + initial(one));
  }
  return type(variables.front().type) + " " + joined(names);
}

std::string Printer::initial(const Variable &variable) const {
  return variable.initial.empty() ? "" : " = " + text(variable.initial[0]);
}

} // namespace voxc::glsl
