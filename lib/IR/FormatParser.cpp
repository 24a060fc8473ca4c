// Parsing of format strings: level+, where level is a letter and its parameters (docs/formats.md).
#include "LevelParser.h"

#include <algorithm>
#include <bit>

namespace voxc {
namespace {

std::string lower(std::string_view text) {
  std::string result(text);
  for (char &c : result)
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return result;
}

/// The kind that somebody who wrote this word most likely meant.
const LevelKind *likelyKind(std::string_view word) {
  for (const LevelKind *kind : levelKinds())
    if (lower(word) == lower(kind->longName) || lower(word) == kind->name ||
        lower(word) == std::string(1, static_cast<char>(kind->letter - 'A' + 'a')))
      return kind;
  return nullptr;
}

std::string knownLevels() {
  std::string text;
  for (const LevelKind *kind : levelKinds())
    text += (text.empty() ? "" : ", ") + signature(*kind);
  return text;
}

/// The level as it is spelled in log2 sizes, if the sizes written are counts of cells: Raw(16,16,16) is
/// R(4,4,4).
std::string rightSpelling(const LevelKind &kind, const std::vector<Argument> &arguments) {
  const bool isWhole =
      arguments.size() <= kind.parameters.size() &&
      std::ranges::all_of(kind.parameters.subspan(arguments.size()),
                          [](const ParameterKind &parameter) { return parameter.defaultValue.has_value(); });
  const bool counts =
      isWhole && std::ranges::all_of(arguments, [](const Argument &a) { return a.value > 0; });
  if (!counts)
    return signature(kind) + " with log2 sizes";
  std::string text(1, kind.letter);
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const bool isSize = kind.parameters[i].isSize() && !kind.isTree();
    const std::uint32_t value = arguments[i].value;
    text += (i == 0 ? "(" : ", ") + std::to_string(isSize ? std::bit_width(value - 1) : value);
  }
  return text + ")";
}

/// An unknown word where a level should start; its parameters are read so that the right spelling can be
/// shown.
void diagnoseUnknownLevel(const Token &word, Lexer &lexer, Diagnostics &diagnostics) {
  const LevelKind *meant = word.kind == TokenKind::Word ? likelyKind(word.text) : nullptr;
  Diagnostics ignored;
  std::vector<Argument> arguments;
  if (lexer.peek().is('('))
    arguments = parseArguments(lexer, ignored).value_or(std::vector<Argument>());
  if (meant && word.text.size() == 1)
    diagnostics.error(word.range, quoted(word) + " is no level; write " + signature(*meant));
  else if (meant)
    diagnostics.error(word.range, quoted(word) + " is no level; sizes are log2, so write " +
                                      rightSpelling(*meant, arguments));
  else
    diagnostics.error(word.range, quoted(word) + " is no level; the levels are " + knownLevels());
}

void parseLevel(Lexer &lexer, Format &format, Diagnostics &diagnostics) {
  const Token letter = lexer.next();
  const LevelKind *kind =
      letter.kind == TokenKind::Word && letter.text.size() == 1 ? findLevelKind(letter.text[0]) : nullptr;
  if (!kind)
    return diagnoseUnknownLevel(letter, lexer, diagnostics);
  Level level;
  level.kind = kind;
  level.range = letter.range;
  const auto arguments = parseArguments(lexer, diagnostics);
  if (!arguments)
    return;
  level.range.end = lexer.takenEnd();
  if (setParameters(level, *arguments, letter.range, diagnostics))
    format.levels.push_back(std::move(level));
}

} // namespace

Format parseFormat(std::string_view text, Diagnostics &diagnostics) {
  Format format;
  if (!checkTextSize(text, diagnostics))
    return format;
  Lexer lexer(text);
  format.source = keepSource(text);
  if (lexer.peek().kind == TokenKind::End)
    diagnostics.error({0, text.size()}, "the format has no level; write at least one of " + knownLevels());
  while (lexer.peek().kind != TokenKind::End)
    parseLevel(lexer, format, diagnostics);
  if (!diagnostics.hasErrors())
    verify(format, diagnostics);
  return format;
}

Expected<Format> parseFormat(std::string_view text, std::string_view name) {
  Diagnostics diagnostics;
  const bool isIr = Lexer(text).peek().isWord("format");
  Format format = isIr ? parseIr(text, diagnostics) : parseFormat(text, diagnostics);
  if (diagnostics.hasErrors())
    return toError(diagnostics, text, name);
  format.source = keepSource(text, name);
  return format;
}

} // namespace voxc
