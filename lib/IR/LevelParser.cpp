// Parsing of a level's parameters.
#include "LevelParser.h"

#include <algorithm>
#include <charconv>

namespace voxc {
namespace {

std::optional<Argument> parseNumber(Lexer &lexer, Diagnostics &diagnostics) {
  const Token token = lexer.peek();
  if (token.kind != TokenKind::Number) {
    diagnostics.error(token.range, "found " + quoted(token) + " where a number should be");
    return std::nullopt;
  }
  lexer.next();
  Argument argument{0, token.range};
  const char *end = token.text.data() + token.text.size();
  const auto [stop, problem] = std::from_chars(token.text.data(), end, argument.value);
  if (problem == std::errc::result_out_of_range && stop == end) {
    diagnostics.error(token.range, quoted(token) + " is too large; the largest number here is 4294967295");
    return std::nullopt;
  }
  if (problem != std::errc() || stop != end) {
    diagnostics.error(token.range, quoted(token) + " is not a number; write a whole number such as 4");
    return std::nullopt;
  }
  return argument;
}

/// A number, or "N^3", which stands for three.
bool parseArgument(Lexer &lexer, std::vector<Argument> &arguments, Diagnostics &diagnostics) {
  const auto argument = parseNumber(lexer, diagnostics);
  if (!argument)
    return false;
  arguments.push_back(*argument);
  if (!lexer.accept('^'))
    return true;
  const Token power = lexer.next();
  if (power.text != "3") {
    diagnostics.error(power.range,
                      "found " + quoted(power) + " after '^'; only cubes, such as 4^3, can be written so");
    return false;
  }
  arguments.back().range.end = power.range.end;
  arguments.insert(arguments.end(), 2, arguments.back());
  return true;
}

void skipPastParenthesis(Lexer &lexer) {
  while (lexer.peek().kind != TokenKind::End && !lexer.accept(')'))
    lexer.next();
}

} // namespace

std::optional<std::vector<Argument>> parseArguments(Lexer &lexer, Diagnostics &diagnostics) {
  if (!lexer.accept('(')) {
    diagnostics.error(lexer.peek().range, "found " + quoted(lexer.peek()) + " where '(' should be");
    return std::nullopt;
  }
  std::vector<Argument> arguments;
  if (lexer.accept(')'))
    return arguments;
  while (true) {
    if (!parseArgument(lexer, arguments, diagnostics))
      break;
    if (lexer.accept(')'))
      return arguments;
    if (!lexer.accept(',')) {
      diagnostics.error(lexer.peek().range, "found " + quoted(lexer.peek()) + " where ',' or ')' should be");
      break;
    }
  }
  skipPastParenthesis(lexer);
  return std::nullopt;
}

bool checkTextSize(std::string_view text, Diagnostics &diagnostics) {
  constexpr std::size_t kMostBytes = std::size_t{1} << 20;
  if (text.size() > kMostBytes)
    diagnostics.error({}, "the text has " + std::to_string(text.size()) +
                              " bytes; that of a format has at most " + std::to_string(kMostBytes));
  return text.size() <= kMostBytes;
}

std::shared_ptr<const SourceText> keepSource(std::string_view text, std::string_view name) {
  return std::make_shared<const SourceText>(SourceText{std::string(name), std::string(text)});
}

namespace {

std::size_t requiredParameters(const LevelKind &kind) {
  return static_cast<std::size_t>(std::ranges::count_if(
      kind.parameters, [](const ParameterKind &parameter) { return !parameter.defaultValue; }));
}

std::string plural(std::size_t count) {
  return std::to_string(count) + " parameter" + (count == 1 ? "" : "s");
}

std::string outOfRange(const ParameterKind &kind, std::uint32_t value) {
  const std::string name(kind.name);
  if (kind.isSize())
    return "2^" + std::to_string(value) + " cells are too many for " + name +
           "; sizes are log2 and at most " + std::to_string(kind.most);
  if (kind.role == ParameterRole::Reach)
    return "the largest distance " + name + " must be at least " + std::to_string(kind.least);
  return name + " is " + std::to_string(kind.least) + " to " + std::to_string(kind.most) + ", not " +
         std::to_string(value) + ": " + std::string(kind.meaning);
}

} // namespace

std::string signature(const LevelKind &kind) {
  std::string text(1, kind.letter);
  std::string end = ")";
  const char *separator = "(";
  for (const ParameterKind &parameter : kind.parameters) {
    if (parameter.defaultValue) {
      text += '[';
      end.insert(0, "]");
    }
    text += separator + std::string(parameter.name);
    separator = ", ";
  }
  return text + end;
}

/// Who wrote R(4) may have meant a cube.
std::string cubeHint(const LevelKind &kind, const std::vector<Argument> &arguments) {
  const std::size_t required = requiredParameters(kind);
  if (arguments.size() != 1 || required < 3)
    return {};
  return std::string(", or ") + kind.letter + "(" + std::to_string(arguments.front().value) +
         (required > 3 ? "^3, ...) for a cube" : "^3) for a cube");
}

bool setParameters(Level &level, const std::vector<Argument> &arguments, SourceRange head,
                   Diagnostics &diagnostics) {
  const auto kinds = level.kind->parameters;
  const std::size_t required = requiredParameters(*level.kind);
  const std::string right = "; it is written " + signature(*level.kind);
  const auto letter = std::string(1, level.kind->letter);
  if (arguments.size() < required) {
    diagnostics.error({head.begin, level.range.end}, letter + " has " + std::to_string(arguments.size()) +
                                                         " of " + std::to_string(required) + " parameters" +
                                                         right + cubeHint(*level.kind, arguments));
    return false;
  }
  if (arguments.size() > kinds.size()) {
    diagnostics.error({arguments[kinds.size()].range.begin, arguments.back().range.end},
                      letter + " takes " + plural(kinds.size()) + ", not " +
                          std::to_string(arguments.size()) + right);
    return false;
  }
  bool inRange = true;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const std::uint32_t value = i < arguments.size() ? arguments[i].value : *kinds[i].defaultValue;
    if (value < kinds[i].least || value > kinds[i].most) {
      diagnostics.error(arguments[i].range, outOfRange(kinds[i], value));
      inRange = false;
    }
    level.parameters.push_back(value);
  }
  return inRange;
}

} // namespace voxc
