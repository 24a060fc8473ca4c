// Parsing of IR text (docs/ir.md):
//   format { level 1: raw(4, 4, 4)  level 2: svdag(8) dedup=level }
#include "LevelParser.h"

#include <algorithm>

namespace voxc {
namespace {

template <typename Range, typename Name> std::string listed(const Range &range, Name &&name) {
  std::string text;
  for (const auto &element : range)
    text += (text.empty() ? "" : ", ") + std::string(name(element));
  return text;
}

class IrParser {
public:
  IrParser(std::string_view text, Diagnostics &diagnostics) : lexer_(text), diagnostics_(diagnostics) {}

  Format parse() {
    if (!expectWord("format") || !parseAttributes("a format", formatAttributes(), format_.attributes) ||
        !expect('{'))
      return format_;
    while (!lexer_.peek().is('}') && lexer_.peek().kind != TokenKind::End)
      if (!parseLevel())
        skipToLevel();
    const Token end = lexer_.peek();
    if (expect('}') && lexer_.peek().kind != TokenKind::End)
      diagnostics_.error(lexer_.peek().range, "found " + quoted(lexer_.peek()) + " after the format's '}'");
    if (format_.levels.empty() && !diagnostics_.hasErrors())
      diagnostics_.error(end.range,
                         "the format has no level; write at least one, such as `level 1: raw(4, 4, 4)`");
    return format_;
  }

private:
  bool expect(char punctuation) {
    if (lexer_.accept(punctuation))
      return true;
    diagnostics_.error(lexer_.peek().range,
                       "found " + quoted(lexer_.peek()) + " where '" + punctuation + "' should be");
    return false;
  }

  bool expectWord(std::string_view word) {
    if (lexer_.peek().isWord(word)) {
      lexer_.next();
      return true;
    }
    diagnostics_.error(lexer_.peek().range,
                       "found " + quoted(lexer_.peek()) + " where '" + std::string(word) + "' should be");
    return false;
  }

  void skipToLevel() {
    while (!lexer_.peek().isWord("level") && !lexer_.peek().is('}') && lexer_.peek().kind != TokenKind::End)
      lexer_.next();
  }

  bool parseLevel() {
    ++number_;
    if (!expectWord("level"))
      return false;
    const Token number = lexer_.next();
    if (number.text != std::to_string(number_)) {
      diagnostics_.error(number.range, "found level " + quoted(number) + " where level " +
                                           std::to_string(number_) +
                                           " should be; levels are numbered from 1");
      return false;
    }
    return expect(':') && parseKind();
  }

  bool parseKind() {
    const Token name = lexer_.next();
    Level level;
    level.kind = findLevelKind(name.text);
    level.range = name.range;
    if (!level.kind) {
      diagnostics_.error(name.range,
                         quoted(name) + " is no level kind; they are " +
                             listed(levelKinds(), [](const LevelKind *kind) { return kind->name; }));
      return false;
    }
    const auto arguments = parseArguments(lexer_, diagnostics_);
    if (!arguments)
      return false;
    level.range.end = lexer_.takenEnd();
    if (!setParameters(level, *arguments, name.range, diagnostics_) ||
        !parseAttributes(level.kind->name, level.kind->attributes, level.attributes))
      return false;
    format_.levels.push_back(std::move(level));
    return true;
  }

  /// The attributes of `owner`, which takes those of `taken`.
  bool parseAttributes(std::string_view owner, AttributeKinds taken, AttributeSet &attributes) {
    while (lexer_.peek().kind == TokenKind::Word && !lexer_.peek().isWord("level"))
      if (!parseAttribute(owner, taken, attributes))
        return false;
    return true;
  }

  bool parseAttribute(std::string_view owner, AttributeKinds taken, AttributeSet &attributes) {
    const Token name = lexer_.next();
    const auto found = std::ranges::find(taken, name.text, &AttributeKind::name);
    if (found == taken.end()) {
      const std::string known = listed(taken, [](const AttributeKind *kind) { return kind->name; });
      diagnostics_.error(name.range,
                         quoted(name) + " is no attribute of " + std::string(owner) + "; it has " + known);
      if (lexer_.accept('=')) // Its value begins no level, even where it is called so.
        lexer_.nextValue();
      return false;
    }
    if (!expect('='))
      return false;
    const Token value = lexer_.nextValue();
    if (std::ranges::find((*found)->values, value.text) == (*found)->values.end()) {
      diagnostics_.error(value.range, quoted(value) + " is no value of " + std::string(name.text) +
                                          "; it takes " +
                                          listed(valueRanges(**found),
                                                 [](const ValueRange &range) { return range.text(); }));
      return false;
    }
    attributes.set(taken, **found, value.text);
    return true;
  }

  Lexer lexer_;
  Diagnostics &diagnostics_;
  Format format_;
  int number_ = 0;
};

} // namespace

Format parseIr(std::string_view text, Diagnostics &diagnostics) {
  if (!checkTextSize(text, diagnostics))
    return {};
  Format format = IrParser(text, diagnostics).parse();
  format.source = keepSource(text);
  if (!diagnostics.hasErrors())
    verify(format, diagnostics);
  return format;
}

} // namespace voxc
