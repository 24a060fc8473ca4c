// The parser, by descent: ParseDeclaration.cpp, ParseStatement.cpp and ParseExpression.cpp.
#pragma once

#include "Glsl/Lexer.h"
#include "Glsl/Tree.h"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace voxc::glsl {

/// After the first problem all tokens are the last one, so that every rule ends soon.
class Parser {
public:
  explicit Parser(std::vector<Token> tokens) : tokens_(std::move(tokens)) {}

  Expected<Module> parse();

private:
  // Tokens.
  const Token &peek(std::size_t ahead = 0) const;
  bool isNext(std::string_view text, std::size_t ahead = 0) const { return peek(ahead).is(text); }
  Token take();
  bool takeIf(std::string_view text);
  void expect(std::string_view text);
  std::string word(std::string_view what);
  void fail(std::string_view wanted);
  /// Those before the next token, which are then of what begins there.
  Notes takeNotes();

  // Outermost.
  void declaration();
  std::string qualifiers();
  void structure(Declaration &declaration);
  void members(Declaration &declaration);
  void function(Declaration &declaration);
  Parameter parameter();
  void remark(Notes notes);
  void add(Declaration declaration);

  // Statements.
  Statement statement();
  Statement simple();
  std::vector<Statement> body(bool &isBraced);
  Statement branch(Statement statement);
  Statement loop(Statement statement);
  Statement count(Statement statement);
  bool beginsDeclaration() const;
  std::vector<Variable> variables(const std::string &type);
  void end(Notes &notes);

  // Expressions.
  Expression expression();
  Expression conditional();
  Expression binary(int leastRank);
  Expression prefix();
  Expression postfix();
  Expression primary();
  std::vector<Expression> arguments();
  std::vector<Expression> sizes();

  std::vector<Token> tokens_;
  std::size_t next_ = 0;
  std::string behind_; ///< The comment behind the last token that was taken.
  std::optional<Error> problem_;
  Module module_;
};

} // namespace voxc::glsl
