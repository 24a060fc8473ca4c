// Splitting of format strings and IR text into tokens.
#include "Lexer.h"

namespace voxc {
namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

} // namespace

void Lexer::skipBlanks() {
  while (position_ < text_.size()) {
    if (isBlank(text_[position_]))
      ++position_;
    else if (text_.substr(position_, 2) == "//")
      position_ = std::min(text_.find('\n', position_), text_.size());
    else
      return;
  }
}

void Lexer::advance() {
  takenEnd_ = token_.range.end;
  skipBlanks();
  const std::size_t begin = position_;
  const auto run = [&](auto &&belongs) {
    do
      ++position_;
    while (position_ < text_.size() && belongs(text_[position_]));
  };
  TokenKind kind = TokenKind::End;
  if (begin < text_.size()) {
    const char first = text_[begin];
    if (isLetter(first)) {
      kind = TokenKind::Word;
      run([](char c) { return isLetter(c) || isDigit(c) || c == '-' || c == '_'; });
    } else if (isDigit(first) || first == '-') {
      kind = TokenKind::Number;
      run([](char c) { return isLetter(c) || isDigit(c) || c == '.' || c == '-'; });
    } else if (const std::size_t end =
                   first == '"' ? text_.find_first_of("\"\n", begin + 1) : std::string_view::npos;
               end != std::string_view::npos && text_[end] == '"') {
      kind = TokenKind::String;
      position_ = end + 1;
    } else {
      kind = TokenKind::Punctuation;
      // A character outside ASCII is several bytes; carets shall stand under all of them.
      run([](char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; });
    }
  }
  token_ = {kind, {begin, position_}, text_.substr(begin, position_ - begin)};
}

Token Lexer::nextValue() {
  Token value = next();
  if (value.kind == TokenKind::Word && token_.is('(') && token_.range.begin == value.range.end) {
    advance();
    if (token_.kind == TokenKind::Number)
      advance();
    accept(')');
    value.range.end = takenEnd_;
    value.text = text_.substr(value.range.begin, value.range.end - value.range.begin);
  }
  return value;
}

std::string quoted(const Token &token) {
  constexpr std::size_t kMostQuoted = 100; // Bytes; a hostile text may be one word.
  if (token.kind == TokenKind::End)
    return "the end";
  const std::string text(token.text.substr(0, kMostQuoted));
  return "'" + text + (text.size() < token.text.size() ? "...'" : "'");
}

} // namespace voxc
