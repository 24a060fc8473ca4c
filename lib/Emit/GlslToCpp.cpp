// GLSL to C++, token by token: only what the two spell differently is touched.
#include "GlslToCpp.h"

#include <algorithm>
#include <cctype>

namespace voxc {
namespace {

bool isWordStart(char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; }
bool isDigit(char c) { return std::isdigit(static_cast<unsigned char>(c)); }
bool isWordPart(char c) { return isWordStart(c) || isDigit(c); }

class Translator {
public:
  explicit Translator(std::string_view glsl) : rest_(glsl) {}

  std::string translate() {
    while (!rest_.empty())
      step();
    return std::move(text_);
  }

private:
  void step() {
    if (rest_.starts_with("//"))
      copy(std::min(rest_.find('\n'), rest_.size()));
    else if (isWordStart(rest_[0]))
      word();
    else if (isDigit(rest_[0]))
      number();
    else
      symbol();
  }

  std::string_view take(std::size_t length) {
    const std::string_view taken = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return taken;
  }
  void copy(std::size_t length) { text_ += take(length); }

  std::size_t wordLength() const {
    std::size_t length = 0;
    while (length < rest_.size() && isWordPart(rest_[length]))
      ++length;
    return length;
  }

  void word() {
    const std::string_view word = take(wordLength());
    const bool isParameter = last_ == '(' || last_ == ',';
    if (word == "inout" || word == "out")
      reference("");
    else if (word == "const" && isParameter)
      reference("const ");
    else if (word == "const" && (text_.empty() || text_.back() == '\n'))
      text_ += "static inline const";
    else if (word == "precise")
      skipBlanks(); // C++ is compiled so that nothing is contracted or reordered.
    else
      text_ += word;
    last_ = 'a';
  }

  /// A parameter's type, whose blank before the name moves: "Walk walk" becomes "Walk &walk".
  void reference(std::string_view qualifier) {
    skipBlanks();
    text_ += qualifier;
    copy(wordLength());
    skipBlanks();
    text_ += " &";
  }

  void skipBlanks() { rest_.remove_prefix(std::min(rest_.find_first_not_of(" \n"), rest_.size())); }

  void number() {
    const bool isHex = rest_.starts_with("0x") || rest_.starts_with("0X");
    std::size_t length = 0;
    bool isFloat = false;
    for (; length < rest_.size() && (isWordPart(rest_[length]) || rest_[length] == '.'); ++length) {
      const char c = rest_[length];
      const bool isExponent = !isHex && (c == 'e' || c == 'E');
      isFloat |= c == '.' || isExponent;
      if (isExponent && length + 1 < rest_.size() && (rest_[length + 1] == '-' || rest_[length + 1] == '+'))
        ++length;
    }
    copy(length);
    if (isFloat && text_.back() != 'f' && text_.back() != 'F')
      text_ += 'f';
    last_ = '0';
  }

  void symbol() {
    if (!std::isspace(static_cast<unsigned char>(rest_[0])))
      last_ = rest_[0];
    copy(1);
  }

  std::string_view rest_;
  std::string text_;
  char last_ = ';'; ///< The last symbol that is no blank; 'a' for a word, '0' for a number.
};

} // namespace

std::string glslToCpp(std::string_view glsl) { return Translator(glsl).translate(); }

} // namespace voxc
