// Text to tokens.
#include "Glsl/Lexer.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace voxc::glsl {
namespace {

/// A sign is the first of these that fits, or a single character.
constexpr std::array<std::string_view, 21> kLongSigns = {
    "<<=", ">>=", "<<", ">>", "<=", ">=", "==", "!=", "&&", "||", "^^",
    "++",  "--",  "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^="};
constexpr std::string_view kSigns = "+-*/%&|^~!<>=?:;,.()[]{}";

bool isWordStart(char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; }
bool isDigit(char c) { return std::isdigit(static_cast<unsigned char>(c)); }
bool isWordPart(char c) { return isWordStart(c) || isDigit(c); }

class Lexer {
public:
  explicit Lexer(std::string_view text) : text_(text) {}

  Expected<std::vector<Token>> tokens() {
    while (skipBlanks())
      if (!take())
        return Error::input("line " + std::to_string(line_) + ": found '" + std::string(1, text_[at_]) +
                            "', which is no part of the language");
    add(Token::Kind::End, 0);
    return std::move(tokens_);
  }

private:
  std::string_view rest() const { return text_.substr(at_); }

  /// To the next token, past comments. False at the end.
  bool skipBlanks() {
    int lines = tokens_.empty() ? 1 : 0; // That ended since the last token or comment.
    while (at_ < text_.size()) {
      if (rest().starts_with("//")) {
        comment(lines);
        lines = 0;
      } else if (!std::isspace(static_cast<unsigned char>(text_[at_]))) {
        break;
      } else if (text_[at_++] == '\n') {
        ++line_;
        ++lines;
      }
    }
    if (lines > 1 && !isAtBegin())
      above_.emplace_back();
    return at_ < text_.size();
  }

  bool isAtBegin() const { return tokens_.empty() && above_.empty(); }

  void comment(int linesBefore) {
    const std::string_view text = rest().substr(0, rest().find('\n'));
    at_ += text.size();
    const bool isBehind = linesBefore == 0 && !tokens_.empty() && above_.empty();
    if (isBehind)
      tokens_.back().notes.behind = text;
    if (isBehind)
      return;
    if (linesBefore > 1 && !isAtBegin())
      above_.emplace_back();
    above_.emplace_back(text);
  }

  bool take() {
    const std::string_view rest = this->rest();
    if (rest[0] == '#')
      return directive();
    if (isWordStart(rest[0]))
      return add(Token::Kind::Word, wordLength(rest));
    if (isDigit(rest[0]))
      return add(Token::Kind::Number, numberLength(rest));
    const auto sign =
        std::ranges::find_if(kLongSigns, [&](std::string_view s) { return rest.starts_with(s); });
    if (sign != kLongSigns.end())
      return add(Token::Kind::Sign, sign->size());
    return kSigns.find(rest[0]) != std::string_view::npos && add(Token::Kind::Sign, 1);
  }

  static std::size_t wordLength(std::string_view text) {
    return static_cast<std::size_t>(std::ranges::find_if_not(text, isWordPart) - text.begin());
  }

  /// With the point and the exponent of a float, and its suffix.
  static std::size_t numberLength(std::string_view text) {
    const bool isHex = text.starts_with("0x");
    std::size_t length = 1;
    while (length < text.size() &&
           (isWordPart(text[length]) || text[length] == '.' ||
            (!isHex && text[length - 1] == 'e' && (text[length] == '-' || text[length] == '+'))))
      ++length;
    return length;
  }

  /// A comment in its line is a part of it.
  bool directive() { return add(Token::Kind::Directive, rest().substr(0, rest().find('\n')).size()); }

  bool add(Token::Kind kind, std::size_t length) {
    tokens_.push_back({kind, std::string(text_.substr(at_, length)), {std::move(above_), ""}, line_});
    above_.clear();
    at_ += length;
    return true;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1;
  std::vector<Token> tokens_;
  std::vector<std::string> above_; ///< Of the token to come.
};

} // namespace

Expected<std::vector<Token>> tokensOf(std::string_view text) { return Lexer(text).tokens(); }

} // namespace voxc::glsl
