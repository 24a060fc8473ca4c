// Tokens of format strings and IR text.
#pragma once

#include "voxc/Support/Diagnostic.h"

#include <string_view>

namespace voxc {

enum class TokenKind { Word, Number, String, Punctuation, End };

struct Token {
  TokenKind kind = TokenKind::End;
  SourceRange range;
  std::string_view text;

  bool is(char punctuation) const { return kind == TokenKind::Punctuation && text[0] == punctuation; }
  bool isWord(std::string_view word) const { return kind == TokenKind::Word && text == word; }
};

/// Splits a text: words of letters, digits, '-' and '_' that start with a letter; numbers (any run of digits,
/// letters, '.' and '-' that starts with a digit or '-', so that a wrong number is one token); strings in
/// quotation marks, which end with their line; single characters. Blanks and `//` comments separate.
class Lexer {
public:
  explicit Lexer(std::string_view text) : text_(text) { advance(); }

  const Token &peek() const { return token_; }
  Token next() {
    const Token token = token_;
    advance();
    return token;
  }
  /// Takes the next token and, where it is a word with a number in brackets right behind it, both:
  /// "palette(4)".
  Token nextValue();
  /// Takes the next token if it is this character.
  bool accept(char punctuation) {
    if (!token_.is(punctuation))
      return false;
    advance();
    return true;
  }
  /// Where the last token that was taken ends.
  std::size_t takenEnd() const { return takenEnd_; }

private:
  void advance();
  void skipBlanks();

  std::string_view text_;
  std::size_t position_ = 0;
  std::size_t takenEnd_ = 0;
  Token token_;
};

/// A token as diagnostics quote it: 'text', of a long one its beginning, or "the end".
std::string quoted(const Token &token);

} // namespace voxc
