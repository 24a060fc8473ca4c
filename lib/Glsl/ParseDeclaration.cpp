// What stands outermost, and the tokens that all rules take.
#include "Glsl/Parse.h"
#include "Glsl/Parser.h"

#include <algorithm>

namespace voxc::glsl {

using Kind = Declaration::Kind;

Expected<Module> Parser::parse() {
  while (!problem_ && peek().kind != Token::Kind::End)
    declaration();
  if (problem_)
    return std::move(*problem_);
  if (Notes notes = takeNotes(); !notes.above.empty())
    remark(std::move(notes));
  return std::move(module_);
}

const Token &Parser::peek(std::size_t ahead) const {
  return problem_ || next_ + ahead >= tokens_.size() ? tokens_.back() : tokens_[next_ + ahead];
}

Token Parser::take() {
  if (!behind_.empty())
    fail("a comment behind the end of a statement");
  Token token = peek();
  if (!token.notes.above.empty())
    fail("a comment above a statement");
  behind_ = token.notes.behind;
  if (!problem_ && next_ + 1 < tokens_.size())
    ++next_;
  return token;
}

bool Parser::takeIf(std::string_view text) {
  const bool isIt = isNext(text);
  if (isIt)
    take();
  return isIt;
}

void Parser::expect(std::string_view text) {
  if (!takeIf(text))
    fail("'" + std::string(text) + "'");
}

std::string Parser::word(std::string_view what) {
  if (peek().kind == Token::Kind::Word)
    return take().text;
  fail(what);
  return "";
}

void Parser::fail(std::string_view wanted) {
  if (problem_)
    return;
  const Token &token = peek();
  const std::string found = token.kind == Token::Kind::End ? "the end" : "'" + token.text + "'";
  problem_ = Error::input("line " + std::to_string(token.line) + ": found " + found + " where " +
                          std::string(wanted) + " would be right");
}

Notes Parser::takeNotes() {
  Notes notes;
  if (!problem_)
    notes.above = std::exchange(tokens_[next_].notes.above, {});
  return notes;
}

/// Comments with an empty line behind them belong to nothing.
void Parser::remark(Notes notes) {
  Declaration remark;
  remark.notes = std::move(notes);
  module_.declarations.push_back(std::move(remark));
}

void Parser::add(Declaration declaration) { module_.declarations.push_back(std::move(declaration)); }

void Parser::declaration() {
  Declaration declaration;
  declaration.notes = takeNotes();
  if (declaration.notes.above.size() > 1 && declaration.notes.above.back().empty()) {
    declaration.notes.above.pop_back();
    remark(std::exchange(declaration.notes, {{""}, ""}));
  }
  if (peek().kind == Token::Kind::Directive) {
    declaration.kind = Kind::Directive;
    declaration.name = take().text;
    return add(std::move(declaration));
  }
  declaration.isSeldom = takeIf("OUT_OF_LINE");
  declaration.isInline = takeIf("INLINE");
  declaration.qualifiers = qualifiers();
  if (isNext("struct") || isNext("{", 1))
    return structure(declaration);
  if (isNext(";")) {
    declaration.kind = Kind::Layout;
    end(declaration.notes);
    return add(std::move(declaration));
  }
  declaration.type = word("a declaration");
  if (isNext("(", 1))
    return function(declaration);
  declaration.kind = Kind::Variable;
  declaration.variables = variables(std::exchange(declaration.type, {}));
  end(declaration.notes);
  add(std::move(declaration));
}

/// layout(..), and the words that say how something is stored.
std::string Parser::qualifiers() {
  static constexpr std::string_view kWords[] = {"const",    "readonly", "writeonly", "restrict",
                                                "coherent", "buffer",   "uniform",   "shared",
                                                "precise",  "in",       "out",       "highp"};
  std::string text;
  const auto isQualifier = [&] {
    return std::ranges::any_of(kWords, [&](auto word) { return isNext(word); });
  };
  while (isNext("layout") || isQualifier()) {
    text += (text.empty() ? "" : " ") + peek().text;
    if (!isNext("layout")) {
      take();
      continue;
    }
    take();
    while (!problem_ && !isNext(")")) {
      const std::string part = take().text;
      text += part == "=" ? " = " : part == "," ? ", " : part;
    }
    expect(")");
    text += ')';
  }
  return text;
}

void Parser::structure(Declaration &declaration) {
  declaration.kind = takeIf("struct") ? Kind::Structure : Kind::Block;
  declaration.name = word("a name");
  expect("{");
  members(declaration);
  expect("}");
  end(declaration.notes);
  add(std::move(declaration));
}

void Parser::members(Declaration &declaration) {
  while (!problem_ && !isNext("}")) {
    Notes notes = takeNotes();
    std::vector<Variable> members = variables(word("a type"));
    end(notes);
    members.front().notes = std::move(notes);
    for (Variable &member : members)
      declaration.variables.push_back(std::move(member));
  }
}

void Parser::function(Declaration &declaration) {
  declaration.kind = Kind::Function;
  declaration.name = word("a name");
  expect("(");
  while (!problem_ && !isNext(")")) {
    declaration.parameters.push_back(parameter());
    if (!isNext(")"))
      expect(",");
  }
  expect(")");
  declaration.isPrototype = isNext(";");
  if (declaration.isPrototype)
    end(declaration.notes);
  else if (bool isBraced; isNext("{"))
    declaration.body = body(isBraced);
  else
    fail("'{'");
  behind_.clear();
  add(std::move(declaration));
}

Parameter Parser::parameter() {
  const Passing passing = takeIf("const")   ? Passing::Const
                          : takeIf("inout") ? Passing::InOut
                          : takeIf("out")   ? Passing::Out
                                            : Passing::In;
  takeIf("in");
  std::string type = word("a type");
  return {passing, std::move(type), word("a name")};
}

Expected<Module> parse(std::string_view text) {
  auto tokens = VOXC_TRY(tokensOf(text));
  return Parser(std::move(tokens)).parse();
}

} // namespace voxc::glsl
