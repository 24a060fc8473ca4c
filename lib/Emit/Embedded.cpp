// GLSL to text for others: read once for what it declares, and once more to write it.
#include "Embedded.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <vector>

namespace voxc {
namespace {

bool isWordPart(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

/// Words, numbers, signs of one character, and what lies between them.
struct Token {
  enum class Kind { Word, Number, Sign, Gap };
  Kind kind;
  std::string_view text;

  bool is(std::string_view other) const { return text == other; }
};

/// The length of a number, with the dot and the exponent of a float.
std::size_t numberLength(std::string_view text) {
  const bool isHex = text.starts_with("0x");
  std::size_t length = 1;
  while (length < text.size() &&
         (isWordPart(text[length]) || text[length] == '.' ||
          (!isHex && text[length - 1] == 'e' && (text[length] == '-' || text[length] == '+'))))
    ++length;
  return length;
}

Token firstToken(std::string_view text) {
  const auto isBlank = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
  const auto begin = text.begin();
  if (text.starts_with("//"))
    return {Token::Kind::Gap, text.substr(0, text.find('\n'))};
  if (isBlank(text[0]))
    return {Token::Kind::Gap, {begin, std::find_if_not(begin, text.end(), isBlank)}};
  if (std::isdigit(static_cast<unsigned char>(text[0])))
    return {Token::Kind::Number, text.substr(0, numberLength(text))};
  if (isWordPart(text[0]))
    return {Token::Kind::Word, {begin, std::find_if_not(begin, text.end(), isWordPart)}};
  return {Token::Kind::Sign, text.substr(0, 1)};
}

std::vector<Token> tokensOf(std::string_view text) {
  std::vector<Token> tokens;
  for (; !text.empty(); text.remove_prefix(tokens.back().text.size()))
    tokens.push_back(firstToken(text));
  return tokens;
}

/// What GLSL text declares at its outermost level.
class Declarations {
public:
  explicit Declarations(const std::vector<Token> &tokens) : tokens_(tokens) {
    for (std::size_t i = 0; i < tokens.size(); ++i)
      if (tokens[i].kind != Token::Kind::Gap)
        read(i);
    handOnVolumes();
  }

  bool has(std::string_view name) const { return names_.contains(name); }
  /// Whether a function begins with this token.
  bool beginsFunction(std::size_t token) const { return begins_.contains(token); }
  /// Whether this token is the name of a function where that is declared.
  bool namesFunction(std::size_t token) const { return functionNames_.contains(token); }
  bool takesVolume(std::string_view function) const { return takers_.contains(function); }
  bool isMember(std::size_t token) const { return members_.contains(token); }

private:
  void read(std::size_t i) {
    const Token &token = tokens_[i];
    if (token.kind == Token::Kind::Word)
      word(i);
    else if (token.kind == Token::Kind::Sign)
      sign(token.text[0]);
  }

  void word(std::size_t i) {
    if (depth_ == 0 && !named_)
      words_.push_back(i);
    else if (!function_.empty())
      calls_[function_].insert(tokens_[i].text);
    last_ = i;
  }

  void sign(char sign) {
    const bool isOutermost = depth_ == 0 && !named_ && !words_.empty();
    if (isOutermost && (sign == '(' || sign == '=' || sign == '{'))
      name(sign);
    if (sign == ';' && depth_ == 1 && isStruct_)
      members_.insert(last_);
    depth_ += sign == '(' || sign == '{' ? 1 : sign == ')' || sign == '}' ? -1 : 0;
    if (depth_ == 0 && (sign == ';' || (sign == '}' && !function_.empty())))
      end();
  }

  /// The declaration that has begun is that of the last word.
  void name(char sign) {
    named_ = true;
    isStruct_ = sign == '{';
    const std::string_view name = tokens_[words_.back()].text;
    names_.insert(name);
    if (sign != '(')
      return;
    function_ = name;
    begins_.insert(words_.front());
    functionNames_.insert(words_.back());
  }

  void end() {
    words_.clear();
    function_ = {};
    named_ = isStruct_ = false;
  }

  /// From load_word up to all that cannot do without a volume.
  void handOnVolumes() {
    takers_.insert("load_word");
    for (std::size_t before = 0; before != takers_.size();) {
      before = takers_.size();
      for (const auto &[function, called] : calls_)
        if (std::ranges::any_of(called, [&](std::string_view name) { return takers_.contains(name); }))
          takers_.insert(function);
    }
  }

  const std::vector<Token> &tokens_;
  std::set<std::string_view> names_;
  std::set<std::string_view> takers_;
  std::map<std::string_view, std::set<std::string_view>> calls_;
  std::set<std::size_t> begins_, functionNames_, members_;

  // The declaration that is being read.
  std::vector<std::size_t> words_;
  std::string_view function_;
  bool named_ = false;
  bool isStruct_ = false;
  int depth_ = 0;
  std::size_t last_ = 0;
};

class Writer {
public:
  Writer(const std::vector<Token> &tokens, std::string_view prefix)
      : tokens_(tokens), declarations_(tokens), prefix_(prefix) {}

  std::string write() {
    while (next_ < tokens_.size())
      step();
    return std::move(text_);
  }

private:
  void step() {
    const Token &token = tokens_[next_];
    if (declarations_.beginsFunction(next_))
      text_ += token.is("OUT_OF_LINE") ? "VOXC_SELDOM " : "VOXC_FUNCTION ";
    if (token.is("OUT_OF_LINE"))
      next_ += 2;
    else if (token.kind == Token::Kind::Word)
      word();
    else
      copy();
  }

  void word() {
    const bool isParameter = last_ == '(' || last_ == ',';
    const std::string_view text = tokens_[next_].text;
    if (text == "precise")
      replace("VOXC_PRECISE");
    else if (text == "inout")
      parameter("VOXC_INOUT(");
    else if (text == "out")
      parameter("VOXC_OUT(");
    else if (text == "const" && isParameter)
      parameter("VOXC_IN(");
    else
      name();
  }

  /// A word that languages have in different ways, or not at all.
  void replace(std::string_view macro) {
    text_ += macro;
    last_ = macro.back();
    ++next_;
  }

  /// A parameter that has a qualifier, which goes around its type.
  void parameter(std::string_view macro) {
    next_ += 2;
    text_ += macro;
    name();
    text_ += ')';
  }

  void name() {
    const std::string_view text = tokens_[next_].text;
    const bool isOurs = last_ != '.' && declarations_.has(text) && !declarations_.isMember(next_);
    const bool isDeclared = declarations_.namesFunction(next_);
    if (isOurs && !text.starts_with(prefix_))
      text_ += prefix_;
    copy();
    if (isOurs && declarations_.takesVolume(text) && next_ < tokens_.size() && tokens_[next_].is("(")) {
      copy();
      text_ += isDeclared ? "VOXC_VOLUME volume" : "volume";
      text_ += tokens_[next_].is(")") ? "" : ", ";
    }
  }

  void copy() {
    const Token &token = tokens_[next_++];
    text_ += token.text;
    if (token.kind != Token::Kind::Gap)
      last_ = token.text.back();
  }

  const std::vector<Token> &tokens_;
  const Declarations declarations_;
  std::string_view prefix_;
  std::string text_;
  std::size_t next_ = 0;
  char last_ = ';'; ///< The last character that is neither blank nor comment.
};

} // namespace

std::string embedded(std::string_view glsl, std::string_view prefix) {
  const std::vector<Token> tokens = tokensOf(glsl);
  return Writer(tokens, prefix).write();
}

} // namespace voxc
